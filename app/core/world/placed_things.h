// The things placed in a world: where they are now, where they move, and their places for the servo. App thread only.
#pragma once

#include <string>
#include <vector>

#include "haptic/compile/simplify_scene.h"
#include "haptic/servo/body_playback.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

class PlacedThings {
public:
    // Takes the placed models of a scene at their places, and the haptic scene compiled from it with this plan. The
    // servo gets places in the simplified scene; everybody else gets the true ones.
    void enter(const Scene& scene, const render::HapticScene& haptic, const compile::Simplification& plan,
               double now_s);
    // The same things at their present places, in a haptic scene that was compiled again.
    void feel_as(const Scene& scene, const render::HapticScene& haptic, const compile::Simplification& plan,
                 double now_s);
    // Moves and turns a thing evenly to another placement; speed > 0, in world metres per second of its position. A
    // pure rotation or change of size takes one second. Index into Scene::placed.
    void send(std::size_t thing, const Placement& to, double speed_m_per_s);
    // Puts a thing that another class moves to a place, from the next tick on.
    void put(std::size_t thing, const Placement& at);
    // Returns true if something that was moving has arrived.
    bool tick(double now_s, double dt_s);

    std::size_t size() const { return things_.size(); }
    const Placement& at(std::size_t thing) const { return things_[thing].at; }
    bool moving() const;
    std::vector<Placement> all() const;
    // For the servo: its number increases whenever something has moved.
    const servo::BodyFrame& frame() const { return frame_; }

private:
    struct Thing {
        Placement at, from, to;
        double part = 1.0, parts_per_s = 0.0;  // of its movement
        int doorway = -1;                      // index in doorways_ of the doorway widened with it
    };
    void publish(double now_s);

    std::vector<Thing> things_;
    std::vector<compile::NarrowOpening> doorways_;
    bool put_ = false;              // since the last tick
    std::uint32_t generation_ = 0;  // of the haptic scene
    servo::BodyFrame frame_;
};

}  // namespace handrail::core
