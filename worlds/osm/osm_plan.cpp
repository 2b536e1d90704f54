#include "worlds/osm/osm_plan.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/floorplan/upright.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/exposed_surface.h"
#include "worlds/osm/osm_levels.h"
#include "worlds/osm/osm_words.h"

namespace handrail::osm {
namespace {

constexpr double kLeastStorey_m = 2.5, kMostStorey_m = 6.0;
constexpr double kFarthest_m = 20'000.0, kNextToOutline_m = 0.3, kNextToCorner_m = 0.05;
constexpr std::size_t kMostOutlines = 60'000, kMostCornersOfOne = 2'000;

void note_id(std::string& ids, const std::string& id) {
    if (ids.size() < 60) ids += (ids.empty() ? "" : ", ") + id;
}

// Finds the spaces whose outlines pass close to a point. It is used for doors, which are often drawn a few centimetres
// off the wall.
class OutlineIndex {
public:
    explicit OutlineIndex(const std::vector<floorplan::PlanSpace>& spaces) : index_(boxes_of(spaces)) {}

    struct DoorSpaces {
        // The spaces on both sides of the wall with the door, in rising order. A room is left out if only a corner of
        // it is next to the door.
        std::vector<std::size_t> spaces;
        std::size_t nearest = static_cast<std::size_t>(-1);
    };
    // Tests every edge of those outlines whose boxes contain `at`.
    DoorSpaces spaces_at(const floorplan::FloorPlan& plan, const Vec2& at) const {
        std::vector<std::uint32_t> near;
        index_.find({Vec3(at, 0.0), Vec3(at, 0.0)}, near);
        std::sort(near.begin(), near.end());
        floorplan::NearestOfOutline wall;
        std::vector<std::pair<std::size_t, Vec2>> near_door;
        DoorSpaces joined;
        for (const std::uint32_t s : near) {
            const floorplan::NearestOfOutline found = floorplan::nearest_of_outline(plan.spaces[s].rings, at);
            if (found.distance_m > kNextToOutline_m) continue;
            near_door.emplace_back(s, found.at_m);
            if (found.distance_m >= wall.distance_m) continue;
            wall = found;
            joined.nearest = s;
        }
        for (const auto& [s, nearest_m] : near_door)
            if (std::abs(glm::dot(nearest_m - at, wall.along)) <= kNextToCorner_m) joined.spaces.push_back(s);
        return joined;
    }

private:
    static std::vector<Aabb> boxes_of(const std::vector<floorplan::PlanSpace>& spaces) {
        std::vector<Aabb> boxes;
        for (const floorplan::PlanSpace& space : spaces) {
            Aabb box;
            for (const Ring& ring : space.rings)
                for (const Vec2& p : ring) box.include(Vec3(p, 0.0));
            boxes.push_back(grown(box, kNextToOutline_m));
        }
        return boxes;
    }

