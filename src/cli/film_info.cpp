#include "cli/film_info.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cli/exr_report.h"
#include "cli/json_text.h"
#include "cli/samples_text.h"
#include "tonemap/scene_luminance.h"
#include "tonemap/zone.h"

namespace emulsion::cli {

namespace {

std::string_view kind_name(ExrKind kind) {
    switch (kind) {
        case ExrKind::film_state:
            return "film state";
        case ExrKind::film_picture:
            return "film picture";
        case ExrKind::picture:
            return "picture";
        case ExrKind::other:
            return "other EXR";
    }
    return "";
}

void report_luminance(const LuminanceStatistics& luminance, double zones, InfoReport& report) {
    const PixelCounts& counts = luminance.counts;
    if (counts.positive > 0) {
        report.line("luminance",
                    fmt::format("{:.6g} to {:.6g} cd/m^2", luminance.min_positive_cdm2, luminance.max_cdm2));
        report.line("dynamic range", fmt::format("{:.1f} zones", zones));
        report.line("log-average", fmt::format("{:.6g} cd/m^2", luminance.log_average_cdm2));
    } else {
        report.line("luminance", "no pixel has any");
    }
    const auto left_out = [&](std::int64_t count, std::string_view what) {
        if (count > 0) report.line("", fmt::format("left out: {} pixel{} {}", count, count == 1 ? "" : "s", what));
    };
    left_out(counts.zero, "of luminance 0");
    left_out(counts.negative, "of negative luminance");
    left_out(counts.nan, "with NaN");
    left_out(counts.infinite, "with infinities");
    report.member("luminance", json_object({{"min_positive_cdm2", json_number(luminance.min_positive_cdm2)},
                                            {"max_cdm2", json_number(luminance.max_cdm2)},
                                            {"log_average_cdm2", json_number(luminance.log_average_cdm2)},
                                            {"dynamic_range_zones", json_number(zones)},
                                            {"positive_pixels", std::to_string(counts.positive)},
                                            {"zero_pixels", std::to_string(counts.zero)},
                                            {"negative_pixels", std::to_string(counts.negative)},
                                            {"nan_pixels", std::to_string(counts.nan)},
                                            {"infinite_pixels", std::to_string(counts.infinite)}}));
}

std::string dropped_text(std::uint64_t nan, std::uint64_t infinite, std::uint64_t negative) {
    if (nan + infinite + negative == 0) return "none";
    return fmt::format("{} NaN, {} infinite, {} of negative luminance", nan, infinite, negative);
}

/// What the pixels of a state show of its samples: fewer without those that were dropped, and another number where a
/// filter splats each into several pixels.
void report_reach(const FilmState& state, const SamplesTaken& taken, InfoReport& report) {
    const std::uint64_t fewest = min_samples_per_pixel(state.contents), most = max_samples_per_pixel(state.contents);
    if (SamplesTaken{fewest, most} != taken) report.line("", count_text(fewest, most) + " reach each pixel");
    report.member("fewest_samples_reaching_a_pixel", std::to_string(fewest));
    report.member("most_samples_reaching_a_pixel", std::to_string(most));
}

void report_samples(const FilmInfo& info, InfoReport& report) {
    const FilmMetadata& metadata = info.exr.metadata;
    const auto least = static_cast<std::uint64_t>(metadata.samples_per_pixel);
    // A picture keeps no account of more.
    const SamplesTaken taken = info.state ? samples_taken(info.state->provenance) : SamplesTaken{};
    const std::string count = taken.most > 0 ? count_text(taken.least, taken.most) : fmt::format("at least {}", least);
    report.line("samples", fmt::format("{} of each pixel, {} in all", count, metadata.sample_count));
    report.member("samples_per_pixel", std::to_string(least));
    if (taken.most > 0) report.member("most_samples_per_pixel", std::to_string(taken.most));
    report.member("sample_count", std::to_string(metadata.sample_count));
    if (info.state) report_reach(*info.state, taken, report);
}

void report_losses(const FilmInfo& info, InfoReport& report) {
    const FilmMetadata& metadata = info.exr.metadata;
    report.line("dropped", dropped_text(metadata.dropped_nan_count, metadata.dropped_infinite_count,
                                        metadata.dropped_negative_luminance_count));
    std::vector<std::string> first;
    if (info.state) {
        for (const DroppedSample& sample : info.state->contents.counts.dropped.first()) {
            report.line("", to_string(sample));
            first.push_back(json_text(to_string(sample)));
        }
        report.member("first_dropped", json_list(first));
    }
    if (metadata.faint_count > 0) report.line("too faint", std::to_string(metadata.faint_count));
    report.line("firefly control", metadata.firefly_control.empty() ? "none" : metadata.firefly_control);
    report.member("dropped",
                  json_object({{"nan", std::to_string(metadata.dropped_nan_count)},
                               {"infinite", std::to_string(metadata.dropped_infinite_count)},
                               {"negative_luminance", std::to_string(metadata.dropped_negative_luminance_count)}}));
    report.member("faint", std::to_string(metadata.faint_count));
    report.member_text("firefly_control", metadata.firefly_control);
}

void report_run(const FilmMetadata& metadata, InfoReport& report) {
    report.line("filter", metadata.filter);
    report.line("film", metadata.film);
    report.line("seed", std::to_string(metadata.seed));
    if (!metadata.model.empty()) report.line("model", metadata.model);
    if (!metadata.sampling.empty()) report.line("sampling", metadata.sampling);
    if (!metadata.pixels.empty()) report.line("pixels", metadata.pixels);
    report.line("renderer", metadata.renderer_version);
    report.line("command line", metadata.command_line);
    report.member_text("filter", metadata.filter);
    report.member_text("film", metadata.film);
    report.member("seed", std::to_string(metadata.seed));
    report.member_text("model", metadata.model);
    report.member_text("sampling", metadata.sampling);
    report.member_text("pixels", metadata.pixels);
    report.member_text("renderer", metadata.renderer_version);
    report.member_text("command_line", metadata.command_line);
}

void report_ranges(const FilmProvenance& provenance, InfoReport& report) {
    std::vector<std::string> ranges;
    for (const SampleRange& range : provenance.samples.ranges()) {
        ranges.push_back(fmt::format("[{}, {}]", range.begin, range.end));
    }
    report.line("sample ranges", ranges.empty() ? "none" : to_text(provenance.samples));
    report.member("sample_ranges", json_list(ranges));
    std::string partial_json = "null";
    if (provenance.partial) {
        const PartialRound& partial = *provenance.partial;
        const auto done = std::count(partial.done.begin(), partial.done.end(), 1);
        report.line("partial round", fmt::format("{}-{}, in {} of {} tiles", partial.samples.begin, partial.samples.end,
                                                 done, partial.done.size()));
        partial_json = json_object({{"begin", std::to_string(partial.samples.begin)},
                                    {"end", std::to_string(partial.samples.end)},
                                    {"tiles", std::to_string(partial.done.size())},
                                    {"done", std::to_string(done)}});
    }
    report.member("partial_round", partial_json);
    report.line("scene", provenance.scene);
    report.member_text("scene", provenance.scene);
}

/// What the header of the picture does not have.
void report_state(const FilmState& state, InfoReport& report) {
    const FilmCounts& counts = state.contents.counts;
    const auto count = [&](std::string_view label, std::string_view key, std::uint64_t number) {
        if (number > 0) report.line(label, std::to_string(number));
        report.member(key, std::to_string(number));
    };
    count("light splats", "light_splats", counts.light_splats);
    count("light paths", "light_paths", counts.light_paths);
    count("dropped aux", "dropped_aux_values", counts.dropped_aux);
    count("no value", "pixels_without_value", static_cast<std::uint64_t>(pixels_without_value(state.contents)));
    count("saturated", "saturated_pixels", static_cast<std::uint64_t>(saturated_pixels(state.contents)));
    report_ranges(state.provenance, report);
    // The picture's header has it with the film's options.
    if (state.metadata.film.find(state.sensor_text) == std::string::npos) report.line("sensor", state.sensor_text);
    report.member_text("sensor", state.sensor_text);
}

}  // namespace

FilmInfo read_film_info(const std::filesystem::path& path, int threads) {
    FilmInfo info{.path = path, .exr = read_exr_info(path), .state = std::nullopt, .luminance = std::nullopt};
    info.bytes = std::filesystem::file_size(path);
    if (info.exr.kind == ExrKind::other) {
        info.notes.emplace_back("no channels X Y Z or R G B: no picture to say more of");
        return info;
    }
    if (info.exr.kind == ExrKind::film_state) info.state = read_film_state(path);
    const FilmImage picture = read_exr(path, {.layers = ExrLayers::skip, .threads = threads});
    const SceneLuminance luminance(picture.xyz.view(), threads);
    info.luminance = luminance.statistics();
    info.dynamic_range_zones = dynamic_range_zones(luminance);
    info.white_luminance_cdm2 = picture.white_luminance_cdm2;
    info.notes = picture.notes;
    return info;
}

InfoReport report_of(const FilmInfo& info) {
    InfoReport report;
    report.line("file", info.path.string());
    report.line("kind", fmt::format("{}, {} bytes", kind_name(info.exr.kind), info.bytes));
    report.member_text("file", info.path.string());
    report.member_text("kind", kind_name(info.exr.kind));
    report.member("bytes", std::to_string(info.bytes));
    report_size(info.exr, report);
    report_channels(info.exr, info.white_luminance_cdm2, report);
    if (info.luminance) report_luminance(*info.luminance, info.dynamic_range_zones, report);
    const bool is_film = info.exr.kind == ExrKind::film_state || info.exr.kind == ExrKind::film_picture;
    if (is_film) {
        report_samples(info, report);
        report_losses(info, report);
    }
    if (info.state) report_state(*info.state, report);
    if (is_film) report_run(info.exr.metadata, report);
    std::vector<std::string> notes;
    for (const std::string& note : info.notes) {
        report.line("note", note);
        notes.push_back(json_text(note));
    }
    report.member("notes", json_list(notes));
    return report;
}

}  // namespace emulsion::cli
