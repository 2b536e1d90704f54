// Puts a route into words, and follows a person on the route: announces what is ahead, and whether the person is still
// on the route or has left it. Plain state and pure functions for the app thread.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/dialogue/words.h"
#include "worlds/navigation/route.h"

namespace handrail::core {

// An instruction: where along the route it is due, and what is there.
struct RouteNode {
    double at_m = 0.0;
    std::string what;       // "Kitchen door", "stairs, 2.9 metres up"; empty: there is only a turn
    double turn_rad = 0.0;  // turn to make there, clockwise; 0: straight on
    Vec3 place_m{0.0};
    bool open = false;  // true: a shut door, which the person must open
};

// Returns, in order, doors, stairs and other features, turns of more than a sixteenth of a circle, and the goal. A turn
// next to a feature is part of the feature's instruction. `name_of` returns the spoken name of a passage, and
// `must_open` returns true if the passage is a shut door that the person must open.
std::vector<RouteNode> nodes_of(const navigation::Route& route, const std::string& goal,
                                const std::function<std::string(const navigation::RoutePassage&)>& name_of,
                                const std::function<bool(const navigation::RoutePassage&)>& must_open);

// Returns the legs of a route, one text each: "Turn slightly left. 14 steps.", "Turn right. 4 steps to Front door."
// `heading_rad` is the direction that the person faces. The result is empty if the person is at the goal.
std::vector<std::string> route_legs(const navigation::Route& route, const std::vector<RouteNode>& nodes,
                                    double heading_rad, const DistanceWords& how);
// What a summary of a route counts besides its length.
struct RouteCounts {
    std::size_t turns = 0, doors = 0;
    int storeys = 0;  // storeys up; negative: down
};
// Counts the turns in `nodes` and the doors of the route.
RouteCounts counts_of(const navigation::Route& route, const std::vector<RouteNode>& nodes);
// Returns one sentence about a route: "19 steps and 16 stairs in all, through Hall: 3 turns, 2 doors, one storey up."
// What is not there is left out. `distance` is the length in words; `exact` is false if it is approximate.
std::string summary_words(const std::string& distance, bool exact, const std::string& through,
                          const RouteCounts& counts);
// Returns the length of a route and its first `most` legs: "About 28 steps in all. Turn slightly left. 14 steps." The
// length is approximate, because each leg is rounded.
std::string route_words(const navigation::Route& route, std::vector<std::string> legs, const DistanceWords& how,
                        std::size_t most = SIZE_MAX, const RouteCounts& counts = {});

// Follows a walker along a route. Announces each feature once when it is 6 m ahead. When the walker reaches it,
// announces it again with the next turn. After every 10 m without an announcement, says that the person is on the
// route. Reports once that the person has left it.
class RouteFollower {
public:
    struct Said {
        std::string text;  // text to announce; may be empty
        bool left = false;
        bool arrived = false;
    };
    void follow(navigation::Route route, std::vector<RouteNode> nodes);
    void stop() { route_ = {}; }
    bool following() const { return route_.points_m.size() >= 2; }
    const navigation::Route& route() const { return route_; }
    const Vec3& goal_m() const { return route_.points_m.back(); }
    double along_m() const { return along_m_; }  // distance of the person along the route
    std::vector<Vec3> ahead_m() const;           // returns the rest of the route
    // The next place on the route where something is due, with the direction in which the route arrives there.
    struct NodePlace {
        Vec3 at_m{0.0};
        double heading_rad = 0.0;
        bool last = false;  // true: the route ends there
    };
    std::optional<NodePlace> next_node() const;
    double left_m() const { return std::max(0.0, route_.length_m - along_m_); }
    // A function that decides whether the person has arrived. `at_end` is true if the end of the route is within
    // kThere_m. A wall may still be in between.
    using There = std::function<bool(bool at_end)>;
    Said tick(
        const Vec3& feet_m, const DistanceWords& how, const There& there = [](bool at_end) { return at_end; });

private:
    navigation::Route route_;
    std::vector<RouteNode> nodes_;
    std::vector<bool> announced_, reached_;
    double along_m_ = 0.0;
    double word_at_m_ = 0.0;  // distance along the route at the last announcement
};

inline constexpr double kAnnounceAhead_m = 6.0, kReassureEvery_m = 10.0, kLeftWay_m = 2.0, kThere_m = 0.8,
                        kAtFeature_m = 1.2;

}  // namespace handrail::core
