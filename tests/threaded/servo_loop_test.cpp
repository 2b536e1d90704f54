#include "haptic/servo/servo_loop.h"

#include <bit>
#include <condition_variable>
#include <mutex>

#include "haptic/device/simulated_device.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/servo_rig.h"

namespace handrail {
namespace servo_loop_test {

using test::kTick;

constexpr double kScale = 60.0;

ServoTuning room_tuning() {
    ServoTuning tuning;
    tuning.touch.world_m_per_hand_m = kScale;
    tuning.touch.radius_m = 0.12;
    tuning.touch.rated_stiffness_n_per_m = 400.0;
    tuning.touch.damping_ns_per_m = 5.0;
    tuning.touch.default_friction_static = tuning.touch.default_friction_kinetic = 0.3;
    return tuning;
}

// What the app does before tick i: it walks, moves the hand, replaces scenes, changes settings and causes faults.
class Script {
public:
    explicit Script(ServoLoop& loop, SimulatedHand& hand, const std::vector<std::shared_ptr<const HapticScene>>& scenes)
        : loop_(loop), hand_(hand), scenes_(scenes) {}

    void before_tick(int i, double now_s) {
        if (i == 0) {
            loop_.set_tuning(tuning_);
            loop_.set_scene(scenes_[0]);
        }
        if (i % 17 == 0) {
            pose_.time_s = now_s;
            pose_.origin_m = Vec3(0.1 * std::sin(0.001 * i), 0.3 * std::sin(0.002 * i), 1.0);
            pose_.heading_rad = 0.0005 * i;
            loop_.set_pose(pose_);
        }
        if (i % 13 == 0)
            hand_.command.publish(
                {HandMode::Follow, Vec3(0.02 * std::sin(0.004 * i), 0.03 * std::cos(0.003 * i), 0), 0.0, Vec3(0.0), 0});
        if (i % 700 == 350) loop_.set_scene(scenes_[static_cast<std::size_t>(i / 700) % scenes_.size()]);
        if (i % 900 == 450) {
            tuning_.touch.default_stiffness_fraction = 0.5 + 0.1 * (i / 900 % 4);
            ++tuning_.confirm;
            loop_.set_tuning(tuning_);
        }
        if (i == 2000) hand_.trouble.publish({.not_a_number_samples = 2});
        if (i == 2100)
            hand_.trouble.publish({.not_a_number_samples = 0, .jump_samples = 3, .jump_m = Vec3(0.05, 0, 0)});
        if (i == 2900) hand_.trouble.publish({.silent_samples = 20});
    }

private:
    ServoLoop& loop_;
    SimulatedHand& hand_;
    const std::vector<std::shared_ptr<const HapticScene>>& scenes_;
    ServoTuning tuning_ = room_tuning();
    WorkspacePose pose_;
};

std::vector<std::shared_ptr<const HapticScene>> two_rooms() {
    return {test::wall_scene(1.2, FeatureId{1}), test::wall_scene(1.0, FeatureId{2})};
}

void add(std::vector<std::uint64_t>& bits, double value) { bits.push_back(std::bit_cast<std::uint64_t>(value)); }
void add(std::vector<std::uint64_t>& bits, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) add(bits, v[axis]);
}

// Returns every number of a ToolState as its bits.
std::vector<std::uint64_t> bits_of(const ToolState& tool) {
    std::vector<std::uint64_t> bits;
    for (const double value : {tool.time_s, tool.proxy_radius_m, tool.force_gain, tool.contact_s, tool.rate_hz})
        add(bits, value);
    for (const Vec3& v : {tool.hip_m, tool.proxy_m, tool.hand_m, tool.force_n}) add(bits, v);
    for (int i = 0; i < tool.contacts.count; ++i) {
        const Contact& contact = tool.contacts.contacts[static_cast<std::size_t>(i)];
        add(bits, contact.normal);
        add(bits, contact.share);
        bits.push_back(contact.feature.value);
    }
    for (const std::uint64_t value :
         {std::uint64_t{tool.contacts.count}, std::uint64_t{tool.liquid.value}, std::uint64_t{tool.buttons},
          static_cast<std::uint64_t>(tool.fault), std::uint64_t{tool.fault_latched}, tool.ticks,
          std::uint64_t{tool.scene_generation}})
        bits.push_back(value);
    return bits;
}

// A virtual clock whose sleeper waits until the test releases it, so that two threads take turns.
class TurnClock final : public Clock {
public:
    double now_s() const override { return clock_.now_s(); }
    void sleep_until_s(double time_s) override {
        std::unique_lock lock(mutex_);
        sleeping_ = true;
        changed_.notify_all();
        changed_.wait(lock, [this] { return turns_ > 0; });
        --turns_;
        sleeping_ = false;
        clock_.sleep_until_s(time_s);
    }
    void wait_until_it_sleeps() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return sleeping_ && turns_ == 0; });
    }
    void let_it_run(int turns) {
        const std::scoped_lock lock(mutex_);
        turns_ += turns;
        changed_.notify_all();
    }

