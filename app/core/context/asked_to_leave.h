// Leaving is asked for twice, the program as well as a lesson in it: whoever has asked a moment ago is not asked again.
// Plain state; app thread only.
#pragma once

namespace handrail {

struct AskedToLeave {
    static constexpr double kWindow_s = 5.0;
    bool lately(double now_s) const { return now_s - at_s <= kWindow_s; }

    double at_s = -1e9;
};

}  // namespace handrail
