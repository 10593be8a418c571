#pragma once
// A folder of its own for each test of atomic files.

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "support/temporary_folder.h"

namespace emulsion {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
  protected:
    [[nodiscard]] const fs::path& folder() const { return folder_.path(); }
    [[nodiscard]] std::vector<std::string> names() const { return folder_.names(); }

  private:
    TemporaryFolder folder_;
};

/// The same for files without a name and with a hidden one.
class EitherAtomicFile : public AtomicFileTest, public testing::WithParamInterface<TemporaryName> {};

inline std::string name_of(const testing::TestParamInfo<TemporaryName>& info) {
    return info.param == TemporaryName::none ? "WithoutAName" : "WithAHiddenName";
}

inline auto throws_io_error(const std::string& reason) {
    return testing::Throws<IoError>(testing::Property(&IoError::reason, testing::HasSubstr(reason)));
}

}  // namespace emulsion
