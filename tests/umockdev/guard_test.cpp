// The program and its guard as processes, with a Falcon on a bus that umockdev plays in this one.
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "haptic/drivers/found_device.h"
#include "haptic/drivers/guarded_device.h"
#include "tests/support/precompiled.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/umockdev/mock_usb.h"

extern "C" char** environ;

namespace handrail {
namespace {

using namespace std::chrono_literals;
using Clock_ = std::chrono::steady_clock;

const std::filesystem::path kGuard = HANDRAIL_GUARD;

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
        bus_.falcon.after_frame = [this](test::FalconEmulator& falcon) { frames_.push_back({Clock_::now(), falcon.motors != std::array<int, 3>{}}); };
    }
    template <class Condition>
    bool wait(Condition&& condition, std::chrono::seconds allowed = 30s) {
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
    std::vector<Frame> frames_;  // under bus_.lock
};

TEST_F(GuardProcess, holds_the_device_for_the_servo_and_lets_it_go_at_zero) {
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
    std::printf("%d ticks: read and write take %.1f us, at most %.0f us; %d samples were fresh\n", kTicks, all_s / kTicks * 1e6, longest_s * 1e6, fresh);
    EXPECT_TRUE(sample.connected);
    EXPECT_GT(fresh, 10);
    EXPECT_TRUE(wait([&] { return !no_force_now(); }));
    device.close();
    const std::lock_guard guard(bus_.lock);
    EXPECT_TRUE(no_force_now());
}

TEST_F(GuardProcess, unplugging_is_seen_and_plugging_in_again_too) {
    GuardedDevice device(*find_device_spec("falcon"), kGuard, {"falcon"});
    ASSERT_TRUE(device.open());
    const auto tick_until = [&](bool connected) {
        for (const auto end = Clock_::now() + 20s; Clock_::now() < end; std::this_thread::sleep_for(1ms)) {
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
    // A guard that is killed is a device that is gone.
    ::kill(device.guard_process(), SIGKILL);
    EXPECT_TRUE(tick_until(false));
}

// The program itself, in the first room, with a hand that presses on the floor with 2 N.
class RunningProgram {
public:
    explicit RunningProgram(const std::filesystem::path& home) {
        std::array<int, 2> input{-1, -1}, output{-1, -1};
        if (::pipe2(input.data(), O_CLOEXEC) != 0 || ::pipe2(output.data(), O_CLOEXEC) != 0) return;
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, input[0], 0);
        posix_spawn_file_actions_adddup2(&actions, output[1], 1);
        std::vector<std::string> words{HANDRAIL_PROGRAM, "--no-window", "--device", "falcon"};
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        std::vector<std::string> variables{"HOME=" + home.string(), "ALSOFT_DRIVERS=null"};
        for (char** variable = environ; *variable; ++variable)
            if (!std::string_view(*variable).starts_with("HOME=") && !std::string_view(*variable).starts_with("XDG_")) variables.emplace_back(*variable);
        std::vector<char*> envp;
        for (std::string& variable : variables) envp.push_back(variable.data());
        envp.push_back(nullptr);
        ::posix_spawn(&pid_, HANDRAIL_PROGRAM, &actions, nullptr, argv.data(), envp.data());
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
    bool says(const std::string& words) {
        for (const auto end = Clock_::now() + 30s; Clock_::now() < end; std::this_thread::sleep_for(10ms))
            if (said().find(words) != std::string::npos) return true;
        return false;
    }
    void type(std::string_view line) { [[maybe_unused]] const auto written = ::write(input_, line.data(), line.size()); }
    void kill_and_wait() {
        ::kill(pid_, SIGKILL);
        ::waitpid(std::exchange(pid_, -1), nullptr, 0);
    }
    void end() {
        if (pid_ > 0) kill_and_wait();
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
    void press_on_the_floor() {
        ASSERT_TRUE(program_.says("First room.")) << program_.said();
        for (const double up_m : {0.006, 0.0}) {  // a first movement, then the ramp of 1 s
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
        // A machine busy with other things may trip the rate watch; the force key brings the force back, as for anybody.
        std::size_t answered = 0;
        ASSERT_TRUE(wait([&] {
            if (const std::size_t alerts = count_of(program_.said(), "press the force key"); alerts > answered) {
                answered = alerts;
                program_.type("forces\n");
            }
            return std::abs(bus_.falcon.force_on_hand_n().y - 2.0) < 0.1 && glm::length(bus_.falcon.velocity_m_per_s) < 0.01 && bus_.falcon.grip_m.y > -0.035;
        })) << program_.said();
    }
    static std::size_t count_of(const std::string& text, std::string_view words) {
        std::size_t count = 0;
        for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
        return count;
    }
    // Waits for zero and tells how it came, from `since` on.
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
        std::printf("zero %.1f ms after, with %d frames of force between\n", std::chrono::duration<double, std::milli>(zero->at - since).count(), with_force);
        for (const Frame* frame = zero; frame <= &frames_.back(); ++frame) EXPECT_FALSE(frame->force) << "no force comes back";
    }

    test::TemporaryFolder home_;
    RunningProgram program_{home_.path()};
};

TEST_F(DyingProgram, killed_with_2_newtons_in_the_hand_leaves_zero_behind) {
    press_on_the_floor();
    const auto killed = Clock_::now();
    program_.kill_and_wait();
    std::printf("kill -9: ");
    // Once it is dead it commands nothing, so at most the frame on its way and the one it had ordered carry force, whatever else the machine does:
    // two frames are less than 20 ms of exchanges.
    expect_zero_since(killed, 20);
    const std::lock_guard guard(bus_.lock);
    EXPECT_LE(bus_.falcon.largest_force_n, 3.0);
}

TEST_F(DyingProgram, frozen_with_2_newtons_in_the_hand_leaves_zero_behind) {
    press_on_the_floor();
    const auto frozen = Clock_::now();
    ::kill(program_.pid(), SIGSTOP);
    std::printf("frozen: ");
    expect_zero_since(frozen, 50);
}

TEST_F(GuardProcess, devices_command_tells_every_fact_of_the_falcon) {
    test::ProgramCall call;
    call.program = HANDRAIL_PROGRAM;
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
    EXPECT_TRUE(std::none_of(frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.force; })) << "looking pushes nobody";
}

TEST_F(GuardProcess, devices_command_names_the_rule_where_the_device_may_not_be_opened) {
    {
        const std::lock_guard guard(bus_.lock);
        bus_.falcon.stage = test::FalconEmulator::Stage::Silent;
    }
    test::ProgramCall call;
    call.program = HANDRAIL_PROGRAM;
    call.arguments = {"devices"};
    const test::ProgramRun asleep = test::run_program(call);
    EXPECT_THAT(asleep.out, testing::HasSubstr("nvent_firmware.bin"));
    EXPECT_THAT(asleep.out, testing::HasSubstr("cannot be used yet"));
    // Left to itself the program says so and goes on with a simulated hand; asked for that very device it ends.
    call.arguments = {"--no-window"};
    call.input = "quit\n";
    const test::ProgramRun left_to_itself = test::run_program(call);
    EXPECT_EQ(left_to_itself.exit_status, 0) << left_to_itself.err;
    EXPECT_THAT(left_to_itself.out, testing::AllOf(testing::HasSubstr("I found a Novint Falcon."), testing::HasSubstr("simulated hand follows"),
                                                   testing::HasSubstr("First room.")));
    call.arguments = {"--no-window", "--device", "falcon"};
    const test::ProgramRun asked_for = test::run_program(call);
    EXPECT_EQ(asked_for.exit_status, 1);
    EXPECT_THAT(asked_for.err, testing::HasSubstr("nvent_firmware.bin"));
}

}  // namespace
}  // namespace handrail
