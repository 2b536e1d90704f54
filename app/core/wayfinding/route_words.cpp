#include "app/core/wayfinding/route_words.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/navigation/route_place.h"

namespace handrail::core {
namespace {

constexpr double kLeastTurn_rad = 2.0 * kPi / 16.0;
constexpr double kNextToFeature_m = 1.0;

double bearing(const Vec3& from, const Vec3& to) { return std::atan2(to.x - from.x, to.y - from.y); }

// Returns the size of a turn in words. On the 16-point compass, a turn by one point is slight, by two half, by four
// plain, by six sharp, and by eight round. Other values are rounded to the nearest of these.
std::string turn_words(double turn_rad) {
    const double points = std::abs(turn_rad) / kLeastTurn_rad;
    const bool right = turn_rad > 0.0;
    if (points < 0.5) return {};
    if (points > 7.0) return phrase("route.turn_round");
    if (points < 1.5) return phrase(right ? "route.turn_slightly_right" : "route.turn_slightly_left");
    if (points < 3.0) return phrase(right ? "route.turn_half_right" : "route.turn_half_left");
    if (points > 5.0) return phrase(right ? "route.turn_sharp_right" : "route.turn_sharp_left");
    return phrase(right ? "route.turn_right" : "route.turn_left");
}

}  // namespace

std::vector<RouteNode> nodes_of(const navigation::Route& route, const std::string& goal,
                                const std::function<std::string(const navigation::RoutePassage&)>& name_of,
                                const std::function<bool(const navigation::RoutePassage&)>& must_open) {
    std::vector<RouteNode> nodes;
    for (const navigation::RoutePassage& passage : route.passages)
        nodes.push_back({passage.at_m, name_of(passage), 0.0, passage.place_m, must_open(passage)});
    double at = 0.0;
    for (std::size_t i = 1; i + 1 < route.points_m.size(); ++i) {
        at += glm::length(route.points_m[i] - route.points_m[i - 1]);
        const double turn = wrap_angle(bearing(route.points_m[i], route.points_m[i + 1]) -
                                       bearing(route.points_m[i - 1], route.points_m[i]));
        if (at > route.length_m) at = route.length_m;
        RouteNode* beside = nullptr;
        for (RouteNode& node : nodes)
            if (std::abs(node.at_m - at) < kNextToFeature_m &&
                (!beside || std::abs(node.at_m - at) < std::abs(beside->at_m - at)))
                beside = &node;
        if (beside) beside->turn_rad = wrap_angle(beside->turn_rad + turn);
        else if (std::abs(turn) > 1e-6) nodes.push_back({at, {}, turn, route.points_m[i], false});
    }
    std::erase_if(nodes,
                  [](const RouteNode& node) { return node.what.empty() && std::abs(node.turn_rad) < kLeastTurn_rad; });
    std::stable_sort(nodes.begin(), nodes.end(),
                     [](const RouteNode& a, const RouteNode& b) { return a.at_m < b.at_m; });
    if (!route.points_m.empty()) nodes.push_back({route.length_m, goal, 0.0, route.points_m.back(), false});
    return nodes;
}

std::vector<std::string> route_legs(const navigation::Route& route, const std::vector<RouteNode>& nodes,
                                    double heading_rad, const DistanceWords& how) {
    std::vector<std::string> legs;
    if (route.points_m.size() < 2) return legs;
    // A leg says first what to do, then how far, and then to what.
    std::string turn = turn_words(wrap_angle(bearing(route.points_m[0], route.points_m[1]) - heading_rad));
    double before = 0.0;
    for (const RouteNode& node : nodes) {
        const std::string distance = distance_words(node.at_m - before, how),
                          what = node.open ? joined(node.what, phrase("questions.shut")) : node.what;
        std::string leg = turn.empty() ? turn : capitalised(phrase("route.first", {{"turn", turn}})) + " ";
        leg += capitalised(
            phrase(node.what.empty() ? "route.leg" : "route.leg_to", {{"distance", distance}, {"what", what}}));
        if (node.open) leg += " " + phrase("leg.open_it");
        legs.push_back(std::move(leg));
        turn = turn_words(node.turn_rad);
        before = node.at_m;
    }
    return legs;
}

RouteCounts counts_of(const navigation::Route& route, const std::vector<RouteNode>& nodes) {
    RouteCounts counts;
    for (const RouteNode& node : nodes) counts.turns += turn_words(node.turn_rad).empty() ? 0 : 1;
    for (const navigation::RoutePassage& passage : route.passages)
        counts.doors += passage.kind == navigation::PassageKind::Door ? 1 : 0;
    return counts;
}

std::string summary_words(const std::string& distance, bool exact, const std::string& through,
                          const RouteCounts& counts) {
    std::string counted;
    if (counts.turns > 0) counted = joined(counted, phrase("route.turns", {{"turns", counts.turns}}));
    if (counts.doors > 0) counted = joined(counted, phrase("route.doors", {{"doors", counts.doors}}));
    if (counts.storeys != 0)
        counted = joined(counted, phrase("route.storeys", {{"storeys", std::abs(counts.storeys)},
                                                           {"up", counts.storeys > 0 ? "yes" : "no"}}));
    const char* any = counted.empty() ? "no" : "yes";
    if (through.empty())
        return capitalised(phrase(exact ? "route.in_all" : "route.in_all_about",
                                  {{"distance", distance}, {"counted", any}, {"counts", counted}}));
    return capitalised(phrase(exact ? "route.in_all_through" : "route.in_all_about_through",
                              {{"distance", distance}, {"rooms", through}, {"counted", any}, {"counts", counted}}));
}

std::string route_words(const navigation::Route& route, std::vector<std::string> legs, const DistanceWords& how,
                        std::size_t most, const RouteCounts& counts) {
    if (legs.empty()) return phrase("route.there");
    if (legs.size() > most) legs.resize(most);
    legs.insert(legs.begin(), summary_words(distance_words(route.length_m, how), false, {}, counts));
    return fmt::format("{}", fmt::join(legs, " "));
}

std::optional<RouteFollower::NodePlace> RouteFollower::next_node() const {
    constexpr double kAtNode_m = 0.3;
    for (const RouteNode& node : nodes_) {
        if (node.at_m < along_m_ + kAtNode_m) continue;
        const Vec3 at_m = navigation::place_along(route_.points_m, node.at_m),
                   before_m = navigation::place_along(route_.points_m, std::max(0.0, node.at_m - kAtNode_m));
        return NodePlace{at_m, bearing(before_m, at_m), &node == &nodes_.back()};
    }
    return std::nullopt;
}

void RouteFollower::follow(navigation::Route route, std::vector<RouteNode> nodes) {
    route_ = std::move(route);
    nodes_ = std::move(nodes);
    announced_.assign(nodes_.size(), false);
    reached_.assign(nodes_.size(), false);
    // The announcement of the whole route has already mentioned what is just ahead.
    for (std::size_t i = 0; i < nodes_.size(); ++i) announced_[i] = nodes_[i].at_m < kAnnounceAhead_m;
    along_m_ = word_at_m_ = 0.0;
}

std::vector<Vec3> RouteFollower::ahead_m() const {
    std::vector<Vec3> rest;
    if (!following()) return rest;
    rest.push_back(navigation::place_along(route_.points_m, along_m_));
    double at_m = 0.0;
    for (std::size_t i = 1; i < route_.points_m.size(); ++i) {
        at_m += glm::length(route_.points_m[i] - route_.points_m[i - 1]);
        if (at_m > along_m_) rest.push_back(route_.points_m[i]);
    }
    return rest;
}

RouteFollower::Said RouteFollower::tick(const Vec3& feet_m, const DistanceWords& how, const There& there) {
    Said said;
    if (!following()) return said;
    const navigation::RoutePlace place = navigation::near_on_path(route_.points_m, feet_m, along_m_);
    const double nearest =
        place.distance_m + navigation::kFartherForEachMetreAlong_m * std::abs(place.along_m - along_m_);
    along_m_ = place.along_m;
    if (there(glm::length(feet_m - goal_m()) < kThere_m || (left_m() < kThere_m && nearest < kThere_m))) {
        const bool named = !nodes_.empty() && !nodes_.back().what.empty();
        said.text = named ? phrase("route.arrived", {{"goal", sentence_case(nodes_.back().what)}})
                          : phrase("route.arrived_at_end");
        said.arrived = true;
        stop();
        return said;
    }
    if (nearest > kLeftWay_m) {
        said.left = true;
        return said;
    }
    for (std::size_t i = 0; i < nodes_.size() && said.text.empty(); ++i) {
        const RouteNode& node = nodes_[i];
        const double ahead = node.at_m - along_m_;
        const std::string turn = turn_words(node.turn_rad);
        if (!reached_[i] && std::abs(ahead) < kAtFeature_m && i + 1 < nodes_.size()) {
            reached_[i] = announced_[i] = true;
            const RouteNode& next = nodes_[i + 1];
            const std::string here = sentence_case(joined(node.what, turn)),
                              distance = distance_words(next.at_m - node.at_m, how);
            if (!here.empty())
                said.text = phrase(next.what.empty() ? "route.reached" : "route.reached_then_to",
                                   {{"here", here}, {"distance", distance}, {"next", next.what}});
        } else if (!announced_[i] && ahead > 0.0 && ahead <= kAnnounceAhead_m) {
            announced_[i] = true;
            said.text = phrase("route.ahead", {{"what", sentence_case(node.what.empty() ? turn : node.what)},
                                               {"distance", distance_words(ahead, how)}});
        }
    }
    if (said.text.empty() && left_m() > kThere_m && along_m_ - word_at_m_ >= kReassureEvery_m)
        said.text = phrase("route.on_the_way", {{"distance", distance_words(left_m(), how)}});
    if (!said.text.empty()) word_at_m_ = along_m_;
    return said;
}

}  // namespace handrail::core
