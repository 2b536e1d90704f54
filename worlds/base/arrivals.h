// Decides in which tick of a session the result of a background task (rooms, the hand's scene, routes) is there: as it
// comes, which is reported to the recorder; or in exactly the ticks of a recording, for which the session waits. Every
// query by the session is counted, and the same session queries in the same order. Owned by the owner of the session;
// each background task gets it when it is made. Plain state; the session's thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <utility>

namespace handrail {

class Arrivals {
    enum class Mode : std::uint8_t { Outside, Counts, LooksOnly };

public:
    // As it comes; `tell` gets the number of each query that was answered with yes.
    explicit Arrivals(std::function<void(std::uint64_t asked)> tell) : tell_(std::move(tell)) {}
    // Exactly these queries are answered with yes.
    explicit Arrivals(std::set<std::uint64_t> came) : came_(std::move(came)) {}

    // While one lives, queries are counted and answered so; outside of any, results are there as soon as they are done.
    // looks_only: somebody reads the session between its ticks; nothing new is there then. of: null if nobody records.
    class Turn {
    public:
        explicit Turn(Arrivals* of, bool looks_only = false) : of_(of) {
            if (of_) before_ = std::exchange(of_->mode_, looks_only ? Mode::LooksOnly : Mode::Counts);
        }
        ~Turn() {
            if (of_) of_->mode_ = before_;
        }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

    private:
        Arrivals* of_;
        Mode before_ = Mode::Outside;
    };

    // Queries `of`, which may be null: `try_it` returns whether the result is there by now; `wait` makes sure that it
    // is, and is called at most once.
    template <class TryIt, class Wait>
    static bool there(Arrivals* of, TryIt try_it, Wait wait) {
        if (!of || of->mode_ == Mode::Outside) return try_it();
        if (of->mode_ == Mode::LooksOnly) return false;
        const std::uint64_t asked = ++of->asked_;
        if (of->came_) {
            if (!of->came_->contains(asked)) return false;
            wait();
            return true;
        }
        const bool yes = try_it();
        if (yes) of->tell_(asked);
        return yes;
    }

private:
    std::function<void(std::uint64_t)> tell_;
    std::optional<std::set<std::uint64_t>> came_;
    std::uint64_t asked_ = 0;
    Mode mode_ = Mode::Outside;
};

}  // namespace handrail
