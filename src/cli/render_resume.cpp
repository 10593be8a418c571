#include "cli/render_resume.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/samples_text.h"

namespace emulsion::cli {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error(fmt::format("can't resume from {}: {}", path.string(), reason));
}

bool is_inside(const SampleRange& range, const SampleRange& wanted) noexcept {
    return range.begin >= wanted.begin && range.end <= wanted.end;
}

}  // namespace

FilmState read_state_for(const RenderStart& start, const std::filesystem::path& path) {
    FilmState state = read_film_state(path);
    try {
        require_same_film(state, start.film, start.provenance);
    } catch (const std::invalid_argument& error) {
        const bool depends_on_count = start.provenance.sampling.starts_with("stratified");
        refuse(path,
               error.what() + std::string(depends_on_count ? " (a stratified sampler's strata depend on --spp)" : ""));
    }
    const auto& had = state.provenance.samples.ranges();
    const auto& partial = state.provenance.partial;
    const bool fits =
        std::all_of(had.begin(), had.end(), [&](auto range) { return is_inside(range, start.samples); }) &&
        (!partial || is_inside(partial->samples, start.samples));
    if (!fits) {
        refuse(path, fmt::format("it has {} of each pixel, expected none outside {}-{}, the samples to render",
                                 samples_text(state.provenance), start.samples.begin, start.samples.end));
    }
    return state;
}

}  // namespace emulsion::cli
