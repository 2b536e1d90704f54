// Runs the program and its guard as separate processes. umockdev emulates a bus with a Falcon in the test process.
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "haptic/drivers/found_device.h"
#include "haptic/drivers/guarded_device.h"
#include "tests/support/login_manager.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/times_in.h"
#include "tests/umockdev/mock_usb.h"
#include "tests/umockdev/mocked_program.h"
#include "worlds/confine/confine.h"

extern "C" char** environ;

namespace handrail {
namespace guard_test {

using namespace std::chrono_literals;
using Clock_ = std::chrono::steady_clock;
using test::times_in;

const std::filesystem::path kGuard = test::built_program("standin_umockdev_guard");

// Returns true if this machine wakes a thread less than 10 ms late. The watchdogs check every 10 ms, and the second
// guard needs some exchanges. So on a slower machine, the test cannot show that the guard meets its deadline.
bool gives_its_time() {
    constexpr int kLooks = 100;
    constexpr auto kLate = 10ms;
    auto worst = Clock_::duration::zero();
    for (int i = 0; i < kLooks; ++i) {
        const auto begun = Clock_::now();
        std::this_thread::sleep_for(5ms);
        worst = std::max(worst, Clock_::now() - begun - 5ms);
    }
    std::printf("this machine woke a thread at most %.1f ms late\n",
                std::chrono::duration<double, std::milli>(worst).count());
    return worst < kLate;
}

constexpr std::size_t kBusyEnough = 4;  // the test gives up after this many announcements that the computer is too busy

// Returns the child processes that any thread of `process` has started, the oldest first.
std::vector<pid_t> children_of(pid_t process) {
    std::vector<pid_t> found;
    std::error_code ec;
    for (const auto& thread : std::filesystem::directory_iterator(fmt::format("/proc/{}/task", process), ec)) {
        std::ifstream children(thread.path() / "children");
        for (pid_t child = 0; children >> child;) found.push_back(child);
    }
    std::sort(found.begin(), found.end());
    return found;
}

// Returns one field of the kernel's status of a process; empty if the process does not exist.
std::string field_of(pid_t process, const std::string& name) {
    std::ifstream status(fmt::format("/proc/{}/status", process));
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name + ":")) return line.substr(line.find_first_not_of(" \t", name.size() + 1));
    return {};
}

class GuardProcess : public testing::Test {
protected:
    struct Frame {
        Clock_::time_point at;
        bool force;
    };

    void SetUp() override {
        ASSERT_TRUE(umockdev_in_mock_environment()) << "this program needs LD_PRELOAD=libumockdev-preload.so.0";
        const std::lock_guard guard(bus_.lock);
        bus_.falcon.stage = test::FalconEmulator::Stage::Running;
        bus_.falcon.after_frame = [this](test::FalconEmulator& falcon) {
            frames_.push_back({Clock_::now(), falcon.motors != std::array<int, 3>{}});
        };
    }
    template <class Condition>
    bool wait(Condition&& condition, std::chrono::seconds allowed = 300s) {
        for (const auto end = Clock_::now() + allowed; Clock_::now() < end; std::this_thread::sleep_for(2ms)) {
            const std::lock_guard guard(bus_.lock);
            if (condition()) return true;
        }
        return false;
    }
    bool no_force_now() const { return bus_.falcon.motors == std::array<int, 3>{}; }

    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed_;
    test::MockFalconBus bus_{bed_.bed};
    std::vector<Frame> frames_;  // `bus_.lock` guards this list
};

TEST_F(GuardProcess, holds_the_device_for_the_servo_and_releases_it_at_zero_force) {
    GuardedDevice device(*find_device_spec("falcon"), kGuard, {"falcon"});
    const auto opened = device.open();
    ASSERT_TRUE(opened) << opened.error().sentence();
    SteadyClock clock;
    DeviceSample sample;
    double longest_s = 0.0, all_s = 0.0;
    int fresh = 0;
    constexpr int kTicks = 1000;
    for (int i = 0; i < kTicks; ++i) {
        const double begun_s = clock.now_s();
        sample = device.read(begun_s);
        device.write({{0.0, 0.5, 0.0}});
        const double took_s = clock.now_s() - begun_s;
        longest_s = std::max(longest_s, took_s);
        all_s += took_s;
        fresh += sample.fresh;
        clock.sleep_until_s(begun_s + 1e-3);
    }
    std::printf("%d ticks: read and write take %.1f us, at most %.0f us; %d samples were fresh\n", kTicks,
                all_s / kTicks * 1e6, longest_s * 1e6, fresh);
    EXPECT_TRUE(sample.connected);
    EXPECT_GT(fresh, 10);
    EXPECT_TRUE(wait([&] { return !no_force_now(); }));
    device.close();
    const std::lock_guard guard(bus_.lock);
    EXPECT_TRUE(no_force_now());
}

