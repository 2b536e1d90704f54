// Builds the doors and connections of an IFC building: door leaves, window panes, the connections between rooms, the
// ground outside, and the starting points.
#include <algorithm>
#include <array>

#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/geometry/clip.h"
#include "worlds/ifc/ifc_scene.h"
#include "worlds/ifc/ifc_spaces.h"
#include "worlds/scene/honest_report.h"
#include "worlds/scene/outer_ground.h"
#include "worlds/scene/surfaces.h"

namespace handrail::ifc {
namespace {

constexpr double kPaneThick_m = 0.06, kClear_m = 0.005;
constexpr double kLeafTravel_s = 1.0;
constexpr double kGroundThick_m = 0.2;
constexpr double kCeiling_m = 1.0;           // greatest thickness of the structure between the rooms of two storeys
constexpr std::size_t kMostCellars = 2'000;  // greatest number of rooms that cut away the ground above them

// Parts along which people walk or ride, each with the kind of portal that it becomes.
constexpr std::array<std::pair<PartRole, StatedPortalKind>, 5> kFlights{
    {{PartRole::Stairs, StatedPortalKind::Stairs},
     {PartRole::Ramp, StatedPortalKind::Ramp},
     {PartRole::Lift, StatedPortalKind::Lift},
     {PartRole::Escalator, StatedPortalKind::Stairs},
     {PartRole::Walkway, StatedPortalKind::Ramp}}};

double middle(double a, double b) { return 0.5 * (a + b); }

std::string joined(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names)
        if (!name.empty()) all += (all.empty() ? "" : ", ") + name;
    return all;
}

// An edge of an outline, seen from above.
struct Edge {
    Vec2 from{0.0}, to{0.0};
};

std::vector<Edge> edges_of(const StatedRoom& room) {
    std::vector<Edge> edges;
    for (const Ring& ring : room.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    return edges;
}

constexpr double kLeastBorder_m = 0.5, kFarthestBorder_m = 200.0, kNextToBorder_m = 0.05, kOneFloor_m = 0.3;
constexpr double kBorderStep_m = 0.25, kBorderBody_m = 0.6;

// Returns the part of `edge` along which `other` runs. Nothing if the two edges share no border.
std::optional<Reach> shared_stretch(const Edge& edge, const Edge& other) {
    const double length = glm::length(edge.to - edge.from);
    if (!(length >= kLeastBorder_m && length <= kFarthestBorder_m)) return std::nullopt;
    const Vec2 way = (edge.to - edge.from) / length, left(-way.y, way.x);
    const Vec2 p = other.from - edge.from, q = other.to - edge.from;
    const Reach shared{std::max(0.0, std::min(glm::dot(p, way), glm::dot(q, way))),
                       std::min(length, std::max(glm::dot(p, way), glm::dot(q, way)))};
    if (std::abs(glm::dot(p, left)) > kNextToBorder_m || std::abs(glm::dot(q, left)) > kNextToBorder_m ||
        shared.most - shared.least < kLeastBorder_m)
        return std::nullopt;
    return shared;
}

// Returns the point of the shared stretch nearest to its middle at which a walker can pass. `height_m` is the height of
// the ceiling above the floor.
std::optional<Vec3> way_across(const IfcBuilding& building, const Edge& edge, const Reach& shared, double floor_m,
                               double height_m) {
    const Vec2 way = (edge.to - edge.from) / glm::length(edge.to - edge.from), left(-way.y, way.x);
    const double middle_m = middle(shared.least, shared.most);
    const double reach_m = std::max(0.5 * (shared.most - shared.least - kBorderBody_m), 0.0);
    WallGap gap;
    gap.axes = {{way.x, way.y, 0.0}, {left.x, left.y, 0.0}, {0.0, 0.0, 1.0}, {}};
    gap.least_m = {-0.5 * kBorderBody_m, -kNextToBorder_m, 0.0};
    gap.most_m = {0.5 * kBorderBody_m, kNextToBorder_m, height_m};
    for (double off = 0.0; off <= reach_m; off += kBorderStep_m)
        for (const double at : {middle_m - off, middle_m + off}) {
            const Vec2 place = edge.from + way * at;
            gap.axes.origin_m = {place.x, place.y, floor_m};
            if (can_pass(building, gap)) return gap.axes.origin_m;
        }
    return std::nullopt;
}

// Returns the widest passage between two rooms on one floor level, where their outlines run along each other.
std::optional<StatedPortal> open_border(const IfcBuilding& building, const StatedRoom& room, const StatedRoom& other) {
    if (std::abs(other.floor_m - room.floor_m) > kOneFloor_m) return std::nullopt;
    StatedPortal portal;
    portal.kind = StatedPortalKind::Opening;
    portal.name = room.name + ", " + other.name;
    portal.by_boundaries = true;
    portal.height_m = std::min(room.height_m, other.height_m);
    const double floor_m = std::max(room.floor_m, other.floor_m);
    const std::vector<Edge> others = edges_of(other);
    for (const Edge& edge : edges_of(room))
        for (const Edge& beside : others) {
            const std::optional<Reach> shared = shared_stretch(edge, beside);
            if (!shared || shared->most - shared->least < portal.width_m) continue;
            if (const std::optional<Vec3> place = way_across(building, edge, *shared, floor_m, portal.height_m)) {
                portal.place_m = *place;
                portal.width_m = shared->most - shared->least;
            }
        }
    if (portal.width_m <= 0.0) return std::nullopt;
    return portal;
}

}  // namespace

void IfcScene::add_leaf(const WallGap& gap, double from, double to, bool hinge_at_least, std::size_t i,
                        std::uint32_t group) {
    const IfcPart& part = building_.parts[i];
    const double y = middle(gap.least_m.y, gap.most_m.y);
    const Vec3 least{from + kClear_m, y - 0.5 * kLeafThick_m, gap.least_m.z + kClear_m},
        most{to - kClear_m, y + 0.5 * kLeafThick_m, gap.most_m.z - kClear_m};
    std::optional<ConvexSolid> leaf = box_solid(least, most, gap.axes);
    if (!leaf) return;
    const FeatureId feature = add_feature(FeatureKind::Door, "door", {}, part.line);
    Mover mover;
    mover.feature = feature;
    mover.group = group;
    mover.wait_s = -1.0;  // the door stays open until the walker shuts it
    mover.travel_s = kLeafTravel_s;
    if (part.operation.find("SLIDING") != std::string::npos) {
        mover.pivot_m = leaf->bounds_m.centre_m();
        mover.slide_m = gap.axes.x * ((hinge_at_least ? -1.0 : 1.0) * (to - from));
    } else if (part.operation.starts_with("ROLLINGUP")) {
        mover.pivot_m = leaf->bounds_m.centre_m();
        mover.slide_m = {0.0, 0.0, most.z - least.z};
    } else {
        // The leaf swings towards +y, as IFC defines it, and turns about its edge on that side.
        mover.pivot_m = gap.axes.at({hinge_at_least ? least.x : most.x, most.y, least.z});
        mover.swing_rad = hinge_at_least ? 0.5 * kPi : -0.5 * kPi;
        Feature& named = scene_.features[feature.value];
        named.hinge = compass_point(
            std::atan2((hinge_at_least ? -gap.axes.x : gap.axes.x).x, (hinge_at_least ? -gap.axes.x : gap.axes.x).y));
        named.handle = compass_point(
            std::atan2((hinge_at_least ? gap.axes.x : -gap.axes.x).x, (hinge_at_least ? gap.axes.x : -gap.axes.x).y));
    }
    const std::string of_material = touch_material(part);
    add_solid(std::move(*leaf), SolidRole::Mover, feature, of_material, part.line);
    scene_.movers.push_back(std::move(mover));
}

void IfcScene::add_door(std::size_t i, const WallGap& gap) {
    const IfcPart& part = building_.parts[i];
    StatedPortal portal = portal_of(i, gap);
    const auto group = static_cast<std::uint32_t>(scene_.movers.size());
    const std::size_t before = scene_.features.size();
    ++plain_;
    if (part.operation.starts_with("DOUBLE")) {
        const double half = middle(gap.least_m.x, gap.most_m.x);
        add_leaf(gap, gap.least_m.x, half, true, i, group);
        add_leaf(gap, half, gap.most_m.x, false, i, group);
    } else {
        add_leaf(gap, gap.least_m.x, gap.most_m.x, part.operation.find("RIGHT") == std::string::npos, i, group);
    }
    if (scene_.features.size() > before) portal.feature = {static_cast<std::uint32_t>(before)};
    doors_.push_back({stated_->portals.size(), i});
    // A door with only one room leads outside. In a file without rooms, a door leads outside if one side of it is under
    // the open sky. If no door of such a file has such a side, all doors lead outside.
    if (portal.rooms.size() == 1 || (stated_->rooms.empty() && (sky_side_.empty() || sky_side_.contains(i))))
        outer_doors_.push_back({stated_->portals.size(), i});
    stated_->portals.push_back(std::move(portal));
}

// Adds a door for which the file states neither shape nor size nor opening, so that no gap can be cut for it.
void IfcScene::add_door_without_place(std::size_t i) {
    const IfcPart& part = building_.parts[i];
    StatedPortal portal;
    portal.name = part.name;
    portal.guid = part.guid;
    portal.source = {part.line, 0};
    const Vec3 at_m = part.body.empty() ? part.frame.origin_m : part.body.bounds_m().centre_m();
    portal.place_m = is_finite(at_m) ? at_m : Vec3(0.0);
    portal.passable = false;
    portal.why = "door_trial.no_size";
    stated_->portals.push_back(std::move(portal));
    note_impassable(stated_->portals.back());
}

void IfcScene::add_window(std::size_t i, const WallGap& gap) {
    const IfcPart& part = building_.parts[i];
    if (!gap.cut) {  // the wall is unknown, so the shape of the window itself is used
        add_part(i);
        return;
    }
    const double y = middle(gap.least_m.y, gap.most_m.y);
    ++plain_;
    if (std::optional<ConvexSolid> pane = box_solid({gap.least_m.x, y - 0.5 * kPaneThick_m, gap.least_m.z},
                                                    {gap.most_m.x, y + 0.5 * kPaneThick_m, gap.most_m.z}, gap.axes))
        add_solid(std::move(*pane), SolidRole::Solid, thing_of(i), "glass", part.line);
}

StatedPortal IfcScene::portal_of(std::size_t i, const WallGap& gap) {
    const IfcPart& part = building_.parts[i];
    StatedPortal portal;
    portal.name = part.name;
    portal.guid = part.guid;
    portal.source = {part.line, 0};
    portal.place_m =
        gap.axes.at({middle(gap.least_m.x, gap.most_m.x), middle(gap.least_m.y, gap.most_m.y), gap.least_m.z});
    portal.width_m = gap.most_m.x - gap.least_m.x;
    portal.height_m = gap.most_m.z - gap.least_m.z;
    std::vector<std::uint32_t> beside, stated;
    for (const std::uint32_t room : neighbouring_rooms(rooms_, gap))
        if (room != kNotStated && std::find(beside.begin(), beside.end(), room) == beside.end()) beside.push_back(room);
    if (const auto found = relations_.spaces_at.find(part.id); found != relations_.spaces_at.end())
        for (const std::uint64_t space : found->second)
            if (const auto at = building_.room_of_id.find(space); at != building_.room_of_id.end())
                stated.push_back(at->second);
    std::sort(beside.begin(), beside.end());
    std::sort(stated.begin(), stated.end());
    portal.by_boundaries = !stated.empty();
    // A third room in the boundaries belongs to a wall that continues beyond the door. In that case the rooms found on
    // the two sides are used.
    const bool within = std::includes(stated.begin(), stated.end(), beside.begin(), beside.end());
    portal.rooms = stated.empty() || (stated.size() > 2 && within && !beside.empty()) ? beside : stated;
    if (!stated.empty() && portal.rooms != beside) ++differing_;
    if (const auto freed = freed_.find(i); freed != freed_.end()) {
        portal.opened_by_box = true;
        const std::string stood = joined(freed->second);
        warn(part.line,
             phrase("ifc.door_blocked", {{"door", part.name},
                                         {"named", part.name.empty() ? "no" : "yes"},
                                         {"names", stood},
                                         {"stood", stood.empty() ? "no" : "yes"}}),
             phrase("ifc.then_opened"));
    }
    return portal;
}

// Tests every door with a walker, after everything that the walker could hit has been added to the scene.
void IfcScene::try_doors() {
    const DoorTrials trials(scene_);
    std::map<int, const std::string*> names;  // names by the line in the file
    for (const IfcPart& part : building_.parts) names.emplace(part.line, &part.name);
    for (const DoorPortal& door : doors_) {
        if (options_.stop.stop_requested()) return;
        const DoorTrial trial = trials.try_door(building_.gaps.at(door.part));
        if (trial.end == DoorTrialEnd::Passed) continue;
        StatedPortal& portal = stated_->portals[door.portal];
        portal.passable = false;
        portal.why = key_of(trial.end);
        portal.step_m = trial.end == DoorTrialEnd::Step ? trial.step_m : 0.0;
        constexpr std::size_t kMostNamed = 3;
        std::vector<std::string> in_the_way;
        for (const int line : trial.lines)
            if (const auto name = names.find(line); name != names.end() && in_the_way.size() < kMostNamed)
                in_the_way.push_back(one_line(*name->second));
        portal.in_the_way = joined(in_the_way);
        note_impassable(portal);
    }
}

void IfcScene::note_impassable(const StatedPortal& portal) {
    warn(portal.source.line,
         phrase("ifc.door_shut", {{"door", one_line(portal.name)},
                                  {"named", portal.name.empty() ? "no" : "yes"},
                                  {"reason", door_trial_words(portal)}}),
         phrase("ifc.then_left_as_is"));
}

// Finds the rooms that a flight of stairs or a ramp connects: the rooms at its two ends.
void IfcScene::join_flights() {
    for (const auto& [i, feature] : thing_) {
        const IfcPart& part = building_.parts[i];
        const auto moves = std::find_if(kFlights.begin(), kFlights.end(),
                                        [&](const auto& flight) { return flight.first == part.role; });
        if (moves == kFlights.end()) continue;
        const Aabb box = scene_.features[feature.value].bounds_m;
        if (box.empty()) continue;
        StatedPortal portal;
        portal.kind = moves->second;
        portal.name = part.name;
        portal.guid = part.guid;
        portal.feature = feature;
        portal.source = {part.line, 0};
        portal.place_m = {box.centre_m().x, box.centre_m().y, box.min_m.z};
        portal.width_m = std::min(box.size_m().x, box.size_m().y);
        portal.height_m = box.size_m().z;
        for (const double z : {box.min_m.z + 0.1, box.max_m.z + 0.1}) {
            // The height of a prefab is only assumed, so rooms above the prefab are not searched.
            if (part.prefab && z > box.max_m.z) continue;
            std::map<std::uint32_t, int> votes;
            for (int ix = 0; ix < 7; ++ix)
                for (int iy = 0; iy < 7; ++iy) {
                    const Vec3 at{box.min_m.x - 0.3 + (box.size_m().x + 0.6) * ix / 6.0,
                                  box.min_m.y - 0.3 + (box.size_m().y + 0.6) * iy / 6.0, z};
                    for (const std::uint32_t r : rooms_.all_at(at)) ++votes[r];
                }
            const auto most = std::max_element(votes.begin(), votes.end(),
                                               [](const auto& a, const auto& b) { return a.second < b.second; });
            if (most == votes.end()) continue;
            if (std::find(portal.rooms.begin(), portal.rooms.end(), most->first) == portal.rooms.end())
                portal.rooms.push_back(most->first);
        }
        std::sort(portal.rooms.begin(), portal.rooms.end());
        stated_->portals.push_back(std::move(portal));
        if (part.role == PartRole::Stairs) note_stairwell(box);
    }
}

// Returns portals between rooms that share a border without a wall. Their outlines must run along each other, the file
// must state such a border for both, and a walker must be able to pass.
std::vector<StatedPortal> IfcScene::open_borders() const {
    std::map<std::uint32_t, int> open;  // each room with the line that states its open border
    for (const auto& [space, boundary] : relations_.open_at)
        if (const auto room = building_.room_of_id.find(space); room != building_.room_of_id.end())
            open.emplace(room->second, model_.line(boundary));
    std::vector<StatedPortal> borders;
    for (const auto& [a, line] : open) {
        const StatedRoom& room = stated_->rooms[a];
        Aabb around;
        for (const Edge& edge : edges_of(room)) around.include({edge.from.x, edge.from.y, room.floor_m});
        if (around.empty()) continue;
        for (const std::uint32_t b : rooms_.near(grown(around, 0.2))) {
            if (b <= a || !open.contains(b)) continue;
            std::optional<StatedPortal> portal = open_border(building_, room, stated_->rooms[b]);
            if (!portal) continue;
            portal->rooms = {a, b};
            portal->source = {line, 0};
            borders.push_back(std::move(*portal));
        }
    }
    return borders;
}

// Adds portals for those borders whose rooms no door connects.
void IfcScene::join_open_rooms(std::vector<StatedPortal> borders) {
    for (StatedPortal& border : borders)
        if (std::none_of(stated_->portals.begin(), stated_->portals.end(), [&](const StatedPortal& known) {
                return known.kind == StatedPortalKind::Door && known.rooms == border.rooms;
            }))
            stated_->portals.push_back(std::move(border));
}

// Marks the rooms of which the stairs fill more than half.
void IfcScene::note_stairwell(const Aabb& stairs) {
    for (const std::uint32_t r : rooms_.near(stairs)) {
        StatedRoom& room = stated_->rooms[r];
        int held = 0;
        for (int ix = 0; ix < 5; ++ix)
            for (int iy = 0; iy < 5; ++iy)
                held += holds(room, {stairs.min_m.x + stairs.size_m().x * (0.5 + ix) / 5.0,
                                     stairs.min_m.y + stairs.size_m().y * (0.5 + iy) / 5.0, stairs.min_m.z + 0.1})
                            ? 1
                            : 0;
        const double covered_m2 = stairs.size_m().x * stairs.size_m().y * held / 25.0;
        room.holds_stairs = room.holds_stairs || (room.area_m2 > 0.0 && covered_m2 > 0.5 * room.area_m2);
    }
}

// Adds ground around the building. Files end at the outer walls, but a walker who steps outside needs ground. The
// ground is at the height of the storey with the most outer doors.
void IfcScene::add_ground() {
    double level_m = scene_.bounds_m.min_m.z;
    std::vector<double> heights;
    for (const DoorPortal& door : outer_doors_) heights.push_back(stated_->portals[door.portal].place_m.z);
    std::sort(heights.begin(), heights.end());
    std::ptrdiff_t most = 0;
    for (const double here_m : heights) {  // if two heights have as many doors, the lower one is used
        const auto first = std::upper_bound(heights.begin(), heights.end(), here_m - 0.6),
                   last = std::lower_bound(heights.begin(), heights.end(), here_m + 0.6);
        if (last - first > most) most = last - first, level_m = here_m;
    }
    ground_m_ = level_m -= kUnderThreshold_m;
    Body ground;
    const Aabb box = grown(scene_.bounds_m, kGroundAround_m);
    if (std::optional<ConvexSolid> slab =
            box_solid({box.min_m.x, box.min_m.y, level_m - kGroundThick_m}, {box.max_m.x, box.max_m.y, level_m}, {}))
        ground.solids.push_back(std::move(*slab));
    // Cuts away the ground above basement rooms, and around the stairs that lead up from these rooms.
    std::size_t cuts = 0;
    for (const StatedRoom& room : stated_->rooms) {
        if (room.floor_m > level_m - 0.3 || room.floor_m + room.height_m < level_m - kCeiling_m) continue;
        if (++cuts > kMostCellars) break;
        for (const Ring& part : convex_parts(room.rings)) {
            std::vector<Plane> planes;
            for (std::size_t k = 0; k < part.size(); ++k) {
                const Vec2 along = part[(k + 1) % part.size()] - part[k];
                const Vec3 out = Vec3(along.y, -along.x, 0.0) / std::max(glm::length(along), 1e-12);
                planes.push_back({out, glm::dot(out, Vec3(part[k].x, part[k].y, 0.0))});
            }
            cut_away(ground, planes);
        }
    }
    const Aabb building = scene_.bounds_m;
    const FeatureId feature = add_feature(FeatureKind::Object, kOuterGround, {}, 0);
    for (ConvexSolid& solid : ground.solids) add_solid(std::move(solid), SolidRole::Solid, feature, {}, 0);
    scene_.bounds_m = building;
    scene_.bounds_m.include(scene_.features[feature.value].bounds_m);
}

// Adds a start in front of each outer door, facing the door. The first start is at the height at which most outer doors
// are. If there are no outer doors, the start is in the largest room of the lowest storey with rooms. If there are no
// rooms either, it is on the ground to the south, facing the building.
void IfcScene::add_starts() {
    for (const DoorPortal& door : outer_doors_) {
        const StatedPortal& portal = stated_->portals[door.portal];
        const auto gap = building_.gaps.find(door.part);
        if (gap == building_.gaps.end()) continue;
        const std::array<std::uint32_t, 2> beside = neighbouring_rooms(rooms_, gap->second);
        const auto sky = sky_side_.find(door.part);
        const Vec3 out = gap->second.axes.y * (sky != sky_side_.end()    ? sky->second
                                               : beside[0] == kNotStated ? -1.0
                                                                         : 1.0);
        Start start;
        start.feet_m = portal.place_m + out * kOutsideDoor_m;
        start.heading_rad = std::atan2(-out.x, -out.y);
        start.name = portal.rooms.empty() ? portal.name : stated_->rooms[portal.rooms[0]].name;
        start.source = portal.source;
        scene_.starts.push_back(std::move(start));
    }
    // Sorts starts at ground level to the front. The other starts are in a sunken yard or on a balcony.
    const auto off_ground = [&](const Start& start) { return std::abs(start.feet_m.z - ground_m_) > 0.6; };
    std::stable_sort(scene_.starts.begin(), scene_.starts.end(),
                     [&](const Start& a, const Start& b) { return !off_ground(a) && off_ground(b); });
    if (scene_.starts.empty() && !stated_->rooms.empty()) {
        const StatedRoom* best = nullptr;
        for (const StatedRoom& room : stated_->rooms)
            if (!room.rings.empty() && (!best || room.floor_m < best->floor_m - 1.0 ||
                                        (room.floor_m < best->floor_m + 1.0 && room.area_m2 > best->area_m2)))
                best = &room;
        if (best) scene_.starts.push_back({best->at_m, 0.0, false, best->name, best->source});
    }
    if (scene_.starts.empty()) {
        const auto ground = std::find_if(scene_.features.begin(), scene_.features.end(), is_outer_ground);
        if (ground != scene_.features.end() && !ground->bounds_m.empty()) {
            const Aabb& box = ground->bounds_m;
            Start start;
            start.feet_m = {box.centre_m().x, box.min_m.y + 0.5 * kGroundAround_m, box.max_m.z};
            scene_.starts.push_back(std::move(start));
        }
    }
    if (!scene_.starts.empty()) scene_.starts.front().base = true;
}

}  // namespace handrail::ifc
