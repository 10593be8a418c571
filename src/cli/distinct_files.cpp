#include "cli/distinct_files.h"

#include <cstddef>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/atomic_file.h"

namespace emulsion::cli {

void require_distinct(const std::vector<NamedFile>& files) {
    for (std::size_t later = 1; later < files.size(); ++later) {
        for (std::size_t earlier = 0; earlier < later; ++earlier) {
            const NamedFile &a = files[earlier], &b = files[later];
            if (a.path.empty() || b.path.empty() || !is_same_file(a.path, b.path)) continue;
            throw CLI::ValidationError(b.argument, fmt::format("found {}, which is the same file as {} ({}), expected "
                                                               "another",
                                                               b.path.string(), a.argument, a.path.string()));
        }
    }
}

}  // namespace emulsion::cli
