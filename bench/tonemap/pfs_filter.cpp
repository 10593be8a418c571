// An operator as a program in a pipe of pfstools, so that whole processes can be compared: the same stream in, the same
// stream out (whole_process.sh).
//
//     pfsinexr in.exr | bench_tonemap_pfs_filter drago | pfsoutexr out.exr
//
// One frame with the channels X, Y and Z.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

constexpr std::array kChannels = {&XYZ::x, &XYZ::y, &XYZ::z};

/// Lines of text, "PFS1" and "7680 4320" the first of them, up to "ENDH", right behind which the numbers start.
std::string read_header() {
    std::string header;
    while (!header.ends_with("\nENDH")) {
        const int byte = std::getchar();
        if (byte == EOF) throw std::runtime_error("the stream ends in its header");
        header += static_cast<char>(byte);
    }
    for (const char* channel : {"\nX\n", "\nY\n", "\nZ\n"}) {
        if (header.find(channel) == std::string::npos) throw std::runtime_error("the channels are not X, Y and Z");
    }
    return header;
}

/// One channel after the other, each row by row.
Image<XYZ> read_pixels(int width, int height) {
    Image<XYZ> picture(width, height);
    std::vector<float> row(static_cast<std::size_t>(width));
    for (const auto channel : kChannels) {
        for (int y = 0; y < height; ++y) {
            if (std::fread(row.data(), sizeof(float), row.size(), stdin) != row.size()) {
                throw std::runtime_error("the stream ends in its pixels");
            }
            for (std::size_t x = 0; x < row.size(); ++x) picture.row(y)[x].*channel = row[x];
        }
    }
    return picture;
}

void write_pixels(const Image<XYZ>& picture) {
    std::vector<float> row(static_cast<std::size_t>(picture.width()));
    for (const auto channel : kChannels) {
        for (int y = 0; y < picture.height(); ++y) {
            for (std::size_t x = 0; x < row.size(); ++x) row[x] = picture.row(y)[x].*channel;
            if (std::fwrite(row.data(), sizeof(float), row.size(), stdout) != row.size()) {
                throw std::runtime_error("cannot write");
            }
        }
    }
}

void filter(const std::string& operator_text) {
    const auto mapper = parse_named<ToneMapper>(operator_text, "tonemap");
    const std::string header = read_header();
    int width = 0, height = 0;
    if (std::sscanf(header.c_str(), "PFS1\n%d %d", &width, &height) != 2) throw std::runtime_error("no PFS stream");
    Image<XYZ> picture = read_pixels(width, height);
    tone_map_into({mapper}, picture.view(), picture.view(), {0.95f, 1.0f, 1.09f}, 0);
    std::fwrite(header.data(), 1, header.size(), stdout);
    write_pixels(picture);
}

}  // namespace
}  // namespace emulsion

int main(int argc, char** argv) {
    try {
        if (argc != 2) throw std::invalid_argument("usage: bench_tonemap_pfs_filter OPERATOR");
        emulsion::filter(argv[1]);
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_tonemap_pfs_filter: %s\n", error.what());
        return EXIT_FAILURE;
    }
}
