#include "worlds/imdf/read_imdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/floorplan/guess_doorways.h"
#include "worlds/floorplan/local_plane.h"
#include "worlds/floorplan/upright.h"
#include "worlds/imdf/meet_buildings.h"
#include "worlds/imdf/zip_archive.h"

namespace handrail::imdf {
namespace {

using Json = nlohmann::json;

constexpr double kFarthest_m = 20'000.0;
constexpr std::size_t kMostFeatures = 60'000, kMostVertical = 3'000, kMostCorners = 2'000, kMostName = 200;
constexpr std::array<std::string_view, 10> kFiles{"venue",   "building", "level", "unit",     "opening",
                                                  "amenity", "fixture",  "kiosk", "occupant", "anchor"};

// Returns the feature type in a path: "somewhere/unit.geojson" gives "unit". Empty if the file is not part of IMDF.
std::string_view type_of(std::string_view path) {
    path = path.substr(path.rfind('/') == std::string_view::npos ? 0 : path.rfind('/') + 1);
    for (const std::string_view type : kFiles)
        if (path.starts_with(type) && (path.substr(type.size()) == ".geojson" || path.substr(type.size()) == ".json"))
            return type;
    return {};
}

// Returns the value of a key, or a null value if the key is missing. Never throws.
const Json& at(const Json& object, const char* key) {
    static const Json nothing;
    if (!object.is_object()) return nothing;
    const auto found = object.find(key);
    return found == object.end() ? nothing : *found;
}

std::string text(const Json& value) {
    return value.is_string() ? one_line(std::string_view(value.get_ref<const std::string&>()).substr(0, kMostName))
                             : std::string();
}

// Returns a text in one of several translations: in the spoken language, else in English, else in the first language.
// The language codes may include a country: "ja-JP".
std::string label(const Json& value) {
    if (value.is_string()) return text(value);
    if (!value.is_object()) return {};
    for (const std::string& wanted : {spoken_language(), std::string("en")})
        for (const auto& [language, words] : value.items())
            if (language.substr(0, language.find('-')) == wanted && !text(words).empty()) return text(words);
    for (const auto& [language, words] : value.items())
        if (!text(words).empty()) return text(words);
    return {};
}

bool position(const Json& value, Vec2& degrees) {
    if (!value.is_array() || value.size() < 2 || !value[0].is_number() || !value[1].is_number()) return false;
    degrees = {value[0].get<double>(), value[1].get<double>()};
    return std::isfinite(degrees.x) && std::isfinite(degrees.y) && std::abs(degrees.x) <= 180.0 &&
           std::abs(degrees.y) <= 85.0;
}

bool line_of(const Json& value, Ring& line) {
    if (!value.is_array() || value.size() > kMostCorners) return false;
    for (const Json& point : value) {
        Vec2 degrees;
        if (!position(point, degrees)) return false;
        line.push_back(degrees);
    }
    return line.size() > 1;
}

// Reads the rings of a Polygon or MultiPolygon, each of them closed. Returns false if the geometry is invalid.
bool rings_of(const Json& geometry, std::vector<Ring>& rings) {
    const Json& coordinates = at(geometry, "coordinates");
    const auto polygon = [&](const Json& value) {
        if (!value.is_array() || value.empty()) return false;
        for (const Json& own : value) {
            Ring ring;
            if (!line_of(own, ring)) return false;
            if (ring.size() > 3 && ring.front() == ring.back()) ring.pop_back();
            if (ring.size() < 3) return false;
            rings.push_back(std::move(ring));
        }
        return true;
    };
    const std::string type = text(at(geometry, "type"));
    if (type == "Polygon") return polygon(coordinates);
    if (type != "MultiPolygon" || !coordinates.is_array() || coordinates.empty()) return false;
    return std::all_of(coordinates.begin(), coordinates.end(), polygon);
}

class ImdfPlan {
public:
    explicit ImdfPlan(const ImdfOptions& options) : options_(options) {
        plan_.format = "imdf";
        plan_.schema = "IMDF";
        plan_.storey_m = kUsualStorey_m;
    }

