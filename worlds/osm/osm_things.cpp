// Walls and pillars by themselves, things, ways outside rooms, and other buildings of an OpenStreetMap file.
#include <algorithm>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/drawn/upright.h"
#include "worlds/osm/osm_levels.h"
#include "worlds/osm/osm_plan.h"
#include "worlds/osm/osm_words.h"

namespace handrail {
namespace {

constexpr double kThing_m = 0.5, kPillar_m = 0.4, kStrip_m = 0.3, kStripHigh_m = 0.01, kNearBuilding_m = 40.0;
constexpr double kWay_m = 2.0, kSteps_m = 1.6, kMostWay_m = 20.0, kBlockStorey_m = 3.0, kBlock_m = 6.0;
constexpr double kMostSide_m = 2'000.0;
constexpr std::size_t kMostThings = 20'000;

double number_of(std::string_view text) {
    double value = 0.0;
    return parse_finite(text.substr(0, text.find_first_not_of("0123456789.")), value) ? value : 0.0;
}

Ring square(const Vec2& at, double side_m) {
    const double half = 0.5 * side_m;
    return {at + Vec2(-half, -half), at + Vec2(half, -half), at + Vec2(half, half), at + Vec2(-half, half)};
}

// On foot.
bool is_walked(const OsmTags& tags) {
    const std::string_view highway = tags["highway"];
    if (tags.is("access", "private") || tags.is("access", "no") || tags.is("foot", "no")) return false;
    return highway == "footway" || highway == "steps" || highway == "corridor" || highway == "pedestrian" ||
           highway == "path" || highway == "platform" || tags.is("railway", "platform");
}

}  // namespace

void OsmPlan::add_walls_and_things() {
    const auto levels_here = [&](const OsmTags& tags) {
        std::vector<std::size_t> here;
        OsmLevels levels = levels_of(tags["level"], tags["repeat_on"]);
        if (levels.levels.empty()) levels.levels.push_back(0.0);
        for (const double number : levels.levels)
            if (const std::size_t level = level_at(number); level != kNone) here.push_back(level);
        return here;
    };
    if (plan_.spaces.empty()) return;
    for (const OsmWay& way : data_.ways) {
        const bool wall = way.tags.is("indoor", "wall") || way.tags.is("buildingpart", "wall"),
                   guidance = way.tags.is("tactile_paving", "yes") && !way.tags.has("highway") &&
                              !is_walked(way.tags) && (way.tags.is("indoor", "yes") || way.tags.has("level")) &&
                              !way.closed(),
                   artwork = way.tags.is("indoor", "yes") && way.tags.has("tourism") && way.closed();
        if (!(wall || guidance || artwork) || !all_known(way.nodes) || plan_.things.size() > kMostThings) continue;
        const Ring line = placed({way.nodes})[0];
        if (std::any_of(line.begin(), line.end(), [](const Vec2& p) { return glm::length(p) > kMostSide_m; })) continue;
        for (const std::size_t level : levels_here(way.tags)) {
            if (wall) {
                for (std::size_t i = 1; i < line.size(); ++i) plan_.walls.push_back({line[i - 1], line[i], level});
                continue;
            }
            PlanThing thing;
            thing.level = level;
            if (guidance) {
                thing.kind = PlanThingKind::Guidance;
                thing.name = "tactile paving";
                thing.made_name = true;
                thing.height_m = kStripHigh_m;
                for (std::size_t i = 1; i < line.size(); ++i)
                    thing.parts.push_back(strip(line[i - 1], line[i], 0.5 * kStrip_m));
            } else {
                thing.name = in_spoken(way.tags, "name");
                if (thing.name.empty()) thing.name = kind_words(way.tags["tourism"]);
                for (const std::string& fact : facts_of(way.tags))
                    thing.message += (thing.message.empty() ? "" : " ") + fact;
                thing.parts = convex_parts({line});
            }
            plan_.things.push_back(std::move(thing));
        }
    }
    for (const std::int64_t n : data_.tagged_nodes) {
        const OsmTags& tags = data_.nodes.at(n).tags;
        const bool pillar = tags.is("wall:type", "pillar") || tags.is("indoor", "pillar") ||
                            tags.is("indoor", "column") || tags.is("building", "pillar");
        const std::string_view what = tags.has("amenity")       ? tags["amenity"]
                                      : tags.has("information") ? tags["information"]
                                      : tags.has("tourism")     ? tags["tourism"]
                                                                : std::string_view();
        const bool indoors = tags.has("level") || tags.is("indoor", "yes");
        if (!(pillar || (!what.empty() && indoors)) || plan_.things.size() > kMostThings) continue;
        const Vec2 at = place_of(n);
        if (glm::length(at) > kMostSide_m) continue;
        for (const std::size_t level : levels_here(tags)) {
            PlanThing thing;
            thing.level = level;
            thing.kind = pillar ? PlanThingKind::Pillar : PlanThingKind::Object;
            thing.made_name = pillar;
            thing.name = pillar ? "pillar" : std::string(in_spoken(tags, "name"));
            if (thing.name.empty()) thing.name = capitalised(kind_words(what));
            for (const std::string& fact : facts_of(tags)) thing.message += (thing.message.empty() ? "" : " ") + fact;
            thing.parts = {square(at, pillar ? kPillar_m : kThing_m)};
            plan_.things.push_back(std::move(thing));
        }
    }
}

// Lines that one walks along: each at its level, and from level to level where their ends say so.
void OsmPlan::add_ways() {
    const auto level_of = [](const OsmTags& tags) {
        const OsmLevels levels = levels_of(tags.has("level") ? tags["level"] : tags["layer"]);
        return levels.levels.empty() ? std::vector<double>{0.0} : levels.levels;
    };
    std::unordered_map<std::int64_t, double> height;  // of the ends that level ways have; looked up only
    std::vector<const OsmWay*> walked;
    int cut_ways = 0;
    for (const OsmWay& way : data_.ways) {
        if (!is_walked(way.tags)) continue;
        if (way.nodes.size() < 2 || !all_known(way.nodes)) {
            ++cut_ways;
            continue;
        }
        const Ring line = placed({way.nodes})[0];
        if (std::any_of(line.begin(), line.end(), [](const Vec2& p) { return glm::length(p) > kMostSide_m; })) continue;
        walked.push_back(&way);
        if (way.tags.is("highway", "steps")) continue;
        const double floor_m = level_of(way.tags).front() * plan_.storey_m;
        for (const std::int64_t n : way.nodes) {
            const auto [at, is_new] = height.try_emplace(n, floor_m);
            if (!is_new && std::abs(floor_m) < std::abs(at->second)) at->second = floor_m;
        }
    }
    for (const OsmWay* way : walked) {
        const std::vector<double> levels = level_of(way->tags);
        const bool steps = way->tags.is("highway", "steps");
        PlanWay made;
        made.steps = steps;
        made.escalator = steps && way->tags.has("conveying") && !way->tags.is("conveying", "no");
        made.id = phrase("osm.way", {{"id", std::to_string(way->id)}});
        made.name = in_spoken(way->tags, "name");
        if (made.name.empty()) made.name = way->tags["ref"];
        const std::string_view highway = way->tags["highway"];
        if (made.name.empty())
            made.name = capitalised(kind_words(made.escalator ? "escalator" : highway.empty() ? "platform" : highway));
        made.area = !steps && way->closed() && (way->tags.is("area", "yes") || way->tags.is("railway", "platform"));
        made.facts = facts_of(way->tags);
        const double stated_m = number_of(way->tags["width"]);
        made.width_m = std::clamp(stated_m > 0.0 ? stated_m : steps ? kSteps_m : kWay_m, 0.8, kMostWay_m);
        made.line = placed({way->nodes})[0];
        double low_m = levels.front() * plan_.storey_m, high_m = levels.back() * plan_.storey_m;
        if (steps) {
            // Its ends say how high they are where other ways meet them, else its levels do.
            const bool down = way->tags.is("incline", "down");
            double first_m = down ? high_m : low_m, last_m = down ? low_m : high_m;
            if (const auto at = height.find(way->nodes.front()); at != height.end()) first_m = at->second;
            if (const auto at = height.find(way->nodes.back()); at != height.end()) last_m = at->second;
            double all = 0.0, gone = 0.0;
            for (std::size_t i = 1; i < made.line.size(); ++i) all += glm::length(made.line[i] - made.line[i - 1]);
            for (std::size_t i = 0; i < made.line.size(); ++i) {
                if (i > 0) gone += glm::length(made.line[i] - made.line[i - 1]);
                made.floor_m.push_back(first_m + (last_m - first_m) * (all > 0.0 ? gone / all : 0.0));
            }
        } else {
            for (const std::int64_t n : way->nodes) made.floor_m.push_back(made.area ? low_m : height.at(n));
        }
        if (made.area) made.line.pop_back();
        plan_.ways.push_back(std::move(made));
    }
    if (cut_ways > 0) plan_.left_out.push_back(phrase("osm.cut_ways", {{"n", cut_ways}}));
    if (!plan_.ways.empty()) {
        plan_.guessed.push_back(phrase("osm.along_ways", {{"n", plan_.ways.size()}}));
        // Levels that only ways have.
        for (const PlanWay& way : plan_.ways)
            for (const double floor_m : way.floor_m) {
                const double number = std::round(floor_m / plan_.storey_m);
                if (!way.steps && std::abs(number * plan_.storey_m - floor_m) < 1e-6 && plan_.spaces.empty() &&
                    level_at(number) == kNone)
                    plan_.levels.push_back({number, phrase("plan.level", {{"number", number}}), floor_m});
            }
        if (plan_.spaces.empty())
            std::sort(plan_.levels.begin(), plan_.levels.end(),
                      [](const PlanLevel& a, const PlanLevel& b) { return a.number < b.number; });
    }
}

// Other buildings near by, and parts of them, as blocks; what stands over rooms that were read has its own walls.
void OsmPlan::add_blocks() {
    Vec2 least{1e300}, most{-1e300};
    for (const PlanSpace& space : plan_.spaces)
        for (const Ring& ring : space.rings)
            for (const Vec2& p : ring) least = glm::min(least, p), most = glm::max(most, p);
    for (const PlanWay& way : plan_.ways)
        for (const Vec2& p : way.line) least = glm::min(least, p), most = glm::max(most, p);
    int over_rooms = 0;
    const auto take = [&](const OsmTags& tags, const std::vector<std::vector<std::int64_t>>& rings) {
        PlanBlock block;
        block.rings = placed(rings);
        Vec2 low{1e300}, high{-1e300};
        for (const Ring& ring : block.rings)
            for (const Vec2& p : ring) low = glm::min(low, p), high = glm::max(high, p);
        const Vec2 off = glm::max(low - most, least - high);
        if (std::max(off.x, off.y) > kNearBuilding_m || block.rings.empty()) return;
        const bool holds_rooms = std::any_of(plan_.spaces.begin(), plan_.spaces.end(), [&](const PlanSpace& space) {
            Vec2 middle{0.0};
            for (const Vec2& p : space.rings[0]) middle += p / static_cast<double>(space.rings[0].size());
            return inside(block.rings, middle) || inside(space.rings, 0.5 * (low + high));
        });
        const bool over_ways = std::any_of(plan_.ways.begin(), plan_.ways.end(), [&](const PlanWay& way) {
            return std::any_of(way.line.begin(), way.line.end(), [&](const Vec2& p) { return inside(block.rings, p); });
        });
        if (holds_rooms || over_ways) {
            ++over_rooms;
            return;
        }
        const double height_m = number_of(tags["height"]), levels = number_of(tags["building:levels"]);
        block.name = in_spoken(tags, "name");
        block.from_m = std::min(number_of(tags["min_height"]), 500.0);
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

}  // namespace handrail
