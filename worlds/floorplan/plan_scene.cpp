#include "worlds/floorplan/plan_scene.h"

#include <algorithm>
#include <map>

#include "worlds/base/human_measures.h"
#include "worlds/base/text.h"
#include "worlds/floorplan/plan_builder.h"
#include "worlds/floorplan/upright.h"
#include "worlds/scene/outer_ground.h"
#include "worlds/scene/surfaces.h"

namespace handrail::floorplan {
namespace {

constexpr std::size_t kMostSolids = 150'000;
// The unit for the tolerances of derive_surfaces, the same as for maps.
constexpr double kSurfaceUnit_m = 1.0 / 32.0;
constexpr double kSlab_m = 0.2, kCeiling_m = 0.1, kFacts_m = 2.0;
constexpr double kLeastStorey_m = 2.2;
constexpr double kNearGround_m = 0.6;

}  // namespace

PlanBuilder::PlanBuilder(FloorPlan plan, const PlanOptions& options)
    : plan_(std::move(plan)), options_(options), stated_(std::make_shared<StatedBuilding>()) {
    stated_->schema = plan_.schema;
    stated_->wall_m = plan_.wall_m;
    scene_.materials.emplace_back();
    scene_.report.format = plan_.format;
    wells_.resize(plan_.spaces.size());
    cabins_.resize(plan_.spaces.size());
    lifts_.assign(plan_.spaces.size(), kNoLift);
    vertical_.assign(plan_.spaces.size(), kNoFeature);
    lowest_raise_.assign(plan_.levels.size(), 0.0);
    for (const PlanSpace& space : plan_.spaces)
        if (space.levels.size() == 1)
            lowest_raise_[space.levels[0]] = std::min(lowest_raise_[space.levels[0]], space.raised_m);
}

bool PlanBuilder::too_large() const { return scene_.solids.size() > kMostSolids; }

Result<Scene> PlanBuilder::build(const std::string& file_name) {
    scene_.source_file = file_name;
    scene_.name = plan_.name.empty() ? options_.world_name : plan_.name;
    const auto progress = [&](double fraction) {
        if (options_.progress) options_.progress(fraction);
    };
    for (std::size_t l = 0; l < plan_.levels.size(); ++l)
        if (std::abs(plan_.levels[l].number) < std::abs(plan_.levels[ground_level_].number)) ground_level_ = l;
    if (!plan_.levels.empty()) ground_m_ = plan_.levels[ground_level_].floor_m;
    state_rooms();
    plan_vertical_spaces();
    add_lifts();
    add_platforms();
    std::vector<std::vector<std::size_t>> here(plan_.levels.size());
    for (std::size_t s = 0; s < plan_.spaces.size(); ++s)
        for (const std::size_t level : plan_.spaces[s].levels) here[level].push_back(s);
    for (std::size_t level = 0; level < plan_.levels.size() && !stopped(); ++level) {
        const LevelWalls walls = walls_of_level(plan_, level, here[level]);
        for (const std::size_t s : here[level]) add_floors(s, level);
        add_walls(level, walls);
        add_doors(level, walls);
        add_openings(level, walls);
        progress(0.3 + 0.4 * static_cast<double>(level + 1) / static_cast<double>(plan_.levels.size()));
    }
    for (std::size_t s = 0; s < plan_.spaces.size() && !stopped(); ++s) add_stairs(s);
    add_flights();
    add_things();
    add_ways();
    if (scene_.solids.empty()) return fail(phrase("plan.nothing_to_touch"), file_name);
    add_blocks();
    if (too_large()) return fail(phrase("plan.too_large"), file_name);
    add_ground();
    if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), file_name);
    derive_surfaces(scene_, looks_, kSurfaceUnit_m, options_.stop);
    if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), file_name);
    add_starts();
    write_report();
    scene_.stated = stated_;
    progress(1.0);
    return std::move(scene_);
}

FeatureId PlanBuilder::add_feature(FeatureKind kind, std::string_view made_name, const std::string& name) {
    Feature feature;
    feature.kind = kind;
    feature.name = name.empty() ? std::string(made_name) : name;
    feature.made_name = name.empty();
    scene_.features.push_back(std::move(feature));
    return {static_cast<std::uint32_t>(scene_.features.size() - 1)};
}