    Result<floorplan::FloorPlan> build(const std::map<std::string, std::string>& files, const std::string& file_name) {
        for (const auto& [path, content] : files) {
            const Json read = Json::parse(content, nullptr, false);
            if (read.is_discarded())
                return fail(phrase("imdf.damaged", {{"file", one_line(path.substr(0, 80))}}), file_name);
            const Json& features = at(read, "features");
            std::vector<Json>& of_type = features_[std::string(type_of(path))];
            if (!features.is_array()) continue;
            if (features.size() > kMostFeatures) return fail(phrase("imdf.too_large"), file_name);
            for (const Json& feature : features)
                if (feature.is_object()) of_type.push_back(feature);
        }
        if (features_["unit"].empty()) return fail(phrase("imdf.no_units"), file_name);
        for (const Json& venue : features_["venue"])
            if (plan_.name.empty()) plan_.name = label(at(at(venue, "properties"), "name"));
        for (const Json& building : features_["building"])
            building_names_[text(at(building, "id"))] = label(at(at(building, "properties"), "name"));
        if (const Result<void> chosen = choose_building(file_name); !chosen) return tl::unexpected(chosen.error());
        find_ordinals();
        set_origin();
        if (wanted_building_.empty()) meet_buildings();
        lay_levels();
        add_units();
        if (plan_.spaces.empty()) return fail(phrase("imdf.no_units"), file_name);
        add_openings();
        add_things();
        const auto warn_count = [&](std::string_view key, int count) {
            if (count > 0) plan_.warnings.emplace_back(phrase(key, {{"n", count}}), phrase("osm.then_left_out"));
        };
        warn_count("imdf.damaged_shapes", damaged_);
        warn_count("imdf.no_level", no_level_);
        if (plan_.doors.empty()) plan_.left_out.push_back(phrase("imdf.no_openings"));
        if (const int guessed = floorplan::guess_doorways(plan_); guessed > 0)
            plan_.guessed.push_back(phrase("imdf.guessed_doorways", {{"n", guessed}}));
        if (occupants_lost_ > 0) plan_.left_out.push_back(phrase("imdf.occupants_lost", {{"n", occupants_lost_}}));
        if (own_categories_ > 0) plan_.simplified.push_back(phrase("imdf.own_categories", {{"n", own_categories_}}));
        return std::move(plan_);
    }

private:
    // If the options name a building, selects that building and its name.
    Result<void> choose_building(const std::string& file_name) {
        if (options_.building.empty()) return {};
        const std::string wanted = lower_ascii(options_.building);
        std::string names;
        int number = 0;
        for (const Json& building : features_["building"]) {
            const std::string id = text(at(building, "id")), name = building_names_[id];
            names += (names.empty() ? "" : ", ") + std::to_string(++number) + " " + name;
            if (wanted_building_.empty() &&
                (wanted == std::to_string(number) || lower_ascii(name).find(wanted) != std::string::npos)) {
                wanted_building_ = id;
                plan_.name = name;
            }
        }
        if (!wanted_building_.empty()) return {};
        return fail(
            phrase("osm.no_such_building", {{"wish", one_line(options_.building.substr(0, 60))}, {"names", names}}),
            file_name);
    }

    void find_ordinals() {
        for (const Json& level : features_["level"]) {
            const Json& properties = at(level, "properties");
            const Json& ordinal = at(properties, "ordinal");
            const double number = ordinal.is_number() ? ordinal.get<double>() : 0.0;
            if (!(std::abs(number) <= 300.0)) continue;
            const Json& buildings = at(properties, "building_ids");
            if (!wanted_building_.empty() && buildings.is_array() &&
                std::none_of(buildings.begin(), buildings.end(),
                             [&](const Json& id) { return text(id) == wanted_building_; }))
                continue;
            // A level that belongs to several buildings or to none gets an empty building id, and is not shifted with
            // any building.
            std::string building;
            if (buildings.is_array() && buildings.size() == 1) building = text(buildings[0]);
            levels_[text(at(level, "id"))] = {number, label(at(properties, "name")), building};
        }
    }

