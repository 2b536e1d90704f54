// How a walk goes on that meets something: along what is met at under 45 degrees, into the doorway whose frame is met,
// and stopped by the rest. Measured and decided as BlindGround::walk does, so that routes for words hold for the body
// of the session. Plain state; app thread. World metres.
#pragma once

#include <functional>
#include <optional>

#include "worlds/base/vec.h"

namespace handrail {

class Gait {
public:
    // Another walk begins: what was met before counts no more.
    void begin() { *this = {}; }
    // Nobody walks any more, so nobody slides.
    void stand() { aside_m_ = 0.0; }
    // So far to the side, positive to the right of the walk, the body still has to slide into a doorway; the walk waits
    // meanwhile.
    double aside_left_m() const { return aside_m_; }
    // A tick of that has been made; less than wished: something is in the way, and the walk goes on as it is.
    void went_aside(double wished_m, double made_m);

    enum class Goes { On, Along, Aside, Stopped };
    // A tick of the walk itself has been made, `met`: against something. line_up_m: see BlindGround::line_up_m, asked
    // once the walk is held; may be null.
    Goes went(double wished_m, double made_m, bool met, const std::function<std::optional<double>()>& line_up_m);

private:
    double wished_m_ = 0.0, made_m_ = 0.0;  // since it was looked at last
    double aside_m_ = 0.0;
    int lined_up_ = 0;
};

}  // namespace handrail
