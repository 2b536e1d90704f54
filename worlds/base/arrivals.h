// Decides in which tick of a session the result of a background task (rooms, the hand's scene, routes) becomes
// available. In a live session that is the first tick after the work is done, and the recorder stores its number. In a
// replay it is the recorded tick, in which the session waits for the result. The class counts every query by the
// session; a replay repeats the same queries in the same order, so a count identifies a query. The owner of the session
// owns this object and hands it to each background task on construction. Plain state, used on the session's thread
// only.
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
    // Makes the object for a live session, in which a result is available as soon as it is done. `report` receives the
    // count of each query that was answered with yes.
    explicit Arrivals(std::function<void(std::uint64_t number)> report) : report_(std::move(report)) {}
    // Makes the object for a replay. The queries with the counts in `came` are answered with yes, and no others.
    explicit Arrivals(std::set<std::uint64_t> came) : came_(std::move(came)) {}

    // While a Turn exists, Arrivals counts and answers queries as described above. While none exists, results are
    // available as soon as they are done. Set `looks_only` if code reads the session between its ticks: every query is
    // then answered with no. `of` is null if the session is neither recorded nor replayed.
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

    // Returns whether a result is available. `of` decides this; if `of` is null, `try_it` decides. `try_it` returns
    // whether the result is done by now. `wait` blocks until the result is done; it is called at most once.
    template <class TryIt, class Wait>
    static bool there(Arrivals* of, TryIt try_it, Wait wait) {
        if (!of || of->mode_ == Mode::Outside) return try_it();
        if (of->mode_ == Mode::LooksOnly) return false;
        const std::uint64_t number = ++of->queries_;
        if (of->came_) {
            if (!of->came_->contains(number)) return false;
            wait();
            return true;
        }
        const bool yes = try_it();
        if (yes) of->report_(number);
        return yes;
    }

private:
    std::function<void(std::uint64_t)> report_;
    std::optional<std::set<std::uint64_t>> came_;
    std::uint64_t queries_ = 0;
    Mode mode_ = Mode::Outside;
};

}  // namespace handrail
