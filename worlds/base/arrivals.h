// Decides in which tick the session receives a result from a background thread, such as rooms, haptic scenes or routes.
// In a live session a result arrives as soon as it is ready, and the tick is reported to whoever records. In a replay,
// results arrive in exactly the recorded ticks, and the session waits for them. Each query whether a result is ready
// gets a number; the same session makes the same queries in the same order. Plain state; used on the session's thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <utility>

namespace handrail {

class Arrivals {
public:
    // Live: results arrive as soon as they are ready. `tell` receives the number of each query that was answered with
    // yes.
    explicit Arrivals(std::function<void(std::uint64_t asked)> tell) : tell_(std::move(tell)) {}
    // Replay: exactly the queries with these numbers are answered with yes.
    explicit Arrivals(std::set<std::uint64_t> came) : came_(std::move(came)) {}

    // While a Turn exists, this Arrivals object answers the queries of this thread. With null, results arrive as soon
    // as they are ready and nothing is counted. looks_only: the session is being inspected between its ticks, so
    // nothing new arrives.
    class Turn {
    public:
        explicit Turn(Arrivals* of, bool looks_only = false) : before_{now_, looks_only_} {
            now_ = of;
            looks_only_ = of && looks_only;
        }
        ~Turn() {
            now_ = before_.first;
            looks_only_ = before_.second;
        }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

    private:
        std::pair<Arrivals*, bool> before_;
    };

    // Makes a query in this turn. `try_it` returns whether the result is ready; `wait` blocks until it is ready and is
    // called at most once.
    template <class TryIt, class Wait>
    static bool there(TryIt try_it, Wait wait) {
        if (!now_) return try_it();
        if (looks_only_) return false;
        const std::uint64_t asked = ++now_->asked_;
        if (now_->came_) {
            if (!now_->came_->contains(asked)) return false;
            wait();
            return true;
        }
        const bool yes = try_it();
        if (yes) now_->tell_(asked);
        return yes;
    }

private:
    static inline thread_local Arrivals* now_ = nullptr;
    static inline thread_local bool looks_only_ = false;

    std::function<void(std::uint64_t)> tell_;
    std::optional<std::set<std::uint64_t>> came_;
    std::uint64_t asked_ = 0;
};

}  // namespace handrail