    void meet_buildings() {
        std::map<std::string, std::size_t> number_of{{"", 0}};  // the number of each building, by its id
        for (const auto& [id, level] : levels_) number_of.try_emplace(level.building, number_of.size());
        if (number_of.size() < 3) return;
        const auto level_named = [&](const Json& feature) {
            return levels_.find(text(at(at(feature, "properties"), "level_id")));
        };
        std::vector<VenueUnit> units;
        for (const Json& unit : features_["unit"]) {
            const auto level = level_named(unit);
            VenueUnit made;
            if (level == levels_.end() || !rings_of(at(unit, "geometry"), made.rings) || !placed(made.rings)) continue;
            made.building = number_of[level->second.building];
            made.ordinal = level->second.ordinal;
            units.push_back(std::move(made));
        }
        std::vector<VenueDoor> doors;
        for (const Json& opening : features_["opening"]) {
            const auto level = level_named(opening);
            std::vector<Ring> line(1);
            if (level == levels_.end() || !line_of(at(at(opening, "geometry"), "coordinates"), line[0]) ||
                !placed(line))
                continue;
            doors.push_back(
                {number_of[level->second.building], level->second.ordinal, 0.5 * (line[0].front() + line[0].back())});
        }
        const std::vector<double> shifts = shifts_of_buildings(number_of.size(), units, doors);
        for (auto& [id, level] : levels_) level.shift = shifts[number_of[level.building]];
        if (const auto moved = std::count_if(shifts.begin(), shifts.end(), [](double s) { return s != 0.0; }))
            plan_.guessed.push_back(phrase("imdf.buildings_meet", {{"n", moved}}));
    }

    // Merges levels at the same height into one. The merged level has the name that a building without a shift gives
    // it, if there is one.
    void lay_levels() {
        std::map<double, std::string> names;
        for (const bool moved : {false, true})
            for (const auto& [id, level] : levels_)
                if (std::string& name = names[level.ordinal + level.shift];
                    name.empty() && moved == (level.shift != 0.0))
                    name = level.name;
        for (const auto& [number, name] : names) {
            level_[number] = plan_.levels.size();
            plan_.levels.push_back(
                {number, name.empty() ? phrase("plan.level", {{"number", number}}) : name, number * plan_.storey_m});
        }
    }

    // Returns kNoLevel if the feature's level is missing or was not requested.
    std::size_t level_of(const Json& feature) {
        const auto found = levels_.find(text(at(at(feature, "properties"), "level_id")));
        return found == levels_.end() ? kNoLevel : level_.at(found->second.ordinal + found->second.shift);
    }

    void set_origin() {
        Vec2 least{1e300}, most{-1e300};
        for (const Json& unit : features_["unit"]) {
            std::vector<Ring> rings;
            const bool wanted = levels_.contains(text(at(at(unit, "properties"), "level_id")));
            if (!wanted || !rings_of(at(unit, "geometry"), rings)) continue;
            for (const Ring& ring : rings)
                for (const Vec2& p : ring) least = glm::min(least, p), most = glm::max(most, p);
        }
        if (least.x <= most.x) plane_ = floorplan::LocalPlane(0.5 * (least + most));
    }

    bool placed(std::vector<Ring>& rings) const {
        for (Ring& ring : rings)
            for (Vec2& p : ring) {
                p = plane_.place_m(p);
                if (!(glm::length(p) < kFarthest_m)) return false;
            }
        return true;
    }

