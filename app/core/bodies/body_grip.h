// Holding a thing by keys: arrows move what is held by steps, PageUp and PageDown lift and lower it, Comma and Period
// turn it by quarters, Enter lets go. The engine leads it with no more than the person's strength, so it stops at what
// it meets. App thread only.
#pragma once

#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/dialogue/held_keys.h"
#include "haptic/dynamics/body_engine.h"

namespace handrail {

class BodyGrip : SessionPart {
public:
    explicit BodyGrip(const SessionContext& context) : SessionPart(context) {}

    void enter_world() { let_go(); }
    bool holds() const { return held_ != kNoBody; }
    std::uint32_t held() const { return held_; }
    bool idle() const { return !stepped_s_; }  // no step is on its way
    // Moves what is held while it is down instead of the body.
    bool keeps(Command command) const;
    void release(Command command) { keys_.release(command); }

    // From where it is now. Says so; too heavy: says that, and takes nothing.
    void take(BodyEngine& engine, const DynamicsScene& scene, std::uint32_t body, const Placement& middle,
              double now_s);
    // False: not a command of the grip.
    bool act(Command command, BodyEngine& engine, const DynamicsScene& scene, const Placement& middle, double now_s,
             int times);
    // Where the step led is told by somebody else.
    void step_is_told() { stepped_s_.reset(); }
    // What it met on the way is told when it comes to rest. hit: what it has met last; kNoFeature: nothing.
    void tick(BodyEngine& engine, const DynamicsScene& scene, const Placement& middle, FeatureId hit, double now_s);
    void let_go();
    void let_go(BodyEngine& engine, const DynamicsScene& scene, double now_s);

private:
    Vec3 way_of(Command command) const;
    double step_m(const DynamicsBody& body) const;
    void step(Command command, BodyEngine& engine, const DynamicsScene& scene, const Placement& middle, double now_s,
              int times);
    void lead(BodyEngine& engine) const;

    HeldKeys keys_;
    std::uint32_t held_ = kNoBody;
    Vec3 to_m_{0.0};  // where it is led
    Rotation turn_;
    std::optional<double> stepped_s_;  // when the last step began that has not come to its end
    Vec3 last_m_{0.0};
    double rests_since_s_ = 0.0;
    bool hints_told_ = false;
};

}  // namespace handrail
