// solve_sigmoid_tables PROBLEMS FILE: the tables of sigmoid_table.h as floats, for every space that
// write_sigmoid_problems wrote.

#include <cstdio>
#include <exception>
#include <fstream>
#include <span>
#include <string>

#include "spectrum/sigmoid_table.h"
#include "spectrum/sigmoid_table_solver.h"

namespace {

void read(std::ifstream& file, std::span<double> numbers) {
    const std::span<std::byte> bytes = std::as_writable_bytes(numbers);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file) throw std::ios_base::failure("the problems end too early");
}

void write(std::ofstream& file, std::span<const float> numbers) {
    const std::span<const std::byte> bytes = std::as_bytes(numbers);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3) return 2;
    std::ifstream problems(argv[1], std::ios::binary);
    std::ofstream file(argv[2], std::ios::binary);
    for (std::size_t i = 0; i < emulsion::kSigmoidTableSpaces.size(); ++i) {
        emulsion::Matrix3 relative_xyz_from_rgb;
        emulsion::ReflectanceWeights xyz_weights;
        for (auto& row : relative_xyz_from_rgb.m) read(problems, row);
        for (auto& weights : xyz_weights.sum) {
            weights.resize(emulsion::kWholeNanometres);
            read(problems, weights);
        }
        write(file,
              emulsion::solve_sigmoid_table(xyz_weights, relative_xyz_from_rgb, emulsion::kSigmoidTableResolution));
    }
    file.close();
    if (!file) throw std::ios_base::failure(argv[2]);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "solve_sigmoid_tables: %s\n", error.what());
    return 1;
}
