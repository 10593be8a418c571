// Writing a 33-megapixel (7680x4320) float picture: our write_exr beside OpenEXR's own multi-threaded OutputFile with
// the same pixels, the same compression and as many threads. They run in pairs, in turns first, so that a busy machine
// slows both. We force files to disk before they get their name, so that the baseline has an fsync too; what that takes
// is measured, and speeds are given with and without it, and by the processor time of all threads. Both files are then
// read back, and must hold the picture. Not one of Google Benchmark's: what is compared is a few long runs in pairs.
//
// bench_film_exr_write [PAIRS] [WIDTH HEIGHT] [FOLDER]: by default 5 pairs of 7680x4320 in the temporary folder.

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfThreading.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/error.h"
#include "core/named_value.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/row_blocks.h"
#include "film/exr_file.h"

namespace emulsion {
namespace {

/// Smooth shapes over four decades, with the noise of a few hundred samples a pixel.
Image<XYZ> rendered_picture(int width, int height) {
    Image<XYZ> image(width, height);
    parallel_for_rows(width, height, 0, [&](int y) {
        Pcg32 random(static_cast<std::uint64_t>(y));
        const float v = static_cast<float>(y) / static_cast<float>(height);
        for (int x = 0; x < width; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(width);
            const float luminance = std::exp(6.0f * std::sin(9.0f * u + 4.0f * v) * std::cos(7.0f * v - 2.0f * u));
            const auto noise = [&] { return 1.0f + 0.1f * (random.next_float() + random.next_float() - 1.0f); };
            image(x, y) = {0.95f * luminance * noise(), luminance * noise(), (0.3f + u) * luminance * noise()};
        }
    });
    return image;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double time_in_fsync_s = 0.0;

/// Of all threads, in the program and in the system for it: hardly depends on what else the machine does.
double processor_s() {
    ::timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Times {
    double all_s = 0.0, without_fsync_s = 0.0, processor_s = 0.0;
};

template <class Write>
Times timed(const Write& write) {
    const double before_s = time_in_fsync_s, processor_before_s = processor_s();
    const auto start = std::chrono::steady_clock::now();
    write();
    const double all_s = seconds_since(start);
    return {all_s, all_s - (time_in_fsync_s - before_s), processor_s() - processor_before_s};
}

void write_baseline(const std::filesystem::path& path, const Image<XYZ>& image, Imf::Compression compression) {
    Imf::Header header(image.width(), image.height());
    header.compression() = compression;
    Imf::FrameBuffer pixels;
    const XYZ& first = image.pixels().front();
    for (const auto& [name, place] : {std::pair("X", &first.x), std::pair("Y", &first.y), std::pair("Z", &first.z)}) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        pixels.insert(name, Imf::Slice::Make(Imf::FLOAT, place, header.dataWindow(), sizeof(XYZ),
                                             sizeof(XYZ) * static_cast<std::size_t>(image.width())));
    }
    {
        Imf::OutputFile file(path.c_str(), header, Imf::globalThreadCount());
        file.setFrameBuffer(pixels);
        file.writePixels(image.height());
    }
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0 || ::fsync(descriptor) != 0) throw IoError(path, errno_text(errno));
    ::close(descriptor);
}

bool same_bits(const Image<XYZ>& a, const Image<XYZ>& b) {
    return a.width() == b.width() && a.height() == b.height() &&
           std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size_bytes()) == 0;
}

/// Median and, in brackets, least and most.
std::string summary(std::vector<double> values, int decimals) {
    std::sort(values.begin(), values.end());
    return fmt::format("{:.{}f} [{:.{}f}, {:.{}f}]", values[values.size() / 2], decimals, values.front(), decimals,
                       values.back(), decimals);
}

struct Case {
    ExrCompression compression;
    Imf::Compression of_openexr;
};

void compare(const Case& chosen, const Image<XYZ>& image, int pairs, const std::filesystem::path& folder) {
    const std::filesystem::path ours = folder / "ours.exr", baseline = folder / "baseline.exr";
    const ExrOptions options{.compression = chosen.compression};
    std::vector<double> our_s, baseline_s, ratio, ratio_without_fsync, ratio_of_processors;
    for (int pair = 0; pair < pairs; ++pair) {
        std::filesystem::remove(ours);
        std::filesystem::remove(baseline);
        const auto write_ours = [&] { return timed([&] { write_exr(ours, image, {}, options); }); };
        Times a, b;
        if (pair % 2 == 0) a = write_ours();
        b = timed([&] { write_baseline(baseline, image, chosen.of_openexr); });
        if (pair % 2 == 1) a = write_ours();
        our_s.push_back(a.without_fsync_s);
        baseline_s.push_back(b.without_fsync_s);
        ratio.push_back(b.all_s / a.all_s);
        ratio_without_fsync.push_back(b.without_fsync_s / a.without_fsync_s);
        ratio_of_processors.push_back(b.processor_s / a.processor_s);
    }
    for (const auto& path : {ours, baseline}) {
        if (!same_bits(read_exr(path).xyz, image)) throw IoError(path, "does not hold the picture that was written");
    }
    fmt::print("{:5} {} MB; ours {} s, OpenEXR {} s without fsync\n", to_text(chosen.compression),
               std::filesystem::file_size(ours) / 1000000, summary(our_s, 2), summary(baseline_s, 2));
    fmt::print("      our speed over OpenEXR's: {}, with fsync {}, in processor time {}\n",
               summary(ratio_without_fsync, 2), summary(ratio, 2), summary(ratio_of_processors, 2));
    std::fflush(stdout);
}

int run(const std::vector<std::string>& arguments) {
    const auto number = [&](std::size_t i, int otherwise) {
        return arguments.size() > i ? std::stoi(arguments[i]) : otherwise;
    };
    const int pairs = number(0, 5), width = number(1, 7680), height = number(2, 4320);
    std::filesystem::path parent = std::filesystem::temp_directory_path();
    if (arguments.size() > 3) parent = arguments[3];
    const std::filesystem::path folder = parent / ("emulsion-exr-write-" + std::to_string(::getpid()));

    Imf::setGlobalThreadCount(hardware_threads());
    const Image<XYZ> image = rendered_picture(width, height);
    fmt::print("{}x{} float XYZ, {} threads, {} pairs; median [least, most]\n", width, height, hardware_threads(),
               pairs);
    std::filesystem::create_directory(folder);
    // The short ones take more pairs to tell.
    for (const Case& chosen : {Case{ZipCompression{}, Imf::ZIP_COMPRESSION}, Case{NoCompression{}, Imf::NO_COMPRESSION},
                               Case{PizCompression{}, Imf::PIZ_COMPRESSION}}) {
        const bool short_one = chosen.of_openexr == Imf::NO_COMPRESSION;
        compare(chosen, image, short_one ? 4 * pairs : pairs, folder);
    }
    std::filesystem::remove_all(folder);
    return EXIT_SUCCESS;
}

}  // namespace
}  // namespace emulsion

/// In the place of the C library's, for both: measures what it takes.
// NOLINTNEXTLINE(readability-inconsistent-declaration-parameter-name): the library's name is a reserved one
extern "C" int fsync(int descriptor) {
    const auto start = std::chrono::steady_clock::now();
    const auto result = static_cast<int>(::syscall(SYS_fsync, descriptor));
    emulsion::time_in_fsync_s += emulsion::seconds_since(start);
    return result;
}

int main(int count, char** arguments) {
    try {
        return emulsion::run({arguments + 1, arguments + count});
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return EXIT_FAILURE;
    }
}
