// The movable things of a world. This class owns their physics engine, sends it the positions of doors and of the
// person, and updates the moved things for hand, walker and view. Without a clock, the session steps the engine here,
// so equal input gives bit-identical results; with a clock, the engine runs on its own thread. If a world has no
// movable things, it has neither engine nor thread. App thread only.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/core/bodies/body_engines.h"
#include "app/core/bodies/body_sounds.h"
#include "app/core/bodies/device_grip.h"
#include "app/core/bodies/keyboard_grip.h"
#include "app/core/context/session_part.h"
#include "app/core/context/view.h"
#include "haptic/dynamics/dynamics_loop.h"
#include "haptic/servo/hand_body_servo.h"

namespace handrail::core {

class Bodies : SessionPart {
public:
    // Moves the things of `world` and passes the engine to the servos through `hands`.
    Bodies(const SessionContext& context, WorldState& world, HandsState& hands)
        : SessionPart(context), world_(world), hand_grip_(context, hands) {}

    // Applies to every world entered from now on.
    void make_engines(BodyEngines how) { how_ = std::move(how); }
    // Null: nothing in this world is movable. Call it after the world and its things have been entered.
    void enter_world(std::shared_ptr<const render::DynamicsScene> scene, double now_s);

    // Takes hold, lets go, puts back and, while something is held, moves it. Returns false if the command belongs to
    // another feature.
    bool act(Command command, double now_s, int times = 1);
    // True if the key moves the held thing instead of the walker.
    bool keeps(Command command) const { return grip_.keeps(command); }
    void release(Command command) { grip_.release(command); }
    // Advances an engine without its own thread to `now_s`. Call it every millisecond if a hand is to feel the bodies;
    // otherwise tick() does it.
    void step_engine(double now_s);
    // Call it before the places of the things are sent to the servo.
    void tick(double now_s);
    // Call it before the walker moves in this direction. Pushes what is in front of the walker if it is light enough,
    // and returns true while that moves. A body that has been driven into the walker is pushed away, and the part of
    // the wish that goes into it is removed.
    bool push_ahead(Vec3& wish_m_per_s, double now_s);

    // A game announces where the held thing came to rest, so the grip does not.
    void step_is_told() { grip_.step_is_told(); }
    // Puts everything back to its place in the world, silently.
    void restart();
    bool any_moving() const { return moving_; }
    // The place of each thing while any of them moves; otherwise empty.
    std::vector<MovedThing> moved() const;
    bool idle() const { return grip_.idle(); }
    // True once after everything has come to rest.
    bool take_rested() { return std::exchange(rested_, false); }
    // Mass of a movable feature; no value: the feature is not movable.
    std::optional<double> mass_kg(FeatureId feature) const;
    // The engine of this world; null: nothing in it is movable.
    const dynamics::BodyEngine* engine() const { return engine_.get(); }
    // How much of the engine's output has been read up to now.
    struct EngineRead {
        std::uint32_t engine = 0;  // HandChannel::engine
        std::uint64_t frame = 0;   // DynamicsFrame::number; 0: none yet
        std::uint64_t events = 0;  // number of all events read
    };
    const EngineRead& read_of_engine() const { return read_; }
    // For the servo of a hand: 0 is the only or right hand, 1 the left. Null: nothing in this world is movable.
    const std::shared_ptr<servo::HandBodyServo>& hand_engine(std::size_t which) const { return hand_engines_[which]; }
    // What a hand holds; kNoFeature: nothing.
    FeatureId held_by_hand(std::size_t which) const {
        return hand_grip_.held(which) == render::kNoBody ? kNoFeature : scene_->bodies[hand_grip_.held(which)].feature;
    }

    // Set by a game; called when one thing hits another or a part of the building.
    std::function<void(FeatureId thing, FeatureId met, double now_s)> on_hit;

private:
    std::uint32_t body_of(FeatureId feature) const {
        return scene_ ? handrail::render::body_of(*scene_, feature) : render::kNoBody;
    }
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
    std::shared_ptr<const render::DynamicsScene> scene_;  // null: nothing is movable
    std::unique_ptr<dynamics::BodyEngine> engine_;
    dynamics::DynamicsLoop* stepped_ = nullptr;  // the same engine if this class steps it; otherwise null
    EngineRead read_;
    KeyboardGrip grip_{context_};
    BodySounds sounds_{context_};
    DeviceGrip hand_grip_;
    std::array<std::shared_ptr<servo::HandBodyServo>, 2> hand_engines_;
    std::vector<Placement> driven_;  // as last sent to the engine
    Vec3 walker_m_{0.0};             // as last sent to the engine
    bool walker_lifted_ = false;
    double moved_s_ = -1e9;
    bool moving_ = false, rested_ = false;
    FeatureId hit_ = kNoFeature;  // last hit by the held thing
    double hit_s_ = -1e9;
    // What the walker pushes, since when without progress, when last, and from where.
    std::uint32_t pushed_ = render::kNoBody;
    double pushed_since_s_ = 0.0, pushed_s_ = -1e9;
    Vec3 pushed_from_m_{0.0};
    // The body that last stopped the walker, and when.
    std::uint32_t in_the_way_ = render::kNoBody;
    double in_the_way_s_ = -1e9;
};

}  // namespace handrail::core
