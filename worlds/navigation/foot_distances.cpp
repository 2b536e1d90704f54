#include "worlds/navigation/foot_distances.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace handrail::navigation {
namespace {

constexpr double kNever_m = std::numeric_limits<double>::infinity();

std::optional<double> if_reached(double distance_m) {
    return distance_m < kNever_m ? std::optional(distance_m) : std::nullopt;
}

// A walker can go through a one-way portal only into its second room.
bool leads_into(const Portal& portal, std::uint32_t room) { return !portal.one_way || portal.rooms[1] == room; }
bool leads_out_of(const Portal& portal, std::uint32_t room) { return !portal.one_way || portal.rooms[0] == room; }

}  // namespace

FootDistances::FootDistances(const RoomGraph& graph, std::uint32_t room, const Vec3& feet_m)
    : portals_(graph.portals),
      room_(room),
      feet_m_(feet_m),
      portals_of_(graph.rooms.size()),
      portal_m_(graph.portals.size(), kNever_m),
      before_(graph.portals.size(), kNothing) {
    for (std::uint32_t p = 0; p < portals_.size(); ++p)
        for (const std::uint32_t of : portals_[p].rooms)
            if (of < portals_of_.size()) portals_of_[of].push_back(p);
    using Reached = std::pair<double, std::uint32_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    const auto reach = [&](std::uint32_t portal, double distance_m, std::uint32_t before) {
        if (distance_m >= portal_m_[portal]) return;
        portal_m_[portal] = distance_m;
        before_[portal] = before;
        next.emplace(distance_m, portal);
    };
    if (room < portals_of_.size())
        for (const std::uint32_t p : portals_of_[room])
            if (leads_out_of(portals_[p], room)) reach(p, glm::length(portals_[p].place_m - feet_m), kNothing);
    while (!next.empty()) {
        const auto [distance_m, at] = next.top();
        next.pop();
        if (distance_m > portal_m_[at]) continue;
        for (const std::uint32_t into : portals_[at].rooms) {
            if (into >= portals_of_.size() || !leads_into(portals_[at], into)) continue;
            for (const std::uint32_t p : portals_of_[into])
                if (leads_out_of(portals_[p], into))
                    reach(p, distance_m + glm::length(portals_[p].place_m - portals_[at].place_m), at);
        }
    }
}

std::optional<double> FootDistances::to(std::uint32_t room, const Vec3& place_m) const {
    if (room >= portals_of_.size()) return std::nullopt;
    double nearest_m = room == room_ ? glm::length(place_m - feet_m_) : kNever_m;
    for (const std::uint32_t p : portals_of_[room])
        if (leads_into(portals_[p], room))
            nearest_m = std::min(nearest_m, portal_m_[p] + glm::length(place_m - portals_[p].place_m));
    return if_reached(nearest_m);
}

std::vector<std::uint32_t> FootDistances::portals_to(std::uint32_t room, const Vec3& place_m) const {
    if (room >= portals_of_.size()) return {};
    double nearest_m = room == room_ ? glm::length(place_m - feet_m_) : kNever_m;
    std::uint32_t last = kNothing;
    for (const std::uint32_t p : portals_of_[room]) {
        const double far_m = portal_m_[p] + glm::length(place_m - portals_[p].place_m);
        if (!leads_into(portals_[p], room) || far_m >= nearest_m) continue;
        nearest_m = far_m;
        last = p;
    }
    std::vector<std::uint32_t> all;
    for (; last != kNothing; last = before_[last]) all.push_back(last);
    std::reverse(all.begin(), all.end());
    return all;
}

std::optional<double> FootDistances::to_portal(std::uint32_t portal) const {
    return portal < portal_m_.size() ? if_reached(portal_m_[portal]) : std::nullopt;
}

}  // namespace handrail::navigation
