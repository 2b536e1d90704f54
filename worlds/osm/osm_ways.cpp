// Ways, platforms and stairs outside rooms of an OpenStreetMap file.
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/drawn/upright.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"
#include "worlds/osm/osm_levels.h"
#include "worlds/osm/osm_plan.h"
#include "worlds/osm/osm_words.h"

namespace handrail {
namespace {

constexpr double kWay_m = 2.0, kSteps_m = 1.6, kMostWay_m = 20.0, kFarthestWay_m = 2'000.0, kSameFloor_m = 0.3,
                 kBeside_m = 0.3, kSurroundings_m = 100.0, kLook_m = 10.0;

bool is_escalator(const OsmTags& tags) {
    return tags.is("highway", "steps") && tags.has("conveying") && !tags.is("conveying", "no");
}

// What the way is, in words: "Footway".
std::string kind_of_way(const OsmTags& tags) {
    const std::string_view highway = tags["highway"];
    const bool plain = is_platform(tags) || highway.empty() || highway == "no";
    return capitalised(kind_words(is_escalator(tags) ? "escalator" : plain ? "platform" : highway));
}

// As the file names it; empty: it does not.
std::string own_name(const OsmTags& tags) {
    std::string name(in_spoken(tags, "name")), ref(tags["ref"]);
    if (!is_platform(tags)) return name.empty() ? ref : name;
    if (ref.empty()) ref = tags["local_ref"];
    if (name.empty()) return ref.empty() ? ref : kind_of_way(tags) + " " + ref;
    return ref.empty() || name.find(ref) != std::string::npos ? name : name + " " + ref;
}

}  // namespace

std::vector<double> OsmPlan::Walked::levels() const {
    OsmLevels found = levels_of(tags->has("level") ? (*tags)["level"] : (*tags)["layer"]);
    if (found.levels.empty()) found.levels.push_back(0.0);
    return std::move(found.levels);
}

bool OsmPlan::is_lift_node(std::int64_t node) const {
    const auto found = data_.nodes.find(node);
    return found != data_.nodes.end() && found->second.tags.is("highway", "elevator");
}

namespace {

// Answers whether places are near any of these outlines.
class Surroundings {
public:
    explicit Surroundings(const std::vector<Ring>& rings) : rings_(rings), index_(boxes_of(rings)) {}

    // True if one of the lines comes near.
    bool hold_one_of(const std::vector<Ring>& lines) const {
        for (const Ring& line : lines)
            for (std::size_t i = 0; i < line.size(); ++i) {
                if (is_near(line[i])) return true;
                if (i == 0) continue;
                const double length_m = glm::length(line[i] - line[i - 1]);
                for (double at_m = kLook_m; at_m < length_m; at_m += kLook_m)
                    if (is_near(line[i - 1] + (line[i] - line[i - 1]) * (at_m / length_m))) return true;
            }
        return false;
    }

private:
    static std::vector<Aabb> boxes_of(const std::vector<Ring>& rings) {
        std::vector<Aabb> boxes;
        for (const Ring& ring : rings) {
            Aabb box;
            for (const Vec2& p : ring) box.include(Vec3(p, 0.0));
            boxes.push_back(grown(box, kSurroundings_m));
        }
        return boxes;
    }
    bool is_near(const Vec2& at) const {
        std::vector<std::uint32_t> found;
        index_.find({Vec3(at, 0.0), Vec3(at, 0.0)}, found);
        return std::any_of(found.begin(), found.end(), [&](std::uint32_t r) {
            return inside({rings_[r]}, at) || distance_to_outline({rings_[r]}, at) <= kSurroundings_m;
        });
    }

