// How a walk continues when it meets something: it slides along a surface met at under 45 degrees, slides into a
// doorway whose frame it meets, and stops at anything else. Measurements and decisions match BlindGround::walk, so that
// routes in words are valid for the walker of the session. Plain state; app thread. World metres.
#pragma once

#include <functional>
#include <optional>

#include "worlds/base/vec.h"

namespace handrail::core {

class Gait {
public:
    // Call it when another walk begins; earlier contacts no longer count.
    void begin() { *this = {}; }
    // Call it when nobody walks: sliding ends.
    void stand() { aside_m_ = 0.0; }
    // How far the walker must still slide to the side into a doorway, positive to the right of the walk; the walk waits
    // meanwhile.
    double aside_left_m() const { return aside_m_; }
    // Reports a tick of sliding. If less than wished was made, something is in the way, and the walk continues from
    // there.
    void went_aside(double wished_m, double made_m);

    enum class Course { On, Along, Aside, Stopped };
    // Reports a tick of the walk itself; `met`: against something. line_up_m: see BlindGround::line_up_m, called once
    // the walk is held; may be null.
    Course went(double wished_m, double made_m, bool met, const std::function<std::optional<double>()>& line_up_m);

private:
    double wished_m_ = 0.0, made_m_ = 0.0;  // since the last decision
    double aside_m_ = 0.0;
    int lined_up_ = 0;
};

}  // namespace handrail::core
