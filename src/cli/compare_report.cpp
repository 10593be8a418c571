#include "cli/compare_report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/json_text.h"
#include "core/name_key.h"

namespace emulsion::cli {

namespace {

std::string pixels_text(std::int64_t count) { return fmt::format("{} pixel{}", count, count == 1 ? "" : "s"); }

std::string_view source_name(WhiteLuminanceSource source) noexcept {
    switch (source) {
        case WhiteLuminanceSource::given:
            return "as given";
        case WhiteLuminanceSource::log_average_of_a:
            return "A's log-average is 18 % of it";
        case WhiteLuminanceSource::log_average_of_b:
            return "B's log-average is 18 % of it, as A is black";
        case WhiteLuminanceSource::none:
            return "as both are black";
    }
    return "";
}

void report_conditions(const CompareReport& in, InfoReport& report) {
    const Comparison& found = in.comparison;
    const PixelBounds frame{0, 0, in.a.width_px, in.a.height_px};
    std::string size = fmt::format("{}x{} pixels", found.window.width(), found.window.height());
    if (found.window != frame) {
        size += fmt::format(", {} of the frame {}", to_string(found.window), to_string(frame));
    }
    report.line("compared", size);
    report.member("window",
                  fmt::format("[{}, {}, {}, {}]", found.window.x0, found.window.y0, found.window.x1, found.window.y1));
    const ViewingConditions& viewing = found.viewing;
    const Chromaticity white = chromaticity_of(viewing.white);
    report.line("white", fmt::format("{:.6g} cd/m^2 ({}), x {:.4f}, y {:.4f}", viewing.white_luminance_cdm2,
                                     source_name(found.white_source), white.x, white.y));
    report.member("white", json_object({{"luminance_cdm2", json_number(viewing.white_luminance_cdm2)},
                                        {"luminance_source", json_text(source_name(found.white_source))},
                                        {"x", json_number(white.x)},
                                        {"y", json_number(white.y)}}));
}

void report_statistics(std::string_view label, std::string_view key, const DifferenceStatistics& found,
                       InfoReport& report) {
    report.line(label, fmt::format("mean {:<8.4g} p50 {:<8.4g} p99 {:<8.4g} max {:.4g} at {}, {}", found.mean,
                                   found.p50, found.p99, found.max, found.max_x, found.max_y));
    report.member(key, json_object({{"mean", json_number(found.mean)},
                                    {"p50", json_number(found.p50)},
                                    {"p99", json_number(found.p99)},
                                    {"max", json_number(found.max)},
                                    {"max_px", fmt::format("[{}, {}]", found.max_x, found.max_y)}}));
}

/// "A has", "B has" or "A and B have": of which the noise is not known.
std::string without_noise(const CompareReport& in) {
    if (in.a.noise != KnownNoise::none) return "B has";
    return in.b.noise != KnownNoise::none ? "A has" : "A and B have";
}

void report_unknown_noise(const CompareReport& in, InfoReport& report) {
    const bool have_layers = in.a.noise != KnownNoise::none && in.b.noise != KnownNoise::none;
    report.line(
        "due to noise",
        have_layers
            ? "unknown: pixels have fewer than two samples"
            : fmt::format(
                  "unknown: {} no layers standard-error; render with --variance xyz, or twice (--a-again, --b-again)",
                  without_noise(in)));
    report.line("due to bias", "unknown");
    report.member("noise_and_bias", "null");
}

/// In [0, 100] %, and the estimate itself where that is not.
std::string share_text(double share) {
    const std::string held = fmt::format("{:.1f} %", 100.0 * std::clamp(share, 0.0, 1.0));
    const std::string estimate = fmt::format("{:.1f} %", 100.0 * share);
    // Not "-0.0 %".
    return std::abs(std::clamp(share, 0.0, 1.0) - share) < 5e-4 ? held : held + " (estimated " + estimate + ")";
}

bool is_upper_bound(const CompareReport& in) noexcept {
    return in.a.estimate == NoiseEstimate::upper_bound || in.b.estimate == NoiseEstimate::upper_bound;
}

void report_noise_and_bias(const NoiseAndBias& parts, const CompareReport& in, InfoReport& report) {
    const bool of_xyz = parts.components == KnownNoise::xyz, is_bound = is_upper_bound(in);
    if (parts.mean_squared > 0.0) {
        report.line("due to noise", fmt::format("{}{} of the squared difference in {}, relative to what is around",
                                                is_bound ? "at most " : "", share_text(parts.noise_share()),
                                                of_xyz ? "X, Y and Z" : "Y"));
        report.line("due to bias",
                    fmt::format("{}{}, with a standard error of {:.1f} %", is_bound ? "at least " : "",
                                share_text(parts.bias_share()), 100.0 * parts.bias_share_standard_error()));
    } else {
        report.line("due to noise", "there is no difference");
        report.line("due to bias", "there is no difference");
    }
    report.member("noise_and_bias",
                  json_object({{"components", json_text(of_xyz ? "xyz" : "luminance")},
                               {"noise_is_upper_bound", is_bound ? "true" : "false"},
                               {"pixels", std::to_string(parts.pixels)},
                               {"mean_squared", json_number(parts.mean_squared)},
                               {"noise", json_number(parts.noise)},
                               {"bias", json_number(parts.bias)},
                               {"bias_standard_error", json_number(parts.bias_standard_error)},
                               {"noise_share", json_number(parts.noise_share())},
                               {"bias_share", json_number(parts.bias_share())},
                               {"bias_share_standard_error", json_number(parts.bias_share_standard_error())}}));
}

void report_errors(const CompareReport& in, InfoReport& report) {
    const Comparison& found = in.comparison;
    report_statistics("CIEDE2000", "ciede2000", found.ciede2000, report);
    report_statistics("dE ITP", "itp", found.itp, report);
    report.line("relative MSE", fmt::format("{:.4g}", found.squared.relative));
    report.member("relative_mse", json_number(found.squared.relative));
    report.member("mse", json_number(found.squared.mean_squared));
    report.line("PSNR", std::isinf(found.psnr_db) ? "infinite: equal once tone-mapped"
                                                  : fmt::format("{:.2f} dB, tone-mapped and encoded", found.psnr_db));
    report.member("psnr_db", json_number(found.psnr_db));
    if (found.squared.parts) return report_noise_and_bias(*found.squared.parts, in, report);
    report_unknown_noise(in, report);
}

void report_rules(std::string_view name, const PixelRuleCounts& counts, InfoReport& report) {
    const auto line = [&](std::int64_t count, std::string_view what) {
        if (count == 0) return;
        report.line(fmt::format("pixels of {}", name), fmt::format("{} {}", count, what));
    };
    line(counts.not_finite, "not finite, left out");
    line(counts.negative, "with negative components, taken as 0 for colour differences");
    line(counts.above_white, "brighter than white, taken as white in luminance for CIEDE2000");
    report.member(name == "A" ? "pixels_of_a" : "pixels_of_b",
                  json_object({{"not_finite", std::to_string(counts.not_finite)},
                               {"negative", std::to_string(counts.negative)},
                               {"above_white", std::to_string(counts.above_white)}}));
}

/// What makes the shares less than they seem.
std::vector<std::string> notes_of(const CompareReport& in) {
    std::vector<std::string> notes;
    if (in.a.observer != in.b.observer || name_key(in.a.observer) != "cie-1931-2deg") {
        notes.emplace_back("dE ITP, relative MSE and PSNR take X, Y and Z for those of CIE 1931, of observer " +
                           in.a.observer + " as they are");
    }
    const std::optional<NoiseAndBias>& parts = in.comparison.squared.parts;
    if (!parts) return notes;
    if (const std::optional<std::uint64_t> seed = common_seed(in.a, in.b)) {
        notes.push_back(fmt::format(
            "both have seed {}: if they share samples, their noise is not independent, and the shares do not hold",
            *seed));
    } else if (is_upper_bound(in) || parts->bias < -3.0 * parts->bias_standard_error) {
        notes.emplace_back(
            "noise is overestimated, bias underestimated: films tell noise as of independent samples, stratified ones "
            "do "
            "better; --a-again and --b-again tell it right");
    }
    return notes;
}

}  // namespace

InfoReport report_of(const CompareReport& in) {
    const Comparison& found = in.comparison;
    InfoReport report;
    report.line("A, the reference", in.settings.a.text);
    report.line("B", in.settings.b.text);
    report.member_text("a", in.settings.a.text);
    report.member_text("b", in.settings.b.text);
    report_conditions(in, report);
    report_errors(in, report);
    report_rules("A", found.a, report);
    report_rules("B", found.b, report);
    if (found.left_out > 0) {
        const auto [x, y] = found.first_left_out_px.value_or(std::pair{0, 0});
        report.line("left out", fmt::format("{} of both, the first at {}, {}", pixels_text(found.left_out), x, y));
    }
    report.member("left_out", std::to_string(found.left_out));
    std::vector<std::string> notes;
    for (const std::string& note : notes_of(in)) {
        report.line("note", note);
        notes.push_back(json_text(note));
    }
    report.member("notes", json_list(notes));
    if (in.settings.limits) {
        report.member("within_limits", exceeded(*in.settings.limits, found).empty() ? "true" : "false");
    }
    return report;
}

std::vector<std::string> exceeded(const DifferenceLimits& limits, const Comparison& comparison) {
    std::vector<std::string> reasons;
    const auto check = [&](std::string_view what, double value, double limit) {
        if (value > limit) reasons.push_back(fmt::format("{} of CIEDE2000 is {:.4g}, above {:g}", what, value, limit));
    };
    check("the mean", comparison.ciede2000.mean, limits.mean);
    if (limits.p99) check("the 99th percentile", comparison.ciede2000.p99, *limits.p99);
    // Those of A alone are A's fault.
    const std::int64_t only_in_b = comparison.left_out - comparison.a.not_finite;
    if (only_in_b > 0) reasons.push_back(fmt::format("{} finite in A and not in B", pixels_text(only_in_b)));
    return reasons;
}

}  // namespace emulsion::cli
