// What is worked out on threads beside a session (rooms, what a hand feels, ways) is there in one tick or another. Here
// is decided in which: as it comes, and told to who records; or in exactly the ones of a recording, which are waited
// for. Each time the session asks whether something is there is counted, and the same session asks in the same order.
// Plain state; the session's thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <utility>

namespace handrail {

class Arrivals {
public:
    // As it comes; `tell` hears the number of each question that was answered with yes.
    explicit Arrivals(std::function<void(std::uint64_t asked)> tell) : tell_(std::move(tell)) {}
    // Exactly those questions are answered with yes.
    explicit Arrivals(std::set<std::uint64_t> came) : came_(std::move(came)) {}

    // While one lives, what is asked on this thread is asked of these. Null: of nobody, and things come as they come.
    // looks_only: somebody looks at the session between its ticks; nothing new is there then.
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

    // Asks in this turn: `try_it` says whether it is there by now; `wait` makes sure that it is, and is called at most
    // once.
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