    void add_units() {
        std::map<std::string, std::string> occupant_of = occupants();
        for (const Json& unit : features_["unit"]) {
            const Json& properties = at(unit, "properties");
            const std::size_t level = level_of(unit);
            if (level == kNoLevel) {
                no_level_ += wanted_building_.empty() ? 1 : 0;
                continue;
            }
            floorplan::PlanSpace space;
            if (!rings_of(at(unit, "geometry"), space.rings) || !placed(space.rings)) {
                ++damaged_;
                continue;
            }
            const std::string category = text(at(properties, "category")), id = text(at(unit, "id"));
            const auto begins = [&](std::string_view word) { return category.starts_with(word); };
            space.id = id;
            space.kind = begins("stairs")      ? floorplan::PlanSpaceKind::Stairs
                         : begins("escalator") ? floorplan::PlanSpaceKind::Escalator
                         : begins("elevator")  ? floorplan::PlanSpaceKind::Lift
                         : begins("walkway") || begins("movingwalkway") || begins("ramp")
                             ? floorplan::PlanSpaceKind::Corridor
                         : begins("platform") || begins("road") || begins("vegetation") || begins("parking") ||
                                 begins("opentobelow") || begins("unenclosedarea") || begins("lobby")
                             ? floorplan::PlanSpaceKind::Area
                             : floorplan::PlanSpaceKind::Room;
            if (begins("opentobelow") || begins("structure")) {
                ++own_categories_;
                continue;
            }
            space.walled =
                space.kind != floorplan::PlanSpaceKind::Corridor && space.kind != floorplan::PlanSpaceKind::Area;
            space.name = label(at(properties, "name"));
            if (space.name.empty()) space.name = label(at(properties, "alt_name"));
            if (const auto occupant = occupant_of.find(id); occupant != occupant_of.end())
                space.name = named_once(space.name, occupant->second);
            if (space.name.empty() && !category.empty()) space.name = capitalised(category_words(category));
            space.facts = facts(properties);
            space.levels = {level};
            unit_number_[id] = plan_.spaces.size();
            plan_.spaces.push_back(std::move(space));
        }
        join_vertical();
    }

    // Joins the unit's own name and that of its occupant. Many files write the same name in both places, which the
    // result then contains only once.
    static std::string named_once(const std::string& unit, const std::string& occupant) {
        return unit.empty() || lower_ascii(unit) == lower_ascii(occupant) ? occupant : unit + ", " + occupant;
    }

    // Returns the names of shops and other occupants, by the unit that they are in.
    std::map<std::string, std::string> occupants() {
        std::map<std::string, std::string> unit_of_anchor, found;
        for (const Json& anchor : features_["anchor"])
            unit_of_anchor[text(at(anchor, "id"))] = text(at(at(anchor, "properties"), "unit_id"));
        for (const Json& occupant : features_["occupant"]) {
            const Json& properties = at(occupant, "properties");
            const auto anchor = unit_of_anchor.find(text(at(properties, "anchor_id")));
            const std::string name = label(at(properties, "name"));
            if (anchor == unit_of_anchor.end() || anchor->second.empty()) ++occupants_lost_;
            else if (!name.empty()) found.try_emplace(anchor->second, name);
        }
        return found;
    }

    std::string category_words(const std::string& category) {
        std::string key = "imdf_kind." + category;
        std::replace(key.begin() + 10, key.end(), '.', '_');
        if (has_phrase(key)) return phrase(key);
        ++own_categories_;
        std::string words = category;
        for (char& c : words)
            if (c == '.' || c == '_') c = ' ';
        return words;
    }

    std::vector<std::string> facts(const Json& properties) {
        std::vector<std::string> said;
        const Json& accessible = at(properties, "accessibility");
        if (accessible.is_array())
            for (const Json& value : accessible)
                if (const std::string word = text(value); has_phrase("imdf_fact." + word))
                    said.push_back(phrase("imdf_fact." + word));
        const std::string restriction = text(at(properties, "restriction"));
        if (restriction == "employeesonly" || restriction == "restricted") said.push_back(phrase("osm_fact.private"));
        return said;
    }