MaterialId PlanBuilder::material_named(const std::string& name) {
    const MaterialSpec* spec = name.empty() ? nullptr : find_material(name);
    if (!spec) return kDefaultMaterial;
    Material material;
    material.name = spec->name;
    material.sound = spec->sound;
    return material_id(scene_, material);
}

void PlanBuilder::add_solid(std::optional<ConvexSolid> shape, SolidRole role, FeatureId feature, MaterialId material) {
    if (!shape) return;
    Solid solid;
    solid.role = role;
    solid.feature = feature;
    solid.face_materials.assign(shape->planes.size(), material);
    looks_.emplace_back(shape->planes.size(), material);
    if (feature) scene_.features[feature.value].bounds_m.include(shape->bounds_m);
    if (role == SolidRole::Solid || role == SolidRole::Mover) {
        scene_.bounds_m.include(shape->bounds_m);
        ++scene_.report.brushes;
        scene_.report.polygons += static_cast<int>(shape->faces.size());
    }
    solid.shape = std::move(*shape);
    scene_.solids.push_back(std::move(solid));
}

double PlanBuilder::storey_of(std::size_t level) const {
    for (std::size_t above = level + 1; above < plan_.levels.size(); ++above)
        if (const double rise = plan_.levels[above].floor_m - plan_.levels[level].floor_m;
            rise >= kLeastStorey_m && rise <= kHighestStorey_m)
            return rise;
    return plan_.storey_m;
}

double PlanBuilder::floor_of(std::size_t space, std::size_t level) const {
    const PlanSpace& of = plan_.spaces[space];
    return plan_.levels[level].floor_m + (of.levels.size() == 1 ? of.raised_m : 0.0);
}

double PlanBuilder::highest_raise(const std::vector<std::size_t>& spaces, std::size_t level) const {
    double most = -1e300;
    for (const std::size_t s : spaces)
        if (s < plan_.spaces.size()) most = std::max(most, floor_of(s, level) - plan_.levels[level].floor_m);
    return most < -1e299 ? 0.0 : most;
}

// Returns the lift platforms that go through the floor of a space, or through its ceiling.
std::vector<Ring> PlanBuilder::platforms_in(std::size_t space, std::size_t level, bool ceiling) const {
    std::vector<Ring> rings;
    for (const PlanLift& lift : plan_.lifts) {
        if (level < lift.low || level > lift.high || (ceiling && level == lift.high)) continue;
        if (std::all_of(lift.ring.begin(), lift.ring.end(),
                        [&](const Vec2& p) { return inside(plan_.spaces[space].rings, p); }))
            rings.push_back(lift.ring);
    }
    return rings;
}

// Returns the name of a room. It includes the level if rooms on several levels have the same name: "Toilets F03, level
// 2".
std::string PlanBuilder::room_name(const PlanSpace& space, std::size_t level, bool with_level) const {
    std::string name = space.name.empty() ? space.number : space.name;
    if (!with_level || name.empty()) return name;
    return phrase("plan.on_level", {{"name", name}, {"level", plan_.levels[level].name}});
}

void PlanBuilder::state_rooms() {
    std::map<std::string, std::size_t> first_level;
    std::map<std::string, bool> several;
    for (const PlanSpace& space : plan_.spaces)
        for (const std::size_t level : space.levels) {
            const std::string name = room_name(space, level, false);
            const auto [at, is_new] = first_level.try_emplace(name, level);
            if (!is_new && at->second != level) several[name] = true;
        }
    for (const PlanLevel& level : plan_.levels) stated_->storeys.push_back({level.name, level.floor_m, 0});
    for (std::size_t s = 0; s < plan_.spaces.size(); ++s) {
        const PlanSpace& space = plan_.spaces[s];
        room_of_.emplace_back();
        const std::vector<Ring> parts = convex_parts(space.rings);
        const Ring* largest = nullptr;
        double area_m2 = 0.0;
        for (const Ring& part : parts) {
            area_m2 += signed_area(part);
            if (!largest || signed_area(part) > signed_area(*largest)) largest = &part;
        }
        for (const std::size_t level : space.levels) {
            StatedRoom room;
            room.name = room_name(space, level, several.contains(room_name(space, level, false)));
            room.number = space.number;
            room.guid = space.id;
            room.storey = static_cast<std::uint32_t>(level);
            room.rings = space.rings;
            room.floor_m = floor_of(s, level);
            room.height_m = room_height(s, level);
            room.source.line = space.line;
            room.area_m2 = area_m2;
            room.holds_stairs = space.kind == PlanSpaceKind::Stairs || space.kind == PlanSpaceKind::Escalator;
            if (largest) {
                Vec2 middle{0.0};
                for (const Vec2& p : *largest) middle += p / static_cast<double>(largest->size());
                room.at_m = Vec3(middle, room.floor_m);
            }
            ++stated_->storeys[level].rooms;
            room_of_.back().push_back(static_cast<std::uint32_t>(stated_->rooms.size()));
            stated_->rooms.push_back(std::move(room));
        }
    }
}

