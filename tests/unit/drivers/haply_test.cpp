// Tests the driver of the Inverse3. A stand-in replaces the maker's service.
#include "haptic/drivers/haply_device.h"

#include <cmath>
#include <random>

#include "tests/emulators/haply_service.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/scale.h"
#include "tests/support/world_axes.h"

namespace handrail {
namespace haply_test {

using test::Mood;
using test::StandInService;

TEST(HaplyFacts, include_the_device_its_firmware_and_its_calibration) {
    for (const bool calibrated : {true, false}) {
        StandInService service;
        service.mood = calibrated ? Mood::Sound : Mood::Uncalibrated;
        SteadyClock clock;
        const auto facts = look_at_haply(clock, service.port());
        ASSERT_TRUE(facts) << facts.error().sentence();
        EXPECT_EQ(facts->device_id, "04BA");
        EXPECT_EQ(facts->firmware, "2.7");
        EXPECT_EQ(facts->calibrated, calibrated);
    }
}

TEST(HaplyDevice, rests_against_a_wall_at_the_exact_static_answer_over_a_thousand_exchanges) {
    StandInService service;
    SteadyClock clock;
    auto device = open_haply_device(clock, service.port());
    ASSERT_TRUE(device) << device.error().sentence();
    constexpr double kStiffness = 500.0, kPush = 2.0;
    {
        const std::lock_guard guard(service.lock);
        service.push = {0.0, kPush, 0.0};
    }
    Vec3 force{0.0};
    DeviceSample sample;
    int answers = 0, lost = 0;
    const double begun_s = clock.now_s();
    for (int i = 0; i < 20000 && answers < 1500; ++i) {
        (*device)->write({force});
        sample = (*device)->read(0.0);
        // The driver reports the device as lost after ten exchanges without an answer. On a very busy machine, the
        // service may wait so long for the processor that it misses ten exchanges.
        if (!sample.connected) {
            ASSERT_LE(++lost, 5);
            device = open_haply_device(clock, service.port());
            ASSERT_TRUE(device) << device.error().sentence();
            force = Vec3(0.0);
            continue;
        }
        if (!sample.fresh) continue;  // no new answer has arrived yet, because the machine is busy
        ++answers;
        force = {0.0, std::min(0.0, -kStiffness * (sample.position_m.y - 0.01)), 0.0};
    }
    std::printf("%d round trips, %.0f per second\n", answers, answers / (clock.now_s() - begun_s));
    EXPECT_NEAR(sample.position_m.y, 0.01 + kPush / kStiffness, 1e-6);
    EXPECT_EQ(service.not_understood, 0);
    EXPECT_LE(service.largest, (*device)->spec().peak_force_n + 1e-9);
    (*device)->close();
    const std::lock_guard guard(service.lock);
    EXPECT_EQ(service.force, Vec3(0.0)) << "zero, then away";
}

TEST(HaplyDevice, force_keeps_its_direction_and_stays_below_the_ceiling) {
    StandInService service;
    SteadyClock clock;
    auto device = open_haply_device(clock, service.port());
    ASSERT_TRUE(device);
    for (const Vec3& requested :
         {Vec3(1e9, 0, 0), Vec3(0, 1e9, -1e9), Vec3(std::nan(""), 1, 1), Vec3(0, INFINITY, 0), Vec3(1, 0, 0)}) {
        for (int answer = 0; answer < 2; ++answer)  // the first answer may belong to the previous command
            do {
                (*device)->read(0.0);
                (*device)->write({requested});
            } while (!(*device)->read(0.0).fresh);
        const std::lock_guard guard(service.lock);
        if (is_finite(requested)) {
            EXPECT_GT(glm::dot(service.force, requested / glm::length(requested)), 0.999 * glm::length(service.force));
        } else {
            EXPECT_EQ(service.force, Vec3(0.0));
        }
        EXPECT_LE(glm::length(service.force), (*device)->spec().peak_force_n + 1e-9);
    }
}

// Checks the axes as the authors understand the service's documentation.
TEST(HaplyDevice, right_forward_up_are_east_north_up_and_a_force_to_the_east_pushes_right) {
    for (int axis = 0; axis < 3; ++axis) {
        StandInService service;
        Vec3 theirs{0.0};
        theirs[axis] = 1.0;
        {
            const std::lock_guard guard(service.lock);
            service.place = 0.01 * theirs;
        }
        SteadyClock clock;
        auto device = open_haply_device(clock, service.port());
        ASSERT_TRUE(device) << device.error().sentence();
        const auto exchange = [&](const ForceCommand& command) {
            for (;;) {
                (*device)->write(command);
                if (const DeviceSample sample = (*device)->read(0.0); sample.fresh) return sample;
            }
        };
        const DeviceSample seen = exchange({});
        const test::ThroughWorld through = test::through_world((*device)->spec(), seen.position_m, axis);
        test::expect_east_north_up(through, axis, 0.01, 1e-9);
        for (int i = 0; i < 3; ++i) exchange(through.command);
        const std::lock_guard guard(service.lock);
        EXPECT_LT(glm::length(service.force - theirs * through.command.force_n[axis]), 1e-6) << axis;
    }
}

TEST(HaplyDevice, names_what_is_missing_in_one_sentence) {
    SteadyClock clock;
    const auto none = open_haply_device(clock, test::port_of_nobody());
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().sentence(), testing::HasSubstr("is not running"));
    StandInService empty(false);
    const auto without = open_haply_device(clock, empty.port());
    ASSERT_FALSE(without);
    EXPECT_THAT(without.error().sentence(), testing::HasSubstr("no Inverse3"));
}

TEST(HaplyDevice, damaged_silent_or_missing_states_are_ignored_and_a_closed_connection_counts_as_unplugged) {
    for (const Mood mood : {Mood::Damaged, Mood::Silent, Mood::NoPosition}) {
        StandInService service;
        SteadyClock clock;
        auto device = open_haply_device(clock, service.port());
        ASSERT_TRUE(device);
        service.mood = mood;
        for (int i = 0; i < 6; ++i) (*device)->read(0.0);  // these reads remove answers that were still under way
        const double begun_s = clock.now_s();
        for (int i = 0; i < 10; ++i) {
            (*device)->write({{0.0, 2.0, 0.0}});
            const DeviceSample sample = (*device)->read(0.0);
            EXPECT_FALSE(sample.fresh);
            EXPECT_TRUE(sample.connected);
        }
        std::printf("ten exchanges without an answer: %.0f ms\n", (clock.now_s() - begun_s) * 1e3);
        service.mood = Mood::Sound;
        bool back = false;
        for (int i = 0; i < 2000 && !back; ++i) {
            (*device)->write({});
            back = (*device)->read(0.0).fresh;
        }
        EXPECT_TRUE(back);
    }
    StandInService service;
    SteadyClock clock;
    auto device = open_haply_device(clock, service.port());
    ASSERT_TRUE(device);
    service.mood = Mood::Hangs_up;
    bool connected = true;
    for (int i = 0; i < 2000 && connected; ++i) {
        (*device)->write({});
        connected = (*device)->read(0.0).connected;
    }
    EXPECT_FALSE(connected);
}

TEST(HaplyDevice, without_calibration_gets_no_force) {
    StandInService service;
    service.mood = Mood::Uncalibrated;
    SteadyClock clock;
    auto device = open_haply_device(clock, service.port());
    ASSERT_TRUE(device);
    for (int i = 0; i < 20; ++i) {
        (*device)->write({{0.0, 2.0, 0.0}});
        EXPECT_FALSE((*device)->read(0.0).homed);
    }
    EXPECT_EQ(service.largest, 0.0);
}

TEST(HaplyState, survives_any_text) {
    std::string id;
    DeviceSample sample;
    const std::string whole =
        R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0.1,"y":-0.2,"z":3e-2}},)"
        R"("status":{"calibrated":false}}]})";
    ASSERT_TRUE(parse_haply_state(whole, id, sample));
    EXPECT_EQ(sample.position_m, Vec3(0.1, -0.2, 0.03));
    EXPECT_FALSE(sample.homed);
    EXPECT_EQ(id, "A");
    for (std::size_t cut = 0; cut < whole.size(); ++cut)
        EXPECT_FALSE(parse_haply_state(whole.substr(0, cut), id, sample)) << cut;
    for (const char* odd :
         {"[]", "null", "{\"inverse3\":{}}", "{\"inverse3\":[1,null,[]]}", "{\"inverse3\":[{\"device_id\":7}]}",
          "{\"inverse3\":[{\"device_id\":\"A\",\"state\":{\"cursor_position\":{\"x\":1e999,\"y\":0,\"z\":0}}}]}",
          "{\"inverse3\":[{\"device_id\":\"B\",\"state\":{\"cursor_position\":{\"x\":1,\"y\":0,\"z\":0}}}]}"})
        EXPECT_FALSE(parse_haply_state(odd, id, sample)) << odd;
    const unsigned seed = 6;
    std::mt19937 random(seed);
    for (int i = 0; i < test::scaled(20000); ++i) {
        std::string text = whole;
        for (int k = 0; k < 3; ++k) text[random() % text.size()] = static_cast<char>(random());
        DeviceSample any;
        std::string any_id;
        EXPECT_TRUE(!parse_haply_state(text, any_id, any) || is_finite(any.position_m)) << text;
    }
}

}  // namespace haply_test
}  // namespace handrail
