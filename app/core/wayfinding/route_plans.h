// Plans the present route, along the stops of a saved route or directly to one goal. This class plans how the route
// continues from a place, for the walker and for a hand. It announces nothing. A plan takes milliseconds. Lengths are
// in world metres. Use it on the app thread only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/saved_routes.h"
#include "app/core/wayfinding/stops.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// A path from the hand to a thing.
struct HandRoute {
    std::vector<Vec3> points_m;  // points of the path; empty: `problem` says why there is no path
    std::string problem;
    bool reaches = true;
    double short_of_m = 0.0;
    std::vector<std::string> passes;  // doors and stairs on the path, in order
};

class RoutePlans : SessionPart {
public:
    RoutePlans(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void enter_world();

    // ---- following a saved route ----
    // Begins the route, which must have at least one stop. If `first_passed` is true and there is a second stop, the
    // route begins with the second stop.
    void begin(const std::vector<Stop>& stops, bool first_passed, bool by_hand);
    void end() { run_.reset(); }
    bool running() const { return run_.has_value(); }
    bool by_hand() const { return run_ && run_->by_hand; }
    void go_on_by_ear() { run_->by_hand = false; }
    // Returns the next stop whose arrival is announced. Valid only while a saved route is followed.
    const Stop& stop() const { return run_->stops[run_->goal()]; }
    bool runs_to(const std::string& goal) const { return run_ && stop().name == goal; }
    // Returns the rest of the route from `from_m` to stop(), and follows it from now on.
    navigation::Route on(const Vec3& from_m);
    // Returns the same route as on(), but does not follow it.
    navigation::Route looked_at(const Vec3& from_m) const {
        return plan_through(rooms_.navigation(), from_m, run_->places());
    }
    // Mark the stops without a name that have been passed. They use the place of the hand, or the distance along the
    // route that on() returned.
    void pass(const Vec3& hand_m);
    void pass(double along_m);
    // Continues with the next stop. Call it when stop() has been reached. Returns false if stop() was the last stop.
    // The route has then ended.
    bool next();

    // ---- to a thing ----
    // Returns the path straight to the thing if a proxy fits through, or else along the planned route. If no route is
    // known, the path is straight, provided nothing is in between.
    HandRoute for_hand(const Goal& goal, std::size_t most_points);
    std::string why_none() const;

    // Sets the last planned route, at floor level. If `soles_m` is empty, there is none. Another route increases
    // changes().
    void know(std::vector<Vec3> soles_m);
    const std::vector<Vec3>& last_m() const { return last_m_; }
    unsigned changes() const { return changes_; }

private:
    Rooms& rooms_;
    std::optional<RouteRun> run_;
    std::vector<Vec3> last_m_;
    unsigned changes_ = 0;
};

}  // namespace handrail::core