// Returns the height from floor to ceiling. It is limited so that the ceiling never extends into the slab above.
double PlanBuilder::room_height(std::size_t s, std::size_t level) const {
    constexpr double kLeast_m = 1.9;
    const PlanSpace& space = plan_.spaces[s];
    const double raised_m = floor_of(s, level) - plan_.levels[level].floor_m;
    const double most_m = storey_of(level) - kSlab_m - kCeiling_m - raised_m;
    return space.height_m ? std::clamp(*space.height_m, std::min(kLeast_m, most_m), most_m) : most_m;
}

StatedPortal PlanBuilder::portal_between(StatedPortalKind kind, const std::string& name, int line, std::uint32_t low,
                                         std::uint32_t high) {
    StatedPortal portal;
    portal.kind = kind;
    portal.name = name;
    portal.source.line = line;
    portal.rooms = {low, high};
    std::erase(portal.rooms, kNotStated);
    std::sort(portal.rooms.begin(), portal.rooms.end());
    portal.by_boundaries = true;
    return portal;
}

std::uint32_t PlanBuilder::room_at(std::size_t space, std::size_t level) const {
    if (space >= plan_.spaces.size()) return kNotStated;
    const std::vector<std::size_t>& levels = plan_.spaces[space].levels;
    const auto at = std::find(levels.begin(), levels.end(), level);
    return at == levels.end() ? kNotStated : room_of_[space][static_cast<std::size_t>(at - levels.begin())];
}

std::vector<std::uint32_t> PlanBuilder::rooms_at(const std::vector<std::size_t>& spaces, std::size_t level) const {
    std::vector<std::uint32_t> rooms;
    for (const std::size_t s : spaces)
        if (const std::uint32_t room = room_at(s, level); room != kNotStated) rooms.push_back(room);
    std::sort(rooms.begin(), rooms.end());
    return rooms;
}

// Adds the floor and the ceiling of a room. A space with stairs or a lift gets a floor on each level, but a ceiling
// only on the highest.
void PlanBuilder::add_floors(std::size_t s, std::size_t level) {
    const PlanSpace& space = plan_.spaces[s];
    const double floor_m = floor_of(s, level), ceiling_m = floor_m + room_height(s, level) + kCeiling_m;
    // The slab extends down to the lowest floor next to it, so that no gap is left at a step.
    const double under_m = std::min(floor_m, plan_.levels[level].floor_m + lowest_raise_[level]) - kSlab_m;
    const MaterialId ground = material_named(space.floor_material);
    std::vector<Ring> rings = space.rings;
    const bool lowest = level == space.levels.front(), highest = level == space.levels.back();
    if (wells_[s] && !lowest)
        rings.push_back(wells_[s]->box(0.0, wells_[s]->length_m, -0.5 * wells_[s]->width_m, 0.5 * wells_[s]->width_m));
    if (!cabins_[s].empty()) rings.push_back(cabins_[s]);
    for (Ring& hole : platforms_in(s, level, false)) rings.push_back(std::move(hole));
    for (const Ring& part : without_flights(convex_parts(rings), level, false))
        add_solid(upright(part, under_m, floor_m), SolidRole::Solid, kNoFeature, ground);
    const std::vector<Ring> parts = convex_parts(space.rings);
    std::vector<Ring> above = space.rings;
    for (Ring& hole : platforms_in(s, level, true)) above.push_back(std::move(hole));
    if (highest || (!wells_[s] && cabins_[s].empty()))
        for (const Ring& part : without_flights(convex_parts(above), level, true))
            add_solid(upright(part, ceiling_m - kCeiling_m, ceiling_m), SolidRole::Solid, kNoFeature);
    add_facts(parts, floor_m, space.facts);
}

