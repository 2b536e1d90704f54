// Tests what a servo writes into a recording: the inputs of each tick. From these inputs, the test must be able to
// recompute the same ticks.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_loop.h"
#include "tests/support/names.h"
#include "worlds/base/clock.h"

namespace handrail {
namespace recorded_servo_test {

// Runs the servo with a hand for `ticks` milliseconds. The hand follows a target back and forth in empty space. If
// `ring` is null, nothing is recorded.
std::vector<ToolState> stepped(int ticks, HandRing* ring, std::vector<HandRow>* rows) {
    VirtualClock clock;
    clock.advance_s(100.0);
    auto hand = std::make_shared<SimulatedHand>();
    const DeviceSpec& spec = *find_device_spec("sim-t");
    ServoLoop loop(std::make_unique<SimulatedDevice>(spec, hand), clock, 1e-3, {nullptr, nullptr, ring});
    EXPECT_TRUE(loop.open());
    ServoTuning tuning;
    std::vector<ToolState> states;
    for (int tick = 0; tick < ticks; ++tick) {
        if (tick % 17 == 0) {
            HandCommand command;
            command.target_m = {0.03 * std::sin(tick * 0.003), 0.02 * std::cos(tick * 0.002), 0.0};
            hand->command.publish(command);
            tuning.confirm = static_cast<std::uint32_t>(tick);
            loop.set_tuning(tuning);
        }
        clock.advance_s(1.0003e-3);
        loop.step();
        states.push_back(loop.tool());
        if (ring) ring->rows.consume_all([rows](const HandRow& row) { rows->push_back(row); });
    }
    return states;
}

TEST(RecordedServo, stores_each_tick_so_that_it_can_be_recomputed_bit_identically) {
    auto ring = std::make_unique<HandRing>();
    std::vector<HandRow> rows;
    const std::vector<ToolState> states = stepped(3000, ring.get(), &rows);
    ASSERT_EQ(rows.size(), states.size());
    EXPECT_EQ(ring->lost, 0U);
    ServoState again(*find_device_spec("sim-t"));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].servo, 1U);
        EXPECT_EQ(rows[i].reads.tuning, i / 17 + 1);
        ServoTuning tuning;
        tuning.confirm = static_cast<std::uint32_t>(i / 17 * 17);
        servo_tick(again, {nullptr, tuning, WorkspacePose{}, rows[i].sample, rows[i].time_s});
        ASSERT_EQ(again.tool().hand_m, states[i].hand_m) << i;
        ASSERT_EQ(again.tool().hip_m, states[i].hip_m) << i;
        ASSERT_EQ(again.tool().time_s, states[i].time_s) << i;
    }
}

TEST(RecordedServo, without_a_recording_passes_its_device_through_unchanged) {
    const std::vector<ToolState> states = stepped(3000, nullptr, nullptr);
    // A recording rounds times to whole microseconds and places to whole micrometres. Without a recording, the servo
    // must use the device's own values. Encoder steps of 55 micrometres, for example, are not whole micrometres in
    // binary.
    ASSERT_EQ(states.size(), 3000U);
    EXPECT_NE(states.back().time_s, in_whole_microseconds(states.back().time_s));
}

}  // namespace recorded_servo_test
}  // namespace handrail
