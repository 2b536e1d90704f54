// Decides how a walk continues when the walker meets something. The walker slides along a surface that it meets at
// under 45 degrees, and slides sideways into a doorway whose frame it meets. At anything else it stops. Measurements
// and decisions match BlindGround::walk, so that spoken directions are valid for the session's walker. Plain state for
// the app thread, in world metres.
#pragma once

#include <functional>
#include <optional>

#include "worlds/base/vec.h"

namespace handrail::core {

class Gait {
public:
    // Forgets earlier contacts. Call it when another walk begins.
    void begin() { *this = {}; }
    // Ends a slide to the side. Call it when the walker does not walk.
    void stand() { aside_m_ = 0.0; }
    // Returns how far the walker must still slide to the side into a doorway, positive to the right of the walking
    // direction. The walk waits meanwhile.
    double aside_left_m() const { return aside_m_; }
    // Call it after each tick of a slide to the side, with the intended and the actual distance. If the actual distance
    // is shorter, an obstacle stopped the slide. The slide then ends, and the walk continues from there.
    void went_aside(double intended_m, double made_m);

    enum class Course { On, Along, Aside, Stopped };
    // Call it after each tick of the walk itself, with the intended and the actual distance. `met` is true if the
    // walker touched something. `line_up_m` is called when the walker is stopped, and may be null.
    // BlindGround::line_up_m explains its result.
    Course went(double intended_m, double made_m, bool met, const std::function<std::optional<double>()>& line_up_m);

private:
    double intended_m_ = 0.0, made_m_ = 0.0;  // intended and actual distance since the last decision
    double aside_m_ = 0.0;
    int lined_up_ = 0;
};

}  // namespace handrail::core
