#include "app/core/wayfinding/hand_path.h"

#include <algorithm>
#include <array>
#include <limits>

#include "worlds/navigation/route_place.h"

namespace handrail::core {
namespace {

constexpr double kNextTo_m = 0.4;    // distance from the side of a thing to a person who stands in front of it
constexpr double kOnePlace_m = 0.3;  // two standing places nearer to each other than this are one place
// Heights of the hand above the floor at which a path to the thing is searched for.
constexpr double kReach_height_m[] = {1.0, 1.5, 0.5};
constexpr double kBefore_m = 0.3;  // distance from the face of a thing to the point where the hand turns towards it
// The target point is this far inside the thing, because the faces of the thing may be covered by what it stands on or
// hangs at.
constexpr double kInside_m = 0.05;
// Distance that the hand keeps from the leaf of an open door when it goes round the leaf.
constexpr double kProxyRoom_m = 0.3;

constexpr WalkerShape kProxy{0.13, 0.26};  // shape of a proxy of 4 mm at scale 60

Vec3 nearest_in(const Aabb& box, const Vec3& to_m) { return glm::clamp(to_m, box.min_m, box.max_m); }

// Returns the last points of a hand's path: straight to the thing, or via a point in front of a side or above. A path
// that is free for a proxy is preferred to a path that is free only for a line. The result is empty if there is no such
// path.
std::vector<Vec3> last_points(const WalkerWorld& world, const Vec3& from_m, const Aabb& thing_m, FeatureId thing) {
    const Vec3 centre = thing_m.centre_m(), half = 0.5 * thing_m.size_m() + Vec3(kBefore_m);
    std::vector<std::vector<Vec3>> ways{{place_on(thing_m, from_m)}};
    for (const Vec3& side : {Vec3(0, 0, 1), Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 1, 0)}) {
        const Vec3 before = centre + side * half;
        if (!world.blocked(before - Vec3(0.0, 0.0, 0.5 * kProxy.height_m), kProxy))
            ways.push_back({before, place_on(thing_m, before)});
    }
    for (const auto& free : {proxy_passes, free_line})
        for (const std::vector<Vec3>& way : ways) {
            Vec3 at = from_m;
            if (std::all_of(way.begin(), way.end(),
                            [&](const Vec3& to) { return free(world, std::exchange(at, to), to, thing); }))
                return way;
        }
    return {};
}

bool within_reach(const WalkerWorld& world, const Vec3& stand_m, const Aabb& thing_m, FeatureId thing) {
    return std::any_of(std::begin(kReach_height_m), std::end(kReach_height_m), [&](double height_m) {
        return !last_points(world, stand_m + Vec3(0.0, 0.0, height_m), thing_m, thing).empty();
    });
}

// Returns a path round the end of a door leaf. A route leads round the leaves of open doors if that is not far, or else
// through a leaf. A leaf that a walker would pass may also stop or catch the hand. The returned path is free for a
// proxy. If even the straight line is blocked, a path that is free for a line is accepted.
std::vector<Vec3> round_leaves(const WalkerWorld& world, const Vec3& from_m, const Vec3& to_m) {
    const Vec3 half(0.0, 0.0, 0.5 * kProxy.height_m);
    const auto door = [&](FeatureId feature) {
        const Feature* leaf = world.scene().find(feature);
        return leaf && leaf->kind == FeatureKind::Door ? leaf : nullptr;
    };
    const Feature* leaf = nullptr;
    Vec3 met_m(0.0);
    for (const Crossing& crossing : world.crossings(from_m, to_m)) {
        if (leaf || !(leaf = door(crossing.feature))) continue;
        met_m = from_m + (to_m - from_m) * (0.5 * (crossing.enter_m + crossing.leave_m) / glm::length(to_m - from_m));
    }
    const bool across = leaf != nullptr;
    if (!across)
        if (const TraceHit met = world.trace(from_m - half, to_m - half, kProxy, true); met.hit) {
            leaf = door(met.feature);
            met_m = met.end_m + half;
        }
    if (!leaf) return {};
    const Aabb& stands = leaf->bounds_m;
    // Candidate points are next to the corners of the leaf. Further candidates are next to the point where the line met
    // the leaf, because the bounds of the leaf may include the frame.
    std::vector<Vec3> beside;
    for (int i = 0; i < 4; ++i)
        beside.emplace_back((i & 1) ? stands.max_m.x + kProxyRoom_m : stands.min_m.x - kProxyRoom_m,
                            (i & 2) ? stands.max_m.y + kProxyRoom_m : stands.min_m.y - kProxyRoom_m, met_m.z);
    const Vec3 leg(to_m.x - from_m.x, to_m.y - from_m.y, 0.0);
    if (const double length_m = glm::length(leg); length_m > 1e-6)
        for (const double side_m : {-kProxyRoom_m, kProxyRoom_m, -2.0 * kProxyRoom_m, 2.0 * kProxyRoom_m})
            beside.push_back(met_m + Vec3(-leg.y, leg.x, 0.0) * (side_m / length_m));
    for (const bool whole : {true, false}) {
        if (!across && !whole) break;
        std::vector<Vec3> best;
        double shortest_m = std::numeric_limits<double>::infinity();
        const auto offer = [&](std::vector<Vec3> way) {
            double length_m = 0.0;
            Vec3 at = from_m;
            way.push_back(to_m);
            for (const Vec3& next : way) {
                if (whole ? !proxy_passes(world, at, next, kNoFeature) : !free_line(world, at, next, kNoFeature))
                    return;
                if (world.blocked(next - half, kProxy)) return;
                length_m += glm::length(next - at);
                at = next;
            }
            way.pop_back();
            if (length_m < shortest_m) {
                shortest_m = length_m;
                best = std::move(way);
            }
        };
        for (const Vec3& one : beside) offer({one});
        if (best.empty())
            for (const Vec3& one : beside)
                for (const Vec3& other : beside)
                    if (one != other) offer({one, other});
        if (!best.empty()) return best;
    }
    return {};
}

}  // namespace

