#include "audio-cues/sinks/dropout_watch.h"

#include <algorithm>

namespace handrail::sinks {

bool DropoutWatch::tick(double now_s, double device_s) {
    const double late_s = now_s - device_s;
    if (!started_) {
        started_ = true;
        window_ends_s_ = now_s + kWindow_s;
        least_s_ = late_s;
    }
    least_s_ = std::min(least_s_, late_s);
    if (now_s < window_ends_s_) return too_many_;
    if (had_window_ && least_s_ > last_least_s_ + kLate_s) {
        std::rotate(dropped_s_.begin(), dropped_s_.end() - 1, dropped_s_.end());
        dropped_s_.front() = now_s;
        dropped_ = std::min(dropped_ + 1, kMost);
        if (dropped_ == kMost && now_s - dropped_s_.back() <= kWithin_s) too_many_ = true;
    }
    had_window_ = true;
    last_least_s_ = least_s_;
    least_s_ = late_s;
    window_ends_s_ = now_s + kWindow_s;
    return too_many_;
}

}  // namespace handrail::sinks
