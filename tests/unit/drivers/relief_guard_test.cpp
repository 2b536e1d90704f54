#include "haptic/drivers/relief_guard.h"
#include "tests/support/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <fstream>
#include <thread>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/unit/drivers/guard_rig.h"

namespace handrail {
namespace relief_guard_test {

using namespace std::chrono_literals;
using test::eventually;
using test::tick_until;

// A second guard on a separate thread. The test acts as the program and as the first guard.
struct Reliever : test::GuardEnds {
    HandMailbox mailbox;
    int guard = ::eventfd(0, EFD_NONBLOCK);  // stands for a process descriptor: readable when the process has ended
    std::atomic<int> zeroed{0}, killed{0}, status{-1};
    std::atomic<bool> refuse{false}, slow{false}, dies_when_killed{true}, held_by_two{false};
    std::atomic<bool> ended{false};
    std::thread thread;

    Reliever() {
        thread = std::thread([this] {
            status = relieve_guard(
                mailbox, guard, guards(),
                [this]() -> Result<void> {
                    if (!ended) held_by_two = true;
                    ++zeroed;
                    while (slow) std::this_thread::sleep_for(1ms);
                    return refuse ? fail("It is not plugged in.") : Result<void>{};
                },
                [this] {
                    ++killed;
                    if (dies_when_killed) end_guard();
                });
        });
    }
    ~Reliever() {
        end_guard();
        leave();
        thread.join();
        ::close(guard);
    }
    void end_guard() {
        ended = true;
        test::signal_event(guard);
    }
    bool comes_to(ReliefState wanted) const {
        return eventually([&] { return mailbox.relief == wanted; });
    }
};

TEST(ReliefGuard, zeroes_the_device_when_the_first_guard_dies_while_holding_it) {
    Reliever relief;
    EXPECT_EQ(relief.message(), "r");
    relief.mailbox.holds = true;
    relief.end_guard();
    ASSERT_TRUE(relief.comes_to(ReliefState::Zero));
    EXPECT_EQ(relief.zeroed, 1);
    EXPECT_EQ(relief.killed, 0);
}

TEST(ReliefGuard, kills_a_frozen_first_guard_before_it_touches_the_device) {
    Reliever relief;
    relief.mailbox.holds = true;
    for (int i = 0; i < 60; ++i, std::this_thread::sleep_for(5ms)) ++relief.mailbox.beats;
    EXPECT_EQ(relief.killed, 0) << "it answers";
    ASSERT_TRUE(relief.comes_to(ReliefState::Zero));
    EXPECT_EQ(relief.killed, 1);
    EXPECT_FALSE(relief.held_by_two);
}

TEST(ReliefGuard, does_not_touch_a_device_that_the_first_guard_has_released) {
    Reliever relief;
    // The first guard needs seconds to open a device, and its count of rounds in the mailbox does not change meanwhile.
    // The second guard must not kill it for that.
    std::this_thread::sleep_for(250ms);
    EXPECT_EQ(relief.killed, 0);
    relief.end_guard();
    ASSERT_TRUE(relief.comes_to(ReliefState::Zero));
    EXPECT_EQ(relief.zeroed, 0);
}

TEST(ReliefGuard, outlives_the_program_and_still_removes_the_force) {
    Reliever relief;
    relief.mailbox.holds = true;
    relief.leave();
    ASSERT_TRUE(relief.comes_to(ReliefState::Zero)) << "the first guard stands still and nobody else is there";
    EXPECT_EQ(relief.killed, 1);
    EXPECT_EQ(relief.zeroed, 1);
}

TEST(ReliefGuard, reports_that_the_device_may_push_and_keeps_trying) {
    Reliever relief;
    EXPECT_EQ(relief.message(), "r");
    relief.refuse = true;
    relief.mailbox.holds = true;
    relief.end_guard();
    EXPECT_TRUE(relief.comes_to(ReliefState::Zeroing));
    ASSERT_TRUE(relief.comes_to(ReliefState::Failed));
    EXPECT_EQ(relief.message(), "fIt is not plugged in.");
    relief.refuse = false;
    EXPECT_TRUE(relief.comes_to(ReliefState::Zero)) << "it was plugged in again";
}

TEST(ReliefGuard, shows_that_it_is_alive_while_it_watches_and_while_a_driver_zeroes_slowly) {
    Reliever relief;
    const auto beats_on = [&] {
        const std::uint32_t before = relief.mailbox.relief_beats;
        return eventually([&] { return relief.mailbox.relief_beats >= before + 3; });
    };
    EXPECT_TRUE(beats_on());
    relief.slow = true;
    relief.mailbox.holds = true;
    relief.end_guard();
    ASSERT_TRUE(relief.comes_to(ReliefState::Zeroing));
    EXPECT_TRUE(beats_on());
    EXPECT_EQ(relief.mailbox.relief, ReliefState::Zeroing);
    relief.slow = false;
    EXPECT_TRUE(relief.comes_to(ReliefState::Zero));
}

TEST(GuardedDevice, is_reported_as_possibly_pushing_until_the_second_guard_has_zeroed_it) {
    for (const int signal : {SIGKILL, SIGSTOP}) {
        GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"echo"});
        ASSERT_TRUE(device.open());
        ASSERT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; }));
        ::kill(device.guard_process(), signal);
        EXPECT_TRUE(tick_until(device, [](const DeviceSample& sample) {
            return !sample.connected && sample.loss == DeviceLoss::ForceOff;
        })) << signal;
        EXPECT_TRUE(device.guard_ended());
        device.close();
        EXPECT_FALSE(device.may_push());
        EXPECT_THAT(device.take_news(), testing::Each(testing::Not(testing::HasSubstr("Let go"))));
    }
}