// Adds the facts about a room as a message that is announced when the person enters the room.
void PlanBuilder::add_facts(const std::vector<Ring>& parts, double floor_m, const std::vector<std::string>& facts) {
    if (facts.empty() || parts.empty()) return;
    const FeatureId feature = add_feature(FeatureKind::Trigger, "about this place", {});
    std::string& message = scene_.features[feature.value].message;
    for (const std::string& fact : facts) message += (message.empty() ? "" : " ") + fact;
    for (const Ring& part : parts) add_solid(upright(part, floor_m, floor_m + kFacts_m), SolidRole::Trigger, feature);
}

void PlanBuilder::add_walls(std::size_t level, const LevelWalls& walls) {
    const double floor_m = plan_.levels[level].floor_m, top_m = floor_m + storey_of(level),
                 under_m = floor_m + lowest_raise_[level];
    const MaterialId material = material_named(plan_.wall_material);
    for (const WallRun& run : walls.runs) {
        const double length = glm::length(run.to - run.from);
        if (length < 1e-3) continue;
        const Vec2 along = (run.to - run.from) / length;
        const auto piece = [&](double from, double to, double from_m, double to_m) {
            if (to - from < 1e-3) return;
            const Ring whole = strip(run.from + along * from, run.from + along * to, 0.5 * plan_.wall_m);
            for (const Ring& part : without_flight_gaps(whole, level))
                add_solid(upright(part, from_m, to_m), SolidRole::Solid, kNoFeature, material);
        };
        double from = -0.5 * plan_.wall_m;
        for (const WallRun::Gap& gap : run.gaps) {
            piece(from, gap.from_m, under_m, top_m);
            const double sill_m = floor_m + gap.sill_m;
            if (sill_m > under_m + 1e-6) piece(gap.from_m, gap.to_m, under_m, sill_m);
            piece(gap.from_m, gap.to_m, sill_m + gap.height_m, top_m);
            from = gap.to_m;
        }
        piece(from, length + 0.5 * plan_.wall_m, under_m, top_m);
    }
}

void PlanBuilder::add_openings(std::size_t level, const LevelWalls& walls) {
    for (const auto& [pair, open] : walls.open) {
        StatedPortal portal;
        portal.kind = StatedPortalKind::Opening;
        portal.rooms = rooms_at({pair.first, pair.second}, level);
        portal.place_m = Vec3(open.at, plan_.levels[level].floor_m + highest_raise({pair.first, pair.second}, level));
        portal.width_m = open.width_m;
        portal.height_m = storey_of(level);
        portal.by_boundaries = true;
        stated_->portals.push_back(std::move(portal));
    }
}

void PlanBuilder::add_things() {
    for (const PlanThing& thing : plan_.things) {
        if (stopped()) return;
        const FeatureId feature = add_feature(FeatureKind::Object, thing.made_name ? thing.name : "object",
                                              thing.made_name ? std::string() : thing.name);
        scene_.features[feature.value].message = thing.message;
        scene_.features[feature.value].landmark = thing.landmark;
        scene_.features[feature.value].clue = thing.clue;
        scene_.features[feature.value].source.line = thing.line;
        const MaterialId material = material_named(thing.material);
        scene_.features[feature.value].material = material;
        const double floor_m = plan_.levels[thing.level].floor_m + thing.from_m;
        const double top_m =
            thing.kind == PlanThingKind::Pillar ? floor_m + storey_of(thing.level) : floor_m + thing.height_m;
        for (const Ring& part : thing.parts)
            add_solid(upright(part, floor_m, top_m), SolidRole::Solid, feature, material);
        const StatedThing stated{feature, scene_.features[feature.value].bounds_m};
        if (thing.window) stated_->windows.push_back(stated);
        else if (thing.kind == PlanThingKind::Object && !thing.fixture) stated_->furnishings.push_back(stated);
    }
}