private:
    VirtualClock clock_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool sleeping_ = false;
    int turns_ = 0;
};

constexpr int kTicks = 4000;

TEST(ServoLoop, gives_bit_identical_tool_states_with_one_or_two_threads) {
    const auto scenes = two_rooms();
    std::vector<std::vector<std::uint64_t>> alone, together;
    bool touched = false, faulted = false;
    {
        VirtualClock clock;
        auto hand = std::make_shared<SimulatedHand>();
        ServoLoop loop(std::make_unique<SimulatedDevice>(*find_device_spec("sim-t"), hand), clock);
        ASSERT_TRUE(loop.open());
        Script script(loop, *hand, scenes);
        double next_s = 0.0;
        for (int i = 0; i < kTicks; ++i) {
            script.before_tick(i, clock.now_s());
            loop.step();
            alone.push_back(bits_of(loop.tool()));
            touched |= glm::length(loop.tool().force_n) > 0.5;
            faulted |= loop.tool().fault_latched;
            next_s += kTick;
            clock.sleep_until_s(next_s);
        }
    }
    EXPECT_TRUE(touched && faulted);  // the script must reach a wall and a fault
    {
        TurnClock clock;
        auto hand = std::make_shared<SimulatedHand>();
        ServoLoop loop(std::make_unique<SimulatedDevice>(*find_device_spec("sim-t"), hand), clock);
        ASSERT_TRUE(loop.open());
        Script script(loop, *hand, scenes);
        script.before_tick(0, 0.0);
        loop.start();
        double next_s = 0.0;
        for (int i = 0; i < kTicks; ++i) {
            clock.wait_until_it_sleeps();
            together.push_back(bits_of(loop.tool()));
            next_s += kTick;
            if (i + 1 < kTicks) {
                script.before_tick(i + 1, next_s);
                clock.let_it_run(1);
            }
        }
        loop.request_stop();
        clock.let_it_run(1000);
        loop.stop();
    }
    ASSERT_EQ(alone.size(), together.size());
    for (std::size_t i = 0; i < alone.size(); ++i) ASSERT_EQ(alone[i], together[i]) << "tick " << i;
}

