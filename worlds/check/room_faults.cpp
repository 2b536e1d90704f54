#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/check/examined.h"
#include "worlds/check/gap_width.h"
#include "worlds/check/missing_doors.h"
#include "worlds/geometry/clip.h"
#include "worlds/navigation/reach.h"
#include "worlds/navigation/stated_stairs.h"
#include "worlds/scene/honest_report.h"

namespace handrail::check {
namespace {

constexpr double kLeastNamed_m2 = 2.0;  // a room smaller than this is treated as a niche, whatever its shape
// A room smaller than this needs no landmark, because everything in it is within reach.
constexpr double kLeastLandmarked_m2 = 4.0;
constexpr double kOneRoom_m = 1.5;  // two names nearer to each other than this belong to the same room
constexpr std::size_t kMostCandidates = 3;

// Finds the rooms that a person can walk into from the base, with doors open and things in place. The person must reach
// an area larger than a doorway, because a strip in front of a blocked door may belong to the room behind that door.
std::vector<bool> walked_into(const Examined& world) {
    const navigation::WalkSpace& space = *world.space;
    const Start* const base = navigation::base_of(world.scene);
    const std::uint32_t first = base ? space.nearest(base->feet_m, 0.5, 0.4, 1.0) : navigation::kNothing;
    if (first == navigation::kNothing) return {};
    const std::vector<bool> seen = navigation::spans_reached(space, first);
    std::vector<std::size_t> all(world.graph->rooms.size(), 0), walked(all);
    for (std::uint32_t s = 0; s < space.spans.size(); ++s)
        if (const std::uint32_t room = world.graph->room_of_span[s]; room != navigation::kNothing) {
            ++all[room];
            walked[room] += seen[s] ? 1 : 0;
        }
    std::vector<bool> rooms;
    for (std::size_t r = 0; r < all.size(); ++r) rooms.push_back(all[r] == 0 || 5 * walked[r] > all[r]);
    return rooms;
}

// Returns the solid that limits the headroom at a place. Null if a sheet limits it.
const Solid* above(const Examined& world, const Vec3& at_m, double headroom_m) {
    constexpr double kInto_m = 0.02;
    return world.solid_at(at_m + Vec3(0.0, 0.0, headroom_m + kInto_m), world.space->body.radius_m);
}

// Returns the name of the solid, or else the name of its underside.
std::string name_from_below(const Scene& scene, const Solid& solid) {
    if (solid.feature != kNoFeature) return spoken_name(scene.features[solid.feature.value]);
    for (std::size_t i = 0; i < std::min(solid.shape.planes.size(), solid.face_features.size()); ++i)
        if (solid.shape.planes[i].normal.z < -0.5 && solid.face_features[i] != kNoFeature)
            return spoken_name(scene.features[solid.face_features[i].value]);
    return {};
}

// Stores in `fault` what the best route lacks. Does nothing if a thing limits the headroom, because things can be
// moved.
void store_lack(const Examined& world, WorldFault& fault, const RouteLacks& found) {
    if (found.lack == Lack::Nothing) return;
    if (found.lack == Lack::Headroom)
        if (const Solid* solid = above(world, found.at_m, found.has_m)) {
            if (solid->feature != kNoFeature && world.is_thing(solid->feature)) return;
            fault.other = name_from_below(world.scene, *solid);
        }
    fault.lack = found.lack;
    fault.at_m = found.at_m;
    fault.amount = found.lack == Lack::Width ? gap_width(world, found.at_m, found.has_m) : found.has_m;
    fault.needed_m = found.needs_m;
}

// For each fault without an explanation, stores what the best route lacks.
void store_lacks(const Examined& world, std::span<WorldFault> faults, std::span<const Lack> kinds,
                 const std::stop_token& stop) {
    const Start* const base = navigation::base_of(world.scene);
    if (!base) return;
    std::vector<WorldFault*> unexplained;
    std::vector<Vec3> places_m;
    for (WorldFault& fault : faults)
        if (fault.other.empty()) {
            unexplained.push_back(&fault);
            places_m.push_back(fault.at_m);
        }
    const std::vector<RouteLacks> lacks = route_lacks(world.scene, *world.space, base->feet_m, places_m, kinds, stop);
    for (std::size_t i = 0; i < lacks.size(); ++i) store_lack(world, *unexplained[i], lacks[i]);
}

// Adds a fault for each flight of stairs on which nobody can walk step by step. Stores what keeps people from walking
// on it. Only routes on the stairs are considered, because a route elsewhere says nothing about the stairs.
void in_one_go(const Examined& world, std::vector<WorldFault>& faults) {
    constexpr std::array kKinds{Lack::Headroom, Lack::Step, Lack::Width};
    for (const navigation::WalkLink& link : world.space->links) {
        if (link.kind != navigation::PassageKind::Climb) continue;
        const Vec3 foot_m = world.space->place_m(link.from);
        const Feature* const stairs = world.scene.find(link.feature);
        WorldFault fault{FaultKind::StairsInOneGo, foot_m, stairs ? stairs->source : world.ground_source(foot_m)};
        fault.feature = link.feature;
        fault.room = world.graph->room_of_span[link.to];
        fault.name = stairs ? spoken_name(*stairs) : spoken_kind("stairs");
        if (stairs && !stairs->bounds_m.empty()) {
            const Vec3 head_m = world.space->place_m(link.to);
            Aabb around = stairs->bounds_m;
            around.include(foot_m);
            around.include(head_m);
            store_lack(world, fault,
                       route_lacks_within(world.scene, *world.space, foot_m, head_m,
                                          grown(around, navigation::kNextToStairs_m), kKinds));
        }
        faults.push_back(std::move(fault));
    }
}

// Returns a fault for each room that things block, unless `reported` has a fault about the room already.
std::vector<WorldFault> blocked_by_things(const Examined& world, std::span<const WorldFault> reported,
                                          const std::stop_token& stop = {}) {
    const std::vector<bool> reached = walked_into(world);
    std::vector<WorldFault> found;
    for (std::uint32_t r = 0; r < reached.size(); ++r) {
        const navigation::Room& room = world.graph->rooms[r];
        const bool known =
            std::any_of(reported.begin(), reported.end(), [&](const WorldFault& fault) { return fault.room == r; });
        if (reached[r] || known || room.kind == navigation::RoomKind::Liquid ||
            room.kind == navigation::RoomKind::Niche || world.is_ground(r))
            continue;
        WorldFault fault{FaultKind::RoomOutOfReach, room.middle_m, world.room_source(r)};
        fault.room = r;
        fault.name = room.name;
        fault.lack = Lack::Things;
        found.push_back(std::move(fault));
    }
    // Stairs may be among the things that block a room. They may lead below a floor, and then the lack of headroom is
    // the better explanation.
    constexpr std::array kKinds{Lack::Headroom};
    store_lacks(world, found, kKinds, stop);
    return found;
}

// Returns the faults about rooms out of reach, for all rooms or only for the room `only`.
std::vector<WorldFault> out_of_reach(const Examined& world, std::optional<std::uint32_t> only = std::nullopt,
                                     const std::stop_token& stop = {}) {
    std::vector<WorldFault> found;
    for (const navigation::RoomOutOfReach& room :
         navigation::rooms_out_of_reach(world.scene, *world.space, *world.graph)) {
        if ((room.room != navigation::kNothing && world.is_ground(room.room)) || (only && room.room != *only)) continue;
        WorldFault fault{
            FaultKind::RoomOutOfReach, room.at_m,
            room.room == navigation::kNothing ? world.ground_source(room.at_m) : world.room_source(room.room)};
        fault.room = room.room;
        fault.name = room.name;
        found.push_back(std::move(fault));
    }
    constexpr std::array kKinds{Lack::Headroom, Lack::Step, Lack::Width};
    store_lacks(world, found, kKinds, stop);
    // Suggests a missing door only if no narrow gap or low opening explains the fault. Most gaps and low openings are
    // in a wall that could have a door as well, so the suggestion would mislead.
    for (WorldFault& fault : found) {
        if (fault.lack != Lack::Nothing || fault.room == navigation::kNothing || stop.stop_requested()) continue;
        const std::vector<MissingDoor> doors =
            missing_doors(world.scene, *world.space, *world.graph, fault.room, std::nullopt, 1);
        if (!doors.empty()) fault.other = world.room_name(doors[0].to);
    }
    return found;
}

// True for a real room. False for landings, which are part of stairs, and for the ground.
bool is_place_of_its_own(const Examined& world, std::uint32_t r) {
    bool other_ways = false, stairs = false;
    for (const navigation::Portal& portal : world.graph->portals)
        if (portal.rooms[0] == r || portal.rooms[1] == r)
            (portal.kind == navigation::PassageKind::Stairs ? stairs : other_ways) = true;
    const navigation::Room& room = world.graph->rooms[r];
    const bool landing = stairs && !other_ways && !room.given && room.map_name.empty();
    return room.kind == navigation::RoomKind::Room && !landing && !world.is_ground(r);
}

void unnamed(const Examined& world, std::vector<WorldFault>& faults) {
    for (std::uint32_t r = 0; r < world.graph->rooms.size(); ++r) {
        const navigation::Room& room = world.graph->rooms[r];
        if (room.area_m2 < kLeastNamed_m2 || !is_place_of_its_own(world, r) || room.given || !room.map_name.empty())
            continue;
        WorldFault fault{FaultKind::UnnamedRoom, room.middle_m, world.room_source(r)};
        fault.room = r;
        fault.name = room.name;
        fault.amount = room.area_m2;
        faults.push_back(std::move(fault));
    }
}

// Returns things that are fixed, have a name that occurs only once in the world, and are large enough to feel. The
// largest is first.
std::vector<FeatureId> landmark_candidates(const Examined& world, const std::vector<std::uint32_t>& things) {
    const Scene& scene = world.scene;
    const auto is_free = [&](FeatureId id) {
        return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                           [&](const FreeBody& body) { return body.feature == id; });
    };
    std::vector<std::uint32_t> candidates;
    for (const std::uint32_t f : things) {
        const Feature& feature = scene.features[f];
        const auto same = std::count_if(scene.features.begin(), scene.features.end(),
                                        [&](const Feature& other) { return other.name == feature.name; });
        if (feature.made_name || feature.name.empty() || same > 1 || is_free(FeatureId{f})) continue;
        candidates.push_back(f);
    }
    std::stable_sort(candidates.begin(), candidates.end(), [&](std::uint32_t a, std::uint32_t b) {
        return scene.features[a].area_m2 > scene.features[b].area_m2;
    });
    std::vector<FeatureId> best;
    for (std::size_t i = 0; i < std::min(kMostCandidates, candidates.size()); ++i)
        best.push_back(FeatureId{candidates[i]});
    return best;
}

void without_landmark(const Examined& world, std::vector<WorldFault>& faults) {
    const navigation::RoomGraph& graph = *world.graph;
    std::vector<bool> marked(graph.rooms.size(), false);
    std::vector<std::vector<std::uint32_t>> things(graph.rooms.size());
    const auto mark = [&](std::uint32_t room) {
        if (room != navigation::kNothing) marked[room] = true;
    };
    for (std::uint32_t f = 0; f < world.scene.features.size(); ++f) {
        const Feature& feature = world.scene.features[f];
        const bool thing = world.is_thing(FeatureId{f});
        if (!feature.landmark && !thing) continue;
        const std::uint32_t room = world.room_of(feature);
        if (feature.landmark) mark(room);
        else if (room != navigation::kNothing) things[room].push_back(f);
        if (!feature.landmark) continue;
        // A door can be a landmark of the rooms on both of its sides.
        for (const navigation::Portal& portal : graph.portals)
            if (portal.feature == FeatureId{f}) mark(portal.rooms[0]), mark(portal.rooms[1]);
    }
    for (std::uint32_t r = 0; r < graph.rooms.size(); ++r) {
        const navigation::Room& room = graph.rooms[r];
        if (room.area_m2 < kLeastLandmarked_m2 || marked[r] || !is_place_of_its_own(world, r)) continue;
        WorldFault fault{FaultKind::NoLandmark, room.middle_m, world.room_source(r)};
        fault.room = r;
        fault.name = room.name;
        fault.candidates = landmark_candidates(world, things[r]);
        faults.push_back(std::move(fault));
    }
}

// Finds two names in a map that are too near to each other to belong to two rooms. Rooms that the file states are
// compared by their outlines instead.
void names_in_one_place(const Examined& world, std::vector<WorldFault>& faults) {
    const std::vector<RoomName>& names = world.scene.room_names;
    std::vector<std::uint32_t> spans, rooms;
    for (const RoomName& name : names) {
        spans.push_back(world.space->nearest(name.at_m, 1.0, 0.6, 3.0));
        rooms.push_back(spans.back() == navigation::kNothing ? navigation::kNothing
                                                             : world.graph->room_of_span[spans.back()]);
    }
    for (std::size_t i = 0; i < names.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const Vec3 apart = names[i].at_m - names[k].at_m;
            const bool near = glm::length(Vec2(apart)) < kOneRoom_m && std::abs(apart.z) < 1.5;
            if (names[i].name == names[k].name || rooms[i] == navigation::kNothing || rooms[k] == navigation::kNothing)
                continue;
            const bool nothing_between =
                near && world.space->straight(world.space->place_m(spans[i]), world.space->place_m(spans[k]));
            if (rooms[i] != rooms[k] && !nothing_between) continue;
            const Vec3 at_m = world.space->place_m(spans[i]);
            WorldFault fault{FaultKind::OverlappingRooms, at_m, world.ground_source(at_m)};
            fault.room = rooms[i];
            fault.name = in_spoken_language(names[k].name, names[k].name_in);
            fault.other = in_spoken_language(names[i].name, names[i].name_in);
            faults.push_back(std::move(fault));
        }
}

}  // namespace

void find_room_faults(const Examined& world, std::vector<WorldFault>& faults) {
    std::vector<WorldFault> no_route = out_of_reach(world), blocked = blocked_by_things(world, no_route);
    std::move(no_route.begin(), no_route.end(), std::back_inserter(faults));
    std::move(blocked.begin(), blocked.end(), std::back_inserter(faults));
    in_one_go(world, faults);
    if (!world.scene.stated) names_in_one_place(world, faults);
    unnamed(world, faults);
    without_landmark(world, faults);
}

std::optional<WorldFault> why_out_of_reach(const Scene& scene, const navigation::WalkSpace& space,
                                           const navigation::RoomGraph& graph, std::uint32_t room,
                                           const std::stop_token& stop) {
    contract_pre(room < graph.rooms.size());
    const Examined world(scene, &space, &graph);
    if (std::vector<WorldFault> no_route = out_of_reach(world, room, stop); !no_route.empty())
        return std::move(no_route.front());
    for (WorldFault& fault : blocked_by_things(world, {}, stop))
        if (fault.room == room) return std::move(fault);
    return std::nullopt;
}

}  // namespace handrail::check