void PlanBuilder::add_blocks() {
    for (const PlanBlock& block : plan_.blocks) {
        if (stopped()) return;
        const FeatureId feature = add_feature(FeatureKind::Object, kNeighbouringBuilding, block.name);
        for (const Ring& part : convex_parts(block.rings))
            add_solid(upright(part, block.from_m, block.to_m), SolidRole::Solid, feature);
    }
}

// Adds ground around the building. Plans end at the outer walls, but a walker who steps outside needs ground.
void PlanBuilder::add_ground() {
    const double level_m = ground_m_ - kUnderThreshold_m;
    const Vec2 least = Vec2(scene_.bounds_m.min_m) - kGroundAround_m,
               most = Vec2(scene_.bounds_m.max_m) + kGroundAround_m;
    std::vector<Ring> ground{{least, {most.x, least.y}, most, {least.x, most.y}}};
    const auto cut = [&](const Ring& cutter) {
        std::vector<Ring> kept;
        for (const Ring& ring : ground)
            for (Ring& left : without(ring, cutter)) kept.push_back(std::move(left));
        ground = std::move(kept);
    };
    // Cuts holes into the ground above stairs and lifts that come up from below, and above spaces that are partly below
    // the ground.
    for (std::size_t s = 0; s < plan_.spaces.size(); ++s) {
        const PlanSpace& space = plan_.spaces[s];
        const double lowest_m = floor_of(s, space.levels.front()),
                     highest_m = plan_.levels[space.levels.back()].floor_m + plan_.storey_m - kSlab_m;
        const bool sunk = space.raised_m < 0.0 && lowest_m < level_m;
        if ((lowest_m > level_m - kSlab_m && !sunk) || highest_m < level_m - kSlab_m) continue;
        for (const Ring& part : convex_parts(space.rings)) cut(part);
    }
    for (const PlanFlight& flight : plan_.flights)
        if (floor_of(flight.from, flight.low) < level_m - kSlab_m &&
            floor_of(flight.to, flight.high) > level_m - kSlab_m)
            cut({flight.least, {flight.most.x, flight.least.y}, flight.most, {flight.least.x, flight.most.y}});
    for (const PlanWay& way : plan_.ways)
        for (std::size_t i = 1; i < way.line.size(); ++i) {
            const double low_m = std::min(way.floor_m[i - 1], way.floor_m[i]),
                         high_m = std::max(way.floor_m[i - 1], way.floor_m[i]);
            if (low_m < level_m - kSlab_m && high_m > level_m - kFacts_m && ground.size() < 20'000)
                cut(strip(way.line[i - 1], way.line[i], 0.5 * way.width_m));
        }
    const Aabb building = scene_.bounds_m;
    const FeatureId feature = add_feature(FeatureKind::Object, kOuterGround, {});
    for (const Ring& part : ground) add_solid(upright(part, level_m - kSlab_m, level_m), SolidRole::Solid, feature);
    scene_.bounds_m = building;
    scene_.bounds_m.include(scene_.features[feature.value].bounds_m);
}

// Adds a start in front of each door that leads outside, facing the door, main entrances first. If there are no such
// doors, the start is in the largest room at ground level.
void PlanBuilder::add_starts() {
    for (const PlanStart& start : plan_.starts) {
        const double floor_m = plan_.levels[start.level].floor_m + start.raised_m;
        scene_.starts.push_back({Vec3(start.at, floor_m), start.heading_rad, false, start.name, {start.line, 0}});
    }
    std::stable_sort(outer_.begin(), outer_.end(),
                     [](const OuterDoor& a, const OuterDoor& b) { return a.entrance < b.entrance; });
    for (const OuterDoor& door : outer_) {
        Start start;
        start.feet_m = door.at_m + Vec3(door.out * kOutsideDoor_m, 0.0);
        start.heading_rad = std::atan2(-door.out.x, -door.out.y);
        start.name = door.name;
        scene_.starts.push_back(std::move(start));
    }
    if (scene_.starts.empty() && !stated_->rooms.empty()) {
        const StatedRoom* best = nullptr;
        for (const StatedRoom& room : stated_->rooms)
            if (!best || std::abs(room.floor_m - ground_m_) < std::abs(best->floor_m - ground_m_) - kNearGround_m ||
                (std::abs(room.floor_m - ground_m_) < std::abs(best->floor_m - ground_m_) + kNearGround_m &&
                 room.area_m2 > best->area_m2))
                best = &room;
        scene_.starts.push_back({best->at_m, 0.0, false, best->name, {}});
    }
    if (scene_.starts.empty() && !plan_.ways.empty()) {
        const PlanWay* best = &plan_.ways.front();
        for (const PlanWay& way : plan_.ways)
            if (std::abs(way.floor_m.front() - ground_m_) < std::abs(best->floor_m.front() - ground_m_)) best = &way;
        const Vec2 ahead = best->line[1] - best->line[0];
        scene_.starts.push_back(
            {Vec3(best->line[0], best->floor_m[0]), std::atan2(ahead.x, ahead.y), false, best->name, {}});
    }
    if (!scene_.starts.empty()) scene_.starts.front().base = true;
}

void PlanBuilder::warn(std::string message, std::string action) {
    constexpr std::size_t kMostKept = 20;
    if (++scene_.report.warnings_in_all <= static_cast<int>(kMostKept))
        scene_.report.warnings.push_back(
            {Severity::Warning, scene_.source_file, 0, 0, std::move(message), std::move(action)});
}

void PlanBuilder::write_report() {
    ReadReport& report = scene_.report;
    report.polygons_kept = report.polygons - report.polygons_hidden;
    report.movers = static_cast<int>(scene_.movers.size());
    report.starts = static_cast<int>(scene_.starts.size());
    report.guessed = plan_.guessed;
    report.simplified = plan_.simplified;
    report.left_out = plan_.left_out;
    const auto add_count = [](std::vector<std::string>& list, std::string_view key, int count) {
        if (count > 0) list.push_back(phrase(key, {{"n", count}}));
    };
    if (!plan_.spaces.empty() && !plan_.measures_known) {
        report.guessed.push_back(phrase("plan.guessed_heights", {{"height", plan_.storey_m}}));
        report.guessed.push_back(phrase("plan.guessed_walls", {{"thick", 100.0 * plan_.wall_m}}));
    }
    add_count(report.guessed, "plan.guessed_widths", guessed_widths_);
    add_count(report.guessed, "plan.guessed_stairs",
              static_cast<int>(
                  std::count_if(wells_.begin(), wells_.end(), [](const auto& well) { return well.has_value(); })));
    if (widened_ > 0)
        report.simplified.push_back(phrase("plan.widened", {{"n", widened_}, {"least", 100.0 * kLeastWay_m}}));
    add_count(report.simplified, "plan.moved_doors", moved_);
    add_count(report.simplified, "plan.revolving", revolving_);
    add_count(report.left_out, "plan.to_nowhere", to_nowhere_);
    add_count(report.left_out, "plan.off_walls", off_walls_);
    add_count(report.left_out, "plan.narrow", narrow_);
    add_count(report.left_out, "plan.no_stairs", no_stairs_);
    int alone = 0;
    std::string names;
    std::vector<bool> led_to(stated_->rooms.size(), false);
    for (const StatedPortal& portal : stated_->portals)
        for (const std::uint32_t room : portal.rooms) led_to[room] = true;
    // A way has no walls, so it is not reported as closed, even if the file connects it to nothing.
    for (std::uint32_t r = 0; r < led_to.size(); ++r)
        if (!led_to[r] && !stated_->rooms[r].is_way && ++alone <= 3)
            names += (alone > 1 ? ", " : "") + one_line(stated_->rooms[r].name);
    if (alone > 0)
        warn(phrase("plan.without_doors", {{"n", alone}, {"names", names}, {"more", std::max(0, alone - 3)}}),
             phrase("plan.then_closed"));
    for (auto& [message, action] : plan_.warnings) warn(std::move(message), std::move(action));
}

Result<Scene> scene_of_plan(FloorPlan plan, const std::string& file_name, const PlanOptions& options) {
    return PlanBuilder(std::move(plan), options).build(file_name);
}

}  // namespace handrail::floorplan
