#include "app/core/wayfinding/grooves.h"

#include <algorithm>
#include <array>
#include <limits>

#include "worlds/base/contract.h"
#include "worlds/navigation/route_place.h"

namespace handrail::core {
namespace {

// Length of a groove on either side of a doorway: the thickness of the wall and a step.
constexpr double kThrough_m = 0.6;
constexpr std::size_t kMostLegs = servo::GuidancePath::kMostPoints / 2;

}  // namespace

std::vector<GrooveLeg> grooves_through_doorways(const navigation::RoomGraph& graph,
                                                const navigation::WalkSpace& space) {
    std::vector<GrooveLeg> legs;
    for (const navigation::Portal& portal : graph.portals) {
        if (portal.kind != navigation::PassageKind::Door && portal.kind != navigation::PassageKind::Opening) continue;
        // Directions square to most walls come first, because the first direction that fits is used.
        for (const double heading_deg : {0.0, 90.0, 45.0, 135.0}) {
            const Vec3 way = forward_of_heading(radians_from_degrees(heading_deg)) * kThrough_m;
            const std::uint32_t one = space.at(portal.place_m - way), other = space.at(portal.place_m + way);
            if (one == navigation::kNothing || other == navigation::kNothing) continue;
            const std::array rooms{graph.room_of_span[one], graph.room_of_span[other]};
            if (!std::is_permutation(rooms.begin(), rooms.end(), portal.rooms.begin())) continue;
            legs.push_back({space.place_m(one), space.place_m(other)});
            break;
        }
    }
    return legs;
}

Grooves nearest_grooves(std::span<const Vec3> way_m, std::span<const GrooveLeg> doorways, const Vec3& near_m,
                        double proxy_radius_m) {
    contract_pre(is_finite(near_m) && proxy_radius_m > 0.0);
    std::vector<std::pair<double, GrooveLeg>> legs;
    const auto offer = [&](const Vec3& from, const Vec3& to) {
        const Vec3 up(0.0, 0.0, proxy_radius_m);
        const std::array ends{from + up, to + up};
        legs.emplace_back(navigation::nearest_on_path(ends, near_m).distance_m, GrooveLeg{ends[0], ends[1]});
    };
    for (std::size_t i = 0; i + 1 < way_m.size(); ++i) offer(way_m[i], way_m[i + 1]);
    for (const GrooveLeg& leg : doorways) offer(leg.from_m, leg.to_m);
    std::stable_sort(legs.begin(), legs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Grooves grooves;
    grooves.path.kind = servo::GuidanceKind::Grooves;
    grooves.good_within_m =
        legs.size() > kMostLegs ? 0.5 * legs[kMostLegs].first : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(legs.size(), kMostLegs); ++i) {
        grooves.path.points_m[grooves.path.count++] = legs[i].second.from_m;
        grooves.path.points_m[grooves.path.count++] = legs[i].second.to_m;
    }
    return grooves;
}

}  // namespace handrail::core
