// Stores the pending request to leave the program or a lesson. The first request opens a question that the person must
// confirm. A second request within kWindow_s leaves at once. Plain state for the app thread only.
#pragma once

namespace handrail::core {

struct LeaveRequested {
    static constexpr double kWindow_s = 5.0;
    bool lately(double now_s) const { return now_s - at_s <= kWindow_s; }

    double at_s = -1e9;
};

}  // namespace handrail::core
