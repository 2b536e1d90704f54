// Adds the free-standing walls and pillars, the objects, and the other buildings of an OpenStreetMap file.
#include <algorithm>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/floorplan/upright.h"
#include "worlds/osm/osm_levels.h"
#include "worlds/osm/osm_plan.h"
#include "worlds/osm/osm_words.h"

namespace handrail::osm {
namespace {

constexpr double kThing_m = 0.5, kPillar_m = 0.4, kStrip_m = 0.3, kStripHigh_m = 0.01, kNearBuilding_m = 40.0;
constexpr double kBlockStorey_m = 3.0, kBlock_m = 6.0;
constexpr double kMostSide_m = 2'000.0;
constexpr std::size_t kMostThings = 20'000;

Ring square(const Vec2& at, double side_m) {
    const double half = 0.5 * side_m;
    return {at + Vec2(-half, -half), at + Vec2(half, -half), at + Vec2(half, half), at + Vec2(-half, half)};
}

// Returns the kind of an object that mappers draw as an outline: a column, a desk or a bench. Empty for anything else.
std::string_view drawn_thing(const OsmTags& tags) {
    if (tags.is("indoor", "column") || tags.is("indoor", "pillar") || tags.is("wall:type", "pillar") ||
        tags.is("building", "pillar") || tags.is("building", "column") || tags.is("buildingpart", "column"))
        return "pillar";
    for (const std::string_view key : {"indoor", "amenity", "furniture", "room"})
        for (const std::string_view value : {"bench", "desk", "table", "counter", "furniture"})
            if (tags.is(key, value)) return key == "indoor" && tags.has("furniture") ? tags["furniture"] : value;
    return tags["furniture"];
}

}  // namespace

std::vector<std::size_t> OsmPlan::levels_here(std::string_view level_text, const OsmTags& tags) const {
    std::vector<std::size_t> here;
    OsmLevels levels = levels_of(level_text, tags["repeat_on"]);
    if (levels.levels.empty()) levels.levels.push_back(0.0);
    for (const double number : levels.levels)
        if (const std::size_t level = level_at(number); level != kNone) here.push_back(level);
    return here;
}

void OsmPlan::add_walls_and_things() {
    if (plan_.spaces.empty()) return;
    for (const OsmWay& way : data_.ways) add_drawn(way);
    for (const std::int64_t n : data_.tagged_nodes) add_thing_at(n);
}

// Adds walls, tactile guidance and objects that are drawn as lines or outlines.
void OsmPlan::add_drawn(const OsmWay& way) {
    const bool wall = way.tags.is("indoor", "wall") || way.tags.is("buildingpart", "wall"),
               guidance = way.tags.is("tactile_paving", "yes") && !way.tags.has("highway") && !is_walked(way.tags) &&
                          (way.tags.is("indoor", "yes") || way.tags.has("level")) && !way.closed(),
               artwork = way.tags.is("indoor", "yes") && way.tags.has("tourism") && way.closed();
    const std::string_view drawn = way.closed() && !wall ? drawn_thing(way.tags) : std::string_view();
    if (!(wall || guidance || artwork || !drawn.empty()) || !all_known(way.nodes) || plan_.things.size() > kMostThings)
        return;
    const Ring line = placed({way.nodes})[0];
    if (std::any_of(line.begin(), line.end(), [](const Vec2& p) { return glm::length(p) > kMostSide_m; })) return;
    for (const std::size_t level : levels_here(data_.level_of(way), way.tags)) {
        if (wall) {
            for (std::size_t i = 1; i < line.size(); ++i) plan_.walls.push_back({line[i - 1], line[i], level});
            continue;
        }
        floorplan::PlanThing thing;
        thing.level = level;
        if (guidance) {
            thing.kind = floorplan::PlanThingKind::Guidance;
            thing.name = "tactile paving";
            thing.made_name = true;
            thing.height_m = kStripHigh_m;
            for (std::size_t i = 1; i < line.size(); ++i)
                thing.parts.push_back(floorplan::strip(line[i - 1], line[i], 0.5 * kStrip_m));
        } else if (drawn == "pillar") {
            thing.kind = floorplan::PlanThingKind::Pillar;
            thing.name = "pillar";
            thing.made_name = true;
            thing.parts = convex_parts({line});
        } else {
            name_thing(thing, way.tags, drawn.empty() ? way.tags["tourism"] : drawn);
            thing.parts = convex_parts({line});
        }
        plan_.things.push_back(std::move(thing));
    }
}

// Sets the name of the object: its own name, or else the name of its kind.
void OsmPlan::name_thing(floorplan::PlanThing& thing, const OsmTags& tags, std::string_view what) const {
    thing.name = in_spoken(tags, "name");
    if (thing.name.empty()) thing.name = capitalised(kind_words(what));
    for (const std::string& fact : facts_of(tags)) thing.message += (thing.message.empty() ? "" : " ") + fact;
}

// Adds pillars and objects that are mapped only as a point.
void OsmPlan::add_thing_at(std::int64_t node) {
    const OsmTags& tags = data_.nodes.at(node).tags;
    const bool pillar = tags.is("wall:type", "pillar") || tags.is("indoor", "pillar") || tags.is("indoor", "column") ||
                        tags.is("building", "pillar");
    std::string_view what = tags["tourism"];
    if (tags.has("information")) what = tags["information"];
    if (tags.has("amenity")) what = tags["amenity"];
    const bool indoors = tags.has("level") || tags.is("indoor", "yes");
    if (!(pillar || (!what.empty() && indoors)) || plan_.things.size() > kMostThings) return;
    const Vec2 at = place_of(node);
    if (glm::length(at) > kMostSide_m) return;
    for (const std::size_t level : levels_here(tags["level"], tags)) {
        floorplan::PlanThing thing;
        thing.level = level;
        name_thing(thing, tags, what);
        if (pillar) {
            thing.kind = floorplan::PlanThingKind::Pillar;
            thing.name = "pillar";
            thing.made_name = true;
        }
        thing.parts = {square(at, pillar ? kPillar_m : kThing_m)};
        plan_.things.push_back(std::move(thing));
    }
}

// Adds other buildings nearby, and parts of them, as blocks. Blocks over rooms or ways that were read are left out,
// because the rooms have their own walls.
void OsmPlan::add_blocks() {
    Vec2 least{1e300}, most{-1e300};
    for (const floorplan::PlanSpace& space : plan_.spaces)
        for (const Ring& ring : space.rings)
            for (const Vec2& p : ring) least = glm::min(least, p), most = glm::max(most, p);
    for (const floorplan::PlanWay& way : plan_.ways)
        for (const Vec2& p : way.line) least = glm::min(least, p), most = glm::max(most, p);
    int over_rooms = 0;
    const auto take = [&](const OsmTags& tags, const std::vector<std::vector<std::int64_t>>& rings) {
        floorplan::PlanBlock block;
        block.rings = placed(rings);
        Vec2 low{1e300}, high{-1e300};
        for (const Ring& ring : block.rings)
            for (const Vec2& p : ring) low = glm::min(low, p), high = glm::max(high, p);
        const Vec2 off = glm::max(low - most, least - high);
        if (std::max(off.x, off.y) > kNearBuilding_m || block.rings.empty()) return;
        const bool holds_rooms =
            std::any_of(plan_.spaces.begin(), plan_.spaces.end(), [&](const floorplan::PlanSpace& space) {
                Vec2 middle{0.0};
                for (const Vec2& p : space.rings[0]) middle += p / static_cast<double>(space.rings[0].size());
                return inside(block.rings, middle) || inside(space.rings, 0.5 * (low + high));
            });
        const bool over_ways = std::any_of(plan_.ways.begin(), plan_.ways.end(), [&](const floorplan::PlanWay& way) {
            return std::any_of(way.line.begin(), way.line.end(), [&](const Vec2& p) { return inside(block.rings, p); });
        });
        if (holds_rooms || over_ways) {
            ++over_rooms;
            return;
        }
        const double height_m = number_in(tags["height"]), levels = number_in(tags["building:levels"]);
        block.name = in_spoken(tags, "name");
        block.from_m = std::min(number_in(tags["min_height"]), 500.0);
        block.to_m = std::min(height_m > 0.0 ? height_m : levels > 0.0 ? levels * kBlockStorey_m : kBlock_m, 800.0);
        if (block.to_m > block.from_m + 0.1) plan_.blocks.push_back(std::move(block));
    };
    for (const OsmWay& way : data_.ways)
        if (way.closed() && (way.tags.has("building") || way.tags.has("building:part")) && all_known(way.nodes) &&
            plan_.blocks.size() < kMostThings)
            take(way.tags, {{way.nodes.begin(), way.nodes.end() - 1}});
    if (over_rooms > 0) plan_.simplified.push_back(phrase("osm.own_walls", {{"n", over_rooms}}));
    if (!plan_.blocks.empty()) plan_.simplified.push_back(phrase("osm.blocks", {{"n", plan_.blocks.size()}}));
}

}  // namespace handrail::osm
