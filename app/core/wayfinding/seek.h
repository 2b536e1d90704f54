// Finding a thing by sounds: the beacon that calls from it, and "warmer". Each works along a planned route if one is
// known. Metres, world. App thread only.
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

// The route along which a tool guides.
struct AlongRoute {
    SoughtRoute way;
    std::shared_ptr<const Scene> planned_in;  // the scene at that time
    std::uint32_t jump = 0;                   // of the workspace, at that time
    double looked_s = -1e9;                   // last check for obstacles and shut doors
};

class Seek : SessionPart {
public:
    Seek(const SessionContext& context, Rooms& rooms, RoutePlans& plans, Doors& doors)
        : SessionPart(context), rooms_(rooms), plans_(plans), doors_(doors) {}

    void enter_world();
    // Both start silently, without an announcement.
    void start_beacon(const Goal& goal);
    void start_warmer(const Goal& goal);
    void silence_beacon() { beacon_.clear(); }
    void silence_warmer() { warmer_.clear(); }
    // Whether it guides along the route or straight, and why; empty if both are the same.
    std::string beacon_words(double now_s) { return words(beacon_along_, beacon_, false, now_s); }
    std::string warmer_words(double now_s) { return words(warmer_along_, warmer_, context_.hands.known(), now_s); }

    // Each plays its sound when due, while it is on, and ends automatically. tick_beacon returns true if the beacon has
    // just been reached.
    bool tick_beacon(double now_s);
    void tick_warmer(double now_s);
    // The ways of both as they are now, since the line with one was cut.
    void tell_anew(double now_s);

    const Beacon& beacon() const { return beacon_; }
    const Warmer& warmer() const { return warmer_; }
    const AlongRoute& beacon_along() const { return beacon_along_; }
    const AlongRoute& warmer_along() const { return warmer_along_; }

private:
    void plan(AlongRoute& along, const Sought& sought, bool hand, double now_s);
    bool keep(AlongRoute& along, const Sought& sought, bool hand, double now_s);
    Vec3 from_m(bool hand) const;
    bool straight_before(const SoughtRoute& way, const Sought& sought, bool hand) const;
    bool body_gets_to(const Sought& sought) const;
    TraceHit met_on_way(const Vec3& soles_m) const;
    std::string words(AlongRoute& along, const Sought& sought, bool hand, double now_s);
    void tell_way(const AlongRoute& along, double now_s);
    std::optional<Vec3> beacon_turning(double now_s);

    Rooms& rooms_;
    RoutePlans& plans_;
    Doors& doors_;
    Beacon beacon_;
    Warmer warmer_;
    AlongRoute beacon_along_, warmer_along_;  // for the walker; for the hand if there is one
    // For a route that is walked by ear:
    bool turning_first_ = false;  // the beacon calls from a turning
    Vec3 turning_m_{0.0};         // which one, at floor level
};

}  // namespace handrail::core
