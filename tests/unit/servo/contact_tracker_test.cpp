#include "haptic/servo/contact_tracker.h"

#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace contact_tracker_test {

constexpr double kTick = 1e-3;
constexpr FeatureId kWall{4}, kFloor{5}, kPool{6};

TouchResult touching(std::initializer_list<FeatureId> features, const Vec3& slide_m = Vec3(0.0)) {
    TouchResult touch;
    touch.slide_m = slide_m;
    touch.contact_force_n = Vec3(0, 0, 1);
    for (const FeatureId feature : features) {
        Contact& contact = touch.contacts.contacts[touch.contacts.count++];
        contact.feature = feature;
        contact.normal = Vec3(0, 0, 1);
        contact.share = 1.0 / static_cast<double>(features.size());
    }
    return touch;
}

struct Bench {
    ContactTracker tracker;
    double now_s = 0.0;
    std::vector<ContactEvent> seen;

    void tick(const TouchResult& touch, const Vec3& velocity = Vec3(0.0), double scale = 1.0) {
        now_s += kTick;
        TickEvents events;
        tracker.update(touch, velocity, scale, now_s, kTick, events);
        seen.insert(seen.end(), events.begin(), events.end());
    }
    int count(ContactEventKind kind, FeatureId feature) const {
        return static_cast<int>(std::count_if(
            seen.begin(), seen.end(), [&](const ContactEvent& e) { return e.kind == kind && e.feature == feature; }));
    }
};

TEST(ContactTracker, reports_the_start_with_the_approach_speed_and_the_end_20_ms_after_leaving) {
    Bench bench;
    bench.tick(touching({}), Vec3(0.3, 0, -0.1));
    EXPECT_TRUE(bench.seen.empty());
    bench.tick(touching({kWall}), Vec3(0.3, 0, -0.1));
    ASSERT_EQ(bench.seen.size(), 1u);
    EXPECT_EQ(bench.seen[0].kind, ContactEventKind::Begin);
    EXPECT_NEAR(bench.seen[0].speed_m_per_s, 0.1, 1e-12);
    EXPECT_NEAR(bench.seen[0].force_n, 1.0, 1e-12);
    EXPECT_EQ(bench.seen[0].time_s, bench.now_s);
    for (int i = 0; i < 500; ++i) bench.tick(touching({kWall}));
    EXPECT_EQ(bench.seen.size(), 1u);
    const double left_s = bench.now_s;
    for (int i = 0; i < 40; ++i) bench.tick(touching({}));
    ASSERT_EQ(bench.seen.size(), 2u);
    EXPECT_EQ(bench.seen[1].kind, ContactEventKind::End);
    EXPECT_NEAR(bench.seen[1].time_s - left_s, ContactTracker::kLetGoS, 1.5 * kTick);
}

TEST(ContactTracker, reports_trembling_at_a_surface_as_one_contact) {
    Bench bench;
    for (int i = 0; i < 2000; ++i) bench.tick(i % 15 < 3 ? touching({kWall}) : touching({}));
    EXPECT_EQ(bench.count(ContactEventKind::Begin, kWall), 1);
    EXPECT_EQ(bench.count(ContactEventKind::End, kWall), 0);
}

TEST(ContactTracker, reports_sliding_every_10_ms_with_hand_speed_and_its_end_once) {
    Bench bench;
    const double scale = 60.0;
    // At scale 60, the hand's 5 cm/s are 3 m/s in the world, which is 3 mm per tick. The motion along the normal must
    // not count as sliding.
    for (int i = 0; i < 1000; ++i) bench.tick(touching({kWall}, Vec3(3e-3, 0, 5e-3)), Vec3(0.0), scale);
    EXPECT_NEAR(bench.count(ContactEventKind::Slide, kWall), 100, 2);
    EXPECT_NEAR(bench.seen.back().speed_m_per_s, 0.05, 1e-4);
    for (int i = 0; i < 200; ++i) bench.tick(touching({kWall}), Vec3(0.0), scale);
    EXPECT_EQ(bench.seen.back().kind, ContactEventKind::Slide);
    EXPECT_EQ(bench.seen.back().speed_m_per_s, 0.0);
    const std::size_t reported = bench.seen.size();
    for (int i = 0; i < 200; ++i) bench.tick(touching({kWall}), Vec3(0.0), scale);
    EXPECT_EQ(bench.seen.size(), reported);
}

