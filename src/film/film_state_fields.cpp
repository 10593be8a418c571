#include "film/film_state_fields.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/parameters.h"
#include "film/film_options_text.h"

namespace emulsion {

namespace {

/// Numbers out of a text, one after the other.
class TextReader {
  public:
    TextReader(std::string_view text, std::string_view what) : text_(text), rest_(text), what_(what) {}

    [[noreturn]] void fail() const {
        throw std::invalid_argument(fmt::format("film state: {}: \"{}\" is malformed", what_, text_));
    }
    [[nodiscard]] bool is_at_end() const noexcept { return rest_.empty(); }
    void expect(std::string_view separator) {
        if (!rest_.starts_with(separator)) fail();
        rest_.remove_prefix(separator.size());
    }
    template <class Integer>
    [[nodiscard]] Integer number(int base = 10) {
        Integer value{};
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value, base);
        if (error != std::errc{}) fail();
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }
    template <class Integer>
    [[nodiscard]] Integer number_and(std::string_view separator, int base = 10) {
        const auto value = number<Integer>(base);
        expect(separator);
        return value;
    }
    [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

  private:
    std::string_view text_, rest_, what_;
};

std::string crop_text(const std::optional<PixelBounds>& crop) {
    return crop ? fmt::format("{},{},{},{}", crop->x0, crop->y0, crop->x1, crop->y1) : "none";
}

std::optional<PixelBounds> parse_crop(const std::string& text) {
    if (text == "none") return std::nullopt;
    TextReader reader(text, "crop");
    PixelBounds crop;
    crop.x0 = reader.number_and<int>(",");
    crop.y0 = reader.number_and<int>(",");
    crop.x1 = reader.number_and<int>(",");
    crop.y1 = reader.number<int>();
    if (!reader.is_at_end()) reader.fail();
    return crop;
}

std::string dropped_text(std::span<const DroppedSample> samples) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    std::string text;
    for (const DroppedSample& s : samples) {
        text += fmt::format("{} {} {} {:08x} {:08x} {:08x} {:08x};", s.x_px, s.y_px, static_cast<int>(s.kind),
                            bits(s.value.x), bits(s.value.y), bits(s.value.z), bits(s.weight));
    }
    return text;
}

std::vector<DroppedSample> parse_dropped(const std::string& text) {
    std::vector<DroppedSample> samples;
    TextReader reader(text, "first dropped samples");
    const auto next_float = [&](std::string_view separator) {
        return std::bit_cast<float>(reader.number_and<std::uint32_t>(separator, 16));
    };
    while (!reader.is_at_end()) {
        DroppedSample s;
        s.x_px = reader.number_and<int>(" ");
        s.y_px = reader.number_and<int>(" ");
        const int kind = reader.number_and<int>(" ");
        if (kind < 0 || kind > static_cast<int>(DroppedKind::negative_luminance)) reader.fail();
        s.kind = static_cast<DroppedKind>(kind);
        s.value.x = next_float(" ");
        s.value.y = next_float(" ");
        s.value.z = next_float(" ");
        s.weight = next_float(";");
        samples.push_back(s);
    }
    return samples;
}

using SumWords = std::array<std::uint32_t, 3>;

std::string sum_text(const ExactSum& sum) {
    const auto words = std::bit_cast<SumWords>(sum);
    return fmt::format("{:08x} {:08x} {:08x}", words[0], words[1], words[2]);
}

ExactSum parse_sum(const std::string& text) {
    TextReader reader(text, "removed luminance");
    SumWords words{};
    words[0] = reader.number_and<std::uint32_t>(" ", 16);
    words[1] = reader.number_and<std::uint32_t>(" ", 16);
    words[2] = reader.number<std::uint32_t>(16);
    if (!reader.is_at_end()) reader.fail();
    return std::bit_cast<ExactSum>(words);
}

std::string partial_text(const std::optional<PartialRound>& partial) {
    if (!partial) return "none";
    std::string text = fmt::format("{}-{} {} {} ", partial->samples.begin, partial->samples.end, partial->tile_px,
                                   partial->done.size());
    for (std::size_t first = 0; first < partial->done.size(); first += 4) {
        unsigned digit = 0;
        for (std::size_t i = first; i < first + 4; ++i) {
            digit = 2 * digit + (i < partial->done.size() && partial->done[i] != 0 ? 1u : 0u);
        }
        text += "0123456789abcdef"[digit];
    }
    return text;
}

std::optional<PartialRound> parse_partial(const std::string& text) {
    if (text == "none") return std::nullopt;
    TextReader reader(text, "partial round");
    PartialRound partial;
    partial.samples.begin = reader.number_and<std::uint64_t>("-");
    partial.samples.end = reader.number_and<std::uint64_t>(" ");
    partial.tile_px = reader.number_and<int>(" ");
    const auto tiles = reader.number_and<std::uint64_t>(" ");
    const std::string_view digits = reader.rest();
    if (partial.tile_px < 1 || digits.size() != tiles / 4 + (tiles % 4 != 0 ? 1 : 0)) reader.fail();
    for (std::size_t i = 0; i < tiles; ++i) {
        constexpr std::string_view kDigits = "0123456789abcdef";
        const std::size_t digit = kDigits.find(digits[i / 4]);
        if (digit == std::string_view::npos) reader.fail();
        partial.done.push_back(static_cast<std::uint8_t>((digit >> (3 - i % 4)) & 1u));
    }
    return partial;
}

FilmOptions options_of(const FilmStateFields& fields) {
    FilmOptions options = parse_film_options(fields.film);
    TextReader size(fields.size, "size");
    options.width_px = size.number_and<int>("x");
    options.height_px = size.number<int>();
    if (!size.is_at_end()) size.fail();
    options.crop = parse_crop(fields.crop);
    parse_number(fields.exposure_time, "film state: exposure time", options.sensor.exposure_time_s);
    parse_number(fields.iso, "film state: iso", options.sensor.iso);
    options.sensor.observer = fields.observer;
    validate(options);
    return options;
}

}  // namespace

