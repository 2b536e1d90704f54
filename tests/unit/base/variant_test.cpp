#include "worlds/base/variant.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace handrail {
namespace {

struct CannotBeCopied {
    CannotBeCopied() = default;
    CannotBeCopied(CannotBeCopied&&) noexcept = default;
    CannotBeCopied& operator=(CannotBeCopied&&) noexcept = default;
    CannotBeCopied(const CannotBeCopied&) { throw 1; }
    CannotBeCopied& operator=(const CannotBeCopied&) { throw 1; }
    ~CannotBeCopied() = default;
};
using Held = CopyableVariant<bool, std::string, std::vector<CannotBeCopied>>;

// If copying its value fails, std::variant becomes valueless, and visiting it would jump to a random address.
TEST(Variant, stays_valid_if_copying_its_value_fails) {
    const Held full(std::vector<CannotBeCopied>(1));
    EXPECT_THROW(Held{full}, int);
    Held text(std::string("kept"));
    EXPECT_THROW(text = full, int);
    EXPECT_EQ(std::get<std::string>(text), "kept");
}

TEST(Variant, is_copied_moved_compared_and_visited_like_a_standard_variant) {
    CopyableVariant<bool, double, std::string> one(std::string("word"));
    const auto two = one;
    EXPECT_EQ(one, two);
    const auto three = std::move(one);
    EXPECT_EQ(three, two);
    one = 2.5;
    EXPECT_NE(one, two);
    EXPECT_EQ(std::get<double>(one), 2.5);
    one = two;
    EXPECT_EQ(std::visit([](const auto& held) { return std::is_same_v<decltype(held), const std::string&>; }, one),
              true);
}

}  // namespace
}  // namespace handrail