    // Joins units for stairs and lifts that are above one another into one space. IMDF has a separate unit for them on
    // each level.
    void join_vertical() {
        std::vector<bool> gone(plan_.spaces.size(), false);
        std::vector<std::size_t> into(plan_.spaces.size()), vertical_before;
        for (std::size_t s = 0; s < plan_.spaces.size(); ++s) {
            into[s] = s;
            floorplan::PlanSpace& space = plan_.spaces[s];
            const bool vertical = space.kind == floorplan::PlanSpaceKind::Stairs ||
                                  space.kind == floorplan::PlanSpaceKind::Escalator ||
                                  space.kind == floorplan::PlanSpaceKind::Lift;
            if (!vertical || vertical_before.size() > kMostVertical) continue;
            Vec2 middle{0.0};
            for (const Vec2& p : space.rings[0]) middle += p / static_cast<double>(space.rings[0].size());
            for (const std::size_t t : vertical_before) {
                floorplan::PlanSpace& other = plan_.spaces[t];
                if (other.kind != space.kind || !inside(other.rings, middle) ||
                    std::find(other.levels.begin(), other.levels.end(), space.levels[0]) != other.levels.end())
                    continue;
                other.levels.push_back(space.levels[0]);
                std::sort(other.levels.begin(), other.levels.end());
                gone[s] = true;
                into[s] = t;
                break;
            }
            if (!gone[s]) vertical_before.push_back(s);
        }
        std::vector<std::size_t> place(plan_.spaces.size());
        std::vector<floorplan::PlanSpace> kept;
        for (std::size_t s = 0; s < plan_.spaces.size(); ++s)
            if (!gone[s]) {
                place[s] = kept.size();
                kept.push_back(std::move(plan_.spaces[s]));
            }
        for (auto& [id, number] : unit_number_) number = place[into[number]];
        plan_.spaces = std::move(kept);
    }

    void add_openings() {
        for (const Json& opening : features_["opening"]) {
            const Json& properties = at(opening, "properties");
            const std::size_t level = level_of(opening);
            Ring line;
            const Json& geometry = at(opening, "geometry");
            if (level == kNoLevel) continue;
            if (text(at(geometry, "type")) != "LineString" || !line_of(at(geometry, "coordinates"), line)) {
                ++damaged_;
                continue;
            }
            std::vector<Ring> one{std::move(line)};
            if (!placed(one)) {
                ++damaged_;
                continue;
            }
            const Vec2 from = one[0].front(), to = one[0].back();
            floorplan::PlanDoor door;
            door.at = 0.5 * (from + to);
            if (const double width_m = glm::length(to - from); width_m > 0.05) {
                door.along = (to - from) / width_m;
                door.width_m = width_m;
            }
            const Json& is = at(properties, "door");
            const std::string type = text(at(is, "type"));
            door.kind = type == "sliding"                   ? floorplan::PlanDoorKind::Sliding
                        : type == "revolving"               ? floorplan::PlanDoorKind::Revolving
                        : type == "open" || !is.is_object() ? floorplan::PlanDoorKind::Opening
                                                            : floorplan::PlanDoorKind::Hinged;
            const Json& automatic = at(is, "automatic");
            door.by_itself = automatic.is_boolean() && automatic.get<bool>();
            const std::string category = text(at(properties, "category"));
            door.entrance = category.find("principal") != std::string::npos ? floorplan::PlanEntrance::Main
                            : category.starts_with("emergencyexit")         ? floorplan::PlanEntrance::Emergency
                                                                            : floorplan::PlanEntrance::Plain;
            door.name = label(at(properties, "name"));
            door.id = text(at(opening, "id"));
            door.levels = {level};
            plan_.doors.push_back(std::move(door));
        }
    }

