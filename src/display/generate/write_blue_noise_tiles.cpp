// write_blue_noise_tiles FILE.cpp: defines blue_noise_ranks() of display/blue_noise.h.

#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>

#include "display/blue_noise.h"
#include "display/void_and_cluster.h"

namespace {

constexpr std::uint64_t kSeed = 1;

void write_tile(std::ofstream& file, int size) {
    file << "constexpr std::uint16_t kRanks" << size << "[] = {\n";
    int column = 0;
    for (const std::uint16_t rank : emulsion::void_and_cluster(size, kSeed)) {
        file << rank << (++column % 16 == 0 ? ",\n" : ", ");
    }
    file << "};\n";
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) return 2;
    std::ofstream file(argv[1]);
    file << "// Made by src/display/generate/write_blue_noise_tiles.cpp.\n#include \"display/blue_noise.h\"\n\n"
            "namespace emulsion {\n\nnamespace {\n";
    for (const emulsion::ParameterWord& size : emulsion::kBlueNoiseSizes) write_tile(file, size.value);
    file << "}  // namespace\n\nstd::span<const std::uint16_t> blue_noise_ranks(int size) noexcept {\n"
            "    return size == 64 ? std::span<const std::uint16_t>(kRanks64) : kRanks128;\n}\n\n"
            "}  // namespace emulsion\n";
    file.close();
    if (!file) throw std::ios_base::failure(argv[1]);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "write_blue_noise_tiles: %s\n", error.what());
    return 1;
}
