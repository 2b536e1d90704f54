#include "worlds/base/clock.h"

#include <cerrno>
#include <cmath>
#include <ctime>

namespace handrail {

double SteadyClock::now_s() const {
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void SteadyClock::sleep_until_s(double time_s) {
    timespec t{};
    t.tv_sec = static_cast<time_t>(std::floor(time_s));
    t.tv_nsec = static_cast<long>((time_s - std::floor(time_s)) * 1e9);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
    }
}

}  // namespace handrail
