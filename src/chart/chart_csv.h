#pragma once
// Charts as comma-separated values: all that a chart holds, so that one can be drawn again without measuring again.
//
//     # chart,NAME,TITLE,NOTE
//     # panel,TITLE,x,LABEL,UNIT,log,low,LEAST_DRAWN,y,LABEL,UNIT,log,low,LEAST_DRAWN,joined
//     panel,series,label,x,x_p25,x_p75,y,y_p25,y_p75,front,details
//     D65,hero-visible,4,1.5,1.4,1.6,0.02,0.02,0.02,1,ns=12.5;Mpix/s=3
//
// One line starting with "# panel" for each panel, in their order; then one row a point, which names its panel by the
// title. Numbers are as short as reads back the same. What holds a comma, a quote or a line break is in double quotes.

#include <filesystem>
#include <string>

#include "chart/chart.h"

namespace emulsion {

[[nodiscard]] std::string to_csv(const Chart& chart);

/// \param name of the text in errors \throws IoError naming the line and what was expected there.
[[nodiscard]] Chart parse_chart_csv(const std::string& text, const std::filesystem::path& name);

}  // namespace emulsion
