#include "app/main/end_signals.h"

#include <atomic>

namespace handrail::program {
namespace {

// The signal handler changes only this flag, because a handler may change nothing else safely.
std::atomic<bool> end_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

EndSignals::EndSignals() {
    end_requested = false;
    struct sigaction action {};
    action.sa_handler = [](int) { end_requested.store(true, std::memory_order_relaxed); };
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &action, &before_[i]);
}

EndSignals::~EndSignals() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

bool EndSignals::requested() const { return end_requested.load(std::memory_order_relaxed); }

}  // namespace handrail::program