TEST(ContactTracker, follows_several_surfaces_at_once) {
    Bench bench;
    bench.tick(touching({kFloor}));
    bench.tick(touching({kFloor, kWall}));
    for (int i = 0; i < 30; ++i) bench.tick(touching({kWall}));
    EXPECT_EQ(bench.count(ContactEventKind::Begin, kFloor), 1);
    EXPECT_EQ(bench.count(ContactEventKind::Begin, kWall), 1);
    EXPECT_EQ(bench.count(ContactEventKind::End, kFloor), 1);
    EXPECT_EQ(bench.count(ContactEventKind::End, kWall), 0);
}

TEST(ContactTracker, begin_and_end_stay_paired_with_more_surfaces_than_it_can_hold) {
    Bench bench;
    for (std::uint32_t i = 0; i < 40; ++i) bench.tick(touching({FeatureId{100 + i}}));
    for (int i = 0; i < 40; ++i) bench.tick(touching({}));
    for (std::uint32_t i = 0; i < 40; ++i) {
        EXPECT_EQ(bench.count(ContactEventKind::Begin, FeatureId{100 + i}), 1);
        EXPECT_EQ(bench.count(ContactEventKind::End, FeatureId{100 + i}), 1);
    }
}

TEST(ContactTracker, reports_entering_and_leaving_liquids_without_stuttering_at_the_surface) {
    Bench bench;
    TouchResult in_liquid;
    in_liquid.liquid = kPool;
    for (int i = 0; i < 500; ++i) bench.tick(i % 10 < 4 ? in_liquid : TouchResult{});
    EXPECT_EQ(bench.count(ContactEventKind::EnterLiquid, kPool), 1);
    EXPECT_EQ(bench.count(ContactEventKind::LeaveLiquid, kPool), 0);
    for (int i = 0; i < 50; ++i) bench.tick(TouchResult{});
    EXPECT_EQ(bench.count(ContactEventKind::LeaveLiquid, kPool), 1);
}

TEST(ContactTracker, treats_yielding_surfaces_like_rigid_ones) {
    Bench bench;
    TouchResult soft;
    soft.soft = kFloor;
    soft.soft_force_n = Vec3(0, 0, 0.2);
    for (int i = 0; i < 30; ++i) bench.tick(soft, Vec3(0, 0, -0.1));
    EXPECT_EQ(bench.count(ContactEventKind::Begin, kFloor), 1);
    EXPECT_NEAR(bench.seen.at(0).force_n, 0.2, 1e-12);
    EXPECT_NEAR(bench.seen.at(0).speed_m_per_s, 0.1, 1e-12);
    // The hand now also presses on the hard floor under the soft one. Both are the same feature, so no second contact
    // may begin.
    TouchResult through = touching({kFloor});
    through.soft = soft.soft;
    through.soft_force_n = soft.soft_force_n;
    for (int i = 0; i < 30; ++i) bench.tick(through);
    for (int i = 0; i < 30; ++i) bench.tick(TouchResult{});
    EXPECT_EQ(bench.count(ContactEventKind::Begin, kFloor), 1);
    EXPECT_EQ(bench.count(ContactEventKind::End, kFloor), 1);
}

TEST(ContactTracker, clear_ends_everything_once) {
    Bench bench;
    TouchResult touch = touching({kFloor, kWall});
    touch.liquid = kPool;
    bench.tick(touch);
    TickEvents events;
    bench.tracker.clear(bench.now_s, events);
    EXPECT_EQ(events.count, 3);
    events.count = 0;
    bench.tracker.clear(bench.now_s, events);
    EXPECT_EQ(events.count, 0);
}

}  // namespace contact_tracker_test
}  // namespace handrail
