// Lets a person find a thing by two tools: the beacon that sounds from the thing, and "warmer". Each tool guides along
// a planned route if there is one. Lengths are in world metres. Use it on the app thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/movers/doors.h"
#include "app/core/wayfinding/finding.h"
#include "app/core/wayfinding/route_plans.h"
#include "app/core/wayfinding/sought_route.h"

namespace handrail::core {

// The route along which a tool guides, and the state for it.
struct AlongRoute {
    SoughtRoute way;
    std::shared_ptr<const Scene> planned_in;  // the scene when the route was planned
    std::uint32_t jump = 0;                   // number of the last jump of the workspace when the route was planned
    double looked_s = -1e9;                   // time of the last check for obstacles and shut doors
};

class Seek : SessionPart {
public:
    Seek(const SessionContext& context, Rooms& rooms, RoutePlans& plans, Doors& doors)
        : SessionPart(context), rooms_(rooms), plans_(plans), doors_(doors) {}

    void enter_world();
    // Start the tools without an announcement.
    void start_beacon(const Goal& goal);
    void start_warmer(const Goal& goal);
    void silence_beacon() { beacon_.clear(); }
    void silence_warmer() { warmer_.clear(); }
    // These functions return a sentence that says whether the tool guides along the route or straight, and why. The
    // sentence is empty if the route is straight.
    std::string beacon_words(double now_s) { return words(beacon_along_, beacon_, false, now_s); }
    std::string warmer_words(double now_s) { return words(warmer_along_, warmer_, context_.hands.known(), now_s); }

    // Each function plays the sound of its tool when it is due, while the tool is on. A tool ends automatically when
    // the thing is found. The functions return true if the person has just found it.
    bool tick_beacon(double now_s);
    bool tick_warmer(double now_s);
    // Announces again how both tools guide now, because a line about that was cut off.
    void announce_anew(double now_s);

    const Beacon& beacon() const { return beacon_; }
    const Warmer& warmer() const { return warmer_; }
    const AlongRoute& beacon_along() const { return beacon_along_; }
    const AlongRoute& warmer_along() const { return warmer_along_; }

private:
    void plan(AlongRoute& along, const Sought& sought, bool hand, double now_s);
    bool keep(AlongRoute& along, const Sought& sought, bool hand, double now_s);
    Vec3 from_m(bool hand) const;
    bool straight_before(const SoughtRoute& way, const Sought& sought, bool hand) const;
    bool walker_gets_to(const Sought& sought) const;
    TraceHit met_on_route(const Vec3& soles_m) const;
    std::string words(AlongRoute& along, const Sought& sought, bool hand, double now_s);
    void announce_route(const AlongRoute& along, double now_s);
    std::optional<Vec3> beacon_turning(double now_s);

    Rooms& rooms_;
    RoutePlans& plans_;
    Doors& doors_;
    Beacon beacon_;
    Warmer warmer_;
    // Routes of the beacon, for the walker, and of "warmer", for the hand if there is one.
    AlongRoute beacon_along_, warmer_along_;
    // These fields are for a route on which the beacon leads the walker.
    bool turning_first_ = false;  // true: the beacon sounds from a turning of the route
    Vec3 turning_m_{0.0};         // place of that turning, at floor level
};

}  // namespace handrail::core
