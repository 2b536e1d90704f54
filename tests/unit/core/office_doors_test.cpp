// Tests an office with as many doors as a large building has, in a session. The hand finds each door shut, the Use key
// opens the door, and then the hand passes.
#include "app/core/world/entering.h"
#include "haptic/render/proxy_solver.h"
#include "haptic/servo/body_playback.h"
#include "tests/support/names.h"
#include "tests/support/office_world.h"
#include "tests/support/scale.h"
#include "tests/support/solver_probe.h"
#include "tests/unit/core/app_session.h"

namespace handrail::test {
namespace office_doors_test {

// A simulated hand for the session, which feels the scene that the session sends to the servo.
struct Hand {
    explicit Hand(AppSession& s) : session(s) { tuning.radius_m = 0.005; }
    // Moves straight from one place to the other within half a second, beginning with a new proxy. Returns what the
    // hand feels at the end.
    TouchResult goes(const Vec3& from_m, const Vec3& to_m) {
        constexpr int kTicks = 50;
        state.reset();
        const auto scene = session.app.haptic_scene();
        TouchResult felt;
        for (int i = 0; i <= kTicks; ++i) {
            const BodyPoses poses = playback.at(session.app.bodies(), *scene, session.now, i == 0);
            felt = touch_tick(state, *scene, tuning, from_m + (to_m - from_m) * (static_cast<double>(i) / kTicks), 1e-3,
                              Vec3(0.0), poses);
            most_followed = std::max(most_followed, SolverProbe(state.solver()).tracked());
            most_work = std::max(most_work, SolverProbe(state.solver()).work());
        }
        return felt;
    }
    AppSession& session;
    TouchTuning tuning;
    TouchState state;
    BodyPlayback playback;
    std::size_t most_followed = 0;
    int most_work = 0;
};

TEST(OfficeDoors, let_every_twentieth_of_two_thousand_open_to_the_hand) {
    const OfficeSize size{4, 10, 25, 0, 1};
    const OfficeWorld office = office_world(size);
    ASSERT_EQ(office.doors, 2000);
    auto read = read_quake_map(office.map, "office.map");
    ASSERT_TRUE(read) << read.error().sentence();
    Settings settings;
    settings.haptic.edge_rounding_mm = 0.0;
    AppSession session(settings, {}, {.executor = on_threads()});
    session.app.apply(WorldEntered{make_ready_to_touch(std::make_shared<const Scene>(std::move(*read)))}, 0.0);
    struct Door {
        FeatureId feature;
        Vec3 middle_m, through;  // unit vector along the thin side of the leaf
    };
    std::vector<Door> doors;
    // Only some doors are tried, because all of them would cost half a minute of computing. They differ only in their
    // distance from the first door.
    const auto every = static_cast<std::size_t>(20.0 / kSanitizerScale);
    const auto scene = session.app.scene();
    ASSERT_EQ(scene->movers.size(), 2000U);
    for (std::size_t i = 0; i < scene->movers.size(); i += every) {
        const Aabb& leaf = scene->features[scene->movers[i].feature.value].bounds_m;
        const Vec3 size_m = leaf.size_m();
        doors.push_back(
            {scene->movers[i].feature, leaf.centre_m(), size_m.x < size_m.y ? Vec3(1, 0, 0) : Vec3(0, 1, 0)});
    }
    Hand hand(session);
    for (const Door& door : doors) {
        const TouchResult shut = hand.goes(door.middle_m - door.through * 0.3, door.middle_m);
        ASSERT_EQ(shut.contacts.count, 1);
        ASSERT_EQ(shut.contacts.contacts[0].feature, door.feature);
        const double floor_m = door.middle_m.z - 0.5 * scene->features[door.feature.value].bounds_m.size_m().z;
        const Vec3 feet(door.middle_m.x - 0.7 * door.through.x, door.middle_m.y - 0.7 * door.through.y, floor_m);
        session.app.apply(Placed{feet, door.through.x > 0.5 ? 0.5 * kPi : 0.0}, session.now);
        session.tap(Command::Use, 0.0);
    }
    session.run(5.0);
    for (const Door& door : doors) {
        const Vec3 beyond = door.middle_m + door.through * 0.3;
        const TouchResult open = hand.goes(door.middle_m - door.through * 0.3, beyond);
        ASSERT_EQ(open.contacts.count, 0) << door.middle_m.x << " " << door.middle_m.y << " " << door.middle_m.z;
        ASSERT_EQ(open.proxy_m, beyond);
    }
    EXPECT_LT(hand.most_followed, 16U);
    EXPECT_LE(hand.most_work, ProxySolver::kMostWork);
}

}  // namespace office_doors_test
}  // namespace handrail::test
