#include "cli/color_command.h"

#include <algorithm>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/color_tasks.h"
#include "cli/messages.h"

namespace emulsion::cli {

struct ColorCommand::Tasks {
    std::vector<ColorTask> all;
};

ColorCommand::ColorCommand(CLI::App& program)
    : command_(program.add_subcommand("color", "Colorimetry: convert, compare and describe colours and spectra")),
      tasks_(std::make_unique<Tasks>()) {
    command_->require_subcommand(1);
    for (const auto add : {add_color_convert, add_color_spectrum, add_color_difference, add_color_adapt,
                           add_color_encode, add_color_decode, add_color_matrix, add_color_list}) {
        tasks_->all.push_back(add(*command_));
    }
}

ColorCommand::~ColorCommand() = default;

bool ColorCommand::chosen() const { return command_->parsed(); }

int ColorCommand::run() const {
    const auto chosen = std::find_if(tasks_->all.begin(), tasks_->all.end(),
                                     [](const ColorTask& task) { return task.command->parsed(); });
    chosen->run();
    return kDone;
}

}  // namespace emulsion::cli
