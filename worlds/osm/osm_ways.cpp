// Adds the footways, platforms and stairs of an OpenStreetMap file that are outside rooms.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_set>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/floorplan/upright.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"
#include "worlds/osm/osm_levels.h"
#include "worlds/osm/osm_plan.h"
#include "worlds/osm/osm_words.h"
#include "worlds/scene/surfaces.h"

namespace handrail::osm {
namespace {

constexpr double kWay_m = 2.0, kSteps_m = 1.6, kMostWay_m = 20.0, kFarthestWay_m = 2'000.0, kNextTo_m = 0.3,
                 kSurroundings_m = 100.0, kLook_m = 10.0, kAsideShare = 0.15;
constexpr int kMostThrough = 4;
constexpr std::size_t kMostLooked = 60;

bool is_escalator(const OsmTags& tags) {
    return tags.is("highway", "steps") && tags.has("conveying") && !tags.is("conveying", "no");
}

// Returns the kind of the way in words, such as "Footway".
std::string kind_of_way(const OsmTags& tags) {
    const std::string_view highway = tags["highway"];
    const bool plain = is_platform(tags) || highway.empty() || highway == "no";
    return capitalised(kind_words(is_escalator(tags) ? "escalator" : plain ? "platform" : highway));
}

// Returns the name that the file states for the way. Empty if it states none.
std::string own_name(const OsmTags& tags) {
    std::string name(in_spoken(tags, "name")), ref(tags["ref"]);
    if (!is_platform(tags)) return name.empty() ? ref : name;
    if (ref.empty()) ref = tags["local_ref"];
    if (name.empty()) return ref.empty() ? ref : kind_of_way(tags) + " " + ref;
    return ref.empty() || name.find(ref) != std::string::npos ? name : name + " " + ref;
}

}  // namespace

std::vector<double> OsmPlan::Walked::levels() const {
    OsmLevels found = levels_of(level.empty() ? (*tags)["layer"] : level);
    if (found.levels.empty()) found.levels.push_back(0.0);
    return std::move(found.levels);
}

bool OsmPlan::is_lift_node(std::int64_t node) const {
    const auto found = data_.nodes.find(node);
    return found != data_.nodes.end() && found->second.tags.is("highway", "elevator");
}

namespace {

// Finds out whether points are near any of the given outlines.
class Surroundings {
public:
    explicit Surroundings(const std::vector<Ring>& rings) : rings_(rings), index_(boxes_of(rings)) {}

    // Returns true if at least one of the lines is near one of the outlines.
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
            return inside({rings_[r]}, at) || floorplan::distance_to_outline({rings_[r]}, at) <= kSurroundings_m;
        });
    }

    const std::vector<Ring>& rings_;
    BoxIndex index_;
};

}  // namespace

