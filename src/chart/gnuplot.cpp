#include "chart/gnuplot.h"

#include <array>
#include <cerrno>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/name_key.h"

namespace emulsion {

namespace {

/// An open file, closed with this object.
class Descriptor {
  public:
    explicit Descriptor(int descriptor) noexcept : descriptor_(descriptor) {}
    ~Descriptor() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int number() const noexcept { return descriptor_; }

  private:
    int descriptor_;
};

/// A file in memory: no name, and no reader to wait for.
int memory_file(const char* name) {
    const int descriptor = ::memfd_create(name, MFD_CLOEXEC);
    if (descriptor < 0) throw std::runtime_error("gnuplot: " + errno_text(errno));
    return descriptor;
}

void write_whole(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ::ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0) {
            if (errno == EINTR) continue;
            throw std::runtime_error("gnuplot: " + errno_text(errno));
        }
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    ::lseek(descriptor, 0, SEEK_SET);
}

std::string read_whole(int descriptor) {
    ::lseek(descriptor, 0, SEEK_SET);
    std::string text;
    std::array<char, 4096> some{};
    for (::ssize_t size = 0; (size = ::read(descriptor, some.data(), some.size())) > 0;) {
        text.append(some.data(), static_cast<std::size_t>(size));
    }
    return text;
}

/// The streams of the program that is to be run.
struct Streams {
    int input, output, errors;
};

/// \returns the state that waitpid() tells.
int run(const std::string& program, const Streams& streams) {
    ::posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, streams.input, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, streams.output, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, streams.errors, STDERR_FILENO);
    // -d: nobody's .gnuplot is read.
    std::string name = program, defaults = "-d";
    const std::array<char*, 3> arguments = {name.data(), defaults.data(), nullptr};
    ::pid_t process = 0;
    const int failure = ::posix_spawnp(&process, name.c_str(), &actions, nullptr, arguments.data(), ::environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (failure == ENOENT) {
        throw std::runtime_error(program + ": not found in PATH; Debian's package gnuplot-nox has it");
    }
    if (failure != 0) throw std::runtime_error(program + ": " + errno_text(failure));
    int state = 0;
    while (::waitpid(process, &state, 0) < 0) {
        if (errno != EINTR) throw std::runtime_error(program + ": " + errno_text(errno));
    }
    return state;
}

void check_success(const std::string& program, int state, const Descriptor& errors) {
    if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return;
    const std::string words = read_whole(errors.number());
    throw std::runtime_error(fmt::format("{} failed: {}", program, words.empty() ? "it does not say why" : words));
}

}  // namespace

ChartFormat chart_format(const std::filesystem::path& name) {
    const std::string ending = name_key(name.extension().string());
    if (ending == name_key(".svg")) return ChartFormat::svg;
    if (ending == name_key(".png")) return ChartFormat::png;
    throw std::invalid_argument("chart: found \"" + name.string() + "\", expected a name ending in .svg or .png");
}

void check_gnuplot(const std::string& program) {
    const Descriptor input(memory_file("script")), output(memory_file("output")), errors(memory_file("errors"));
    check_success(program, run(program, {input.number(), output.number(), errors.number()}), errors);
}

void draw_chart(const Chart& chart, const std::filesystem::path& file, const std::string& program) {
    const std::string script = gnuplot_script(chart, chart_format(file));
    AtomicFile drawn(file);
    const Descriptor output(::open(drawn.temporary_path().c_str(), O_WRONLY | O_CLOEXEC));
    if (output.number() < 0) throw IoError(file, errno_text(errno));
    const Descriptor input(memory_file("script")), errors(memory_file("errors"));
    write_whole(input.number(), script);
    const int state = run(program, {input.number(), output.number(), errors.number()});
    check_success(program, state, errors);
    if (::lseek(output.number(), 0, SEEK_END) == 0) {
        throw IoError(file, program + " drew nothing: " + read_whole(errors.number()));
    }
    drawn.commit();
}

}  // namespace emulsion
