#pragma once
// Drawing of charts by gnuplot: Debian's gnuplot-nox, looked up in PATH when a chart is drawn. This is the one place
// that starts another program; no shell is between, and what gnuplot reads and writes goes through memory and the file
// that is drawn.

#include <filesystem>
#include <string>
#include <string_view>

#include "chart/chart.h"

namespace emulsion {

enum class ChartFormat { svg, png };

/// By the ending of the name, ".svg" or ".png", in any letters. \throws std::invalid_argument for others.
[[nodiscard]] ChartFormat chart_format(const std::filesystem::path& name);

/// What gnuplot is told, 900 pixels wide; it draws to its standard output. Points on the Pareto front are filled and
/// joined, the others are hollow; bars are from p25 to p75. Colours are those of Okabe & Ito, "Color Universal Design",
/// 2008, which all kinds of colour vision tell apart, and series have signs of their own besides.
/// \throws std::invalid_argument as validate(Chart)
[[nodiscard]] std::string gnuplot_script(const Chart& chart, ChartFormat format);

/// Finds out whether the program is there: for saying so before minutes of measuring, not after.
/// \throws std::runtime_error as draw_chart() does.
void check_gnuplot(const std::string& program = "gnuplot");

/// Draws a chart. The file appears whole or not at all.
/// \param program to run, looked up in PATH
/// \throws std::runtime_error if there is no such program, naming Debian's package; and if it fails, with its words.
/// \throws IoError if the file can't be written; std::invalid_argument as chart_format() and validate(Chart).
void draw_chart(const Chart& chart, const std::filesystem::path& file, const std::string& program = "gnuplot");

}  // namespace emulsion
