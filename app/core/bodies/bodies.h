// Manages the movable things of a world. The session owns this class. The class owns the physics engine of these things
// and sends it the positions of doors and of the walker. It passes the positions of the moved things to the hand, the
// walker and the view. Without a clock, the session steps the engine here, so equal input gives bit-identical results.
// With a clock, the engine runs on its own thread. A world without movable things has neither engine nor thread. Use
// the class on the app thread only.
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
    // Writes the positions of the things to `world`, and passes the engine to the servos through `hands`.
    Bodies(const SessionContext& context, WorldState& world, HandsState& hands)
        : SessionPart(context), world_(world), hand_grip_(context, hands) {}

    // Sets how an engine is made for each world that is entered after this call.
    void make_engines(BodyEngines how) { how_ = std::move(how); }
    // Starts the engine of a new world. Call it after the world and its things have been entered. If `scene` is null,
    // nothing in this world is movable.
    void enter_world(std::shared_ptr<const render::DynamicsScene> scene, double now_s);

    // Carries out the commands that take hold of a thing, release it, put it back or move it while it is held. Returns
    // false if the command belongs to another feature.
    bool act(Command command, double now_s, int times = 1);
    // Returns true if the key of this command moves the held thing instead of the walker.
    bool keeps(Command command) const { return grip_.keeps(command); }
    void release(Command command) { grip_.release(command); }
    // Advances an engine without its own thread to `now_s`. Call this function every millisecond if a hand has to feel
    // the bodies. Otherwise tick() advances the engine.
    void step_engine(double now_s);
    // Reads the engine's results and advances the grips. Call it before the positions of the things are sent to the
    // servo.
    void tick(double now_s);
    // Call this function before the walker moves with the velocity `intended_m_per_s`. It pushes the thing in front of
    // the walker if that thing is light enough, and returns true while the thing moves. It also pushes away a body that
    // has been driven into the walker, and removes the part of `intended_m_per_s` that leads into that body.
    bool push_ahead(Vec3& intended_m_per_s, double now_s);

    // Prevents the grip from announcing where the held thing came to rest. A game calls this because the game announces
    // the place.
    void step_is_announced() { grip_.step_is_announced(); }
    // Silently moves every thing back to its position in the world file.
    void restart();
    bool any_moving() const { return moving_; }
    // Returns the position of each thing while at least one of them moves; otherwise returns an empty list.
    std::vector<MovedThing> moved() const;
    bool idle() const { return grip_.idle(); }
    // Returns true once after all bodies have come to rest.
    bool take_rested() { return std::exchange(rested_, false); }
    // Returns the mass of a movable feature, or no value if the feature is not movable.
    std::optional<double> mass_kg(FeatureId feature) const;
    // Returns the engine of this world, or null if nothing in the world is movable.
    const dynamics::BodyEngine* engine() const { return engine_.get(); }
    // Counters that tell how far this class has read the engine's output.
    struct EngineRead {
        std::uint32_t engine = 0;  // number of the engine, as in HandChannel::engine
        std::uint64_t frame = 0;   // number of the last frame read, as in DynamicsFrame::number; 0: none yet
        std::uint64_t events = 0;  // number of events read since the engine was made
    };
    const EngineRead& read_of_engine() const { return read_; }
    // Returns the engine for the servo of a hand: 0 is the only or right hand, 1 the left. Returns null if nothing in
    // this world is movable.
    const std::shared_ptr<servo::HandBodyServo>& hand_engine(std::size_t which) const { return hand_engines_[which]; }
    // Returns the thing that the hand holds, or kNoFeature.
    FeatureId held_by_hand(std::size_t which) const {
        return hand_grip_.held(which) == render::kNoBody ? kNoFeature : scene_->bodies[hand_grip_.held(which)].feature;
    }

    // A game sets this function. This class calls it when a thing hits another thing or a part of the building.
    std::function<void(FeatureId thing, FeatureId met, double now_s)> on_hit;

private:
    std::uint32_t body_of(FeatureId feature) const {
        return scene_ ? handrail::render::body_of(*scene_, feature) : render::kNoBody;
    }
    Placement middle(std::uint32_t body) const;
    std::uint32_t in_reach() const;
    bool in_sight(std::uint32_t body, const Aabb& box_m) const;
    void update_engine();
    void shove(std::uint32_t body, const Vec3& speed_m_per_s);
    std::uint32_t keep_apart(Vec3& intended_m_per_s);
    void announce_in_the_way(std::uint32_t body, double now_s);
    void hear(double now_s);
    void take_places(double now_s);
    void put_back(double now_s);

    WorldState& world_;
    BodyEngines how_;
    std::shared_ptr<const render::DynamicsScene> scene_;  // null: nothing in this world is movable
    std::unique_ptr<dynamics::BodyEngine> engine_;
    dynamics::DynamicsLoop* stepped_ = nullptr;  // the engine, if this class steps it; otherwise null
    EngineRead read_;
    KeyboardGrip grip_{context_};
    BodySounds sounds_{context_};
    DeviceGrip hand_grip_;
    std::array<std::shared_ptr<servo::HandBodyServo>, 2> hand_engines_;
    std::vector<Placement> driven_;  // positions of the doors as last sent to the engine
    Vec3 walker_m_{0.0};             // position of the walker as last sent to the engine
    bool walker_lifted_ = false;
    double moved_s_ = -1e9;
    bool moving_ = false, rested_ = false;
    FeatureId hit_ = kNoFeature;  // the feature that the held thing hit last
    double hit_s_ = -1e9;
    // The body that the walker pushes, the start of the present attempt without progress, the time of the last push,
    // and the position of the body at that start.
    std::uint32_t pushed_ = render::kNoBody;
    double pushed_since_s_ = 0.0, pushed_s_ = -1e9;
    Vec3 pushed_from_m_{0.0};
    // The body that last stopped the walker, and the time when it did.
    std::uint32_t in_the_way_ = render::kNoBody;
    double in_the_way_s_ = -1e9;
};

}  // namespace handrail::core
