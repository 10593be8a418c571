#include "cli/samples_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace emulsion::cli {

std::string samples_text(const FilmProvenance& provenance) {
    std::string text = provenance.samples.empty() ? "no samples" : "samples " + to_text(provenance.samples);
    if (stops_by_tile(provenance)) text += " (fewer where tiles had enough)";
    if (const auto& partial = provenance.partial) {
        text += fmt::format(" (and {}-{} in {} of {} tiles)", partial->samples.begin, partial->samples.end,
                            std::count(partial->done.begin(), partial->done.end(), 1), partial->done.size());
    }
    return text;
}

std::string count_text(std::uint64_t least, std::uint64_t most) {
    return least == most ? std::to_string(least) : fmt::format("{} to {}", least, most);
}

std::string count_text(const FilmProvenance& provenance, const FilmContents<ExactSums>& contents) {
    const SamplesTaken taken = samples_taken(provenance);
    if (taken.most > 0) return count_text(taken.least, taken.most);
    return count_text(min_samples_per_pixel(contents), max_samples_per_pixel(contents));
}

}  // namespace emulsion::cli