    void add_things() {
        const auto add = [&](const Json& feature, std::vector<Ring> parts, std::size_t level, double height_m) {
            const Json& properties = at(feature, "properties");
            floorplan::PlanThing thing;
            thing.name = label(at(properties, "name"));
            if (thing.name.empty()) thing.name = capitalised(category_words(text(at(properties, "category"))));
            for (const std::string& fact : facts(properties))
                thing.message += (thing.message.empty() ? "" : " ") + fact;
            thing.parts = std::move(parts);
            thing.height_m = height_m;
            thing.level = level;
            if (!thing.parts.empty()) plan_.things.push_back(std::move(thing));
        };
        for (const char* type : {"fixture", "kiosk"})
            for (const Json& feature : features_[type]) {
                std::vector<Ring> rings;
                const std::size_t level = level_of(feature);
                if (level == kNoLevel) continue;
                if (!rings_of(at(feature, "geometry"), rings) || !placed(rings)) ++damaged_;
                else add(feature, convex_parts(rings), level, std::string_view(type) == "kiosk" ? 2.0 : 0.8);
            }
        for (const Json& amenity : features_["amenity"]) {
            const Json& units = at(at(amenity, "properties"), "unit_ids");
            Vec2 degrees;
            if (!position(at(at(amenity, "geometry"), "coordinates"), degrees) || !units.is_array()) continue;
            for (const Json& id : units) {
                const auto unit = unit_number_.find(text(id));
                if (unit == unit_number_.end()) continue;
                const Vec2 at_m = plane_.place_m(degrees);
                if (inside(plan_.spaces[unit->second].rings, at_m))
                    add(amenity, {floorplan::strip(at_m - Vec2(0.2, 0.0), at_m + Vec2(0.2, 0.0), 0.2)},
                        plan_.spaces[unit->second].levels[0], 1.0);
                break;
            }
        }
    }

    static constexpr std::size_t kNoLevel = static_cast<std::size_t>(-1);

    const ImdfOptions& options_;
    floorplan::FloorPlan plan_;
    std::map<std::string, std::vector<Json>> features_;
    std::map<std::string, std::string> building_names_;
    struct Level {
        double ordinal = 0.0;
        std::string name, building;  // `building` is the id of the level's building
        double shift = 0.0;          // shift of the level's building, see meet_buildings.h
    };
    std::map<std::string, Level> levels_;
    std::map<double, std::size_t> level_;  // index in plan_.levels, by the shifted ordinal
    std::map<std::string, std::size_t> unit_number_;
    std::string wanted_building_;
    floorplan::LocalPlane plane_;
    int damaged_ = 0, no_level_ = 0, occupants_lost_ = 0, own_categories_ = 0;
};

}  // namespace

bool is_imdf(std::string_view bytes) {
    if (!bytes.starts_with("PK\x03\x04")) return false;
    // The directory with the file names is at the end of the archive.
    const std::string_view end = bytes.substr(bytes.size() > 70'000 ? bytes.size() - 70'000 : 0);
    return end.find("unit.geojson") != std::string_view::npos || end.find("unit.json") != std::string_view::npos ||
           (end.find("manifest.json") != std::string_view::npos && end.find(".geojson") != std::string_view::npos);
}

Result<Scene> read_imdf_venue(std::string_view bytes, const std::string& file_name, const ImdfOptions& options) {
    const Result<std::map<std::string, std::string>> files =
        unzip(bytes, file_name, [](std::string_view path) { return !type_of(path).empty(); });
    if (!files) return tl::unexpected(files.error());
    if (options.plan.progress) options.plan.progress(0.1);
    Result<floorplan::FloorPlan> plan = ImdfPlan(options).build(*files, file_name);
    if (!plan) return tl::unexpected(plan.error());
    if (options.plan.stop.stop_requested()) return fail(phrase("files.stopped"), file_name);
    return floorplan::scene_of_plan(std::move(*plan), file_name, options.plan);
}

}  // namespace handrail::imdf
