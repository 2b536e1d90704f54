// The way that is gone now, along the stops of a kept way or straight to one goal: where it leads on from a place, for
// the feet and for a hand. Plans and says nothing; a plan takes milliseconds. Metres, world. App thread only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/ways.h"
#include "app/core/wayfinding/stops.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

// From the hand to a thing.
struct WayForHand {
    std::vector<Vec3> points_m;  // none: `problem` says why
    std::string problem;
    bool reaches = true;
    double short_of_m = 0.0;
    std::vector<std::string> passes;  // doors and stairs, in order
};

class WayPlans : SessionPart {
public:
    WayPlans(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void enter_world();

    // ---- a kept way that is gone along ----
    // At least one stop. If the first one is passed already, the way begins at the second, if there is one.
    void begin(const std::vector<Stop>& stops, bool first_passed, bool by_hand);
    void end() { run_.reset(); }
    bool running() const { return run_.has_value(); }
    bool by_hand() const { return run_ && run_->by_hand; }
    void go_on_by_ear() { run_->by_hand = false; }
    // The stop whose reaching is told; only while one is gone along.
    const Stop& stop() const { return run_->stops[run_->goal()]; }
    bool runs_to(const std::string& goal) const { return run_ && stop().name == goal; }
    // The rest of the way from there to that stop, which is followed from now on.
    Route on(const Vec3& from_m);
    // The same, only looked at.
    Route looked_at(const Vec3& from_m) const { return plan_through(rooms_.navigation(), from_m, run_->places()); }
    // The stops without a name that lie behind: by where the hand is, or by how far one is along the way of on().
    void pass(const Vec3& hand_m);
    void pass(double along_m);
    // That stop is reached. False: it was the last one, and the way is over.
    bool next();

    // ---- to a thing ----
    // Straight to it where the ball passes, else along the planned way; where none is known, straight as long as
    // nothing stands between.
    WayForHand for_hand(const Goal& goal, std::size_t most_points);
    std::string why_none() const;

    // The way planned last, soles; empty: none. It is another one where `changes` has risen.
    void know(std::vector<Vec3> soles_m);
    const std::vector<Vec3>& last_m() const { return last_m_; }
    unsigned changes() const { return changes_; }

private:
    Rooms& rooms_;
    std::optional<WayRun> run_;
    std::vector<Vec3> last_m_;
    unsigned changes_ = 0;
};

}  // namespace handrail