    BoxIndex index_;
};

}  // namespace

OsmPlan::OsmPlan(const OsmData& data, const OsmOptions& options) : data_(data), options_(options) {
    plan_.format = "osm";
    plan_.schema = "OpenStreetMap";
    plan_.storey_m = kUsualStorey_m;
}

Result<floorplan::FloorPlan> OsmPlan::build(const std::string& file_name) {
    find_outlines();
    if (outlines_.size() > kMostOutlines) return fail(phrase("osm.too_large"), file_name);
    if (const Result<void> chosen = choose_building(file_name); !chosen) return tl::unexpected(chosen.error());
    stack_outlines();
    set_origin();
    lay_levels();
    add_spaces();
    add_doors();
    add_lift_nodes();
    add_walls_and_things();
    add_ways(rooms_are_joined());
    if (plan_.spaces.empty() && plan_.ways.empty()) return fail(phrase("osm.nothing"), file_name);
    add_blocks();
    report("osm.open_outlines", open_, open_ids_);
    report("osm.incomplete", incomplete_, incomplete_ids_);
    report("osm.odd_levels", odd_levels_);
    if (without_level_ > 0) plan_.guessed.push_back(phrase("osm.without_level", {{"n", without_level_}}));
    if (doors_alone_ > 0) plan_.left_out.push_back(phrase("osm.doors_alone", {{"n", doors_alone_}}));
    return std::move(plan_);
}

void OsmPlan::report(std::string_view key, int count, const std::string& ids) {
    if (count > 0) plan_.warnings.emplace_back(phrase(key, {{"n", count}, {"ids", ids}}), phrase("osm.then_left_out"));
}

bool OsmPlan::all_known(const std::vector<std::int64_t>& nodes) const {
    return std::all_of(nodes.begin(), nodes.end(), [&](std::int64_t n) { return data_.nodes.contains(n); });
}

// Returns the rings that the member ways form when they are joined end to end.
std::vector<std::vector<std::int64_t>> OsmPlan::rings_of(const OsmArea& area, bool& broken) const {
    std::vector<std::vector<std::int64_t>> rings, open;
    for (const auto& [id, hole] : area.ways) {
        const auto found = data_.way_number.find(id);
        if (found == data_.way_number.end()) {
            broken = true;
            continue;
        }
        const std::vector<std::int64_t>& nodes = data_.ways[found->second].nodes;
        const bool closed = data_.ways[found->second].closed();
        if (nodes.size() > 1 && (closed || nodes.front() != nodes.back())) (closed ? rings : open).push_back(nodes);
    }
    while (!open.empty()) {
        std::vector<std::int64_t> ring = std::move(open.back());
        open.pop_back();
        for (bool grown = true; grown && ring.front() != ring.back();) {
            grown = false;
            for (std::size_t i = 0; i < open.size(); ++i) {
                if (open[i].back() == ring.back()) std::reverse(open[i].begin(), open[i].end());
                if (open[i].front() != ring.back()) continue;
                ring.insert(ring.end(), open[i].begin() + 1, open[i].end());
                open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
                grown = true;
                break;
            }
        }
        if (ring.front() == ring.back() && ring.size() > 3) rings.push_back(std::move(ring));
        else broken = true;
    }
    return rings;
}

void OsmPlan::take_outline(std::string id, const OsmTags& tags, std::string_view level,
                           std::vector<std::vector<std::int64_t>> rings) {
    Outline outline;
    outline.id = std::move(id);
    outline.tags = &tags;
    for (std::vector<std::int64_t>& ring : rings) {
        if (!all_known(ring) || ring.size() > kMostCornersOfOne) {
            ++incomplete_;
            note_id(incomplete_ids_, outline.id);
            return;
        }
        ring.pop_back();
        outline.rings.push_back(std::move(ring));
    }
    OsmLevels levels = levels_of(level, tags["repeat_on"]);
    odd_levels_ += levels.damaged ? 1 : 0;
    if (levels.levels.empty()) {
        ++without_level_;
        levels.levels.push_back(0.0);
    }
    outline.levels = std::move(levels.levels);
    outlines_.push_back(std::move(outline));
}

void OsmPlan::find_outlines() {
    for (const OsmWay& way : data_.ways) {
        const bool building = way.tags.has("building") && !way.tags.is("building", "no");
        const std::string id = phrase("osm.way", {{"id", std::to_string(way.id)}});
        if (building && way.closed() && all_known(way.nodes)) {
            Building made{id, std::string(in_spoken(way.tags, "name")), std::string(way.tags["ref"]), &way.tags, {}};
            if (made.name.empty()) made.name = way.tags["addr:housename"];
            made.rings = in_degrees({way.nodes});
            buildings_.push_back(std::move(made));
        }
        if (!is_space(way.tags)) continue;
        if (!way.closed()) {
            ++open_;
            note_id(open_ids_, std::to_string(way.id));
            continue;
        }
        take_outline(id, way.tags, data_.level_of(way), {way.nodes});
    }
    for (const OsmArea& area : data_.areas) {
        const bool building = area.tags.has("building") && !area.tags.is("building", "no");
        if (!building && !is_space(area.tags)) continue;
        const std::string id = phrase("osm.relation", {{"id", std::to_string(area.id)}});
        bool broken = false;
        std::vector<std::vector<std::int64_t>> rings = rings_of(area, broken);
        const bool known = std::all_of(rings.begin(), rings.end(), [&](const auto& ring) { return all_known(ring); });
        if (building && known && !rings.empty()) {
            Building made{id, std::string(in_spoken(area.tags, "name")), std::string(area.tags["ref"]), &area.tags, {}};
            made.rings = in_degrees(rings);
            buildings_.push_back(std::move(made));
        }
        if (!is_space(area.tags)) continue;
        if (broken || rings.empty()) {
            ++incomplete_;
            note_id(incomplete_ids_, id);
        }
        if (!rings.empty()) take_outline(id, area.tags, area.tags["level"], std::move(rings));
    }
    for (Building& building : buildings_)
        for (const Ring& ring : building.rings)
            for (const Vec2& p : ring)
                building.least = glm::min(building.least, p), building.most = glm::max(building.most, p);
}

std::vector<Ring> OsmPlan::in_degrees(const std::vector<std::vector<std::int64_t>>& rings) const {
    std::vector<Ring> made;
    for (const std::vector<std::int64_t>& ring : rings) {
        made.emplace_back();
        for (const std::int64_t n : ring) {
            const OsmNode& node = data_.nodes.at(n);
            made.back().emplace_back(node.lon_deg, node.lat_deg);
        }
    }
    return made;
}

// Assigns each outline to the building around the middle of the outline. If no building surrounds that point, the
// outline belongs to the nearest building within a kilometre. Then selects the building to read.
Result<void> OsmPlan::choose_building(const std::string& file_name) {
    std::vector<Aabb> boxes;
    for (const Building& building : buildings_) boxes.push_back({Vec3(building.least, 0.0), Vec3(building.most, 0.0)});
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> near;
    for (Outline& outline : outlines_) {
        const std::vector<Ring> rings = in_degrees(outline.rings);
        Vec2 middle{0.0};
        for (const Vec2& p : rings[0]) middle += p / static_cast<double>(rings[0].size());
        double nearest = 1e300;
        // Distances in degrees: 0, about 10 m, 100 m and 1 km.
        for (const double around_deg : {0.0, 1e-4, 1e-3, 1e-2}) {
            const Vec3 reach(around_deg, around_deg, 1.0);
            index.find({Vec3(middle, 0.0) - reach, Vec3(middle, 0.0) + reach}, near);
            for (const std::uint32_t b : near) {
                const Building& building = buildings_[b];
                const Vec2 off = glm::max(glm::max(building.least - middle, middle - building.most), Vec2(0.0));
                double far = glm::length(off);
                if (far == 0.0 && !inside(building.rings, middle)) far = 1e-6;
                if (far < nearest) nearest = far, outline.building = b;
            }
            if (outline.building != kNone) break;
        }
        if (outline.building != kNone) buildings_[outline.building].spaces += static_cast<int>(outline.levels.size());
    }
    std::vector<std::size_t> with_rooms;
    for (std::size_t b = 0; b < buildings_.size(); ++b)
        if (buildings_[b].spaces > 0) with_rooms.push_back(b);
    const auto called = [&](std::size_t b) {
        if (!buildings_[b].name.empty()) return buildings_[b].name;
        return buildings_[b].ref.empty() ? buildings_[b].id : buildings_[b].ref;
    };
    const auto listed = [&](std::size_t but) {
        std::string names;
        for (std::size_t k = 0; k < with_rooms.size() && k < 8; ++k)
            if (with_rooms[k] != but)
                names += (names.empty() ? "" : ", ") + std::to_string(k + 1) + " " + called(with_rooms[k]);
        return names;
    };
    if (!options_.building.empty()) {
        const std::string wanted = lower_ascii(options_.building);
        for (std::size_t k = 0; k < with_rooms.size() && chosen_ == kNone; ++k) {
            const Building& b = buildings_[with_rooms[k]];
            const bool meant = wanted == std::to_string(k + 1) ||
                               lower_ascii(b.name).find(wanted) != std::string::npos || lower_ascii(b.ref) == wanted ||
                               b.id == options_.building;
            if (meant) chosen_ = with_rooms[k];
        }
        if (chosen_ == kNone)
            return fail(phrase("osm.no_such_building",
                               {{"wish", one_line(options_.building.substr(0, 60))}, {"names", listed(kNone)}}),
                        file_name);
    }
    for (const std::size_t b : with_rooms)
        if (options_.building.empty() && (chosen_ == kNone || buildings_[b].spaces > buildings_[chosen_].spaces))
            chosen_ = b;
    if (with_rooms.size() > 1) {
        plan_.left_out.push_back(
            phrase("osm.other_buildings",
                   {{"n", with_rooms.size() - 1}, {"name", called(chosen_)}, {"names", listed(chosen_)}}));
        std::erase_if(outlines_, [&](const Outline& outline) { return outline.building != chosen_; });
    }
    if (chosen_ == kNone) return {};
    const Building& building = buildings_[chosen_];
    plan_.name = building.name;
    const double height = number_in((*building.tags)["height"]),
                 levels = number_in((*building.tags)["building:levels"]);
    if (levels >= 1.0 && height / levels >= kLeastStorey_m && height / levels <= kMostStorey_m)
        plan_.storey_m = height / levels;
    return {};
}

// Puts the origin in the middle of the area that is read, because lengths are exact only near the origin.
void OsmPlan::set_origin() {
    bool around_building = false;
    Vec2 least{1e300}, most{-1e300};
    const auto include = [&](const Vec2& p) { least = glm::min(least, p), most = glm::max(most, p); };
    for (const Outline& outline : outlines_)
        for (const Ring& ring : in_degrees(outline.rings))
            for (const Vec2& p : ring) include(p);
    const bool rooms = std::any_of(outlines_.begin(), outlines_.end(), [](const Outline& outline) {
        const std::string kind = kind_of_space(*outline.tags);
        return kind != "lift" && kind != "stairs" && kind != "escalator";
    });
    // If there are several buildings, only the surroundings of the chosen one are read. If there is only one, the whole
    // file is read.
    const auto with_rooms = std::count_if(buildings_.begin(), buildings_.end(),
                                          [](const Building& building) { return building.spaces > 0; });
    if (!options_.building.empty() || (rooms && with_rooms > 1)) around_building = true;
    if (!rooms)
        for (const OsmWay& way : data_.ways)
            if ((way.tags.has("highway") || is_platform(way.tags)) && all_known(way.nodes))
                for (const Ring& line : in_degrees({way.nodes}))
                    for (const Vec2& p : line) include(p);
    for (const OsmArea& area : data_.areas) {
        bool broken = false;
        if (rooms || !is_walked(area.tags)) continue;
        for (const std::vector<std::int64_t>& ring : rings_of(area, broken)) {
            if (!all_known(ring)) continue;
            const std::vector<Ring> outline = in_degrees({ring});
            std::for_each(outline[0].begin(), outline[0].end(), include);
        }
    }
    if (least.x > most.x) return;
    plane_ = floorplan::LocalPlane(0.5 * (least + most));
    if (!around_building || chosen_ == kNone) return;
    for (Ring ring : buildings_[chosen_].rings) {
        for (Vec2& p : ring) p = plane_.place_m(p);
        surroundings_of_.push_back(std::move(ring));
    }
}

Vec2 OsmPlan::place_of(std::int64_t node) const {
    const OsmNode& found = data_.nodes.at(node);
    return plane_.place_m({found.lon_deg, found.lat_deg});
}

std::vector<Ring> OsmPlan::placed(const std::vector<std::vector<std::int64_t>>& rings) const {
    std::vector<Ring> made;
    for (const std::vector<std::int64_t>& ring : rings) {
        made.emplace_back();
        for (const std::int64_t n : ring) made.back().push_back(place_of(n));
    }
    return made;
}

void OsmPlan::lay_levels() {
    std::set<double> numbers;
    for (const Outline& outline : outlines_) numbers.insert(outline.levels.begin(), outline.levels.end());
    if (numbers.empty()) numbers.insert(0.0);
    find_level_names();
    for (const double number : numbers) plan_.levels.push_back(level_made(number));
}

// Names each level after its relation or outline. If it has neither, its name is made of the tag level:ref of its
// outlines ("Level B1").
void OsmPlan::find_level_names() {
    const auto take = [&](std::string_view level, const std::string& name) {
        const OsmLevels levels = levels_of(level);
        if (levels.levels.size() == 1 && !name.empty()) level_names_.try_emplace(levels.levels[0], name);
    };
    for (const OsmTags& tags : data_.levels) take(tags["level"], std::string(in_spoken(tags, "name")));
    for (const OsmWay& way : data_.ways)
        if (way.tags.is("indoor", "level")) take(way.tags["level"], std::string(in_spoken(way.tags, "name")));
    for (const Outline& outline : outlines_)
        if (const std::string_view ref = (*outline.tags)["level:ref"]; !ref.empty())
            take((*outline.tags)["level"], phrase("osm.level_ref", {{"ref", std::string(ref)}}));
}

floorplan::PlanLevel OsmPlan::level_made(double number) const {
    const auto named = level_names_.find(number);
    return {number, named == level_names_.end() ? phrase("plan.level", {{"number", number}}) : named->second,
            number * plan_.storey_m};
}

std::size_t OsmPlan::level_at(double number) const {
    for (std::size_t l = 0; l < plan_.levels.size(); ++l)
        if (plan_.levels[l].number == number) return l;
    return kNone;
}

void OsmPlan::add_spaces() {
    int far = 0;
    for (const Outline& outline : outlines_) {
        const OsmTags& tags = *outline.tags;
        const std::string kind = kind_of_space(tags);
        floorplan::PlanSpace space;
        const bool open_sides = tags.is("indoor", "area"), corridor = tags.is("indoor", "corridor") ||
                                                                      tags.is("buildingpart", "corridor") ||
                                                                      tags.is("buildingpart", "hall");
        space.walled = !open_sides && !corridor;
        space.kind = kind == "stairs"      ? floorplan::PlanSpaceKind::Stairs
                     : kind == "escalator" ? floorplan::PlanSpaceKind::Escalator
                     : kind == "lift"      ? floorplan::PlanSpaceKind::Lift
                     : open_sides          ? floorplan::PlanSpaceKind::Area
                     : corridor            ? floorplan::PlanSpaceKind::Corridor
                                           : floorplan::PlanSpaceKind::Room;
        space.name = name_of_space(tags);
        space.number = tags["ref"];
        space.id = outline.id;
        space.facts = facts_of(tags);
        space.rings = placed(outline.rings);
        const bool near = std::all_of(space.rings.begin(), space.rings.end(), [](const Ring& ring) {
            return std::all_of(ring.begin(), ring.end(), [](const Vec2& p) { return glm::length(p) < kFarthest_m; });
        });
        if (!near) {
            ++far;
            continue;
        }
        for (const double number : outline.levels) space.levels.push_back(level_at(number));
        for (const std::vector<std::int64_t>& ring : outline.rings)
            for (const std::int64_t n : ring) {
                std::vector<std::size_t>& at = spaces_of_[n];
                if (at.empty() || at.back() != plan_.spaces.size()) at.push_back(plan_.spaces.size());
            }
        plan_.spaces.push_back(std::move(space));
    }
    report("osm.far", far);
}

void OsmPlan::add_doors() {
    const OutlineIndex outlines(plan_.spaces);
    for (const std::int64_t n : data_.tagged_nodes) {
        const OsmTags& tags = data_.nodes.at(n).tags;
        const std::string_view kind = tags["door"];
        if (kind.empty() && !tags.has("entrance")) continue;
        const Vec2 place = place_of(n);
        const auto [spaces, nearest] = outlines.spaces_at(plan_, place);
        if (spaces.empty()) {
            doors_alone_ += kind.empty() ? 0 : 1;
            continue;
        }
        OsmLevels levels = levels_of(tags["level"], tags["repeat_on"]);
        odd_levels_ += levels.damaged ? 1 : 0;
        // A door that states no level is on the levels of the outlines that contain its node, or else on those of the
        // nearest outline. Other outlines are ignored, because walls of other storeys often pass through the same
        // place.
        const auto part_of = spaces_of_.find(n);
        if (levels.levels.empty())
            for (const std::size_t s : part_of != spaces_of_.end() ? part_of->second : std::vector{nearest})
                for (const std::size_t l : plan_.spaces[s].levels) levels.levels.push_back(plan_.levels[l].number);
        std::sort(levels.levels.begin(), levels.levels.end());
        levels.levels.erase(std::unique(levels.levels.begin(), levels.levels.end()), levels.levels.end());
        floorplan::PlanDoor door;
        door.kind = kind == "no"                                ? floorplan::PlanDoorKind::Opening
                    : kind == "sliding" || kind == "overhead"   ? floorplan::PlanDoorKind::Sliding
                    : kind == "revolving" || kind == "trapdoor" ? floorplan::PlanDoorKind::Revolving
                                                                : floorplan::PlanDoorKind::Hinged;
        door.at = place;
        if (const double width_m = number_in(tags["width"]); width_m > 0.0) door.width_m = width_m;
        else if (const double own_m = number_in(tags["door:width"]); own_m > 0.0) door.width_m = own_m;
        door.name = in_spoken(tags, "name");
        door.id = phrase("osm.node", {{"id", std::to_string(n)}});
        const std::string_view entrance = tags["entrance"];
        door.entrance = entrance == "main"                              ? floorplan::PlanEntrance::Main
                        : entrance == "emergency" || entrance == "exit" ? floorplan::PlanEntrance::Emergency
                                                                        : floorplan::PlanEntrance::Plain;
        if (door.name.empty() && !entrance.empty() && entrance != "no")
            door.name = kind_words(entrance == "main"        ? "entrance_main"
                                   : entrance == "emergency" ? "entrance_emergency"
                                                             : "entrance");
        if (const std::string_view ref = tags["ref"]; !ref.empty() && !door.name.empty())
            door.name += " " + std::string(ref);
        door.by_itself = tags.has("automatic_door") && !tags.is("automatic_door", "no");
        for (const double number : levels.levels) {
            const std::size_t level = level_at(number);
            if (level == kNone) continue;
            std::vector<std::size_t> joined;
            for (const std::size_t s : spaces) {
                const std::vector<std::size_t>& own = plan_.spaces[s].levels;
                if (std::find(own.begin(), own.end(), level) != own.end()) joined.push_back(s);
            }
            if (joined.empty()) continue;
            door.levels.push_back(level);
            door.spaces.push_back(std::move(joined));
        }
        if (door.levels.empty()) ++doors_alone_;
        else plan_.doors.push_back(std::move(door));
    }
}

bool OsmPlan::rooms_are_joined() const {
    const bool rooms = std::any_of(plan_.spaces.begin(), plan_.spaces.end(), [](const floorplan::PlanSpace& space) {
        return space.kind == floorplan::PlanSpaceKind::Room || space.kind == floorplan::PlanSpaceKind::Corridor ||
               space.kind == floorplan::PlanSpaceKind::Area;
    });
    if (!rooms) return false;
    DisjointSets groups(plan_.spaces.size());
    for (const floorplan::PlanDoor& door : plan_.doors)
        for (const std::vector<std::size_t>& joined : door.spaces)
            for (std::size_t i = 1; i < joined.size(); ++i)
                groups.join(static_cast<std::uint32_t>(joined[0]), static_cast<std::uint32_t>(joined[i]));
    std::vector<std::size_t> size(plan_.spaces.size(), 0);
    std::size_t most = 0;
    for (std::uint32_t s = 0; s < size.size(); ++s) most = std::max(most, ++size[groups.find(s)]);
    return 2 * most >= size.size();
}

}  // namespace handrail::osm
