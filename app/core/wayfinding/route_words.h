// A route in words, and following it: what is ahead, that the person is still on it, or has left it. Plain state and
// pure functions; app thread.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/dialogue/words.h"
#include "worlds/navigation/route.h"

namespace handrail::core {

// One instruction: where along the route it is due, and what is there.
struct RouteNode {
    double at_m = 0.0;
    std::string what;       // "Kitchen door", "stairs, 2.9 metres up"; empty for a turn only
    double turn_rad = 0.0;  // clockwise, to make there; 0: straight on
    Vec3 place_m{0.0};
};

// Doors, stairs and other features, turns of more than a sixteenth of a circle, and the goal, in order. A turn next to
// a feature belongs to it. name_of: spoken name of a passage.
std::vector<RouteNode> nodes_of(const navigation::Route& route, const std::string& goal,
                                const std::function<std::string(const navigation::RoutePassage&)>& name_of);

// "28 steps in all. Turn slightly left. 14 steps. Turn right. 4 steps to Front door. Turn left. 10 steps to Kitchen."
// `heading_rad`: of the listener.
std::string route_words(const navigation::Route& route, const std::vector<RouteNode>& nodes, double heading_rad,
                        const DistanceWords& how);

// Follows a walker along a route. Announces each feature once, 6 m before it, and again when it is reached, with the
// next turn. After every 10 m without an announcement, it says that the person is on the route. It also reports once
// that the person has left it.
class RouteFollower {
public:
    struct Said {
        std::string text;  // empty: nothing
        bool left = false;
        bool arrived = false;
    };
    void follow(navigation::Route route, std::vector<RouteNode> nodes);
    void stop() { route_ = {}; }
    bool following() const { return route_.points_m.size() >= 2; }
    const navigation::Route& route() const { return route_; }
    const Vec3& goal_m() const { return route_.points_m.back(); }
    double along_m() const { return along_m_; }  // distance of the person along the route
    std::vector<Vec3> ahead_m() const;           // the rest of it
    double left_m() const { return std::max(0.0, route_.length_m - along_m_); }
    // Decides whether the person has arrived. at_end: the end of the route is within kThere_m, although a wall may be
    // in between.
    using There = std::function<bool(bool at_end)>;
    Said tick(
        const Vec3& feet_m, const DistanceWords& how, const There& there = [](bool at_end) { return at_end; });

private:
    navigation::Route route_;
    std::vector<RouteNode> nodes_;
    std::vector<bool> announced_, reached_;
    double along_m_ = 0.0;
    double word_at_m_ = 0.0;  // where along the route the last announcement was
};

inline constexpr double kAnnounceAhead_m = 6.0, kReassureEvery_m = 10.0, kLeftWay_m = 2.0, kThere_m = 0.8,
                        kAtFeature_m = 1.2;

}  // namespace handrail::core
