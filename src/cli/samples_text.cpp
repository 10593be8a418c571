#include "cli/samples_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace emulsion::cli {

std::string samples_text(const FilmProvenance& provenance) {
    std::string text = provenance.samples.empty() ? "no samples" : "samples " + to_text(provenance.samples);
    if (const auto& partial = provenance.partial) {
        text += fmt::format(" (and {}-{} in {} of {} tiles)", partial->samples.begin, partial->samples.end,
                            std::count(partial->done.begin(), partial->done.end(), 1), partial->done.size());
    }
    return text;
}

std::string count_text(std::uint64_t least, std::uint64_t most) {
    return least == most ? std::to_string(least) : fmt::format("{} to {}", least, most);
}

}  // namespace emulsion::cli
