// Makes the portals of outdoor ways, as the plan states them: between ways, and from ways to stairs, doors and the
// ground.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "worlds/floorplan/plan_builder.h"
#include "worlds/floorplan/upright.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"
#include "worlds/geometry/exposed_surface.h"

namespace handrail::floorplan {
namespace {

constexpr double kMeetFloor_m = 0.3, kEndsBeforeDoor_m = 1.5, kOnGround_m = 0.6;

// Returns true if the point is on the floor of the way, or directly next to the floor of an area.
bool is_on_floor(const PlanWay& way, const Vec3& at) {
    if (way.area) {
        const std::vector<Ring> rings = rings_of_way(way);
        return inside(rings, Vec2(at)) || distance_to_outline(rings, Vec2(at)) < kMeetFloor_m;
    }
    for (std::size_t i = 1; i < way.line.size(); ++i) {
        const Vec2 along = way.line[i] - way.line[i - 1], off = Vec2(at) - way.line[i - 1];
        const double length_2 = glm::dot(along, along);
        const double t = length_2 > 0.0 ? std::clamp(glm::dot(off, along) / length_2, 0.0, 1.0) : 0.0;
        const double floor_m = way.floor_m[i - 1] + t * (way.floor_m[i] - way.floor_m[i - 1]);
        if (glm::length(off - along * t) <= 0.5 * way.width_m && std::abs(floor_m - at.z) <= kMeetFloor_m) return true;
    }
    return false;
}

}  // namespace

// Joins ways that share a point, and joins a way with the way on whose floor it ends. Stairs join the way or room at
// their foot with the way or room at their head.
void PlanBuilder::join_ways(const std::vector<FeatureId>& features, const std::vector<std::uint32_t>& rooms) {
    using Point = std::array<long long, 3>;
    std::map<Point, std::vector<std::uint32_t>> rooms_at_point;
    const auto key = [](const Vec2& p, double floor_m) {
        return Point{std::llround(p.x * 1e3), std::llround(p.y * 1e3), std::llround(floor_m * 1e2)};
    };
    const auto meet = [&](const Vec2& p, double floor_m, std::uint32_t room) {
        std::vector<std::uint32_t>& here = rooms_at_point[key(p, floor_m)];
        if (std::find(here.begin(), here.end(), room) == here.end()) here.push_back(room);
    };
    std::vector<std::size_t> floors;
    std::vector<Aabb> boxes;
    for (std::size_t w = 0; w < rooms.size(); ++w) {
        const PlanWay& way = plan_.ways[w];
        if (rooms[w] == kNotStated) continue;
        for (std::size_t i = 0; i < way.line.size(); ++i) meet(way.line[i], way.floor_m[i], rooms[w]);
        for (const Ring& ring : way.further)
            for (const Vec2& p : ring) meet(p, way.floor_m[0], rooms[w]);
        Aabb box;
        for (std::size_t i = 0; i < way.line.size(); ++i) box.include(Vec3(way.line[i], way.floor_m[i]));
        floors.push_back(w);
        boxes.push_back(grown(box, std::max(kMeetFloor_m, way.area ? 0.0 : 0.5 * way.width_m)));
    }
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> near;
    for (const PlanWay& way : plan_.ways)
        for (const std::size_t end : {std::size_t{0}, way.line.size() - 1}) {
            if (way.area) break;
            const Vec3 at(way.line[end], way.floor_m[end]);
            index.find({at, at}, near);
            for (const std::uint32_t f : near)
                if (is_on_floor(plan_.ways[floors[f]], at)) meet(way.line[end], way.floor_m[end], rooms[floors[f]]);
        }
    std::set<std::pair<std::uint32_t, std::uint32_t>> reported;
    for (const PlanWay& way : plan_.ways)
        for (std::size_t i = 0; i < way.line.size() && !way.steps; ++i) {
            const std::vector<std::uint32_t>& here = rooms_at_point[key(way.line[i], way.floor_m[i])];
            for (std::size_t k = 1; k < here.size(); ++k) {
                if (!reported.emplace(here[0], here[k]).second) continue;
                StatedPortal portal;
                portal.kind = StatedPortalKind::Opening;
                portal.rooms = {here[0], here[k]};
                portal.place_m = Vec3(way.line[i], way.floor_m[i]);
                portal.width_m = way.width_m;
                portal.by_boundaries = true;
                stated_->portals.push_back(std::move(portal));
            }
        }
    for (std::size_t w = 0; w < features.size(); ++w) {
        const PlanWay& way = plan_.ways[w];
        if (!way.steps) continue;
        StatedPortal portal;
        portal.kind = StatedPortalKind::Stairs;
        portal.name = way.name.empty() ? way.id : way.name;
        portal.guid = way.id;
        portal.feature = features[w];
        for (const std::size_t end : {std::size_t{0}, way.line.size() - 1})
            if (const auto found = rooms_at_point.find(key(way.line[end], way.floor_m[end]));
                found != rooms_at_point.end())
                portal.rooms.insert(portal.rooms.end(), found->second.begin(), found->second.end());
        std::sort(portal.rooms.begin(), portal.rooms.end());
        portal.rooms.erase(std::unique(portal.rooms.begin(), portal.rooms.end()), portal.rooms.end());
        portal.place_m = Vec3(way.line.front(), way.floor_m.front());
        portal.width_m = way.width_m;
        portal.height_m = std::abs(way.floor_m.back() - way.floor_m.front());
        portal.by_boundaries = true;
        stated_->portals.push_back(std::move(portal));
    }
    join_doors_with_ways(rooms);
    open_ways_to_the_ground(rooms);
}

// Joins the room of each door that leads outside with the way that ends in front of that door.
void PlanBuilder::join_doors_with_ways(const std::vector<std::uint32_t>& rooms) {
    for (StatedPortal& portal : stated_->portals) {
        if (portal.kind != StatedPortalKind::Door || portal.rooms.size() != 1) continue;
        double nearest_m = kEndsBeforeDoor_m;
        std::uint32_t found = kNotStated;
        for (std::size_t w = 0; w < rooms.size(); ++w) {
            const PlanWay& way = plan_.ways[w];
            for (std::size_t i = 0; i < way.line.size() && rooms[w] != kNotStated; ++i) {
                const double off_m = glm::length(way.line[i] - Vec2(portal.place_m));
                if (off_m >= nearest_m || std::abs(way.floor_m[i] - portal.place_m.z) > kMeetFloor_m) continue;
                nearest_m = off_m;
                found = rooms[w];
            }
        }
        if (found == kNotStated) continue;
        portal.rooms.push_back(found);
        std::sort(portal.rooms.begin(), portal.rooms.end());
    }
}

// Makes portals from ways at ground level to the ground. Of several ways that are joined, only the first gets such a
// portal.
void PlanBuilder::open_ways_to_the_ground(const std::vector<std::uint32_t>& rooms) {
    DisjointSets groups(stated_->rooms.size());
    std::vector<std::uint32_t> outside;
    for (const StatedPortal& portal : stated_->portals) {
        for (std::size_t i = 1; i < portal.rooms.size(); ++i) groups.join(portal.rooms[0], portal.rooms[i]);
        if (portal.outside && portal.passable) outside.push_back(portal.rooms[0]);
    }
    std::set<std::uint32_t> open;
    for (const std::uint32_t room : outside) open.insert(groups.find(room));
    for (std::size_t w = 0; w < rooms.size(); ++w) {
        const PlanWay& way = plan_.ways[w];
        if (rooms[w] == kNotStated || std::abs(way.floor_m[0] - ground_m_) > kOnGround_m) continue;
        if (!open.insert(groups.find(rooms[w])).second) continue;
        StatedPortal portal;
        portal.outside = true;
        portal.kind = StatedPortalKind::Opening;
        portal.rooms = {rooms[w]};
        portal.place_m = Vec3(way.line.front(), way.floor_m.front());
        portal.width_m = way.width_m;
        portal.by_boundaries = true;
        stated_->portals.push_back(std::move(portal));
    }
}

}  // namespace handrail::floorplan
