#include "app/core/context/session_event.h"

#include <algorithm>
#include <utility>

namespace handrail::core {

void Events::report(Happening what, double now_s) {
    SessionEvent event{now_s, std::move(what)};
    if (on_reported) on_reported(event);
    if (waiting_.size() < kMost) return waiting_.push_back(std::move(event));
    waiting_[oldest_] = std::move(event);
    oldest_ = (oldest_ + 1) % kMost;
}

std::vector<SessionEvent> Events::take() {
    std::rotate(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(oldest_), waiting_.end());
    oldest_ = 0;
    return std::exchange(waiting_, {});
}

}  // namespace handrail::core
