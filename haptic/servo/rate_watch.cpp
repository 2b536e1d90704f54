#include "haptic/servo/rate_watch.h"

#include <algorithm>

namespace handrail::servo {

bool too_slow(RateWatch& watch, double period_s, double min_rate_hz) noexcept {
    if (!(min_rate_hz > 0.0) || !(period_s * min_rate_hz > 1.0)) {
        watch = {};
        return false;
    }
    watch.counted_s += std::min(period_s, RateWatch::kMostPerPeriodS);
    watch.elapsed_s += period_s;
    return watch.counted_s >= RateWatch::kPatienceS * (1.0 - 1e-9);
}

}  // namespace handrail::servo