TEST(ServoLoop, runs_on_its_own_thread_in_parallel_with_app_and_audio) {
    const auto scenes = two_rooms();
    SteadyClock clock;
    auto hand = std::make_shared<SimulatedHand>();
    ServoLoop loop(std::make_unique<SimulatedDevice>(*find_device_spec("sim-t"), hand), clock);
    ASSERT_TRUE(loop.open());
    Script script(loop, *hand, scenes);
    script.before_tick(0, clock.now_s());
    loop.start();
    std::atomic<bool> done{false};
    std::uint64_t heard = 0;
    double last_heard_s = 0.0;
    bool in_order = true;
    std::thread ears([&] {
        while (!done.load()) {
            loop.events().consume_all([&](const ContactEvent& event) {
                ++heard;
                in_order &= event.time_s >= last_heard_s;
                last_heard_s = event.time_s;
            });
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    });
    std::vector<std::weak_ptr<const HapticScene>> swapped;
    // The number of servo ticks ends this loop, so a slow machine only takes longer.
    for (int i = 1; loop.tool().ticks < 1500; ++i) {
        script.before_tick(i, clock.now_s());
        if (i % 20 == 0) {
            auto scene = test::wall_scene(1.0 + 0.001 * i, FeatureId{static_cast<std::uint32_t>(i)});
            swapped.push_back(scene);
            loop.set_scene(std::move(scene));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const std::size_t kept = loop.scenes_kept();
    loop.stop();
    done = true;
    ears.join();
    EXPECT_TRUE(in_order);
    EXPECT_LE(kept, 3u);
    EXPECT_GE(swapped.size(), 10u);
    int alive = 0;
    for (const auto& scene : swapped) alive += !scene.expired();
    EXPECT_LE(alive, 1);
    EXPECT_EQ(loop.tool().force_gain, 0.0);
    const ServoReport& report = loop.report();
    EXPECT_GE(report.counters.periods.total(), 1499u);
    EXPECT_NE(report.scheduling, Scheduling::NotStarted);
    EXPECT_FALSE(scheduling_sentence(report.scheduling).empty());
    fmt::print(
        "[ measured ] {} period p50 {} s, p99 {} s, worst {:.6f} s; tick p99 {} s, worst {:.6f} s; overruns {}; events "
        "heard {}\n",
        scheduling_sentence(report.scheduling), report.counters.periods.quantile_s(0.5),
        report.counters.periods.quantile_s(0.99), report.counters.periods.worst_s, report.durations.quantile_s(0.99),
        report.durations.worst_s, report.overruns, heard);
}

// A device that records the commands that it receives.
class NotingDevice final : public HapticDevice {
public:
    struct Notes {
        std::vector<double> forces_n;
        Vec3 position_m{0.0};
        int opened = 0, closed = 0;
        bool refuses = false;
    };
    explicit NotingDevice(Notes& notes) : notes_(notes) {}
    const DeviceSpec& spec() const override { return *find_device_spec("sim-t"); }
    Result<void> open() override {
        if (notes_.refuses) return fail("The touch device is in use by another program; close that first.");
        ++notes_.opened;
        return {};
    }
    DeviceSample read(double) noexcept override { return {notes_.position_m, 0, true, true}; }
    void write(const ForceCommand& command) noexcept override {
        if (notes_.forces_n.size() < notes_.forces_n.capacity())
            notes_.forces_n.push_back(glm::length(command.force_n));
    }
    void close() noexcept override { ++notes_.closed; }

private:
    Notes& notes_;
};

// Presses the hand into a wall until the force ramp is complete.
void press(ServoLoop& loop, NotingDevice::Notes& notes, VirtualClock& clock) {
    notes.forces_n.reserve(100000);
    ServoTuning tuning = room_tuning();
    tuning.touch.default_friction_static = tuning.touch.default_friction_kinetic = 0.0;
    loop.set_tuning(tuning);
    loop.set_pose({});
    loop.set_scene(test::wall_scene(1.2));
    for (int i = 0; i < 1500; ++i) {
        notes.position_m.y = std::min(0.021, i * 1e-4);
        ASSERT_TRUE(loop.step());
        clock.advance_s(kTick);
    }
    ASSERT_GT(notes.forces_n.back(), 0.5);
}

TEST(ServoLoop, stopping_removes_the_force_within_75_ms_and_then_closes) {
    NotingDevice::Notes notes;
    VirtualClock clock;
    ServoLoop loop(std::make_unique<NotingDevice>(notes), clock);
    ASSERT_TRUE(loop.open());
    press(loop, notes, clock);
    const std::size_t before = notes.forces_n.size();
    loop.request_stop();
    while (loop.step()) clock.advance_s(kTick);
    EXPECT_LE(notes.forces_n.size() - before, 76u);
    for (std::size_t i = before; i < notes.forces_n.size(); ++i) EXPECT_LE(notes.forces_n[i], notes.forces_n[i - 1]);
    EXPECT_EQ(notes.forces_n.back(), 0.0);
    EXPECT_EQ(notes.closed, 0);
    loop.stop();
    loop.stop();
    EXPECT_EQ(notes.closed, 1);
    EXPECT_EQ(notes.opened, 1);
}

// Presses the stop key F12 in virtual time, without the app. The thread that sees the key sets the stop switch; on the
// next tick, the force must be zero.
TEST(ServoLoop, the_stop_switch_zeroes_the_force_on_the_next_tick_and_a_lost_keyboard_within_76_ticks) {
    for (const bool stop : {true, false}) {
        VirtualClock clock;
        ServoSwitches switches;
        ServoLoop::EventRing ring;
        auto hand = std::make_shared<SimulatedHand>();
        ServoLoop loop(std::make_unique<SimulatedDevice>(*find_device_spec("sim-f"), hand), clock, kTick,
                       {&switches, &ring});
        ASSERT_TRUE(loop.open());
        loop.set_tuning(room_tuning());
        loop.set_scene(test::wall_scene(0.4));
        const auto steps = [&](int count) {
            for (int i = 0; i < count; ++i) {
                loop.step();
                clock.sleep_until_s(clock.now_s() + kTick);
            }
        };
        for (const double y : {0.004, 0.006}) {
            hand->command.publish({HandMode::Move, Vec3(0, y, 0), 0.05, Vec3(0.0), 0});
            steps(1500);
        }
        ASSERT_GT(glm::length(loop.tool().force_n), 0.3);
        if (stop) switches.stop();
        else switches.focused = false;
        steps(stop ? 1 : 76);
        EXPECT_EQ(loop.tool().force_n, Vec3(0.0)) << stop;
        steps(500);
        EXPECT_EQ(loop.tool().force_n, Vec3(0.0)) << stop;
        ContactEvent event, last;
        while (ring.pop(event)) last = event;
        EXPECT_EQ(last.kind == ContactEventKind::FaultRaised, !stop) << "the app says what a stop is";
        ServoTuning let_go = room_tuning();
        let_go.stops_let_go = switches.stops;
        loop.set_tuning(let_go);
        switches.focused = true;
        steps(1);
        EXPECT_GT(loop.tool().force_gain, 0.0);
        EXPECT_LT(loop.tool().force_gain, 2e-3);
        loop.stop();
    }
}

TEST(ServoLoop, the_destructor_stops_a_running_thread) {
    NotingDevice::Notes notes;
    VirtualClock clock;  // sleeping advances this clock, so the thread runs as fast as it can
    {
        ServoLoop loop(std::make_unique<NotingDevice>(notes), clock);
        ASSERT_TRUE(loop.open());
        loop.start();
        while (loop.tool().ticks < 100) std::this_thread::yield();
    }
    EXPECT_EQ(notes.closed, 1);
}

TEST(ServoLoop, reports_the_reason_if_a_device_refuses_and_starts_nothing) {
    NotingDevice::Notes notes;
    notes.refuses = true;
    VirtualClock clock;
    ServoLoop loop(std::make_unique<NotingDevice>(notes), clock);
    const Result<void> opened = loop.open();
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().message.find("in use"), std::string::npos);
    loop.start();
    loop.stop();
    EXPECT_EQ(loop.tool().ticks, 0u);
    EXPECT_EQ(notes.closed, 0);
}

TEST(ServoLoop, frees_a_scene_only_after_the_servo_thread_has_released_it) {
    NotingDevice::Notes notes;
    VirtualClock clock;
    ServoLoop loop(std::make_unique<NotingDevice>(notes), clock);
    ASSERT_TRUE(loop.open());
    auto first = test::wall_scene(1.2);
    std::weak_ptr<const HapticScene> watch = first;
    loop.set_scene(std::move(first));
    loop.step();
    loop.set_scene(test::wall_scene(1.0));
    EXPECT_EQ(loop.scenes_kept(), 2u);
    EXPECT_FALSE(watch.expired());
    clock.advance_s(kTick);
    loop.step();
    EXPECT_EQ(loop.scenes_kept(), 1u);
    EXPECT_TRUE(watch.expired());
    // The loop must also free scenes that the servo never used.
    for (int i = 0; i < 5; ++i) loop.set_scene(test::wall_scene(1.0));
    clock.advance_s(kTick);
    loop.step();
    EXPECT_EQ(loop.scenes_kept(), 1u);
}

TEST(ServoLoop, counts_events_that_were_not_fetched_in_time) {
    NotingDevice::Notes notes;
    VirtualClock clock;
    ServoLoop loop(std::make_unique<NotingDevice>(notes), clock);
    ASSERT_TRUE(loop.open());
    press(loop, notes, clock);
    for (int i = 0; i < 20000; ++i) {
        notes.position_m = Vec3(0.02 * std::sin(0.003 * i), 0.021, 0.0);
        loop.step();
        clock.advance_s(kTick);
    }
    loop.request_stop();
    while (loop.step()) clock.advance_s(kTick);
    loop.stop();
    const std::size_t waiting = loop.events().read_available();
    EXPECT_GE(waiting, 1000u);
    EXPECT_GT(loop.report().counters.lost_events, 100u);
}

// Two devices are two hands. Each has its own thread, and both feel the same scene. A fault that stops one hand must
// not stop the other.
TEST(ServoLoop, two_loops_share_only_a_scene_and_the_stop_key) {
    SteadyClock clock;
    ServoSwitches switches;
    const auto scene = test::wall_scene(1.2, FeatureId{1});
    struct Hand {
        std::shared_ptr<SimulatedHand> simulated = std::make_shared<SimulatedHand>();
        ServoLoop::EventRing events;
        std::unique_ptr<ServoLoop> loop;
    };
    std::array<Hand, 2> hands;
    WorkspacePose pose;
    pose.time_s = clock.now_s();
    for (std::size_t i = 0; i < hands.size(); ++i) {
        Hand& hand = hands[i];
        DeviceSpec spec = *find_device_spec(i == 0 ? "sim-t" : "sim-f");
        spec.min_rate_hz = 0.0;  // the load of this machine must not cause faults here
        hand.loop = std::make_unique<ServoLoop>(std::make_unique<SimulatedDevice>(spec, hand.simulated), clock, kTick,
                                                ServoLoop::Links{&switches, &hand.events});
        ASSERT_TRUE(hand.loop->open());
        ServoTuning tuning = room_tuning();
        tuning.force_ceiling_n = i == 0 ? 0.5 : 2.0;
        hand.loop->set_scene(scene);
        hand.loop->set_tuning(tuning);
        hand.loop->set_pose(pose);
    }
    for (Hand& hand : hands) hand.loop->start();
    const auto put = [&](const Vec3& at_m) {
        for (Hand& hand : hands) {
            HandCommand command;
            command.mode = HandMode::Move;
            command.target_m = at_m;
            command.speed_m_per_s = 0.1;
            hand.simulated->command.publish(command);
        }
    };
    // Waits until `holds` returns true. On a busy machine this may take long. If the loop is faulty, it never ends.
    const auto until = [&](auto holds) {
        while (!holds()) clock.sleep_until_s(clock.now_s() + kTick);
    };
    const auto force_n = [&](std::size_t i) { return glm::length(hands[i].loop->tool().force_n); };
    put({0.0, 0.01, 0.0});
    until([&] { return !hands[0].loop->tool().waiting_for_hand && !hands[1].loop->tool().waiting_for_hand; });
    put({0.0, 0.03, 0.0});
    until([&] { return force_n(0) > 0.45 && force_n(1) > 0.55; });
    EXPECT_LE(force_n(0), 0.5 + 1e-9) << "each has its own ceiling";
    for (Hand& hand : hands) {
        bool met = false;
        until([&] {
            hand.events.consume_all([&](const ContactEvent& event) {
                met |= event.kind == ContactEventKind::Begin && event.feature == FeatureId{1};
            });
            return met;
        });
    }
    DeviceTrouble trouble;
    trouble.unplugged = true;
    hands[1].simulated->trouble.publish(trouble);
    until([&] { return hands[1].loop->tool().fault == Fault::Unplugged; });
    EXPECT_EQ(force_n(1), 0.0);
    const std::uint64_t then = hands[0].loop->tool().ticks;
    until([&] { return hands[0].loop->tool().ticks > then + 50; });
    EXPECT_NE(hands[0].loop->tool().fault, Fault::Unplugged);
    switches.stop();
    until([&] { return force_n(0) == 0.0; });
    for (Hand& hand : hands) hand.loop->stop();
}

}  // namespace servo_loop_test
}  // namespace handrail