bool proxy_passes(const WalkerWorld& world, const Vec3& from_m, const Vec3& to_m, FeatureId thing) {
    const Vec3 half(0.0, 0.0, 0.5 * kProxy.height_m);
    if (world.blocked(from_m - half, kProxy)) return false;
    const TraceHit met = world.trace(from_m - half, to_m - half, kProxy, true);
    return !met.hit || (thing && met.feature == thing);
}

Vec3 place_on(const Aabb& thing_m, const Vec3& from_m) {
    const Vec3 in = glm::min(Vec3(kInside_m), 0.5 * thing_m.size_m());
    return glm::clamp(from_m, thing_m.min_m + in, thing_m.max_m - in);
}

bool free_line(const WalkerWorld& world, const Vec3& from_m, const Vec3& to_m, FeatureId thing) {
    const std::vector<Crossing> crossings = world.crossings(from_m, to_m);
    return std::all_of(crossings.begin(), crossings.end(),
                       [&](const Crossing& crossing) { return thing && crossing.feature == thing; });
}

navigation::Route walk_to_thing(navigation::Navigation& navigation, const WalkerWorld& world, const Vec3& from_m,
                                const Aabb& thing_m, FeatureId thing) {
    const Vec3 middle = thing_m.centre_m(), low = thing_m.min_m, high = thing_m.max_m;
    std::vector<Vec3> stands, within;
    for (const Vec3& beside : {nearest_in(thing_m, from_m), Vec3(low.x - kNextTo_m, middle.y, low.z),
                               Vec3(high.x + kNextTo_m, middle.y, low.z), Vec3(middle.x, low.y - kNextTo_m, low.z),
                               Vec3(middle.x, high.y + kNextTo_m, low.z), Vec3(middle.x, middle.y, low.z)}) {
        const auto stand = navigation.nearest_place(beside);
        if (!stand || std::any_of(stands.begin(), stands.end(),
                                  [&](const Vec3& other) { return glm::length(other - *stand) < kOnePlace_m; }))
            continue;
        stands.push_back(*stand);
        if (within_reach(world, *stand, thing_m, thing)) within.push_back(*stand);
    }
    if (stands.empty()) return navigation.plan(from_m, middle);
    navigation::Route best;
    const auto better = [&](const navigation::Route& route) {
        if (best.points_m.empty() || route.reaches != best.reaches) return best.points_m.empty() || route.reaches;
        return route.reaches ? route.length_m < best.length_m : route.short_of_m < best.short_of_m;
    };
    for (const Vec3& stand : within.empty() ? stands : within)
        if (navigation::Route route = navigation.plan(from_m, stand); better(route)) best = std::move(route);
    return best;
}

bool hand_can_follow(const navigation::Route& route) {
    return std::none_of(route.passages.begin(), route.passages.end(), [](const navigation::RoutePassage& passage) {
        return passage.kind == navigation::PassageKind::Lift || passage.kind == navigation::PassageKind::Climb ||
               passage.kind == navigation::PassageKind::Teleporter;
    });
}

std::vector<Vec3> path_of_hand(const navigation::Route& route, const Vec3& hand_m, double height_m,
                               const WalkerWorld& world, const Aabb& thing_m, FeatureId thing, std::size_t most) {
    std::vector<Vec3> points{hand_m};
    for (const Vec3& soles : route.points_m) {
        const Vec3 next = soles + Vec3(0.0, 0.0, height_m);
        for (const Vec3& round : round_leaves(world, points.back(), next)) points.push_back(round);
        points.push_back(next);
    }
    if (route.reaches) {
        // If the hand cannot reach the thing at that height, higher and lower points are tried.
        std::vector<Vec3> last = last_points(world, points.back(), thing_m, thing);
        for (const double other_m : kReach_height_m) {
            if (!last.empty()) break;
            const Vec3 there = route.points_m.back() + Vec3(0.0, 0.0, other_m);
            last = last_points(world, there, thing_m, thing);
            if (!last.empty()) last.insert(last.begin(), there);
        }
        if (last.empty()) last.push_back(place_on(thing_m, points.back()));
        points.insert(points.end(), last.begin(), last.end());
    }
    while (points.size() > most) {
        std::size_t least = 1;
        double bend_m = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            const std::array ends{points[i - 1], points[i + 1]};
            if (const double off_m = navigation::nearest_on_path(ends, points[i]).distance_m; off_m < bend_m) {
                bend_m = off_m;
                least = i;
            }
        }
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(least));
    }
    return points;
}

}  // namespace handrail::core
