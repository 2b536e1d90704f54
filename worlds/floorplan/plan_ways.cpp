// Builds the doors, stairs, lifts and outdoor ways of a drawn plan.
#include <algorithm>
#include <array>

#include "worlds/base/human_measures.h"
#include "worlds/floorplan/plan_builder.h"
#include "worlds/floorplan/upright.h"
#include "worlds/geometry/clip.h"

#include "worlds/scene/surfaces.h"

namespace handrail::floorplan {
namespace {

constexpr double kClear_m = 0.005, kLeafTravel_s = 1.0, kTwoLeaves_m = 1.4;
constexpr double kStepThick_m = 0.3, kRail_m = 1.0, kRailThick_m = 0.08, kFloorThick_m = 0.2;
constexpr double kLiftSpeed_m_per_s = 0.75;
constexpr double kNearDoor_m = 1.5, kAtGround_m = 0.6, kCabinClear_m = 0.03, kLeastCabin_m = 0.7;
constexpr double kLeastRise_m = 0.5, kStepRise_m = 0.17;

bool is_stairs(PlanSpaceKind kind) { return kind == PlanSpaceKind::Stairs || kind == PlanSpaceKind::Escalator; }

bool joins(const PlanDoor& door, std::size_t space) {
    return std::any_of(door.spaces.begin(), door.spaces.end(), [&](const std::vector<std::size_t>& joined) {
        return std::find(joined.begin(), joined.end(), space) != joined.end();
    });
}

// Returns true if the point is on the outline or within kNear_m of it.
bool lies_on(const std::vector<Ring>& rings, const Vec2& at) {
    constexpr double kNear_m = 0.3;
    return distance_to_outline(rings, at) < kNear_m;
}

// Returns a sloping floor along a line. Its height changes evenly from `from_m` to `to_m`.
std::optional<ConvexSolid> sloped(const Vec2& from, const Vec2& to, double half_width_m, double from_m, double to_m) {
    const std::optional<ConvexSolid> level =
        upright(strip(from, to, half_width_m), std::min(from_m, to_m) - kFloorThick_m, std::max(from_m, to_m));
    if (!level) return {};
    std::vector<Plane> planes(level->planes.begin() + 2, level->planes.end());
    const Vec3 along = glm::normalize(Vec3(to, to_m) - Vec3(from, from_m));
    const Vec2 flat = glm::normalize(to - from);
    const Vec3 up = glm::normalize(glm::cross(along, Vec3(left_of(flat), 0.0)));
    planes.push_back({up, glm::dot(up, Vec3(from, from_m))});
    planes.push_back({-up, -glm::dot(up, Vec3(from, from_m - kFloorThick_m))});
    BuiltSolid built = solid_from_planes(planes, level->bounds_m.centre_m(), glm::length(level->bounds_m.size_m()));
    if (built.fault != SolidFault::None) return {};
    return std::move(built.solid);
}

}  // namespace

// Chooses the places of stairs and cabins, before floors are laid around them.
void PlanBuilder::plan_vertical_spaces() {
    for (std::size_t s = 0; s < plan_.spaces.size(); ++s) {
        const PlanSpace& space = plan_.spaces[s];
        if (is_stairs(space.kind)) ++stated_->stairs;
        if (space.kind == PlanSpaceKind::Lift) ++stated_->lifts;
        if (space.levels.size() < 2) continue;
        if (is_stairs(space.kind)) {
            double rise_m = 0.0;
            for (std::size_t i = 1; i < space.levels.size(); ++i)
                rise_m =
                    std::max(rise_m, plan_.levels[space.levels[i]].floor_m - plan_.levels[space.levels[i - 1]].floor_m);
            std::vector<Vec2> doors;
            for (const PlanDoor& door : plan_.doors)
                if (door.spaces.empty() ? lies_on(space.rings, door.at) : joins(door, s)) doors.push_back(door.at);
            wells_[s] = lay_stairs(space.rings, doors, rise_m);
            no_stairs_ += wells_[s] ? 0 : 1;
        } else if (space.kind == PlanSpaceKind::Lift) {
            const std::optional<InnerBox> box = inner_box(space.rings, longest_side(space.rings));
            if (!box || std::min(box->most.x - box->least.x, box->most.y - box->least.y) < kLeastCabin_m) continue;
            const Vec2 least = box->least + kCabinClear_m, most = box->most - kCabinClear_m;
            const auto at = [&](double x, double y) { return box->origin + box->along * x + left_of(box->along) * y; };
            cabins_[s] = {at(least.x, least.y), at(most.x, least.y), at(most.x, most.y), at(least.x, most.y)};
        }
    }
}

// Adds the floor of a lift as a feature that moves up and down. The mover of the floor is then the last entry of
// Scene::movers.
FeatureId PlanBuilder::add_cabin(const Ring& floor, double low_m, double way_m, const std::string& name,
                                 std::vector<double> halts) {
    const FeatureId feature = add_feature(FeatureKind::Lift, "lift", name);
    add_solid(upright(floor, low_m - kFloorThick_m, low_m), SolidRole::Mover, feature);
    Mover mover;
    mover.feature = feature;
    mover.pivot_m = scene_.features[feature.value].bounds_m.centre_m();
    mover.slide_m = {0.0, 0.0, way_m};
    mover.travel_s = std::max(1.0, way_m / kLiftSpeed_m_per_s);
    mover.wait_s = -1.0;
    mover.halts = std::move(halts);
    mover.group = static_cast<std::uint32_t>(scene_.movers.size());
    scene_.movers.push_back(std::move(mover));
    return feature;
}

// Adds the floors of lift cabins, each at the lowest level of its lift. A cabin stops at all levels of its space.
void PlanBuilder::add_lifts() {
    for (std::size_t s = 0; s < plan_.spaces.size(); ++s) {
        const PlanSpace& space = plan_.spaces[s];
        if (space.kind != PlanSpaceKind::Lift || space.levels.size() < 2) continue;
        const double low_m = plan_.levels[space.levels.front()].floor_m,
                     way_m = plan_.levels[space.levels.back()].floor_m - low_m;
        StatedPortal portal;
        portal.kind = StatedPortalKind::Lift;
        portal.name = space.name.empty() ? space.number : space.name;
        portal.guid = space.id;
        portal.rooms = room_of_[s];
        portal.by_boundaries = true;
        portal.passable = !cabins_[s].empty();
        if (portal.passable) {
            std::vector<double> halts;
            for (const std::size_t level : space.levels) halts.push_back((plan_.levels[level].floor_m - low_m) / way_m);
            lifts_[s] = static_cast<std::uint32_t>(scene_.movers.size());
            portal.feature = vertical_[s] = add_cabin(cabins_[s], low_m, way_m, portal.name, std::move(halts));
            const Aabb box = scene_.features[portal.feature.value].bounds_m;
            portal.place_m = {box.centre_m().x, box.centre_m().y, low_m};
            portal.width_m = std::min(box.size_m().x, box.size_m().y);
            portal.height_m = way_m;
        }
        stated_->portals.push_back(std::move(portal));
    }
}

// Adds lifts without a shaft. Each is in the lower of the two rooms that it connects.
void PlanBuilder::add_platforms() {
    for (const PlanLift& lift : plan_.lifts) {
        const double low_m = floor_of(lift.from, lift.low), way_m = floor_of(lift.to, lift.high) - low_m;
        if (way_m < kLeastRise_m) continue;
        StatedPortal portal = portal_between(StatedPortalKind::Lift, lift.name, lift.line, room_at(lift.from, lift.low),
                                             room_at(lift.to, lift.high));
        portal.feature = add_cabin(lift.ring, low_m, way_m, lift.name, {0.0, 1.0});
        const Aabb box = scene_.features[portal.feature.value].bounds_m;
        portal.place_m = {box.centre_m().x, box.centre_m().y, low_m};
        portal.width_m = std::min(box.size_m().x, box.size_m().y);
        portal.height_m = way_m;
        ++stated_->lifts;
        stated_->portals.push_back(std::move(portal));
    }
}

void PlanBuilder::add_leaf(const PlanDoor& door, const DoorGap& gap, double floor_m, double from, double to,
                           bool hinge_at_from, bool to_left, std::uint32_t lift, std::uint32_t group) {
    const Vec2 least = gap.at + gap.along * (from + kClear_m), most = gap.at + gap.along * (to - kClear_m);
    std::optional<ConvexSolid> leaf =
        upright(strip(least, most, 0.5 * kLeafThick_m), floor_m + kClear_m, floor_m + kDoorHigh_m - kClear_m);
    if (!leaf) return;
    const FeatureId feature = add_feature(FeatureKind::Door, "door", door.name);
    Mover mover;
    mover.feature = feature;
    mover.group = group;
    mover.wait_s = -1.0;  // the door stays open until the walker shuts it
    mover.travel_s = kLeafTravel_s;
    mover.pivot_m = leaf->bounds_m.centre_m();
    if (door.kind == PlanDoorKind::Sliding || lift != kNoLift) {
        mover.slide_m = Vec3(gap.along * ((hinge_at_from ? -1.0 : 1.0) * (to - from)), 0.0);
    } else {
        const Vec2 side = left_of(gap.along) * (to_left ? 0.5 : -0.5) * kLeafThick_m;
        mover.pivot_m = Vec3((hinge_at_from ? least : most) + side, floor_m + kClear_m);
        mover.swing_rad = hinge_at_from == to_left ? 0.5 * kPi : -0.5 * kPi;
        const Vec2 hinge = hinge_at_from ? -gap.along : gap.along;
        scene_.features[feature.value].hinge = compass_point(std::atan2(hinge.x, hinge.y));
        scene_.features[feature.value].handle = compass_point(std::atan2(-hinge.x, -hinge.y));
    }
    if (door.by_itself || lift != kNoLift) {
        mover.wait_s = kDoorWait_s;
        mover.approach_m = grown(leaf->bounds_m, kNearDoor_m);
        mover.approach_m.min_m.z = floor_m;
        mover.approach_m.max_m.z = floor_m + kStandingRoom_m;
    }
    if (lift != kNoLift) {
        const Mover& of = scene_.movers[lift];
        const Aabb cabin = scene_.features[of.feature.value].bounds_m;
        mover.lift = lift;
        mover.lift_part = (floor_m - cabin.max_m.z) / of.slide_m.z;
        mover.wait_s = kLiftDoorWait_s;
        mover.approach_m = cabin;  // the door opens for anyone inside, so that nobody is shut in
        mover.approach_m.min_m.z = floor_m;
        mover.approach_m.max_m.z = floor_m + kStandingRoom_m;
    }
    add_solid(std::move(leaf), SolidRole::Mover, feature);
    scene_.movers.push_back(std::move(mover));
}

void PlanBuilder::add_doors(std::size_t level, const LevelWalls& walls) {
    const bool at_ground = std::abs(plan_.levels[level].floor_m - ground_m_) < kAtGround_m;
    for (const DoorGap& gap : walls.doors) {
        if (stopped()) return;
        const PlanDoor& door = plan_.doors[gap.door];
        const double floor_m = plan_.levels[level].floor_m + highest_raise(gap.spaces, level);
        StatedPortal portal;
        const bool opening = door.kind == PlanDoorKind::Opening || door.guessed;
        portal.kind = opening ? StatedPortalKind::Opening : StatedPortalKind::Door;
        portal.name = door.name;
        portal.guid = door.id;
        portal.source.line = door.line;
        portal.rooms = rooms_at(gap.spaces, level);
        for (std::size_t i = 0; i < portal.rooms.size() && door.name.empty(); ++i)
            portal.name += (i > 0 ? ", " : "") + stated_->rooms[portal.rooms[i]].name;
        portal.place_m = Vec3(gap.at, floor_m);
        portal.width_m = gap.width_m;
        portal.height_m = kDoorHigh_m;
        portal.by_boundaries = !door.spaces.empty();
        portal.passable = gap.in_wall && gap.width_m >= kLeastWay_m;
        scene_.report.doors += portal.kind == StatedPortalKind::Door ? 1 : 0;
        guessed_widths_ += door.width_m ? 0 : 1;
        widened_ += door.width_m && *door.width_m < kLeastWay_m ? 1 : 0;
        moved_ += gap.moved ? 1 : 0;
        narrow_ += gap.in_wall && gap.width_m < kLeastWay_m ? 1 : 0;
        // The spaces are open to each other at the door, so the door needs no wall.
        const bool open_there = !gap.in_wall && portal.rooms.size() > 1;
        off_walls_ += !gap.in_wall && !open_there ? 1 : 0;
        if (open_there) portal.passable = true;
        const bool outside = gap.in_wall && portal.rooms.size() == 1;
        const bool nowhere = outside && !at_ground;
        if (nowhere) portal.passable = false;
        to_nowhere_ += nowhere ? 1 : 0;
        portal.outside = outside && at_ground;
        // The leaf swings into the smaller of the two rooms. A door that leads outside swings inwards.
        const auto area = [&](std::size_t side) {
            const std::uint32_t room = room_at(gap.sides[side], level);
            return room == kNotStated ? 1e300 : stated_->rooms[room].area_m2;
        };
        const bool to_left = area(0) <= area(1);
        std::uint32_t lift = kNoLift;
        for (const std::size_t s : gap.spaces)
            if (lifts_[s] != kNoLift) lift = lifts_[s];
        revolving_ += door.kind == PlanDoorKind::Revolving ? 1 : 0;
        const bool leaf = gap.in_wall && (door.kind == PlanDoorKind::Hinged || door.kind == PlanDoorKind::Sliding);
        if (nowhere) {
            add_solid(upright(strip(gap.at - gap.along * (0.5 * gap.width_m), gap.at + gap.along * (0.5 * gap.width_m),
                                    0.5 * kLeafThick_m),
                              floor_m, floor_m + kDoorHigh_m),
                      SolidRole::Solid, add_feature(FeatureKind::Object, "door", door.name));
        } else if (leaf) {
            const std::size_t before = scene_.features.size();
            const auto group = static_cast<std::uint32_t>(scene_.movers.size());
            const double half = 0.5 * gap.width_m;
            if (gap.width_m > kTwoLeaves_m) {
                add_leaf(door, gap, floor_m, -half, 0.0, true, to_left, lift, group);
                add_leaf(door, gap, floor_m, 0.0, half, false, to_left, lift, group);
            } else {
                add_leaf(door, gap, floor_m, -half, half, true, to_left, lift, group);
            }
            if (scene_.features.size() > before) portal.feature = {static_cast<std::uint32_t>(before)};
        }
        if (outside && at_ground && portal.passable) {
            const bool inside_left = room_at(gap.sides[0], level) != kNotStated;
            outer_.push_back({door.entrance, portal.place_m, left_of(gap.along) * (inside_left ? -1.0 : 1.0),
                              door.name.empty() ? stated_->rooms[portal.rooms[0]].name : door.name});
        }
        stated_->portals.push_back(std::move(portal));
    }
}

// Adds two flights with a landing between them, from each level of the space to the next level.
void PlanBuilder::add_stairs(std::size_t s) {
    const PlanSpace& space = plan_.spaces[s];
    if (!is_stairs(space.kind) || space.levels.size() < 2) return;
    const std::string name = space.name.empty() ? space.number : space.name;
    const FeatureId feature = wells_[s] ? add_feature(FeatureKind::Object, "stairs", name) : kNoFeature;
    const double lowest_m = plan_.levels[space.levels.front()].floor_m,
                 top_m = plan_.levels[space.levels.back()].floor_m;
    for (std::size_t i = 1; i < space.levels.size(); ++i) {
        StatedPortal portal;
        portal.kind = StatedPortalKind::Stairs;
        portal.name = name;
        portal.guid = space.id;
        portal.rooms = {room_of_[s][i - 1], room_of_[s][i]};
        portal.by_boundaries = true;
        portal.passable = wells_[s].has_value();
        portal.feature = feature;
        const double low_m = plan_.levels[space.levels[i - 1]].floor_m,
                     rise_m = plan_.levels[space.levels[i]].floor_m - low_m;
        portal.place_m = stated_->rooms[portal.rooms[0]].at_m;
        portal.height_m = rise_m;
        if (const std::optional<StairWell>& well = wells_[s]) {
            const double half = 0.5 * well->width_m;
            portal.place_m = Vec3(well->at(0.0, -0.5 * half), low_m);
            portal.width_m = half;
            const int steps = steps_of_half(rise_m, well->step_rise_m);
            const double going = (well->length_m - well->landing_m) / steps, rise = 0.5 * rise_m / steps;
            const auto step = [&](double from, double to, double right, double left, double at_m) {
                const double under_m = i == 1 ? lowest_m : std::max(at_m - kStepThick_m, lowest_m);
                add_solid(upright(well->box(from, to, right, left), under_m, at_m), SolidRole::Solid, feature);
            };
            for (int k = 0; k < steps; ++k) {
                step(k * going, (k + 1) * going, -half, 0.0, low_m + (k + 1) * rise);
                step((steps - 1 - k) * going, (steps - k) * going, 0.0, half, low_m + 0.5 * rise_m + (k + 1) * rise);
            }
            step(steps * going, well->length_m, -half, half, low_m + 0.5 * rise_m);
        }
        stated_->portals.push_back(std::move(portal));
    }
    if (!wells_[s]) return;
    // Adds low walls around the well and between the flights, so that nobody falls.
    const StairWell& well = *wells_[s];
    const double half = 0.5 * well.width_m, flight = well.length_m - well.landing_m;
    const auto rail = [&](double from, double to, double right, double left, double from_m) {
        add_solid(upright(well.box(from, to, right, left), from_m, top_m + kRail_m), SolidRole::Solid, kNoFeature);
    };
    rail(0.0, well.length_m, -half - kRailThick_m, -half, lowest_m);
    rail(0.0, well.length_m, half, half + kRailThick_m, lowest_m);
    rail(well.length_m, well.length_m + kRailThick_m, -half - kRailThick_m, half + kRailThick_m, lowest_m);
    rail(0.0, flight, -0.5 * kRailThick_m, 0.5 * kRailThick_m, lowest_m);
    rail(-kRailThick_m, 0.0, -half - kRailThick_m, 0.0, top_m);
}

// Adds floors along the lines of ways. Stairs get steps.
void PlanBuilder::add_ways() {
    std::vector<FeatureId> features;
    std::vector<std::uint32_t> rooms;
    for (const PlanWay& way : plan_.ways) {
        if (stopped()) return;
        features.push_back(way.steps ? add_feature(FeatureKind::Object, "stairs", way.name) : kNoFeature);
        rooms.push_back(kNotStated);
        stated_->stairs += way.steps ? 1 : 0;
        const std::vector<Ring> parts = way.area ? convex_parts(rings_of_way(way)) : add_strips(way, features.back());
        if (way.area)
            for (const Ring& part : parts)
                add_solid(upright(part, way.floor_m[0] - kFloorThick_m, way.floor_m[0]), SolidRole::Solid, kNoFeature);
        if (parts.empty()) continue;
        add_facts(parts, *std::min_element(way.floor_m.begin(), way.floor_m.end()), way.facts);
        if (way.steps) continue;
        rooms.back() = static_cast<std::uint32_t>(stated_->rooms.size());
        state_way(way, parts);
    }
    join_ways(features, rooms);
}

// Adds the floors of a way and returns the rectangles that they cover.
std::vector<Ring> PlanBuilder::add_strips(const PlanWay& way, FeatureId feature) {
    std::vector<Ring> parts;
    const double half = 0.5 * way.width_m;
    for (std::size_t i = 1; i < way.line.size(); ++i) {
        const Vec2 &a = way.line[i - 1], &b = way.line[i];
        const double from_m = way.floor_m[i - 1], to_m = way.floor_m[i];
        if (glm::length(b - a) < 1e-3) continue;
        if (way.steps && std::abs(to_m - from_m) > kLeastRise_m) {
            const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to_m - from_m) / kStepRise_m)));
            for (int k = 0; k < steps && !too_large(); ++k) {
                const double at_m = from_m + (to_m - from_m) * (to_m > from_m ? k + 1 : k) / steps;
                add_solid(upright(strip(a + (b - a) * (static_cast<double>(k) / steps),
                                        a + (b - a) * (static_cast<double>(k + 1) / steps), half),
                                  at_m - kStepThick_m, at_m),
                          SolidRole::Solid, feature);
            }
        } else if (std::abs(to_m - from_m) < 1e-6) {
            add_solid(upright(strip(a, b, half), from_m - kFloorThick_m, from_m), SolidRole::Solid, feature);
        } else {
            add_solid(sloped(a, b, half, from_m, to_m), SolidRole::Solid, feature);
        }
        parts.push_back(strip(a, b, half));
    }
    // Fills the corners of the line with discs, because rectangles leave gaps there.
    for (std::size_t i = 0; i < way.line.size() && !way.steps; ++i) {
        Ring disc;
        for (int k = 0; k < 8; ++k)
            disc.push_back(way.line[i] + Vec2(std::cos(k * 0.25 * kPi), std::sin(k * 0.25 * kPi)) * half);
        add_solid(upright(disc, way.floor_m[i] - kFloorThick_m, way.floor_m[i]), SolidRole::Solid, kNoFeature);
    }
    return parts;
}

