#include "core/visit.h"

#include <string>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

struct Size {
    std::size_t operator()(const std::string& text) const noexcept { return text.size(); }
    std::size_t operator()(int number) const noexcept { return static_cast<std::size_t>(number); }
    std::size_t operator()(bool) const noexcept { return 1000; }
};

TEST(VisitNoexcept, CallsTheVisitorWithTheValue) {
    using Value = std::variant<int, std::string, bool>;
    EXPECT_EQ(visit_noexcept(Size{}, Value(7)), 7u);
    EXPECT_EQ(visit_noexcept(Size{}, Value(std::string("four"))), 4u);
    EXPECT_EQ(visit_noexcept(Size{}, Value(true)), 1000u);
    static_assert(noexcept(visit_noexcept(Size{}, Value(7))));
}

}  // namespace
}  // namespace emulsion
