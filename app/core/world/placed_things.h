// Manages the things placed in a world: where they are now, where they are moving to, and their positions for the
// servo. Use it on the app thread only.
#pragma once

#include <string>
#include <vector>

#include "haptic/compile/simplify_scene.h"
#include "haptic/servo/body_playback.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

class PlacedThings {
public:
    // Begins with the things of a scene at their places. `haptic` is the haptic scene that was compiled from that scene
    // with the simplification plan `plan`. The servo gets the positions in the simplified scene. All other code gets
    // the true positions.
    void enter(const Scene& scene, const render::HapticScene& haptic, const compile::Simplification& plan,
               double now_s);
    // Call it when the haptic scene was compiled again. The things stay where they are.
    void feel_as(const Scene& scene, const render::HapticScene& haptic, const compile::Simplification& plan,
                 double now_s);
    // Moves and turns a thing at a constant rate to another placement. `speed_m_per_s` is the speed of its position in
    // world metres per second, and must be positive. A rotation or change of size without movement takes one second.
    // `thing` is an index into Scene::placed.
    void send(std::size_t thing, const Placement& to, double speed_m_per_s);
    // Moves a thing to a place at once, for a class that moves the thing itself. The change takes effect in the next
    // tick.
    void put(std::size_t thing, const Placement& at);
    // Moves the things for `dt_s`. Returns true if a moving thing has arrived.
    bool tick(double now_s, double dt_s);

    std::size_t size() const { return things_.size(); }
    const Placement& at(std::size_t thing) const { return things_[thing].at; }
    bool moving() const;
    std::vector<Placement> all() const;
    // Returns the positions for the servo. The number of the frame increases whenever something has moved.
    const servo::BodyFrame& frame() const { return frame_; }

private:
    struct Thing {
        Placement at, from, to;
        double part = 1.0, parts_per_s = 0.0;  // finished share of the movement of this thing, and shares per second
        int doorway = -1;  // index in doorways_ of the doorway that was widened together with this thing
    };
    void publish(double now_s);

    std::vector<Thing> things_;
    std::vector<compile::NarrowOpening> doorways_;
    bool put_ = false;              // true: put() was called since the last tick
    std::uint32_t generation_ = 0;  // generation of the haptic scene
    servo::BodyFrame frame_;
};

}  // namespace handrail::core
