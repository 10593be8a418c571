// What README.md tells people to type works.

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "run_program.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::SizeIs;

const std::string kProgram = "build/release/bin/emulsion";

/// The lines of README.md that start with the program, as words. None of them has quotes or a comment.
std::vector<std::vector<std::string>> readme_commands() {
    std::istringstream readme(read_text(EMULSION_SOURCE_DIR "/README.md"));
    std::vector<std::vector<std::string>> commands;
    for (std::string line; std::getline(readme, line);) {
        std::istringstream words(line);
        std::string word;
        if (!(words >> word) || word != kProgram) continue;
        EXPECT_EQ(line.find_first_of("'\"#\\`$|>"), std::string::npos) << "this test can't read: " << line;
        std::vector<std::string>& arguments = commands.emplace_back();
        while (words >> word) arguments.push_back(word);
    }
    return commands;
}

TEST(Readme, CommandsWriteTheFilesThatTheyName) {
    const auto commands = readme_commands();
    ASSERT_THAT(commands, ::testing::Not(::testing::IsEmpty()));
    const TemporaryFolder out;
    std::vector<std::string> outputs;
    for (std::vector<std::string> arguments : commands) {
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            if (!arguments[i].starts_with("out/")) continue;
            arguments[i] = out.file(arguments[i].substr(4));
            const std::string& flag = arguments[i - 1];
            if (flag == "-o" || flag == "--png" || flag == "--contact-sheet" || flag == "--map" || flag == "--csv") {
                outputs.push_back(arguments[i]);
            }
        }
        // As typed, but small; of an option given twice CLI11 would take neither.
        if (arguments[0] == "render" || arguments[0] == "compare") {
            for (const auto& [flag, value] : {std::pair{"--spp", "2"}, std::pair{"--resolution", "16x16"}}) {
                const auto given = std::find(arguments.begin(), arguments.end(), flag);
                if (given != arguments.end()) {
                    *std::next(given) = value;
                } else {
                    arguments.insert(arguments.end(), {flag, value});
                }
            }
        }
        const auto in_repository = [] {
            if (::chdir(EMULSION_SOURCE_DIR) != 0) ::_exit(126);
        };
        const ProgramResult result = run_program(arguments, {.before = in_repository});
        EXPECT_EQ(result.exit_code, 0) << ::testing::PrintToString(arguments) << result.err;
    }
    for (const std::string& output : outputs) EXPECT_TRUE(std::filesystem::exists(output)) << output;
    EXPECT_THAT(out.names(), SizeIs(outputs.size()));
}

}  // namespace
}  // namespace emulsion::testing