TEST(GuardedDevice, warns_on_closing_that_it_may_push_if_zero_was_not_confirmed) {
    GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"stubborn"});
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; }));
    ::kill(device.guard_process(), SIGKILL);
    ASSERT_TRUE(tick_until(device, [](const DeviceSample& sample) { return !sample.connected; }));
    // When guard_ended() is true, the second guard has tried to remove the force and failed. close() waits only a
    // second for the second guard.
    ASSERT_TRUE(tick_until(device, [&](const DeviceSample&) { return device.guard_ended(); }));
    EXPECT_EQ(device.read(0.0).loss, DeviceLoss::MayPush);
    device.close();
    EXPECT_TRUE(device.may_push());
    EXPECT_THAT(device.take_news(), testing::Contains("Let go of the grip and switch the Falcon off. Its force could "
                                                      "not be taken away. The Falcon is not plugged in."));
}

TEST(GuardedDevice, gets_a_new_second_guard_when_the_old_one_dies) {
    GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"echo"});
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; }));
    const pid_t first = device.relief_process();
    ::kill(first, SIGKILL);
    ASSERT_TRUE(eventually([&] {
        device.take_news();
        return device.relief_process() != first;
    }));
    ::kill(device.guard_process(), SIGKILL);
    EXPECT_TRUE(tick_until(
        device, [](const DeviceSample& sample) { return !sample.connected && sample.loss == DeviceLoss::ForceOff; }));
}

// Returns whether another second guard replaces the process `than`. The function never reads the news of `device`,
// because the program must replace a second guard even if the app is busy.
bool gets_another_second_guard(const GuardedDevice& device, pid_t than) {
    return eventually([&] { return device.relief_process() != than; });
}

TEST(GuardedDevice, gets_a_new_second_guard_when_the_old_one_freezes) {
    GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"echo"});
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; }));
    const pid_t frozen = device.relief_process();
    ::kill(frozen, SIGSTOP);
    ASSERT_TRUE(gets_another_second_guard(device, frozen));
    EXPECT_NE(::kill(frozen, 0), 0) << "the frozen one was ended, so it can never open the device beside the other";
    EXPECT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; })) << "the hand goes on";
    ::kill(device.guard_process(), SIGKILL);
    EXPECT_TRUE(tick_until(
        device, [](const DeviceSample& sample) { return !sample.connected && sample.loss == DeviceLoss::ForceOff; }));
}

TEST(GuardedDevice, leaves_no_force_if_the_second_guard_is_frozen_and_the_first_fails) {
    for (const int signal : {SIGKILL, SIGSTOP}) {
        for (const bool leaves : {false, true}) {
            GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"echo"});
            ASSERT_TRUE(device.open());
            ASSERT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; }));
            ::kill(device.relief_process(), SIGSTOP);
            ::kill(device.guard_process(), signal);
            if (!leaves) {
                EXPECT_TRUE(tick_until(device, [](const DeviceSample& sample) {
                    return !sample.connected && sample.loss == DeviceLoss::ForceOff;
                })) << signal;
            }
            device.close();
            EXPECT_FALSE(device.may_push()) << signal << ", left at once: " << leaves;
        }
    }
}

TEST(GuardedDevice, warns_that_it_may_push_if_no_second_guard_can_be_started_again) {
    GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"echo"});
    ASSERT_TRUE(device.open());
    ASSERT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; }));
    for (int i = 0; i < GuardedDevice::kMostReliefs; ++i) {
        const pid_t killed = device.relief_process();
        ::kill(killed, SIGKILL);
        ASSERT_TRUE(gets_another_second_guard(device, killed));
    }
    ::kill(device.relief_process(), SIGKILL);
    ::kill(device.guard_process(), SIGKILL);
    const auto warns = [&] {
        const auto news = device.take_news();
        return std::any_of(news.begin(), news.end(), [](const std::string& sentence) {
            return sentence.find("switch the Falcon off") != std::string::npos;
        });
    };
    EXPECT_TRUE(eventually(warns));
}

TEST(GuardProcess, refuses_a_mailbox_file_that_could_be_truncated) {
    for (const bool sealed : {false, true}) {
        const int memory = ::memfd_create("mailbox", MFD_ALLOW_SEALING);
        ASSERT_EQ(::ftruncate(memory, sizeof(HandMailbox)), 0);
        if (sealed) {
            ASSERT_EQ(::fcntl(memory, F_ADD_SEALS, F_SEAL_SHRINK), 0);
        }
        void* mapped = ::mmap(nullptr, sizeof(HandMailbox), PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0);
        new (mapped) HandMailbox;
        const std::string number = std::to_string(memory), guard = test::built_program("standin_guard");
        const pid_t child = ::fork();
        if (child == 0) {
            ::execl(guard.c_str(), guard.c_str(), "hold", number.c_str(), "9998", "9999", "en", "", "absent", nullptr);
            ::_exit(99);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(WEXITSTATUS(status), sealed ? 1 : 2) << "2: refused; 1: no device";
        ::munmap(mapped, sizeof(HandMailbox));
        ::close(memory);
    }
}

}  // namespace relief_guard_test
}  // namespace handrail
