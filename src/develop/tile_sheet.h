#pragma once
// Pictures of one size side by side, each with its label below.

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/image.h"
#include "develop/pipeline.h"
#include "display/code_value.h"

namespace emulsion {

/// What a tile takes with its label and the margins around it.
struct TileCell {
    int width, height;  ///< px
};

/// Of tiles of width x height pixels, at least 1, and of these labels.
[[nodiscard]] TileCell tile_cell(int width, int height, std::span<const std::string> labels) noexcept;

/// What the sheet itself is made of.
struct SheetGreys {
    CodeRGB background, ink;
};

/// The background has 2% of the luminance of white, the labels 72%: as codes on the display of the pipeline.
/// \throws std::invalid_argument if display or transfer function aren't valid.
[[nodiscard]] SheetGreys sheet_greys(const Pipeline& pipeline);

/// About the same for codes that stand for no light, such as those of plates: shares of the range.
[[nodiscard]] SheetGreys sheet_greys(const CodeScale& scale) noexcept;

/// A sheet of dark grey that is filled tile by tile, row by row.
class TileSheet {
  public:
    /// A place for each of the labels (display/label.h says which letters there are).
    /// \param width and \param height of all tiles, in px, at least 1 \param columns at least 1
    TileSheet(int width, int height, std::vector<std::string> labels, int columns, const SheetGreys& greys);

    /// Puts the next tile into its place, and its label below. Not more often than there are labels.
    void add(const Image<CodeRGB>& tile);

    [[nodiscard]] const Image<CodeRGB>& picture() const& noexcept { return sheet_; }
    [[nodiscard]] Image<CodeRGB> picture() && noexcept { return std::move(sheet_); }

  private:
    std::vector<std::string> labels_;
    TileCell cell_;
    int columns_, tile_height_;
    CodeRGB ink_;
    std::size_t next_ = 0;
    Image<CodeRGB> sheet_;
};

}  // namespace emulsion