    const std::vector<Ring>& rings_;
    BoxIndex index_;
};

}  // namespace

// Reports the ways that lack places, and those that are left out because they are far away.
std::vector<OsmPlan::Walked> OsmPlan::find_walked() {
    std::vector<Walked> walked;
    int cut_ways = 0, far_ways = 0;
    const Surroundings surroundings(surroundings_of_);
    const auto take = [&](Walked made) {
        const std::vector<Ring> lines = placed(made.lines);
        const bool near = std::all_of(lines.begin(), lines.end(), [](const Ring& line) {
            return std::all_of(line.begin(), line.end(),
                               [](const Vec2& p) { return glm::length(p) <= kFarthestWay_m; });
        });
        if (near && (surroundings_of_.empty() || surroundings.hold_one_of(lines))) walked.push_back(std::move(made));
        else ++far_ways;
    };
    for (const OsmWay& way : data_.ways) {
        if (!is_walked(way.tags) || (way.closed() && is_space(way.tags))) continue;
        if (way.nodes.size() < 2 || !all_known(way.nodes)) {
            ++cut_ways;
            continue;
        }
        Walked made{phrase("osm.way", {{"id", std::to_string(way.id)}}), &way.tags, {way.nodes}};
        made.area = !made.steps() && way.closed() && !way.tags.is("area", "no") &&
                    (way.tags.is("area", "yes") || is_platform(way.tags));
        if (made.area) made.lines[0].pop_back();
        take(std::move(made));
    }
    for (const OsmArea& area : data_.areas) {
        if (!is_walked(area.tags) || area.tags.is("highway", "steps") || is_space(area.tags)) continue;
        bool broken = false;
        Walked made{phrase("osm.relation", {{"id", std::to_string(area.id)}}), &area.tags, rings_of(area, broken)};
        made.area = true;
        const bool known =
            std::all_of(made.lines.begin(), made.lines.end(), [&](const auto& line) { return all_known(line); });
        if (broken || !known || made.lines.empty()) {
            ++cut_ways;
            continue;
        }
        for (std::vector<std::int64_t>& line : made.lines) line.pop_back();
        take(std::move(made));
    }
    if (cut_ways > 0) plan_.left_out.push_back(phrase("osm.cut_ways", {{"n", cut_ways}}));
    if (far_ways > 0)
        plan_.left_out.push_back(phrase("osm.far_ways", {{"n", far_ways}, {"metres", std::lround(kSurroundings_m)}}));
    return walked;
}

// A level that has only ways is a storey too, if a way keeps a place at its height. A footway that only slopes up to it
// does not make one.
void OsmPlan::add_levels(const std::vector<Walked>& walked, const std::unordered_map<std::int64_t, double>& height_m) {
    std::vector<PlanLevel> levels = plan_.levels;
    for (const Walked& way : walked) {
        const double number = way.levels().front();
        const bool known =
            std::any_of(levels.begin(), levels.end(), [&](const PlanLevel& level) { return level.number == number; });
        const auto is_at_level = [&](std::int64_t node) {
            const auto at = height_m.find(node);
            return at == height_m.end() || at->second == number * plan_.storey_m;
        };
        const bool stays = way.area || std::any_of(way.lines[0].begin(), way.lines[0].end(), is_at_level);
        if (!way.steps() && !known && stays)
            levels.push_back({number, phrase("plan.level", {{"number", number}}), number * plan_.storey_m});
    }
    std::sort(levels.begin(), levels.end(), [](const PlanLevel& a, const PlanLevel& b) { return a.number < b.number; });
    std::vector<PlanLevel> before = std::move(plan_.levels);
    plan_.levels = std::move(levels);
    const auto move_level = [&](std::size_t& level) { level = level_at(before[level].number); };
    for (PlanSpace& space : plan_.spaces) std::for_each(space.levels.begin(), space.levels.end(), move_level);
    for (PlanDoor& door : plan_.doors) std::for_each(door.levels.begin(), door.levels.end(), move_level);
    for (PlanWall& wall : plan_.walls) move_level(wall.level);
    for (PlanThing& thing : plan_.things) move_level(thing.level);
}

PlanWay OsmPlan::way_of(const Walked& walked, const std::unordered_map<std::int64_t, double>& height_m) const {
    const OsmTags& tags = *walked.tags;
    PlanWay made;
    made.id = walked.id;
    made.steps = walked.steps();
    made.escalator = is_escalator(tags);
    made.area = walked.area;
    made.name = own_name(tags);
    made.facts = facts_of(tags);
    const double stated_m = number_in(tags["width"]);
    made.width_m = std::clamp(stated_m > 0.0 ? stated_m : made.steps ? kSteps_m : kWay_m, 0.8, kMostWay_m);
    std::vector<Ring> lines = placed(walked.lines);
    made.line = std::move(lines[0]);
    made.further.assign(lines.begin() + 1, lines.end());
    const std::vector<std::int64_t>& nodes = walked.lines[0];
    const std::vector<double> levels = walked.levels();
    const double low_m = levels.front() * plan_.storey_m, high_m = levels.back() * plan_.storey_m;
    const auto height_at = [&](std::int64_t node, double own_m) {
        const auto at = height_m.find(node);
        return at == height_m.end() ? own_m : at->second;
    };
    if (!made.steps) {
        for (const std::int64_t n : nodes) made.floor_m.push_back(made.area ? low_m : height_at(n, low_m));
        return made;
    }
    // Other ways that meet the ends of stairs say how high they are. Without any, the levels of the stairs do.
    const bool down = tags.is("incline", "down");
    const double first_m = height_at(nodes.front(), down ? high_m : low_m),
                 last_m = height_at(nodes.back(), down ? low_m : high_m);
    double all = 0.0, gone = 0.0;
    for (std::size_t i = 1; i < made.line.size(); ++i) all += glm::length(made.line[i] - made.line[i - 1]);
    for (std::size_t i = 0; i < made.line.size(); ++i) {
        if (i > 0) gone += glm::length(made.line[i] - made.line[i - 1]);
        made.floor_m.push_back(first_m + (last_m - first_m) * (all > 0.0 ? gone / all : 0.0));
    }
    return made;
}

// Names the ways that have no name by what they join: "Footway from Platform 3 to the stairs".
void OsmPlan::name_ways(const std::vector<Walked>& walked) {
    std::unordered_map<std::int64_t, std::vector<std::size_t>> at_node;  // looked up only
    std::vector<std::size_t> areas;
    for (std::size_t w = 0; w < walked.size(); ++w) {
        for (const std::vector<std::int64_t>& line : walked[w].lines)
            for (const std::int64_t n : line) at_node[n].push_back(w);
        if (walked[w].area && !plan_.ways[w].name.empty()) areas.push_back(w);
    }
    const auto met_at = [&](std::size_t w, std::size_t end) {
        const PlanWay& way = plan_.ways[w];
        const std::int64_t node = walked[w].lines[0][end];
        std::string stairs;
        for (const std::size_t other : at_node[node]) {
            if (other == w) continue;
            const PlanWay& met = plan_.ways[other];
            if (std::string name = own_name(*walked[other].tags); !name.empty()) return name;
            if (met.steps) stairs = phrase(met.escalator ? "osm.the_escalator" : "osm.the_stairs");
        }
        for (const std::size_t other : areas) {
            const std::vector<Ring> rings = rings_of_way(plan_.ways[other]);
            const bool level = std::abs(plan_.ways[other].floor_m[0] - way.floor_m[end]) < kSameFloor_m;
            if (level && (inside(rings, way.line[end]) || distance_to_outline(rings, way.line[end]) < kBeside_m))
                return plan_.ways[other].name;
        }
        return is_lift_node(node) ? phrase("osm.the_lift") : stairs;
    };
    for (std::size_t w = 0; w < walked.size(); ++w) {
        PlanWay& way = plan_.ways[w];
        if (!way.name.empty()) continue;
        const std::string kind = kind_of_way(*walked[w].tags);
        way.name = kind;
        if (way.area || way.steps) continue;
        const std::string from = met_at(w, 0), to = met_at(w, way.line.size() - 1);
        if (!from.empty() && !to.empty() && from != to)
            way.name = phrase("osm.way_from_to", {{"kind", kind}, {"from", from}, {"to", to}});
        else if (!from.empty() || !to.empty())
            way.name = phrase("osm.way_at", {{"kind", kind}, {"to", to.empty() ? from : to}});
    }
}

// True if its middle is in a room of its level.
bool OsmPlan::is_within_rooms(const Walked& walked) const {
    const Ring line = placed(walked.lines)[0];
    Vec2 middle{0.0};
    if (walked.area)
        for (const Vec2& p : line) middle += p / static_cast<double>(line.size());
    else middle = 0.5 * (line[(line.size() - 1) / 2] + line[line.size() / 2]);
    const std::vector<double> levels = walked.levels();
    return std::any_of(plan_.spaces.begin(), plan_.spaces.end(), [&](const PlanSpace& space) {
        return std::any_of(space.levels.begin(), space.levels.end(),
                           [&](std::size_t level) {
                               return std::find(levels.begin(), levels.end(), plan_.levels[level].number) !=
                                      levels.end();
                           }) &&
               inside(space.rings, middle);
    });
}

// Lines and areas that people walk on: each at its level, and from level to level where its ends say so. If the rooms
// are joined by doors, those that lie within rooms add nothing.
void OsmPlan::add_ways(bool rooms_are_joined) {
    if (rooms_are_joined && surroundings_of_.empty()) {
        for (const PlanSpace& space : plan_.spaces)
            surroundings_of_.insert(surroundings_of_.end(), space.rings.begin(), space.rings.end());
        for (const OsmWay& way : data_.ways)
            if (is_platform(way.tags) && all_known(way.nodes) && !way.nodes.empty())
                surroundings_of_.push_back(placed({way.nodes})[0]);
    }
    std::vector<Walked> walked = find_walked();
    if (rooms_are_joined) std::erase_if(walked, [&](const Walked& way) { return is_within_rooms(way); });
    if (walked.empty()) return;
    std::unordered_map<std::int64_t, double> height_m;  // of the nodes of level ways; looked up only
    // Areas first: they are flat, so the lines that end on them climb to them.
    std::unordered_set<std::int64_t> of_area;  // looked up only
    for (const bool area : {true, false}) {
        for (const auto& [n, floor_m] : height_m) of_area.insert(n);
        for (const Walked& way : walked) {
            if (way.steps() || way.area != area) continue;
            const double floor_m = way.levels().front() * plan_.storey_m;
            for (const std::vector<std::int64_t>& line : way.lines)
                for (const std::int64_t n : line) {
                    if (of_area.contains(n)) continue;
                    const auto [at, is_new] = height_m.try_emplace(n, floor_m);
                    if (!is_new && std::abs(floor_m) < std::abs(at->second)) at->second = floor_m;
                }
        }
    }
    for (const Walked& way : walked) plan_.ways.push_back(way_of(way, height_m));
    name_ways(walked);
    add_levels(walked, height_m);
    plan_.guessed.push_back(
        phrase(rooms_are_joined ? "osm.outdoor_ways" : "osm.along_ways", {{"n", plan_.ways.size()}}));
}

}  // namespace handrail
