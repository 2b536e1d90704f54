#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "worlds/base/human_measures.h"
#include "worlds/check/examined.h"
#include "worlds/geometry/clip.h"

namespace handrail::check {
namespace {

constexpr double kNarrowestCrack_m = 1e-3, kWidestCrack_m = 0.06;
// kLevelCrack: a face whose unit normal has at least this z is level. kWidestJoint_m: joints up to this width are usual
// between an underside and its support, such as a slab on a wall, and around a beam.
constexpr double kLevelCrack = 0.7, kWidestJoint_m = 0.02;
constexpr double kLeastCrack_m2 = 0.01;  // least area over which two faces must be opposite each other
constexpr double kLeastOpen_m2 = 0.05;
constexpr double kRail_m = 1.1;

// True for walls, floors and other parts of the building without a name from the file.
bool is_shell(const Scene& scene, const Solid& solid) {
    const Feature* feature = scene.find(solid.feature);
    return solid.role == SolidRole::Solid && (!feature || feature->made_name);
}

// True if the file says that the solid is a beam.
bool is_beam(const Scene& scene, const Solid& solid) {
    const Feature* feature = scene.find(solid.feature);
    return feature && feature->made_name && feature->name == "beam";
}

// Returns the part of `face` that the other face `by` covers in perpendicular projection.
std::vector<Vec3> looked_at(const Polygon& face, const Plane& plane, const Polygon& by) {
    std::vector<Vec3> part = face.points_m, scratch;
    for (std::size_t i = 0; i < by.points_m.size() && part.size() >= 3; ++i) {
        const Vec3 &a = by.points_m[i], &b = by.points_m[(i + 1) % by.points_m.size()];
        // Seen from the front of `plane`, the corners of `by` are in the opposite order, because that face looks the
        // other way.
        Vec3 out = glm::cross(plane.normal, b - a);
        const double length = glm::length(out);
        if (length < 1e-9) continue;
        out /= length;
        keep_back(part, {out, glm::dot(out, a)}, 1e-7, scratch);
    }
    return part.size() >= 3 ? part : std::vector<Vec3>{};
}

// Finds a place where two solids nearly touch and nothing fills the space between them.
std::optional<WorldFault> crack_between(const Examined& world, const Solid& one, const Solid& other) {
    const bool beam = is_beam(world.scene, one) || is_beam(world.scene, other);
    for (std::size_t a = 0; a < one.shape.planes.size(); ++a)
        for (std::size_t b = 0; b < other.shape.planes.size(); ++b) {
            const Plane &plane = one.shape.planes[a], &facing = other.shape.planes[b];
            if (glm::dot(plane.normal, facing.normal) > -0.99999) continue;
            const double gap = -facing.offset_m - plane.offset_m;
            if (gap < kNarrowestCrack_m || gap > kWidestCrack_m) continue;
            if (gap < kWidestJoint_m && (beam || std::abs(plane.normal.z) > kLevelCrack)) continue;
            const std::vector<Vec3> part = looked_at(one.shape.faces[a], plane, other.shape.faces[b]);
            if (part.empty() || area_m2(std::span(part)) < kLeastCrack_m2) continue;
            Vec3 middle(0.0);
            for (const Vec3& p : part) middle += p / static_cast<double>(part.size());
            middle += plane.normal * (0.5 * gap);
            if (world.solid_at(middle, 1e-6) || world.sheet_near({middle - Vec3(gap), middle + Vec3(gap)})) continue;
            WorldFault fault{FaultKind::Crack, middle, one.source};
            fault.amount = gap;
            return fault;
        }
    return std::nullopt;
}

void cracks(const Examined& world, std::vector<WorldFault>& faults) {
    for (std::uint32_t i = 0; i < world.scene.solids.size(); ++i) {
        const Solid& solid = world.scene.solids[i];
        if (!is_shell(world.scene, solid)) continue;
        const std::vector<std::uint32_t> near = world.solids_near(grown(solid.shape.bounds_m, kWidestCrack_m));
        for (const std::uint32_t k : near) {
            if (k <= i || !is_shell(world.scene, world.scene.solids[k])) continue;
            auto fault = crack_between(world, world.scene.solids[k], solid);
            if (!fault) continue;
            const Feature* feature = nullptr;
            for (const FeatureId id : world.scene.solids[k].face_features)
                if (!feature) feature = world.scene.find(id);
            if (feature) fault->name = spoken_name(*feature);
            fault->source = world.scene.solids[k].source;
            if (world.space)
                if (const std::uint32_t span = world.space->nearest(fault->at_m, 1.0, 0.6, 3.0);
                    span != navigation::kNothing)
                    fault->room = world.graph->room_of_span[span];
            fault->other = world.room_name(fault->room);
            faults.push_back(std::move(*fault));
        }
    }
}

void roofs(const Examined& world, std::vector<WorldFault>& faults) {
    const std::vector<navigation::Room>& rooms = world.graph->rooms;
    const auto put = [&](FaultKind kind, std::uint32_t room, const Vec3& at_m, const std::string& other) {
        WorldFault fault{kind, at_m, world.ground_source(at_m)};
        fault.room = room;
        fault.name = world.room_name(room);
        fault.other = other;
        faults.push_back(std::move(fault));
    };
    for (std::uint32_t r = 0; r < rooms.size(); ++r) {
        const double open_m2 = static_cast<double>(world.cover(r).open) * world.space->cell_area_m2();
        if (rooms[r].kind == navigation::RoomKind::Room && world.cover(r).covered() && open_m2 >= kLeastOpen_m2)
            put(FaultKind::OpenRoof, r, world.space->place_m(world.cover(r).first_open), {});
    }
    for (const navigation::Portal& portal : world.graph->portals) {
        if (portal.kind != navigation::PassageKind::Opening) continue;
        const bool first_in = world.cover(portal.rooms[0]).covered() && world.cover(portal.rooms[1]).under_sky(),
                   second_in = world.cover(portal.rooms[1]).covered() && world.cover(portal.rooms[0]).under_sky();
        if (!first_in && !second_in) continue;
        // If the covered area is not a room, it is only a niche under the eaves and gives no fault.
        if (rooms[portal.rooms[first_in ? 0 : 1]].kind != navigation::RoomKind::Room) continue;
        const std::uint32_t in = portal.rooms[first_in ? 0 : 1], out = portal.rooms[first_in ? 1 : 0];
        put(FaultKind::OpenToOutside, in, portal.place_m, world.room_name(out));
    }
}

// True if nothing up to the height of a rail stops a person who walks off the edge in this direction.
bool is_open(const Examined& world, const Vec3& feet_m, const Vec3& way, double far_m) {
    for (const double up : {0.3, 0.6, 0.9, kRail_m})
        for (double along = 0.1; along < far_m + 0.05; along += 0.1)
            if (world.something_at(feet_m + Vec3(0.0, 0.0, up) + way * along, 0.01)) return false;
    return true;
}

void edges(const Examined& world, std::vector<WorldFault>& faults) {
    const navigation::WalkSpace& space = *world.space;
    const std::array<Vec3, 4> ways{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)};
    const double far_m = space.body.radius_m + 2.0 * space.cell_m;
    // The faults that are already reported, so that each kind is reported only once in a room.
    std::set<std::pair<std::uint32_t, FaultKind>> reported;
    for (std::uint32_t s = 0; s < space.spans.size(); ++s) {
        const navigation::WalkSpan& span = space.spans[s];
        const std::uint32_t room = world.graph->room_of_span[s];
        if (!span.near_edge || span.liquid || room == navigation::kNothing || world.is_ground(room)) continue;
        const Vec3 feet = space.place_m(s);
        for (std::size_t d = 0; d < ways.size(); ++d) {
            if (span.next[d] != navigation::kNothing || !is_open(world, feet, ways[d], far_m)) continue;
            const auto top = world.top_below(feet + ways[d] * far_m + Vec3(0.0, 0.0, 0.3));
            const double drop = top ? feet.z - *top : 0.0;
            if (top && drop < kMostDrop_m) continue;
            const FaultKind kind = top ? FaultKind::UnguardedDrop : FaultKind::FloorEnds;
            if (!reported.insert({room, kind}).second) continue;
            WorldFault fault{kind, feet, world.ground_source(feet)};
            fault.room = room;
            fault.name = world.room_name(room);
            fault.amount = drop;
            faults.push_back(std::move(fault));
        }
    }
}

}  // namespace

void find_shell_faults(const Examined& world, std::vector<WorldFault>& faults) {
    cracks(world, faults);
    if (!world.space || !world.graph) return;
    roofs(world, faults);
    edges(world, faults);
}

}  // namespace handrail::check
