// Defines a new feature of the session: a class that uses the session's context. The test needs no full session.
// docs/developer/examples.md describes this example.
#include <gmock/gmock.h>

#include "app/core/context/session_part.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace new_feature_test {

// Counts the walker's steps. A feature owns its state and accesses the session through the context. It can be neither
// copied nor moved, because open lists may hold its address. Only the app thread uses it.
class StepCount : SessionPart {
public:
    explicit StepCount(const SessionContext& context) : SessionPart(context) {}

    void enter_world() {
        walked_m_ = 0.0;
        was_m_ = context_.avatar.feet_m();
    }
    // The session calls this once a tick. If the walker is farther away than a step, the walker did not walk: something
    // placed it there.
    void tick() {
        const Vec3 off = context_.avatar.feet_m() - was_m_;
        const double moved_m = std::hypot(off.x, off.y);
        if (moved_m < context_.settings.walk.step_length_m) walked_m_ += moved_m;
        was_m_ = context_.avatar.feet_m();
    }
    // Returns false if the command belongs to another feature. This example borrows a command; a real feature has its
    // own.
    bool act(Command command, double now_s) {
        if (command != Command::ProgressReport) return false;
        context_.answer(std::to_string(std::lround(walked_m_ / context_.settings.walk.step_length_m)), now_s);
        return true;
    }

private:
    double walked_m_ = 0.0;
    Vec3 was_m_{0.0};
};

TEST(NewFeature, counts_steps_without_a_full_session) {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor");
    test::PlainSession plain(builder.share());
    StepCount steps(plain.context);
    steps.enter_world();
    const double step_m = plain.person.settings.walk.step_length_m;
    const auto walk = [&](const Vec3& to_m) {
        plain.avatar.walker->place(to_m);
        steps.tick();
    };
    const Vec3 from_m = plain.avatar.feet_m();
    for (int i = 1; i <= 20; ++i) walk(from_m + Vec3(0.0, 0.5 * step_m * i, 0.0));
    walk(from_m + Vec3(5.0, 0.0, 0.0));  // too far for a step, so the walker was placed there
    EXPECT_FALSE(steps.act(Command::Exits, 0.0)) << "another's command";
    EXPECT_TRUE(steps.act(Command::ProgressReport, 0.0));
    EXPECT_THAT(plain.said(), testing::ElementsAre("10"));
}

}  // namespace new_feature_test
}  // namespace handrail
