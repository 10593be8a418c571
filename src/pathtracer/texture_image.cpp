#include "pathtracer/texture_image.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/visit.h"
#include "pathtracer/texture_enlarge.h"

namespace emulsion {

namespace {

/// The linear values of the codes of 8 bits, to which linear values are rounded.
class ByteCodes {
  public:
    explicit ByteCodes(const TextureEncoding& encoding) {
        const auto decoded = [&](double code) {
            return static_cast<float>(
                visit_noexcept([&](const auto& chosen) noexcept { return decode(chosen, code / 255.0); }, encoding));
        };
        for (std::size_t i = 0; i < value_.size(); ++i) value_[i] = decoded(static_cast<double>(i));
        for (std::size_t i = 0; i < end_.size(); ++i) end_[i] = decoded(static_cast<double>(i) + 0.5);
    }
    [[nodiscard]] float rounded(float linear) const noexcept {
        const auto* const end = std::upper_bound(end_.begin(), end_.end(), linear);
        return value_[static_cast<std::size_t>(end - end_.begin())];
    }
    [[nodiscard]] RGB rounded(const RGB& linear) const noexcept {
        return {rounded(linear.r), rounded(linear.g), rounded(linear.b)};
    }

  private:
    std::array<float, 256> value_{};
    std::array<float, 255> end_{};  // where the next code begins
};

template <class Texel>
void enlarge(Image<Texel>& texels, TextureWrap wrap, const std::optional<TextureEncoding>& byte_codes) {
    if (has_sides_of_powers_of_two(texels)) return;
    texels = enlarged_to_powers_of_two(texels, wrap);
    if (!byte_codes) return;
    const ByteCodes codes(*byte_codes);
    for (Texel& texel : texels.pixels()) texel = codes.rounded(texel);
}

}  // namespace

RgbTexels read_rgb_texels(const std::filesystem::path& path, std::string_view bytes, const TextureEncoding& encoding,
                          std::optional<TextureWrap> wrap) {
    DecodedPicture picture = read_picture(path, bytes, encoding);
    if (wrap) enlarge(picture.rgb, *wrap, picture.byte_codes);
    return {std::move(picture.rgb), picture.space, std::move(picture.note)};
}

Image<float> read_number_texels(const std::filesystem::path& path, std::string_view bytes,
                                const TextureEncoding& encoding, TextureFilter filter,
                                std::optional<TextureWrap> wrap) {
    DecodedPicture picture = read_picture(path, bytes, encoding);
    if (picture.alpha && filter == TextureFilter::bilinear) {
        if (wrap) enlarge(*picture.alpha, *wrap, picture.byte_codes);
        return std::move(*picture.alpha);
    }
    if (wrap) enlarge(picture.rgb, *wrap, picture.byte_codes);
    Image<float> numbers(picture.rgb.width(), picture.rgb.height(), UnsetPixels{});
    std::ranges::transform(picture.rgb.pixels(), numbers.pixels().begin(), [&](const RGB& rgb) {
        return filter == TextureFilter::bilinear ? (rgb.r + rgb.g + rgb.b) / 3.0f : rgb.r;
    });
    return numbers;
}

}  // namespace emulsion
