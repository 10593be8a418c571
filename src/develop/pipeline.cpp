#include "develop/pipeline.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/named_value.h"
#include "core/parameters.h"

namespace emulsion {

namespace {

/// Calls visitor(key, stage) for every stage, in their order: the one list of keys.
template <class AnyPipeline, class Visitor>
void for_each_stage(AnyPipeline& pipeline, Visitor&& visitor) {
    visitor("bloom", pipeline.bloom);
    visitor("vision", pipeline.vision);
    visitor("tonemap", pipeline.tone_mapper);
    visitor("adaptation", pipeline.adaptation);
    visitor("precision", pipeline.precision);
    visitor("scene-white", pipeline.scene_white);
    visitor("display", pipeline.display);
    visitor("gamut", pipeline.gamut);
    visitor("transfer", pipeline.transfer);
    visitor("bits", pipeline.bits);
    visitor("range", pipeline.range);
    visitor("dither", pipeline.dither);
}

std::string stage_text(int bits) { return number_text(bits); }
template <NamedVariant Variant>
std::string stage_text(const Variant& stage) {
    return to_text(stage);
}

template <NamedVariant Variant>
std::string stage_text(const std::optional<Variant>& stage) {
    return stage ? to_text(*stage) : std::string(kOwnStage);
}

void validate_stage(std::string_view key, int bits) { check_range(bits, kCodeBits, key); }
template <NamedVariant Variant>
void validate_stage(std::string_view key, const Variant& stage) {
    validate_named(stage, key);
}

template <NamedVariant Variant>
void validate_stage(std::string_view key, const std::optional<Variant>& stage) {
    if (stage) validate_named(*stage, key);
}

void parse_stage(std::string_view key, std::string_view text, int& bits) {
    parse_number(text, key, bits);
    validate_stage(key, bits);
}
template <NamedVariant Variant>
void parse_stage(std::string_view key, std::string_view text, Variant& stage) {
    stage = parse_named<Variant>(text, key);
}
template <NamedVariant Variant>
void parse_stage(std::string_view key, std::string_view text, std::optional<Variant>& stage) {
    stage = parse_named_or<Variant>(kOwnStage, text, key);
}

/// Sets the stage named by the key of "key=value".
void parse_word(std::string_view word, Pipeline& pipeline, std::vector<std::string_view>& seen) {
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos) {
        throw std::invalid_argument("pipeline: found \"" + std::string(word) + "\", expected stage=value");
    }
    const std::string_view key = word.substr(0, equals);
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
        throw std::invalid_argument("pipeline: " + std::string(key) + " given twice");
    }
    seen.push_back(key);

    std::vector<std::string_view> known;
    bool found = false;
    for_each_stage(pipeline, [&](std::string_view stage_key, auto& stage) {
        known.push_back(stage_key);
        if (stage_key != key) return;
        parse_stage(key, word.substr(equals + 1), stage);
        found = true;
    });
    if (!found) throw_unknown_name("pipeline stage", key, std::move(known));
}

}  // namespace

TransferFunction transfer_of(const Pipeline& pipeline) {
    return pipeline.transfer ? *pipeline.transfer : own_transfer(pipeline.display);
}

std::string to_text(const Pipeline& pipeline) {
    std::string text;
    for_each_stage(pipeline, [&](std::string_view key, const auto& stage) {
        if (!text.empty()) text += ' ';
        text += key;
        text += '=';
        text += stage_text(stage);
    });
    return text;
}

Pipeline parse_pipeline(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n";
    Pipeline pipeline;
    std::vector<std::string_view> seen;
    for (std::size_t begin = text.find_first_not_of(kSpace); begin != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(kSpace, begin), text.size());
        parse_word(text.substr(begin, end - begin), pipeline, seen);
        begin = text.find_first_not_of(kSpace, end);
    }
    validate(pipeline);
    return pipeline;
}

void validate(const Pipeline& pipeline) {
    for_each_stage(pipeline, [](std::string_view key, const auto& stage) { validate_stage(key, stage); });
    validate(pipeline.display);
    validate(pipeline.scene_white, pipeline.display);
    (void)code_scale(pipeline.bits, pipeline.range);
}

}  // namespace emulsion
