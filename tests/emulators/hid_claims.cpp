#include "tests/emulators/hid_claims.h"

#include <thread>

#include "haptic/drivers/space_mouse.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "worlds/base/clock.h"

namespace handrail::test {
namespace {

constexpr int kExchanges = 1000;

}  // namespace

void exchange_a_thousand_reports(std::unique_ptr<HidLink> link, PadBus bus, PadEmulator& emulator, std::mutex& lock,
                                 const std::function<void()>& ring) {
    ASSERT_TRUE(link);
    const SteadyClock clock;
    {
        PlaystationPad pad(std::move(link), PadModel::DualSense, bus);
        const auto opened = pad.open();
        ASSERT_TRUE(opened) << opened.error().sentence();
        EXPECT_EQ(pad.firmware(), "2.24");
        const double begun_s = clock.now_s();
        for (int i = 0; i < kExchanges; ++i) {
            PadOutput output;
            output.strong = static_cast<std::uint8_t>(i);
            output.right = trigger_resists(3, 1 + i % 8);
            ASSERT_TRUE(pad.write(output)) << i;
            const auto seen = [&] {
                const std::lock_guard guard(lock);
                return emulator.strong == output.strong && emulator.right_effect == output.right;
            };
            for (const double end_s = clock.now_s() + kPatience_s; !seen() && clock.now_s() < end_s;)
                std::this_thread::yield();
            ASSERT_TRUE(seen()) << i;
            {
                const std::lock_guard guard(lock);
                emulator.triggers = {static_cast<std::uint8_t>(i), 0};
                emulator.send();
            }
            ring();
            const auto input = pad.read(5.0);
            ASSERT_TRUE(input) << i;
            ASSERT_EQ(std::lround(input->left_trigger * 255.0), i % 256);
        }
        std::printf("%s: %.0f pairs per second\n", bus == PadBus::Bluetooth ? "Bluetooth" : "USB",
                    kExchanges / (clock.now_s() - begun_s));
    }
    const auto still = [&] {
        const std::lock_guard guard(lock);
        return emulator.right_effect == trigger_off() && emulator.strong == 0;
    };
    EXPECT_TRUE(eventually(still)) << "let go";
    const std::lock_guard guard(lock);
    EXPECT_EQ(emulator.bad, 0U);
    EXPECT_EQ(emulator.sequence_breaks, 0);
    EXPECT_EQ(emulator.good, kExchanges + 2U) << "one on opening and one on letting go";
}

void steer_with_a_space_mouse(std::unique_ptr<HidLink> link, PuckEmulator& emulator, std::mutex& lock,
                              const std::function<void()>& ring) {
    ASSERT_TRUE(link);
    SpaceMouse mouse(std::move(link));
    {
        const std::lock_guard guard(lock);
        emulator.send(1, {0, -350, 0});
        emulator.send(2, {0, 0, -350});
        emulator.send_buttons(1);
    }
    ring();
    PuckState state;
    EXPECT_TRUE(eventually([&] { return (state = mouse.poll(0.0)).buttons != 0; }));
    EXPECT_EQ(state.move, Vec3(0.0, 1.0, 0.0));
    EXPECT_EQ(state.turn, Vec3(0.0, 0.0, 1.0));
    EXPECT_EQ(state.buttons, 1U);
    EXPECT_TRUE(mouse.light(true));
    const auto lit = [&] {
        const std::lock_guard guard(lock);
        return emulator.light;
    };
    EXPECT_TRUE(eventually(lit));
}

}  // namespace handrail::test
