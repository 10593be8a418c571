// write_sigmoid_problems FILE: what the tables of sigmoid_table.h are solved from, as doubles. For each of
// kSigmoidTableSpaces the matrix that gives white-relative XYZ, then the three sums' weights (reflectance_weights.h).
// It uses the whole library and takes no time; the solving is a program of its own, so that it need not be done again
// when something else in the library changes.

#include <cstdio>
#include <exception>
#include <fstream>
#include <span>

#include "spectrum/reflectance_weights.h"
#include "spectrum/sigmoid_table.h"

namespace {

void write(std::ofstream& file, std::span<const double> numbers) {
    const std::span<const std::byte> bytes = std::as_bytes(numbers);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) return 2;
    std::ofstream file(argv[1], std::ios::binary);
    for (const std::string_view name : emulsion::kSigmoidTableSpaces) {
        const emulsion::ReflectanceRgb space = emulsion::reflectance_rgb(emulsion::rgb_space(name));
        for (const auto& row : space.relative_xyz_from_rgb.m) write(file, row);
        for (const auto& weights : space.xyz_weights.sum) write(file, weights);
    }
    file.close();
    if (!file) throw std::ios_base::failure(argv[1]);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "write_sigmoid_problems: %s\n", error.what());
    return 1;
}
