// Tests how drivers limit and convert a force just before they send it, and the bytes that each driver sends.
#include "haptic/drivers/force_packing.h"

#include <limits>
#include <random>

#include "haptic/drivers/ff_link.h"
#include "haptic/drivers/force_stick.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/scale.h"

namespace handrail {
namespace force_packing_test {

constexpr double kInf = std::numeric_limits<double>::infinity();

// A link that keeps the last effect that it received. The angle `towards_rad` is the kernel's: 0 is towards the person,
// and angles grow clockwise.
class KeepingLink final : public FfLink {
public:
    struct Sent {
        double level = 0.0, towards_rad = 0.0;
    };
    explicit KeepingLink(Sent& sent) : sent_(sent) {}
    FfAbilities abilities() const override { return {.rumble = false, .constant = true, .gain = true, .stick = true}; }
    bool rumble(double, double) noexcept override { return false; }
    bool constant(double level, double towards_rad) noexcept override {
        sent_ = {level, towards_rad};
        return true;
    }
    bool stop() noexcept override { return true; }
    bool gain(double) noexcept override { return true; }
    bool poll(Stick&) noexcept override { return true; }

private:
    Sent& sent_;
};

// Returns a force whose axes differ by up to 600 orders of magnitude, so that some components are nearly zero compared
// with others.
Vec3 any_force(std::mt19937& random) {
    std::uniform_real_distribution<double> power(-300.0, 300.0), sign(-1.0, 1.0);
    const auto axis = [&] { return std::copysign(std::pow(10.0, power(random)), sign(random)); };
    return {axis(), axis(), axis()};
}

TEST(ForcePacking, any_force_stays_within_the_peak_and_keeps_its_direction) {
    const unsigned seed = 41;
    std::mt19937 random(seed);
    for (int i = 0; i < test::scaled(100000); ++i) {
        const Vec3 force = any_force(random);
        const Vec3 held = held_to(force, 3.0);
        ASSERT_TRUE(is_finite(held));
        ASSERT_LE(glm::length(held), 3.0 * (1.0 + 1e-15)) << "seed " << seed << ", " << i;
        const double largest = std::max({std::abs(force.x), std::abs(force.y), std::abs(force.z)});
        if (largest < 1.0) {
            ASSERT_EQ(held, force) << "a weak force is left alone; seed " << seed << ", " << i;
            continue;
        }
        const double scale = std::max({std::abs(held.x), std::abs(held.y), std::abs(held.z)}) / largest;
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_NEAR(held[axis], scale * force[axis], 1e-14) << "seed " << seed << ", " << i;
    }
    for (const double newtons : {1e9, 1e300, 1.7e308})
        EXPECT_NEAR(glm::length(held_to({newtons, -newtons, newtons}, 3.0)), 3.0, 1e-14);
}

TEST(ForcePacking, of_an_invalid_number_gives_no_force) {
    for (const double odd : {std::nan(""), kInf, -kInf})
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 force{1.0, -2.0, 0.5};
            force[axis] = odd;
            EXPECT_EQ(held_to(force, 3.0), Vec3(0.0));
            EXPECT_EQ(held_to({1.0, 0.0, 0.0}, odd > 0.0 ? 0.0 : odd), Vec3(0.0))
                << "nor is there any where the peak is none";
        }
}

TEST(ForceStick, level_stays_in_range_and_keeps_its_direction_for_any_request) {
    KeepingLink::Sent sent;
    ForceStick stick(std::make_unique<KeepingLink>(sent));
    ASSERT_TRUE(stick.open());
    std::mt19937 random(42);
    for (int i = 0; i < test::scaled(20000); ++i) {
        const Vec3 force = any_force(random);
        stick.write({force});
        ASSERT_TRUE(sent.level >= 0.0 && sent.level <= 1.0 + 1e-12) << sent.level;
        if (std::max(std::abs(force.x), std::abs(force.y)) < 1e-3) continue;
        const double largest = std::max(std::abs(force.x), std::abs(force.y));
        const double length = std::hypot(force.x / largest, force.y / largest);
        ASSERT_NEAR(-std::sin(sent.towards_rad), force.x / largest / length, 1e-9);
        ASSERT_NEAR(-std::cos(sent.towards_rad), force.y / largest / length, 1e-9);
    }
    for (const double odd : {std::nan(""), kInf, -kInf})
        for (int axis = 0; axis < 3; ++axis) {
            stick.write({{1.0, 0.0, 0.0}});
            ASSERT_GT(sent.level, 0.3);
            Vec3 force{1.0, 1.0, 1.0};
            force[axis] = odd;
            stick.write({force});
            EXPECT_EQ(sent.level, 0.0);
        }
}

}  // namespace force_packing_test
}  // namespace handrail
