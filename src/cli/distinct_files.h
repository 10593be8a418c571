#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace emulsion::cli {

/// A file of the command line: the argument that names it, and its path; empty if it was not given.
struct NamedFile {
    std::string argument;
    std::filesystem::path path;
};

/// That no output lands on an input or on another output, by whatever names they go.
/// \throws CLI::ValidationError naming the later of two that are one file.
void require_distinct(const std::vector<NamedFile>& files);

}  // namespace emulsion::cli