FilmStateFields fields_of(const FilmState& state) {
    const FilmCounts& counts = state.contents.counts;
    const FilmOptions& options = state.options;
    return {.size = fmt::format("{}x{}", options.width_px, options.height_px),
            .crop = crop_text(options.crop),
            .film = to_text(options),
            .sensor = state.sensor_text,
            .exposure_time = number_text(options.sensor.exposure_time_s),
            .iso = number_text(options.sensor.iso),
            .observer = options.sensor.observer,
            .samples = counts.samples,
            .light_splats = counts.light_splats,
            .light_paths = counts.light_paths,
            .dropped_aux = counts.dropped_aux,
            .faint = counts.faint,
            .dropped_nan = counts.dropped.count(DroppedKind::nan),
            .dropped_infinite = counts.dropped.count(DroppedKind::infinite),
            .dropped_negative_luminance = counts.dropped.count(DroppedKind::negative_luminance),
            .first_dropped = dropped_text(counts.dropped.first()),
            .clamped = counts.clamped.count,
            .removed_luminance = sum_text(counts.clamped.removed_luminance),
            .scene = state.provenance.scene,
            .sampling = state.provenance.sampling,
            .sample_ranges = to_text(state.provenance.samples),
            .partial_round = partial_text(state.provenance.partial)};
}

FilmState state_of(const FilmStateFields& fields) {
    FilmCounts counts;
    counts.samples = fields.samples;
    counts.light_splats = fields.light_splats;
    counts.light_paths = fields.light_paths;
    counts.dropped_aux = fields.dropped_aux;
    counts.faint = fields.faint;
    counts.dropped =
        DroppedSamples::restored({fields.dropped_nan, fields.dropped_infinite, fields.dropped_negative_luminance},
                                 parse_dropped(fields.first_dropped));
    counts.clamped = {fields.clamped, parse_sum(fields.removed_luminance)};
    const FilmOptions options = options_of(fields);
    return {.options = options,
            .sensor_text = fields.sensor,
            .contents = {{}, ChannelSums(FilmChannels(options), 0), counts},
            .provenance = {fields.scene, fields.sampling, parse_sample_ranges(fields.sample_ranges),
                           parse_partial(fields.partial_round)},
            .metadata = {}};
}

}  // namespace emulsion