void PlanBuilder::state_way(const PlanWay& way, const std::vector<Ring>& parts) {
    StatedRoom room;
    room.name = way.name;
    room.guid = way.id;
    room.is_way = true;
    if (way.area) {
        room.rings = rings_of_way(way);
    } else {
        Ring right, left;
        for (const Ring& part : parts) {
            right.insert(right.end(), {part[0], part[1]});
            left.insert(left.end(), {part[3], part[2]});
        }
        std::reverse(left.begin(), left.end());
        right.insert(right.end(), left.begin(), left.end());
        room.rings = {right};
    }
    const auto [low, high] = std::minmax_element(way.floor_m.begin(), way.floor_m.end());
    room.floor_m = *low;
    room.height_m = 2.5 + *high - *low;
    room.at_m = Vec3(0.5 * (parts[0][0] + parts[0][2]), 0.5 * (way.floor_m[0] + way.floor_m[1]));
    for (const Ring& part : parts) room.area_m2 += signed_area(part);
    for (std::size_t l = 0; l < plan_.levels.size(); ++l)
        if (std::abs(plan_.levels[l].floor_m - way.floor_m[0]) < kAtGround_m) {
            room.storey = static_cast<std::uint32_t>(l);
            ++stated_->storeys[l].rooms;
            break;
        }
    stated_->rooms.push_back(std::move(room));
}

}  // namespace handrail::floorplan
