// The things that were set down in a world, where they are now and where they go: what the servo is told of them. App
// thread only.
#pragma once

#include <string>
#include <vector>

#include "haptic/compile/simplify_scene.h"
#include "haptic/servo/body_playback.h"
#include "worlds/scene/scene.h"

namespace handrail {

class PlacedThings {
public:
    // Takes the placed models of a scene as they stand there, and the haptic scene that was compiled from it by this
    // plan. The servo is told of places as they are felt, everybody else of the true ones.
    void enter(const Scene& scene, const HapticScene& haptic, const Simplification& plan, double now_s);
    // The same things, wherever they are now, in a haptic scene that was compiled anew.
    void feel_as(const Scene& scene, const HapticScene& haptic, const Simplification& plan, double now_s);
    // Slides and turns a thing evenly to another placement; speed > 0, in world metres per second of its position (a
    // pure turn or change of size takes one second). Index into Scene::placed.
    void send(std::size_t thing, const Placement& to, double speed_m_per_s);
    // A thing that somebody else moves stands there from the next tick on.
    void put(std::size_t thing, const Placement& at);
    // True when something that was on its way has arrived.
    bool tick(double now_s, double dt_s);

    std::size_t size() const { return things_.size(); }
    const Placement& at(std::size_t thing) const { return things_[thing].at; }
    bool moving() const;
    std::vector<Placement> all() const;
    // For the servo: rises in number whenever something moved.
    const BodyFrame& frame() const { return frame_; }

private:
    struct Thing {
        Placement at, from, to;
        double part = 1.0, parts_per_s = 0.0;  // of the way
        int doorway = -1;                      // that is widened with it: place in doorways_
    };
    void publish(double now_s);

    std::vector<Thing> things_;
    std::vector<NarrowOpening> doorways_;
    bool put_ = false;              // since the last tick
    std::uint32_t generation_ = 0;  // of the haptic scene
    BodyFrame frame_;
};

}  // namespace handrail