// Finds the lines and areas that people walk on. Reports those with missing nodes, and those that are left out because
// they are far away.
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
        Walked made{
            phrase("osm.way", {{"id", std::to_string(way.id)}}), &way.tags, {way.nodes}, false, data_.level_of(way)};
        made.area = !made.steps() && way.closed() && !way.tags.is("area", "no") &&
                    (way.tags.is("area", "yes") || is_platform(way.tags));
        if (made.area) made.lines[0].pop_back();
        take(std::move(made));
    }
    for (const OsmArea& area : data_.areas) {
        if (!is_walked(area.tags) || area.tags.is("highway", "steps") || is_space(area.tags)) continue;
        bool broken = false;
        Walked made{phrase("osm.relation", {{"id", std::to_string(area.id)}}), &area.tags, rings_of(area, broken), true,
                    area.tags["level"]};
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

// Adds a storey for each level that has only ways, if a point of a way is at the height of the level. A footway that
// merely slopes up to the level is not enough.
void OsmPlan::add_levels(const std::vector<Walked>& walked, const std::unordered_map<std::int64_t, double>& height_m) {
    std::vector<floorplan::PlanLevel> levels = plan_.levels;
    for (const Walked& way : walked) {
        const double number = way.levels().front();
        const bool known = std::any_of(levels.begin(), levels.end(),
                                       [&](const floorplan::PlanLevel& level) { return level.number == number; });
        const auto is_at_level = [&](std::int64_t node) {
            const auto at = height_m.find(node);
            return at == height_m.end() || at->second == number * plan_.storey_m;
        };
        const bool stays = way.area || std::any_of(way.lines[0].begin(), way.lines[0].end(), is_at_level);
        if (!way.steps() && !known && stays) levels.push_back(level_made(number));
    }
    std::sort(levels.begin(), levels.end(),
              [](const floorplan::PlanLevel& a, const floorplan::PlanLevel& b) { return a.number < b.number; });
    std::vector<floorplan::PlanLevel> before = std::move(plan_.levels);
    plan_.levels = std::move(levels);
    const auto move_level = [&](std::size_t& level) { level = level_at(before[level].number); };
    for (floorplan::PlanSpace& space : plan_.spaces)
        std::for_each(space.levels.begin(), space.levels.end(), move_level);
    for (floorplan::PlanDoor& door : plan_.doors) std::for_each(door.levels.begin(), door.levels.end(), move_level);
    for (floorplan::PlanWall& wall : plan_.walls) move_level(wall.level);
    for (floorplan::PlanThing& thing : plan_.things) move_level(thing.level);
}

// Adds the heights of landings, which are nodes where only flights of steps meet. If a flight states two levels and its
// other end is at one of them, the landing is at the other level. Otherwise the landing divides the rise between the
// ends of its flights by their lengths.
void OsmPlan::add_landings(const std::vector<Walked>& walked,
                           std::unordered_map<std::int64_t, double>& height_m) const {
    constexpr int kRounds = 200;  // enough for a dozen flights in a row
    struct Flight {
        std::int64_t other = 0;
        double length_m = 0.0, low_m = 0.0, high_m = 0.0;
    };
    std::map<std::int64_t, std::vector<Flight>> flights_at;
    for (const Walked& way : walked) {
        if (!way.steps()) continue;
        const Ring line = placed(way.lines)[0];
        Flight flight;
        for (std::size_t i = 1; i < line.size(); ++i) flight.length_m += glm::length(line[i] - line[i - 1]);
        flight.length_m = std::max(flight.length_m, 0.1);
        const std::vector<double> levels = way.levels();
        flight.low_m = levels.front() * plan_.storey_m;
        flight.high_m = levels.back() * plan_.storey_m;
        const std::int64_t from = way.lines[0].front(), to = way.lines[0].back();
        flight.other = to;
        flights_at[from].push_back(flight);
        flight.other = from;
        flights_at[to].push_back(flight);
    }
    std::erase_if(flights_at, [&](const auto& at) { return at.second.size() < 2 || height_m.contains(at.first); });
    for (auto at = flights_at.begin(); at != flights_at.end();) {
        const auto known = std::find_if(at->second.begin(), at->second.end(), [&](const Flight& flight) {
            const auto other = height_m.find(flight.other);
            return flight.low_m < flight.high_m && other != height_m.end() &&
                   (other->second == flight.low_m || other->second == flight.high_m);
        });
        if (known == at->second.end()) {
            ++at;
            continue;
        }
        height_m[at->first] = height_m.at(known->other) == known->low_m ? known->high_m : known->low_m;
        at = flights_at.erase(at);
    }
    std::map<std::int64_t, double> landing_m;
    for (int round = 0; round < kRounds && !flights_at.empty(); ++round)
        for (const auto& [node, flights] : flights_at) {
            double sum = 0.0, weights = 0.0;
            for (const Flight& flight : flights) {
                const auto known = height_m.find(flight.other);
                const auto landing = landing_m.find(flight.other);
                if (known == height_m.end() && landing == landing_m.end()) continue;
                sum += (known != height_m.end() ? known->second : landing->second) / flight.length_m;
                weights += 1.0 / flight.length_m;
            }
            if (weights > 0.0) landing_m[node] = sum / weights;
        }
    height_m.insert(landing_m.begin(), landing_m.end());
}

floorplan::PlanWay OsmPlan::way_of(const Walked& walked,
                                   const std::unordered_map<std::int64_t, double>& height_m) const {
    const OsmTags& tags = *walked.tags;
    floorplan::PlanWay made;
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
    // The ends of stairs have the heights of the ways that end at the same nodes. If no way ends there, the height
    // comes from the levels of the stairs.
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

namespace {

// Finds the places and other ways to which a way leads.
class LedTo {
public:
    LedTo(const std::vector<floorplan::PlanWay>& ways, std::vector<std::vector<std::int64_t>> nodes)
        : ways_(ways), nodes_(std::move(nodes)) {
        std::vector<Aabb> boxes;
        for (std::size_t w = 0; w < ways.size(); ++w) {
            for (const std::int64_t n : nodes_[w]) at_node_[n].push_back(w);
            if (!ways[w].area || ways[w].name.empty()) continue;
            Aabb box;
            for (const Vec2& p : ways[w].line) box.include(Vec3(p, ways[w].floor_m[0]));
            areas_.push_back(w);
            boxes.push_back(grown(box, kNextTo_m));
        }
        index_ = BoxIndex(boxes);
    }

    // Returns the ways at a node, in file order.
    const std::vector<std::size_t>& ways_at(std::int64_t node) const {
        static const std::vector<std::size_t> none;
        const auto found = at_node_.find(node);
        return found == at_node_.end() ? none : found->second;
    }
    const std::vector<std::int64_t>& nodes_of(std::size_t way) const { return nodes_[way]; }
    // Returns the named area in which, or next to which, a line ends. Null if there is none.
    const floorplan::PlanWay* area_at(const Vec2& at, double floor_m) const {
        std::vector<std::uint32_t> near;
        index_.find({Vec3(at, floor_m), Vec3(at, floor_m)}, near);
        for (const std::uint32_t a : near) {
            const floorplan::PlanWay& area = ways_[areas_[a]];
            const std::vector<Ring> rings = floorplan::rings_of_way(area);
            if (inside(rings, at) || floorplan::distance_to_outline(rings, at) < kNextTo_m) return &area;
        }
        return nullptr;
    }

private:
    const std::vector<floorplan::PlanWay>& ways_;
    std::vector<std::vector<std::int64_t>> nodes_;  // node ids of each way
    // By node id; never iterated, because the order is arbitrary.
    std::unordered_map<std::int64_t, std::vector<std::size_t>> at_node_;
    std::vector<std::size_t> areas_;
    BoxIndex index_;
};

}  // namespace

// Names unnamed ways by the places that they connect: "Footway from Platform 3 to the stairs".
void OsmPlan::name_ways(const std::vector<Walked>& walked) {
    std::vector<std::vector<std::int64_t>> nodes;
    std::vector<std::string> own;
    for (const Walked& way : walked) {
        nodes.emplace_back();
        for (const std::vector<std::int64_t>& line : way.lines)
            nodes.back().insert(nodes.back().end(), line.begin(), line.end());
        own.push_back(own_name(*way.tags));
    }
    const LedTo led(plan_.ways, std::move(nodes));
    // Returns the name of the place or passage at a node. A named place takes precedence over lifts and stairs.
    const auto met_at = [&](std::int64_t node, const std::vector<std::size_t>& but) {
        std::string passage = is_lift_node(node) ? phrase("osm.the_lift") : std::string();
        for (const std::size_t other : led.ways_at(node)) {
            if (std::find(but.begin(), but.end(), other) != but.end()) continue;
            if (!own[other].empty()) return own[other];
            const floorplan::PlanWay& met = plan_.ways[other];
            if (met.steps && passage.empty()) passage = phrase(met.escalator ? "osm.the_escalator" : "osm.the_stairs");
        }
        if (const auto found = spaces_of_.find(node); found != spaces_of_.end())
            for (const std::size_t s : found->second) {
                const floorplan::PlanSpace& space = plan_.spaces[s];
                if (space.kind == floorplan::PlanSpaceKind::Lift) passage = phrase("osm.the_lift");
                else if (space.kind == floorplan::PlanSpaceKind::Stairs) passage = phrase("osm.the_stairs");
                else if (!space.name.empty()) return space.name;
            }
        return passage;
    };
    // Returns the name of the place to which one end of a way leads. If there is none at that end, searches through
    // unnamed ways, through as few as possible.
    const auto led_to = [&](std::size_t w, bool at_end) {
        const floorplan::PlanWay& way = plan_.ways[w];
        const std::int64_t end = at_end ? walked[w].lines[0].back() : walked[w].lines[0].front();
        std::vector<std::size_t> through{w};
        const auto in_area = [&](const floorplan::PlanWay& line, bool last) {
            const floorplan::PlanWay* area = led.area_at(last ? line.line.back() : line.line.front(),
                                                         last ? line.floor_m.back() : line.floor_m.front());
            return area ? area->name : std::string();
        };
        std::string direct = in_area(way, at_end);
        if (direct.empty()) direct = met_at(end, through);
        std::vector<std::int64_t> from{end};
        for (int k = 0; k < kMostThrough && direct.empty() && !from.empty(); ++k) {
            std::vector<std::int64_t> next;
            for (const std::int64_t node : from)
                for (const std::size_t other : led.ways_at(node)) {
                    if (through.size() > kMostLooked || plan_.ways[other].area || plan_.ways[other].steps ||
                        std::find(through.begin(), through.end(), other) != through.end())
                        continue;
                    through.push_back(other);
                    for (const bool last : {false, true})
                        if (direct.empty()) direct = in_area(plan_.ways[other], last);
                    next.insert(next.end(), led.nodes_of(other).begin(), led.nodes_of(other).end());
                }
            for (const std::int64_t node : next)
                if (direct.empty()) direct = met_at(node, through);
            from = std::move(next);
        }
        return direct;
    };
    std::vector<std::string> names(walked.size());
    for (std::size_t w = 0; w < walked.size(); ++w) {
        if (!own[w].empty()) continue;
        const std::string kind = kind_of_way(*walked[w].tags);
        names[w] = kind;
        if (plan_.ways[w].area || plan_.ways[w].steps) continue;
        const std::string from = led_to(w, false), to = led_to(w, true);
        if (!from.empty() && !to.empty() && from != to)
            names[w] = phrase("osm.way_from_to", {{"kind", kind}, {"from", from}, {"to", to}});
        else if (!from.empty() || !to.empty())
            names[w] = phrase("osm.way_at", {{"kind", kind}, {"to", to.empty() ? from : to}});
    }
    for (std::size_t w = 0; w < walked.size(); ++w)
        if (own[w].empty()) plan_.ways[w].name = std::move(names[w]);
    distinguish_ways(walked);
}

// Makes the names of ways with the same name different. It adds their levels or, if these are equal, the side of the
// site on which they are.
void OsmPlan::distinguish_ways(const std::vector<Walked>& walked) {
    Aabb all;
    for (const floorplan::PlanWay& way : plan_.ways)
        for (const Vec2& p : way.line) all.include(Vec3(p, 0.0));
    const auto level_words = [&](std::size_t w) { return level_made(walked[w].levels().front()).name; };
    const auto side_words = [&](std::size_t w) {
        Aabb box;
        for (const Vec2& p : plan_.ways[w].line) box.include(Vec3(p, 0.0));
        const Vec3 off = box.centre_m() - all.centre_m(), size = all.size_m();
        const bool aside = std::abs(off.x) > std::max(1.0, kAsideShare * size.x) ||
                           std::abs(off.y) > std::max(1.0, kAsideShare * size.y);
        return aside ? compass_word(off) : phrase("room_name.middle");
    };
    const auto distinguish = [&](const auto& words_of) {
        std::map<std::string, std::vector<std::size_t>> called;
        for (std::size_t w = 0; w < plan_.ways.size(); ++w)
            if (!plan_.ways[w].steps) called[plan_.ways[w].name].push_back(w);
        for (const auto& [name, ways] : called) {
            std::set<std::string> differ;
            for (const std::size_t w : ways) differ.insert(words_of(w));
            if (differ.size() < 2) continue;
            for (const std::size_t w : ways)
                plan_.ways[w].name = phrase("plan.on_level", {{"name", name}, {"level", words_of(w)}});
        }
    };
    distinguish(level_words);
    distinguish(side_words);
}

// Returns true if the middle of the way is in a room on the same level.
bool OsmPlan::is_within_rooms(const Walked& walked) const {
    const Ring line = placed(walked.lines)[0];
    Vec2 middle{0.0};
    if (walked.area)
        for (const Vec2& p : line) middle += p / static_cast<double>(line.size());
    else middle = 0.5 * (line[(line.size() - 1) / 2] + line[line.size() / 2]);
    const std::vector<double> levels = walked.levels();
    return std::any_of(plan_.spaces.begin(), plan_.spaces.end(), [&](const floorplan::PlanSpace& space) {
        return std::any_of(space.levels.begin(), space.levels.end(),
                           [&](std::size_t level) {
                               return std::find(levels.begin(), levels.end(), plan_.levels[level].number) !=
                                      levels.end();
                           }) &&
               inside(space.rings, middle);
    });
}

// Adds the lines and areas that people walk on. A way is at its own level. The way slopes between levels if the heights
// of its ends differ. If doors join the rooms, ways within rooms are left out.
void OsmPlan::add_ways(bool rooms_are_joined) {
    if (rooms_are_joined && surroundings_of_.empty()) {
        for (const floorplan::PlanSpace& space : plan_.spaces)
            surroundings_of_.insert(surroundings_of_.end(), space.rings.begin(), space.rings.end());
        for (const OsmWay& way : data_.ways)
            if (is_platform(way.tags) && all_known(way.nodes) && !way.nodes.empty())
                surroundings_of_.push_back(placed({way.nodes})[0]);
    }
    std::vector<Walked> walked = find_walked();
    if (rooms_are_joined) std::erase_if(walked, [&](const Walked& way) { return is_within_rooms(way); });
    if (walked.empty()) return;
    // Heights of the nodes of level ways; the arbitrary order of the map has no effect.
    std::unordered_map<std::int64_t, double> height_m;
    // Areas come first: they are level, so the lines that end on them slope to reach them.
    std::unordered_set<std::int64_t> of_area;  // the arbitrary order of the set has no effect
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
    add_landings(walked, height_m);
    for (const Walked& way : walked) plan_.ways.push_back(way_of(way, height_m));
    name_ways(walked);
    add_levels(walked, height_m);
    plan_.guessed.push_back(
        phrase(rooms_are_joined ? "osm.outdoor_ways" : "osm.along_ways", {{"n", plan_.ways.size()}}));
}

}  // namespace handrail::osm
