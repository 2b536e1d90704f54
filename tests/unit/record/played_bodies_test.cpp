// Tests recordings of the engine of movable bodies. From such a recording, the program must recompute the engine and
// the hands bit for bit. It must do so even if the engine stalled so long that its queues for pushes and orders were
// full, and if the engine skipped time.
#include "app/record/played_bodies.h"

#include <random>

#include "haptic/dynamics/dynamics_loop.h"
#include "haptic/servo/servo_tick.h"
#include "tests/support/names.h"
#include "tests/unit/dynamics/rig.h"

namespace handrail::test {
namespace played_bodies_test {

struct World {
    std::shared_ptr<const HapticScene> felt;
    std::shared_ptr<const DynamicsScene> moves;
};
World crates() {
    BodyWorldMaker maker;
    maker.floor();
    maker.box({Vec3(1.2, -5, 0), Vec3(1.9, 5, 5)}, kWall);
    for (int i = 0; i < 6; ++i)
        maker.body(i == 2 ? ball_of(0.1) : box_of(0.1), Vec3(0.3 * i - 0.6, 0.0, 0.1), nature(0.5));
    return {maker.felt(), maker.moves()};
}

// One hand with its servo. The hand's target depends only on the time.
class OneHand {
public:
    OneHand(const World& world, std::shared_ptr<HandChannel> channel, unsigned which)
        : world_(world), which_(which), engine_(world.moves, std::move(channel), which, world.felt->bodies.size()) {
        tuning_.touch.world_m_per_hand_m = 20.0;
        tuning_.touch.radius_m = 0.04;
        tuning_.touch.rated_stiffness_n_per_m = state_.spec().rated_stiffness_n_per_m;
        tuning_.bodies.grip_buttons = 1;
        pose_.origin_m = Vec3(0.0, 0.0, 0.2);
    }
    DeviceSample sample_at(int tick) const {
        DeviceSample sample;
        sample.connected = sample.homed = true;
        const double sign = which_ == 0 ? 1.0 : -1.0;
        sample.position_m =
            Vec3(sign * (-0.05 + 2e-5 * tick), 0.004 * std::sin(0.003 * tick), -0.004 + 0.004 * std::sin(0.005 * tick));
        sample.buttons = tick % 900 > 500 ? 1U : 0U;
        return sample;
    }
    Vec3 tick(const DeviceSample& sample, double now_s) {
        pose_.time_s = now_s;
        return servo_tick(state_, {.scene = world_.felt.get(),
                                   .tuning = tuning_,
                                   .pose = pose_,
                                   .sample = sample,
                                   .now_s = now_s,
                                   .engine = &engine_})
            .force_n;
    }
    HandBodyServo& engine() { return engine_; }
    const ToolState& tool() const { return state_.tool(); }

private:
    const World& world_;
    const unsigned which_;
    HandBodyServo engine_;
    ServoState state_{*find_device_spec("sim-t")};
    ServoTuning tuning_;
    WorkspacePose pose_;
};

// Gives the engine the session's orders in a frame: it places a walker and shoves things. Every fifty frames it gives
// far more orders than fit into the engine's queue.
void request(BodyEngine& engine, int frame, std::vector<char>& answers) {
    BodyEngine::Order walker;
    walker.kind = BodyEngine::Order::Kind::Walker;
    walker.at_m = Vec3(-1.0 + 0.004 * frame, 0.6, 0.0);
    walker.radius_m = 0.2;
    walker.height_m = 1.7;
    const int times = frame % 50 == 49 ? 70 : 1;
    for (int i = 0; i < times; ++i) answers.push_back(engine.order(walker));
    BodyEngine::Order shove;
    shove.kind = BodyEngine::Order::Kind::Shove;
    shove.body = static_cast<std::uint32_t>(frame % 6);
    shove.speed_m_per_s = Vec3(0.0, 0.3, 0.0);
    shove.most_n = 20.0;
    shove.for_s = 0.05;
    answers.push_back(engine.order(shove));
    if (frame == 150) answers.push_back(engine.order({.kind = BodyEngine::Order::Kind::Restart}));
}

// What the hands and the session received from the engine.
struct Seen {
    std::vector<Vec3> forces_n[2];
    std::vector<char> answers;
    std::vector<DynamicsFrame> frames;
    std::vector<BodyEvent> events;