TEST_F(GuardProcess, unplugging_and_replugging_are_detected) {
    GuardedDevice device(*find_device_spec("falcon"), kGuard, {"falcon"});
    ASSERT_TRUE(device.open());
    const auto tick_until = [&](bool connected) {
        for (const auto end = Clock_::now() + 300s; Clock_::now() < end; std::this_thread::sleep_for(1ms)) {
            const DeviceSample sample = device.read(0.0);
            device.write({Vec3(0.0)});
            if (sample.connected == connected && (sample.fresh || !connected)) return true;
        }
        return false;
    };
    EXPECT_TRUE(tick_until(true));
    {
        const std::lock_guard guard(bus_.lock);
        bus_.unplugged = true;
    }
    EXPECT_TRUE(tick_until(false));
    {
        const std::lock_guard guard(bus_.lock);
        bus_.unplugged = false;
    }
    EXPECT_TRUE(tick_until(true));
    // If the guard is killed, the program must report that the device is lost. The second guard must make sure that the
    // device exerts no force.
    ::kill(device.guard_process(), SIGKILL);
    EXPECT_TRUE(tick_until(false));
    for (const auto end = Clock_::now() + 20s; Clock_::now() < end && device.read(0.0).loss != DeviceLoss::ForceOff;) {
        (void)device.take_news();  // the app makes this call, too; the call also replaces a second guard that has died
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(device.read(0.0).loss, DeviceLoss::ForceOff);
    EXPECT_TRUE(device.guard_ended()) << "another guard may open it";
}

// The program in the first room, as a separate process.
class RunningProgram {
public:
    explicit RunningProgram(const std::filesystem::path& home, const std::string& device = "falcon",
                            const std::string& command = "") {
        std::array<int, 2> input{-1, -1}, output{-1, -1};
        if (::pipe2(input.data(), O_CLOEXEC) != 0 || ::pipe2(output.data(), O_CLOEXEC) != 0) return;
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, input[0], 0);
        posix_spawn_file_actions_adddup2(&actions, output[1], 1);
        std::vector<std::string> words{test::mocked_program().string(), "--no-window", "--device", device};
        if (!command.empty()) words.insert(words.begin() + 1, command);
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        // The program also gets no speech server. Starting one forks the process. A lock of umockdev may stay locked in
        // the child if another thread is looking for devices at that moment.
        const auto bare = test::bare_environment(home.string());
        std::vector<std::string> variables;
        for (char** variable = environ; *variable; ++variable) {
            const std::string_view whole = *variable;
            if (!whole.starts_with("XDG_") && !bare.contains(std::string(whole.substr(0, whole.find('=')))))
                variables.emplace_back(whole);
        }
        for (const auto& [name, value] : bare)
            if (!value.empty()) variables.push_back(name + "=" + value);
        std::vector<char*> envp;
        for (std::string& variable : variables) envp.push_back(variable.data());
        envp.push_back(nullptr);
        ::posix_spawn(&pid_, argv[0], &actions, nullptr, argv.data(), envp.data());
        posix_spawn_file_actions_destroy(&actions);
        ::close(input[0]);
        ::close(output[1]);
        input_ = input[1];
        output_ = output[0];
        reader_ = std::thread([this] {
            std::array<char, 4096> bytes{};
            for (ssize_t size; (size = ::read(output_, bytes.data(), bytes.size())) > 0;) {
                const std::lock_guard guard(mutex_);
                said_.append(bytes.begin(), bytes.begin() + size);
            }
        });
    }
    ~RunningProgram() {
        end();
        ::close(input_);
        reader_.join();
        ::close(output_);
    }
    pid_t pid() const { return pid_; }
    std::string said() {
        const std::lock_guard guard(mutex_);
        return said_;
    }
    bool says(const std::string& words, std::chrono::seconds allowed = 300s) {
        for (const auto end = Clock_::now() + allowed; Clock_::now() < end; std::this_thread::sleep_for(10ms))
            if (said().find(words) != std::string::npos) return true;
        return false;
    }
    // Returns true once the program has announced `words` another time.
    bool says_again(const std::string& words) {
        for (const auto end = Clock_::now() + 300s; Clock_::now() < end; std::this_thread::sleep_for(10ms)) {
            const std::string text = said();
            if (text.find(words, text.find(words) + 1) != std::string::npos) return true;
        }
        return false;
    }
    void type(std::string_view line) {
        [[maybe_unused]] const auto written = ::write(input_, line.data(), line.size());
    }
    // Kills the program, and waits until its guards have ended, too. umockdev would end the test if a process still
    // used a bus that is being removed.
    void kill_and_wait() {
        const std::vector<pid_t> guards = children_of(pid_);
        ::kill(pid_, SIGKILL);
        ::waitpid(std::exchange(pid_, -1), nullptr, 0);
        const auto goes_on = [](pid_t guard) {
            const std::string state = field_of(guard, "State");
            return !state.empty() && state.front() != 'Z';
        };
        for (const pid_t guard : guards) {
            for (const auto end = Clock_::now() + 10s; Clock_::now() < end && goes_on(guard);)
                std::this_thread::sleep_for(2ms);
            if (goes_on(guard)) ::kill(guard, SIGKILL);
        }
    }
    void end() {
        if (pid_ > 0) kill_and_wait();
    }
    int wait_for_end() {
        int status = -1;
        ::waitpid(std::exchange(pid_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t pid_ = -1;
    int input_ = -1, output_ = -1;
    std::mutex mutex_;
    std::string said_;
    std::thread reader_;
};

class DyingProgram : public GuardProcess {
protected:
    // Lifts the hand, waits for the force, which rises over 1 s, and then pushes down with 2 N.
    void put_hand_on_floor() {
        {
            const std::lock_guard guard(bus_.lock);
            bus_.falcon.held = true;
        }
        for (const double up_m : {0.006, 0.0}) {
            std::this_thread::sleep_for(100ms);
            const std::lock_guard guard(bus_.lock);
            bus_.falcon.grip_m.y = up_m;
        }
        std::this_thread::sleep_for(1500ms);
        {
            const std::lock_guard guard(bus_.lock);
            bus_.falcon.held = false;
            bus_.falcon.push_n = {0.0, -2.0, 0.0};
        }
    }
    void press_on_the_floor() {
        if (!gives_its_time()) GTEST_SKIP() << "this machine is too busy to give a servo its rate";
        ASSERT_TRUE(program_.says("First room, 6 by 4 metres.") && program_.says("The Falcon is ready."))
            << program_.said();
        // On a busy machine, the watchdog of the servo rate may switch the force off. In that case, the test switches
        // the force on again with the force command, as a user would.
        // If the machine stops for a moment, there is no force after it and the hand sinks. It is then lifted again.
        std::size_t answered = 0, stalls = 0;
        bool pressed = false, stalled = true;
        while (std::exchange(stalled, false) && stalls < kBusyEnough) {
            put_hand_on_floor();
            wait(
                [&] {
                    stalled = times_in(program_.said(), "The computer stopped") > stalls;
                    if (const std::size_t alerts = times_in(program_.said(), "type forces"); alerts > answered) {
                        answered = alerts;
                        program_.type("forces\n");
                    }
                    pressed = std::abs(bus_.falcon.force_on_hand_n().y - 2.0) < 0.1 &&
                              glm::length(bus_.falcon.velocity_m_per_s) < 0.01 && bus_.falcon.grip_m.y > -0.035;
                    return pressed || stalled || answered >= kBusyEnough;
                },
                60s);
            stalls = times_in(program_.said(), "The computer stopped");
        }
        if (!pressed && (stalls >= kBusyEnough || times_in(program_.said(), "too busy for steady touch") > 0))
            GTEST_SKIP() << "this machine is too busy to give a servo its rate";
        ASSERT_TRUE(pressed) << program_.said();
    }
    // Waits for zero force. Checks that at most `most_frames_with_force` frames after `since` carried a force, and that
    // no force returns. Prints how long it took until the force was zero.
    void expect_zero_since(Clock_::time_point since, int most_frames_with_force) {
        ASSERT_TRUE(wait([this] { return no_force_now(); }));
        const std::lock_guard guard(bus_.lock);
        int with_force = 0;
        const Frame* zero = nullptr;
        for (const Frame& frame : frames_) {
            if (frame.at < since) continue;
            if (!frame.force) {
                zero = &frame;
                break;
            }
            ++with_force;
        }
        ASSERT_TRUE(zero);
        EXPECT_LE(with_force, most_frames_with_force);
        std::printf("zero %.1f ms after, with %d frames of force between\n",
                    std::chrono::duration<double, std::milli>(zero->at - since).count(), with_force);
        for (const Frame* frame = zero; frame <= &frames_.back(); ++frame)
            EXPECT_FALSE(frame->force) << "no force comes back";
    }

    test::TemporaryFolder home_;
    RunningProgram program_{home_.path()};
};

TEST_F(DyingProgram, killed_with_2_newtons_in_the_hand_leaves_zero_force) {
    press_on_the_floor();
    if (IsSkipped() || HasFatalFailure()) return;
    const auto killed = Clock_::now();
    program_.kill_and_wait();
    std::printf("kill -9: ");
    // A killed program sends no more commands. At most two frames should still carry a force: the frame under way, and
    // the frame that the program had ordered. The test allows 20 frames, which are about 20 ms.
    expect_zero_since(killed, 20);
    const std::lock_guard guard(bus_.lock);
    EXPECT_LE(bus_.falcon.largest_force_n, 3.0);
}

TEST_F(DyingProgram, frozen_with_2_newtons_in_the_hand_leaves_zero_force) {
    press_on_the_floor();
    if (IsSkipped() || HasFatalFailure()) return;
    const auto frozen = Clock_::now();
    ::kill(program_.pid(), SIGSTOP);
    std::printf("frozen: ");
    expect_zero_since(frozen, 50);
}

class FailingGuard : public DyingProgram {
protected:
    // Returns the process numbers of both guards. The first guard starts before the second one, so its number is
    // smaller.
    std::vector<pid_t> guards() { return children_of(program_.pid()); }
    // Returns the milliseconds from `since` until the motors first had no force. Also checks that no force returns
    // during the next 300 ms.
    double zero_after_ms(Clock_::time_point since) {
        EXPECT_TRUE(wait([this] { return no_force_now(); }));
        std::this_thread::sleep_for(300ms);
        const std::lock_guard guard(bus_.lock);
        const auto zero = std::find_if(frames_.begin(), frames_.end(),
                                       [&](const Frame& frame) { return frame.at >= since && !frame.force; });
        if (zero == frames_.end()) {
            ADD_FAILURE() << "no frame of zero came";
            return 1e9;
        }
        EXPECT_TRUE(std::none_of(zero, frames_.end(), [](const Frame& frame) { return frame.force; }))
            << "no force comes back";
        return std::chrono::duration<double, std::milli>(zero->at - since).count();
    }
    // Runs `act` while the hand feels 2 N. Expects zero force within `most_ms`. If the force was zero only later, and
    // the machine is too busy to measure times, skips the test.
    void expect_zero_within(double most_ms, const char* what, const std::function<void()>& act) {
        press_on_the_floor();
        if (IsSkipped() || HasFatalFailure()) return;
        const auto since = Clock_::now();
        act();
        const double took_ms = zero_after_ms(since);
        std::printf("%s: zero %.1f ms after\n", what, took_ms);
        if (took_ms > most_ms && !gives_its_time())
            GTEST_SKIP() << "this machine is too busy to measure times: " << took_ms << " ms";
        EXPECT_LE(took_ms, most_ms);
    }
};

TEST_F(FailingGuard, killed_with_2_newtons_in_the_hand_is_followed_by_zero_force_within_100_ms_and_a_true_message) {
    expect_zero_within(100.0, "guard killed", [this] { ::kill(guards().front(), SIGKILL); });
    if (IsSkipped() || HasFatalFailure()) return;
    EXPECT_TRUE(program_.says("Let go of the grip: the device may still push.")) << program_.said();
    EXPECT_TRUE(program_.says("The device no longer pushes.")) << program_.said();
    EXPECT_EQ(program_.said().find("was unplugged"), std::string::npos) << program_.said();
    EXPECT_TRUE(program_.says("I found a Falcon.")) << "and can be taken again: " << program_.said();
}

TEST_F(FailingGuard, frozen_with_2_newtons_in_the_hand_is_killed_and_followed_by_zero_force_within_250_ms) {
    pid_t guard = 0;
    expect_zero_within(250.0, "guard frozen", [&] { ::kill(guard = guards().front(), SIGSTOP); });
    if (IsSkipped() || HasFatalFailure()) return;
    EXPECT_TRUE(program_.says("Let go of the grip: the device may still push.")) << program_.said();
    EXPECT_TRUE(program_.says("The device no longer pushes.")) << program_.said();
    EXPECT_NE(field_of(guard, "State").substr(0, 1), "T") << "it can never go on";
}

TEST_F(FailingGuard, frozen_together_with_the_program_is_still_followed_by_zero_force) {
    expect_zero_within(250.0, "guard and program frozen", [this] {
        const auto both = guards();
        ::kill(program_.pid(), SIGSTOP);
        ::kill(both.front(), SIGSTOP);
    });
}

TEST_F(FailingGuard, frozen_while_the_program_exits_leaves_zero_force) {
    expect_zero_within(400.0, "guard frozen, then left", [this] {
        ::kill(guards().front(), SIGSTOP);
        program_.type("quit\n");
    });
    if (IsSkipped() || HasFatalFailure()) return;
    EXPECT_EQ(program_.wait_for_end(), 0) << program_.said();
}

// The test first freezes the second guard. So when the first guard dies, only the program can remove the force.
TEST_F(FailingGuard, killed_with_a_frozen_second_guard_is_still_followed_by_zero_force) {
    expect_zero_within(250.0, "second guard frozen, first killed", [this] {
        const auto both = guards();
        ::kill(both.back(), SIGSTOP);
        ::kill(both.front(), SIGKILL);
    });
    if (IsSkipped() || HasFatalFailure()) return;
    EXPECT_TRUE(program_.says("The device no longer pushes.")) << program_.said();
}

TEST_F(FailingGuard, frozen_with_a_frozen_second_guard_is_followed_by_zero_force_even_when_the_program_exits) {
    expect_zero_within(500.0, "both guards frozen, then left", [this] {
        for (const pid_t guard : guards()) ::kill(guard, SIGSTOP);
        program_.type("quit\n");
    });
    if (IsSkipped() || HasFatalFailure()) return;
    EXPECT_EQ(program_.wait_for_end(), 0) << program_.said();
}

TEST_F(FailingGuard, drops_all_privileges_and_is_replaced_when_the_second_guard_dies) {
    press_on_the_floor();
    if (IsSkipped() || HasFatalFailure()) return;
    const auto both = guards();
    ASSERT_EQ(both.size(), 2U);
    for (const pid_t guard : both) {
        EXPECT_EQ(field_of(guard, "NoNewPrivs"), "1");
        EXPECT_EQ(field_of(guard, "Seccomp") == "2", confinement_offered().seccomp);
        std::ifstream limits(fmt::format("/proc/{}/limits", guard));
        const std::string text{std::istreambuf_iterator<char>(limits), {}};
        EXPECT_THAT(text, testing::ContainsRegex("Max core file size +0 +0"));
        EXPECT_THAT(text, testing::ContainsRegex("Max open files +256 +256"));
        // If the system does not protect the guard from running out of memory, or refuses to lock its memory, the
        // program must say so.
        int score = 0;
        std::ifstream(fmt::format("/proc/{}/oom_score_adj", guard)) >> score;
        EXPECT_EQ(score != -1000, program_.said().find("If memory runs out") != std::string::npos) << program_.said();
        const bool locked = std::atoi(field_of(guard, "VmLck").c_str()) > 0;
        EXPECT_TRUE(locked || program_.said().find("is not locked") != std::string::npos) << program_.said();
    }
    ::kill(both.back(), SIGKILL);
    std::vector<pid_t> now;
    for (const auto end = Clock_::now() + 300s; Clock_::now() < end && (now.size() != 2 || now.back() == both.back());
         std::this_thread::sleep_for(20ms))
        now = guards();
    ASSERT_EQ(now.size(), 2U);
    EXPECT_EQ(now.front(), both.front());
    std::this_thread::sleep_for(200ms);
    ::kill(now.front(), SIGKILL);
    EXPECT_TRUE(wait([this] { return no_force_now(); })) << "the new second guard does its work";
}

// A system bus with logind on it. The constructor starts the bus before the program starts and looks for logind.
struct SystemBus {
    test::TemporaryFolder folder;
    std::optional<test::LoginManager> logind;
    SystemBus() {
        if (!test::LoginManager::why_not().empty()) return;
        logind.emplace(folder.path());
        if (logind->ready()) ::setenv("DBUS_SYSTEM_BUS_ADDRESS", logind->address().c_str(), 1);
    }
    ~SystemBus() { ::unsetenv("DBUS_SYSTEM_BUS_ADDRESS"); }
    bool is_delayed() const { return logind->inhibitors() == "sleep Handrail delay\n"; }
};

class SleepingComputer : protected SystemBus, public FailingGuard {};

TEST_F(SleepingComputer, loses_2_newtons_before_it_sleeps_and_gets_them_back_only_on_request) {
    if (!logind) GTEST_SKIP() << test::LoginManager::why_not();
    press_on_the_floor();
    if (IsSkipped() || HasFatalFailure()) return;
    EXPECT_TRUE(test::eventually([this] { return is_delayed(); }));
    logind->announce_sleep(true);
    ASSERT_TRUE(test::eventually([this] { return !is_delayed(); }));
    {
        const std::lock_guard guard(bus_.lock);
        EXPECT_TRUE(no_force_now()) << "the computer may sleep from here on";
    }
    logind->announce_sleep(false);
    EXPECT_TRUE(program_.says("The computer is awake again. Type forces to bring the force back.")) << program_.said();
    EXPECT_TRUE(test::eventually([this] { return is_delayed(); })) << "for the next sleep";
    {
        const std::lock_guard guard(bus_.lock);
        EXPECT_TRUE(no_force_now()) << "no force comes back by itself";
    }
    program_.type("forces\n");
    EXPECT_TRUE(wait([this] { return !no_force_now(); })) << program_.said();
}

// No device is connected at the start. When a Falcon is plugged in later, the program must announce it, open it at the
// force command, and wake it. Then the hand must feel a force.
TEST(HotPlug, a_device_plugged_in_later_is_found_named_offered_and_used) {
    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed;
    ASSERT_TRUE(umockdev_in_mock_environment());
    if (!gives_its_time()) GTEST_SKIP() << "this machine is too busy to give a servo its rate";
    const test::TemporaryFolder home;
    RunningProgram program(home.path(), "auto");
    ASSERT_TRUE(program.says("First room, 6 by 4 metres.")) << program.said();
    test::MockFalconBus bus(bed.bed);
    {
        const std::lock_guard guard(bus.lock);
        bus.falcon.stage = test::FalconEmulator::Stage::Running;
    }
    ASSERT_TRUE(program.says("I found a Falcon. Type forces to use it.")) << program.said();
    program.type("where\n");
    ASSERT_TRUE(program.says("At the base, by the door")) << "the keyboard goes on meanwhile";
    program.type("forces\n");
    ASSERT_TRUE(program.says("Opening the Falcon.") && program.says("The Falcon is ready.")) << program.said();
    // Moves the grip: first freely, then into a wall, which must exert a force.
    const auto moved_to = [&](double y_m) {
        const std::lock_guard guard(bus.lock);
        bus.falcon.grip_m.y = y_m;
    };
    bool felt = false;
    // On a busy machine, the force may be off. In that case, the test switches the force on again with the force
    // command, as a user would.
    std::size_t reported = 0;
    for (const auto end = Clock_::now() + 300s; !felt && Clock_::now() < end;) {
        const std::string said = program.said();
        if (const std::size_t off = said.find("type forces to try again", reported); off != std::string::npos) {
            reported = off + 1;
            program.type("forces\n");
        }
        for (const double y_m : {0.006, 0.0, -0.01, -0.02}) {
            moved_to(y_m);
            std::this_thread::sleep_for(300ms);
            const std::lock_guard guard(bus.lock);
            felt = felt || bus.falcon.motors != std::array<int, 3>{};
        }
    }
    EXPECT_TRUE(felt) << program.said();
    // When the guard of the Falcon is killed, the program must report that the Falcon is lost. It must then be able to
    // open the Falcon again.
    const auto both = children_of(program.pid());
    ASSERT_EQ(both.size(), 2U);
    ::kill(both.front(), SIGKILL);
    ASSERT_TRUE(program.says("The device no longer pushes.") && program.says_again("I found a Falcon."))
        << program.said();
    program.type("forces\n");
    ASSERT_TRUE(program.says_again("The Falcon is ready.")) << program.said();
    program.end();  // end the program while the bus still exists
    const std::lock_guard guard(bus.lock);
    EXPECT_LE(bus.falcon.largest_force_n, 3.0);
}

class CalibratingProgram : public GuardProcess {
protected:
    // Waits until the program has announced `words`. If a fault interrupts on a busy machine, presses Enter, as a user
    // would. Returns false if the guard released the device because it ran out of time, or if the servo complained too
    // often about lack of time. Fails and returns false after 300 s.
    bool hears(const std::string& words) {
        for (const auto end = Clock_::now() + 300s; Clock_::now() < end; std::this_thread::sleep_for(10ms)) {
            if (program_->said().find(words) != std::string::npos) return true;
            if (!answers_what_came_between()) return false;
        }
        ADD_FAILURE() << "\"" << words << "\" was never said:\n" << program_->said();
        return false;
    }
    bool answers_what_came_between() {
        const std::string said = program_->said();
        lost_ = said.find("I will go on without it") != std::string::npos ||
                times_in(said, "too busy for steady touch") >= kBusyEnough;
        const std::size_t faults = times_in(said, "Type an empty line to go on, or type leave to end the set-up.");
        if (std::exchange(faults_, faults) < faults) program_->type("\n");
        return !lost_;
    }
    bool hears_and_types(const std::string& words, std::string_view line) {
        if (!hears(words)) return false;
        program_->type(line);
        return true;
    }
    // Moves the hand to `grip_m` in steps of 0.2 mm, one with each exchange.
    bool move_to(const Vec3& grip_m) {
        {
            const std::lock_guard guard(bus_.lock);
            target_m_ = grip_m;
        }
        return wait([&] { return bus_.falcon.grip_m == grip_m; });
    }
    void glide(test::FalconEmulator& falcon) const {
        constexpr double kPerFrame_m = 2e-4;
        const Vec3 way_m = target_m_ - falcon.grip_m;
        const double length_m = glm::length(way_m);
        falcon.grip_m = length_m <= kPerFrame_m ? target_m_ : falcon.grip_m + way_m * (kPerFrame_m / length_m);
    }
    void press_button(bool down) {
        const std::lock_guard guard(bus_.lock);
        bus_.falcon.buttons = down ? 4 : 0;
    }
    // Presses the button when the hand feels a force. Presses it again if the program repeats the question, because a
    // fault interrupted the question or because the guard released the device.
    bool feels_and_presses() {
        if (!hears("I will press")) return false;
        const auto feels = [this] { return glm::length(bus_.falcon.force_on_hand_n()) > 0.2; };
        std::size_t let_go = 0;
        for (const auto end = Clock_::now() + 300s; Clock_::now() < end;) {
            if (!answers_what_came_between()) return false;
            const std::size_t times = times_in(program_->said(), " and then let go");
            const bool has_let_go = std::exchange(let_go, times) < times;
            if (!has_let_go && !wait(feels, 1s)) continue;
            press_button(true);
            // Wait for this sentence, because a second press would answer the next question.
            const bool felt = program_->says("You felt it at", 5s);
            press_button(false);
            if (felt) return true;
            // Wait, so that the program, which polls sixty times a second, sees that the button is released.
            std::this_thread::sleep_for(100ms);
        }
        return hears("You felt it at");
    }
    bool sweeps() {
        for (const Vec3& side : {Vec3(0.03, 0.0, 0.125), Vec3(-0.03, 0.0, 0.125), Vec3(0.0, 0.02, 0.125),
                                 Vec3(0.0, -0.02, 0.125), Vec3(0.0, 0.0, 0.15), Vec3(0.0, 0.0, 0.1)}) {
            if (!move_to(side)) return false;
            // Wait, so that the program, which polls sixty times a second, sees the hand at this side.
            std::this_thread::sleep_for(100ms);
        }
        return true;
    }
    bool is_led_through() {
        return hears_and_types("bell on your left", "left\nright\n") && hears("Pull it all the way towards you.") &&
               move_to({0.0, 0.0, 0.16}) && hears("Push the grip in, away from you.") && move_to({0.0, 0.0, 0.11}) &&
               hears("Which hand holds the grip?") && move_to({-0.03, 0.0, 0.11}) && hears("Left hand.") &&
               feels_and_presses() && hears_and_types("Now you will feel a wall.", "\n") &&
               hears("Nothing will push with more than 1.2 newtons.") &&
               hears("Move the grip as far as is comfortable") && sweeps() &&
               hears_and_types("A click marks each side", "\n") && hears_and_types("Your reach covers", "\n") &&
               hears_and_types("Pushing is on; type up or down", "\n") && hears_and_types("Your step is", "65\n") &&
               hears("The set-up is complete.");
    }

    test::TemporaryFolder home_;
    std::optional<RunningProgram> program_;
    std::size_t faults_ = 0;
    bool lost_ = false;
    Vec3 target_m_{0.0, 0.0, 0.145};  // `bus_.lock` guards this position
};

TEST_F(CalibratingProgram, guides_through_the_whole_setup_by_voice_and_saves_a_profile) {
    if (!gives_its_time()) GTEST_SKIP() << "this machine is too busy to play a Falcon";
    {
        const std::lock_guard guard(bus_.lock);
        bus_.falcon.homes_by_moving = true;
        bus_.falcon.after_frame = [this](test::FalconEmulator& falcon) { glide(falcon); };
    }
    program_.emplace(home_.path(), "falcon", "calibrate");
    if (!is_led_through()) {
        if (lost_)
            GTEST_SKIP() << "this machine is too busy to play a Falcon: the guard had to let it go, or the servo had "
                            "not its rate";
        FAIL() << program_->said();
    }
    EXPECT_EQ(program_->wait_for_end(), 0);
    const std::string settings = test::content_of(home_.path() / ".config" / "handrail" / "settings.toml");
    EXPECT_THAT(settings,
                testing::AllOf(testing::HasSubstr("[profile.\"falcon"), testing::HasSubstr("ceiling_n = 1.2"),
                               testing::HasSubstr("hand = \"left\""), testing::HasSubstr("gentlest_n = 0."),
                               testing::HasSubstr("width_m = 0.06"), testing::HasSubstr("step_length_m = 0.65")));
    const std::lock_guard guard(bus_.lock);
    EXPECT_EQ(bus_.falcon.frames_before_homed_with_force, 0U);
    EXPECT_LE(bus_.falcon.largest_force_n, 1.2 + 0.05);
    EXPECT_TRUE(no_force_now());
}

TEST_F(GuardProcess, devices_command_lists_every_fact_of_the_falcon) {
    test::ProgramCall call;
    call.program = test::mocked_program().string();
    call.arguments = {"devices", "--json"};
    {
        const std::lock_guard guard(bus_.lock);
        bus_.falcon.frames_until_homed = 1'000'000;
    }
    const test::ProgramRun run = test::run_program(call);
    ASSERT_EQ(run.exit_status, 0) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    ASSERT_EQ(json["devices"].size(), 1U) << run.out;
    const auto& falcon = json["devices"][0];
    EXPECT_EQ(falcon["name"], "falcon");
    EXPECT_EQ(falcon["model"], "Novint Falcon");
    EXPECT_EQ(falcon["kind"], "force");
    EXPECT_EQ(falcon["connection"], "USB bus 1, device 7");
    EXPECT_EQ(falcon["firmware"], "running");
    EXPECT_THAT(falcon["calibration"].get<std::string>(), testing::HasSubstr("not homed"));
    EXPECT_EQ(falcon["workspace_radius_m"], 0.04);
    EXPECT_EQ(falcon["force_limit_n"], 3.0);
    EXPECT_EQ(falcon["stiffness_limit_n_per_m"], 1000.0);
    EXPECT_EQ(falcon["rate_hz"], 1000.0);
    EXPECT_EQ(falcon["usable"], true);
    EXPECT_TRUE(falcon["problem"].is_null());
    const std::lock_guard guard(bus_.lock);
    EXPECT_TRUE(std::none_of(frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.force; }))
        << "looking pushes nobody";
}

TEST_F(GuardProcess, devices_command_names_the_udev_rule_if_access_is_denied) {
    {
        const std::lock_guard guard(bus_.lock);
        bus_.falcon.stage = test::FalconEmulator::Stage::Silent;
    }
    test::ProgramCall call;
    call.program = test::mocked_program().string();
    call.arguments = {"devices"};
    const test::ProgramRun asleep = test::run_program(call);
    EXPECT_THAT(asleep.out, testing::HasSubstr("nvent_firmware.bin"));
    EXPECT_THAT(asleep.out, testing::HasSubstr("cannot be used yet"));
    // If the user requested no device, the program must announce the failure and continue with a simulated hand. If the
    // user requested this device by name, the program must end.
    call.arguments = {"--no-window"};
    const test::ProgramRun left_to_itself = test::run_program(call);
    EXPECT_EQ(left_to_itself.exit_status, 0) << left_to_itself.err;
    EXPECT_THAT(left_to_itself.out, testing::AllOf(testing::HasSubstr("I found a Novint Falcon."),
                                                   testing::HasSubstr("simulated hand follows"),
                                                   testing::HasSubstr("First room, 6 by 4 metres.")));
    call.arguments = {"--no-window", "--device", "falcon"};
    const test::ProgramRun with_request = test::run_program(call);
    EXPECT_EQ(with_request.exit_status, 1);
    EXPECT_THAT(with_request.err, testing::HasSubstr("nvent_firmware.bin"));
}

}  // namespace guard_test
}  // namespace handrail
