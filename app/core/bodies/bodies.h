// The things of a world that are free to move: it owns their engine, says where doors and the person are, and puts
// what has moved where the hand, the body and the picture meet it. Without a clock the engine is stepped here, so the
// same input gives the same bits; with one it runs on a thread of its own. In a world in which nothing is free there is
// neither. App thread only.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/core/bodies/body_engines.h"
#include "app/core/bodies/body_grip.h"
#include "app/core/bodies/body_sounds.h"
#include "app/core/bodies/hand_grip.h"
#include "app/core/context/session_part.h"
#include "app/core/context/view.h"
#include "haptic/dynamics/dynamics_loop.h"
#include "haptic/servo/hand_engine.h"

namespace handrail {

class Bodies : SessionPart {
public:
    // It moves the things of `world` and tells the servos by `hands`.
    Bodies(const SessionContext& context, WorldState& world, HandsState& hands)
        : SessionPart(context), world_(world), hand_grip_(context, hands) {}

    // Of every world entered from now on.
    void make_engines(BodyEngines how) { how_ = std::move(how); }
    // Null: nothing is free in it. The world and its things are entered already.
    void enter_world(std::shared_ptr<const DynamicsScene> scene, double now_s);

    // Taking hold, letting go, putting back, and while something is held the keys that move it. False: it is another's.
    bool act(Command command, double now_s, int times = 1);
    // The key moves what is held, and not the body.
    bool keeps(Command command) const { return grip_.keeps(command); }
    void release(Command command) { grip_.release(command); }
    // The engine goes on to now where it has no thread: each millisecond where a hand is to feel it, else tick() does.
    void step_engine(double now_s);
    // Before the things of the world are told to the servo.
    void tick(double now_s);
    // The body is about to walk that way: what lies before it and is not too heavy goes along. True: something does.
    // What has been driven against the body is pushed off, and nobody walks farther into it: that is taken from the
    // wish.
    bool push_ahead(Vec3& wish_m_per_s, double now_s);

    // Where what is held came to is told by a game.
    void step_is_told() { grip_.step_is_told(); }
    // Everything where the world has it, without a word.
    void restart();
    bool any_moving() const { return moving_; }
    // While any move: where each is.
    std::vector<MovedThing> moved() const;
    bool idle() const { return grip_.idle(); }
    // All has come to rest since this was asked last.
    bool take_rested() { return std::exchange(rested_, false); }
    // A free body is there: its mass; nothing: none.
    std::optional<double> mass_kg(FeatureId feature) const;
    // The engine of this world; null: nothing is free in it.
    const BodyEngine* engine() const { return engine_.get(); }
    // What has been read of it until now.
    struct EngineRead {
        std::uint32_t engine = 0;  // HandChannel::engine
        std::uint64_t frame = 0;   // DynamicsFrame::number; 0: none yet
        std::uint64_t events = 0;  // all of them
    };
    const EngineRead& read_of_engine() const { return read_; }
    // For the servo of a hand: 0 the only or right one, 1 the left one. Null: nothing is free in this world.
    const std::shared_ptr<HandEngine>& hand_engine(std::size_t which) const { return hand_engines_[which]; }
    // What a hand holds; kNoFeature: nothing.
    FeatureId held_by_hand(std::size_t which) const {
        return hand_grip_.held(which) == kNoBody ? kNoFeature : scene_->bodies[hand_grip_.held(which)].feature;
    }

    // Set by a game: one thing has met another, or a part of the building.
    std::function<void(FeatureId thing, FeatureId met, double now_s)> on_hit;

private:
    std::uint32_t body_of(FeatureId feature) const { return scene_ ? handrail::body_of(*scene_, feature) : kNoBody; }
    Placement middle(std::uint32_t body) const;
    std::uint32_t in_reach() const;
    bool in_sight(std::uint32_t body, const Aabb& box_m) const;
    void tell_engine();
    void shove(std::uint32_t body, const Vec3& speed_m_per_s);
    std::uint32_t keep_apart(Vec3& wish_m_per_s);
    void tell_in_the_way(std::uint32_t body, double now_s);
    void hear(double now_s);
    void take_places(double now_s);
    void put_back(double now_s);

    WorldState& world_;
    BodyEngines how_;
    std::shared_ptr<const DynamicsScene> scene_;  // null: nothing is free here
    std::unique_ptr<BodyEngine> engine_;
    DynamicsLoop* stepped_ = nullptr;  // the same one, where nobody else steps it
    EngineRead read_;
    BodyGrip grip_{context_};
    BodySounds sounds_{context_};
    HandGrip hand_grip_;
    std::array<std::shared_ptr<HandEngine>, 2> hand_engines_;
    std::vector<Placement> driven_;  // as the engine was told last
    Vec3 walker_m_{0.0};             // likewise
    bool walker_lifted_ = false;
    double moved_s_ = -1e9;
    bool moving_ = false, rested_ = false;
    FeatureId hit_ = kNoFeature;  // by what is held, last
    double hit_s_ = -1e9;
    // What somebody who walks pushes: since when, and whether it went.
    std::uint32_t pushed_ = kNoBody;
    double pushed_since_s_ = 0.0, pushed_s_ = -1e9;
    Vec3 pushed_from_m_{0.0};
    // What it is held from going into, likewise.
    std::uint32_t in_the_way_ = kNoBody;
    double in_the_way_s_ = -1e9;
};

}  // namespace handrail
