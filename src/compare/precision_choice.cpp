#include "compare/precision_choice.h"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "core/name_key.h"
#include "core/parameters.h"
#include "core/row_blocks.h"
#include "develop/averaged_down.h"
#include "develop/develop.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/viewing_conditions.h"
#include "tonemap/pixel_class.h"

namespace emulsion {

namespace {

Image<XYZ> shown_by(const Precision& precision, const Image<XYZ>& scene, Pipeline& pipeline, int threads) {
    pipeline.precision = precision;
    return tone_mapped(scene, pipeline, threads);
}

Lab lab_on_display(const XYZ& pixel, const ViewingConditions& viewing) {
    return lab_as_viewed(XYZd{pixel.x, pixel.y, pixel.z}, viewing);
}

/// So that it takes seconds at most.
int usual_most_px(const Pipeline& pipeline) {
    const bool grows_by_square =
        !std::holds_alternative<NoBloom>(pipeline.bloom) || !std::holds_alternative<NoVision>(pipeline.vision);
    return grows_by_square ? 96 : 256;
}

}  // namespace

PrecisionChoice parse_precision_choice(std::string_view text) {
    if (const auto budget = parse_auto(text, "precision")) return AutoPrecision{*budget};
    const std::string name = name_key(text);
    if (name == FastPrecision::kName) return FastPrecision{};
    if (name == ReferencePrecision::kName) return ReferencePrecision{};
    throw std::invalid_argument(fmt::format("found \"{}\", expected fast, reference or auto[:MEAN[,P99]]", text));
}

PrecisionLoss precision_loss(const Image<XYZ>& scene, Pipeline pipeline, const PrecisionLossOptions& options) {
    validate(pipeline);
    const int most_px = options.most_px.value_or(usual_most_px(pipeline));
    check_range(most_px, {1.0, kInfinity}, "precision: most_px");
    if (scene.width() < 1 || scene.height() < 1) throw std::invalid_argument("precision: the picture has no pixels");
    const auto good = [](const XYZ& pixel) { return is_bad(classify(pixel)) ? std::nullopt : std::optional(pixel); };
    const auto [width, height] = size_within(scene.width(), scene.height(), most_px);
    const Image<XYZ> smaller = averaged_down(scene, width, height, options.threads, good);
    const Image<XYZ> fast = shown_by(FastPrecision{}, smaller, pipeline, options.threads);
    const Image<XYZ> exact = shown_by(ReferencePrecision{}, smaller, pipeline, options.threads);

    const ViewingConditions viewing{shown_as_white(pipeline.scene_white, pipeline.display), 1.0};
    Image<double> differences(width, height, UnsetPixels{});
    parallel_for_rows(width, height, options.threads, [&](int y) {
        for (int x = 0; x < differences.width(); ++x) {
            differences(x, y) = difference(Ciede2000Difference{}, lab_on_display(exact(x, y), viewing),
                                           lab_on_display(fast(x, y), viewing));
        }
    });
    return {difference_statistics(std::as_const(differences).view()), width, height};
}

PrecisionDecision decide_precision(const PrecisionLoss& loss, const ErrorBudget& budget) {
    validate(budget);
    const DifferenceStatistics& found = loss.ciede2000;
    const std::string measured = fmt::format("dE00 {:.2g} mean, {:.2g} p99 on {}x{} pixels", found.mean, found.p99,
                                             loss.width_px, loss.height_px);
    if (is_within(found.mean, found.p99, budget)) {
        return {FastPrecision{}, fmt::format("fast: {}, within {:g} and {:g}", measured, budget.mean, budget.p99)};
    }
    return {ReferencePrecision{},
            fmt::format("reference: fast has {}; asked for {:g} and {:g}", measured, budget.mean, budget.p99)};
}

}  // namespace emulsion