    void read(BodyEngine& engine) {
        for (BodyEvent event; engine.take_event(event);) events.push_back(event);
        if (engine.newer_frame_for_app()) frames.push_back(engine.frame_for_app());
    }
};

constexpr int kTicks = 6000;
constexpr double kBegin_s = 100.0;
double time_s(int tick) { return in_whole_microseconds(kBegin_s + 1.0003e-3 * tick); }

Seen recorded(const World& world, Recording& recording) {
    std::mt19937 draw(5);
    EngineRecording kept;
    DynamicsLoop engine(world.moves, kBegin_s, &kept);
    OneHand hands[2]{{world, engine.hand(0), 0}, {world, engine.hand(1), 1}};
    Seen seen;
    int stalls_until = 0;
    for (int tick = 1; tick <= kTicks; ++tick) {
        const double now_s = time_s(tick);
        for (std::size_t which = 0; which < 2; ++which) {
            HandRow row;
            row.time_s = now_s;
            row.sample = hands[which].sample_at(tick);
            row.force_n = hands[which].tick(row.sample, now_s);
            HandBodyServo& side = hands[which].engine();
            row.bodies = {side.channel().engine, side.channel().frame.read().number, side.take_refused()};
            recording.hands[which].push_back(row);
            seen.forces_n[which].push_back(row.force_n);
            // The engine may also step between the ticks of the two hands.
            if (tick >= stalls_until && draw() % 4 == 0) engine.step_until(now_s);
        }
        if (draw() % 150 == 0) stalls_until = tick + static_cast<int>(draw() % 200);
        if (tick % 17 != 0) continue;
        request(engine, tick / 17, seen.answers);
        seen.read(engine);
        FrameRow frame;
        frame.tick = frame.left_tick = static_cast<std::uint64_t>(tick);
        frame.engine = 1;
        frame.engine_frame = engine.frame_for_app().number;
        frame.engine_events = seen.events.size();
        recording.frames.push_back(frame);
        kept.rows.consume_all([&](const EngineRow& row) { recording.bodies.push_back(row); });
        for (const std::uint64_t order : kept.refused)
            recording.lines.push_back({0.0, "order_refused", "{\"number\":" + std::to_string(order) + "}", 0});
        kept.refused.clear();
    }
    EXPECT_EQ(kept.lost, 0U);
    EXPECT_GT(engine.lost_s(), 0.0) << "time was let go";
    EXPECT_GT(engine.late_steps(), 100U);
    return seen;
}

Seen computed(const World& world, const Recording& recording, bool& failed) {
    std::unique_ptr<OneHand> hands[2];
    std::size_t next[2]{};
    Seen seen;
    PlayedBodies* all = nullptr;
    const auto step = [&](std::size_t which) {
        if (next[which] >= recording.hands[which].size()) return false;
        const HandRow& row = recording.hands[which][next[which]];
        if (!all->before_tick(which, row)) return false;
        ++next[which];
        seen.forces_n[which].push_back(hands[which]->tick(row.sample, row.time_s));
        all->after_tick(which, row, &hands[which]->engine());
        return true;
    };
    PlayedBodies bodies(recording, step);
    all = &bodies;
    const auto engine = bodies.make(world.moves, kBegin_s);
    for (unsigned which = 0; which < 2; ++which)
        hands[which] = std::make_unique<OneHand>(world, engine->hand(which), which);
    int frame = 0;
    for (const FrameRow& row : recording.frames) {
        for (std::size_t which = 0; which < 2; ++which)
            while (next[which] < row.tick && step(which)) {
            }
        bodies.session_reads(row);
        request(*engine, ++frame, seen.answers);
        seen.read(*engine);
    }
    failed = bodies.failed();
    bodies.close();
    return seen;
}

TEST(PlayedBodies, repeat_bit_identically_the_recording_of_a_stalling_engine) {
    const World world = crates();
    Recording recording;
    const Seen was = recorded(world, recording);
    std::size_t refused = 0, pushed = 0, hits = 0;
    for (const auto& hand : recording.hands)
        for (const HandRow& row : hand) refused += row.bodies.refused != 0;
    for (const EngineRow& row : recording.bodies) pushed += row.pushes[0] + row.pushes[1];
    for (const BodyEvent& event : was.events) hits += event.kind == BodyEvent::Kind::Hit;
    EXPECT_GT(refused, 20U) << "pushes found no room";
    EXPECT_GT(pushed, 500U);
    EXPECT_GT(hits, 20U) << "things have met";
    EXPECT_NE(std::count(was.answers.begin(), was.answers.end(), 0), 0) << "orders found no room";
    // Rounds the rows to the numbers that a file contains.
    for (auto& hand : recording.hands)
        for (HandRow& row : hand) row.bodies = row_of(numbers_of(row)).bodies;
    for (EngineRow& row : recording.bodies) row = row_of(numbers_of(row));
    bool failed = true;
    const Seen again = computed(world, recording, failed);
    EXPECT_FALSE(failed);
    EXPECT_EQ(again.answers, was.answers);
    for (std::size_t which = 0; which < 2; ++which) {
        ASSERT_GE(again.forces_n[which].size(), recording.frames.back().tick);
        for (std::size_t tick = 0; tick < again.forces_n[which].size(); ++tick)
            ASSERT_EQ(again.forces_n[which][tick], was.forces_n[which][tick]) << which << " " << tick;
    }
    ASSERT_EQ(again.frames.size(), was.frames.size());
    for (std::size_t i = 0; i < was.frames.size(); ++i) {
        ASSERT_EQ(again.frames[i].number, was.frames[i].number);
        ASSERT_EQ(again.frames[i].things, was.frames[i].things) << i;
    }
    ASSERT_EQ(again.events.size(), was.events.size());
    for (std::size_t i = 0; i < was.events.size(); ++i) ASSERT_EQ(again.events[i].at_m, was.events[i].at_m) << i;
}

TEST(PlayedBodies, with_a_missing_step_or_tick_fail_and_never_hang) {
    const World world = crates();
    Recording whole;
    (void)recorded(world, whole);
    bool failed = false;
    Recording lacks = whole;
    lacks.bodies.erase(lacks.bodies.begin() + 400);
    (void)computed(world, lacks, failed);
    EXPECT_TRUE(failed) << "a step";
    lacks = whole;
    lacks.hands[1].resize(2000);
    failed = false;
    (void)computed(world, lacks, failed);
    EXPECT_TRUE(failed) << "ticks of a hand";
    lacks = whole;
    lacks.bodies.resize(300);
    failed = false;
    (void)computed(world, lacks, failed);
    EXPECT_TRUE(failed) << "the end";
    // The rows of this recording contain random numbers that no program wrote. Whatever the results are, the
    // computation must end.
    std::mt19937_64 draw(3);
    for (int round = 0; round < 8; ++round) {
        lacks = whole;
        for (int change = 0; change < 3; ++change) {
            EngineNumbers numbers = numbers_of(lacks.bodies[draw() % 200]);
            numbers[1 + draw() % (kEngineColumns - 1)] += static_cast<std::int64_t>(draw() % 7) - 3;
            lacks.bodies[draw() % 200] = row_of(numbers);
        }
        (void)computed(world, lacks, failed);
    }
}

}  // namespace played_bodies_test
}  // namespace handrail::test
