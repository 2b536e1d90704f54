#include "app/main/end_in_time.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <stop_token>

#include "worlds/base/executor.h"

namespace handrail::program {

void EndInTime::end_within(double seconds, int status) {
    watch_ = std::jthread([seconds, status](const std::stop_token& stop) {
        name_this_thread("end-in-time");
        std::mutex mutex;
        std::condition_variable_any wake;
        std::unique_lock lock(mutex);
        wake.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
        // End the process without destructors, because another thread may still use what they would destroy.
        if (!stop.stop_requested()) std::_Exit(status);
    });
}

}  // namespace handrail::program
