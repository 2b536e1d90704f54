// Lets the keys hold a thing. The arrow keys move the thing in steps, PageUp and PageDown lift and lower it, Comma and
// Period turn it by 90 degrees, and Enter releases it. The engine moves the thing with no more than the person's
// strength, so an obstacle stops the thing. Use this class on the app thread only.
#pragma once

#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/dialogue/held_keys.h"
#include "haptic/dynamics/body_engine.h"

namespace handrail::core {

class KeyboardGrip : SessionPart {
public:
    explicit KeyboardGrip(const SessionContext& context) : SessionPart(context) {}

    void enter_world() { let_go(); }
    bool holds() const { return held_ != render::kNoBody; }
    std::uint32_t held() const { return held_; }
    bool idle() const { return !stepped_s_; }  // true if no step is under way
    // Returns true if the key of this command, while it is down, moves the held thing instead of the walker.
    bool keeps(Command command) const;
    void release(Command command) { keys_.release(command); }

    // Takes hold of the body at its present position and announces it. If the body is too heavy, this function
    // announces that and does not take hold.
    void take(dynamics::BodyEngine& engine, const render::DynamicsScene& scene, std::uint32_t body,
              const Placement& middle, double now_s);
    // Carries out a command for the held thing. Returns false if the command belongs to another feature.
    bool act(Command command, dynamics::BodyEngine& engine, const render::DynamicsScene& scene, const Placement& middle,
             double now_s, int times);
    // Ends the step without an announcement. A game calls this because the game announces where the thing came to rest.
    void step_is_announced() { stepped_s_.reset(); }
    // Announces the result of a step when the thing comes to rest. `hit` is the feature that the thing hit last, or
    // kNoFeature.
    void tick(dynamics::BodyEngine& engine, const render::DynamicsScene& scene, const Placement& middle, FeatureId hit,
              double now_s);
    void let_go();
    void let_go(dynamics::BodyEngine& engine, const render::DynamicsScene& scene, double now_s);

private:
    Vec3 way_of(Command command) const;
    double step_m(const render::DynamicsBody& body) const;
    void step(Command command, dynamics::BodyEngine& engine, const render::DynamicsScene& scene,
              const Placement& middle, double now_s, int times);
    void lead(dynamics::BodyEngine& engine) const;

    HeldKeys keys_;
    std::uint32_t held_ = render::kNoBody;
    Vec3 to_m_{0.0};  // the position to which the engine moves the held thing
    Rotation turn_;
    std::optional<double> stepped_s_;  // start of the step that is under way; no value: none is
    Vec3 last_m_{0.0};
    double rests_since_s_ = 0.0;
    bool hints_announced_ = false;
};

}  // namespace handrail::core
