#include "worlds/exports/as_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/geometry/flat_parts.h"

namespace handrail {
namespace {

constexpr double kFinest_m = 1e-4, kSlabs_m = 0.3, kLeastStorey_m = 2.3, kMostStorey_m = 12.0;
constexpr double kLevel_m = 0.02;     // floors that are that near are level
constexpr double kStepDown_m = 0.3;   // from there on an opening is a drop
constexpr double kMostRaise_m = 1.5;  // of what is said to be raised or sunk

bool on_grid(double value) { return std::abs(value / kFinest_m - std::round(value / kFinest_m)) < 1e-3; }

struct Box {
    Vec2 least{1e300}, most{-1e300};
    bool plain = false;  // the outline is this rectangle
};

Box box_of(const std::vector<Ring>& rings) {
    Box box;
    for (const Ring& ring : rings)
        for (const Vec2& p : ring) box.least = glm::min(box.least, p), box.most = glm::max(box.most, p);
    const auto corner = [&](const Vec2& p) {
        return (std::abs(p.x - box.least.x) < 1e-6 || std::abs(p.x - box.most.x) < 1e-6) &&
               (std::abs(p.y - box.least.y) < 1e-6 || std::abs(p.y - box.most.y) < 1e-6);
    };
    box.plain =
        rings.size() == 1 && rings[0].size() == 4 && std::all_of(rings[0].begin(), rings[0].end(), corner) &&
        std::abs(std::abs(signed_area(rings[0])) - (box.most.x - box.least.x) * (box.most.y - box.least.y)) < 1e-6;
    return box;
}

class Writer {
public:
    Writer(const WordsHouse& house, const Scene& scene, WordLanguage language)
        : house_(house), scene_(scene), german_(language == WordLanguage::German), language_(language) {
        for (const WordsHouse::Room& room : house.rooms) boxes_.push_back(box_of(room.rings));
        std::map<std::pair<std::size_t, std::string>, int> count;
        for (std::size_t r = 0; r < house.rooms.size(); ++r) {
            std::string name = house.rooms[r].name;
            std::replace_if(
                name.begin(), name.end(), [](char c) { return c == '"' || static_cast<unsigned char>(c) < ' '; }, '\'');
            for (const std::string_view mark : {"„", "“", "”", "«", "»"})
                for (std::size_t at = name.find(mark); at != std::string::npos; at = name.find(mark))
                    name.replace(at, mark.size(), "'");
            if (name.empty()) name = std::string(words("Room", "Raum")) + " " + std::to_string(r + 1);
            const int same = ++count[{house.rooms[r].storey, folded(name)}];
            names_.push_back(same > 1 ? fmt::format("{} {}", name, same) : name);
        }
    }

    std::string write() {
        text_ += fmt::format("{}: {}.\n", words("Building", "Gebäude"), quoted(house_.name, true));
        text_ += german_ ? "Sprache: Deutsch.\n" : "Language: English.\n";
        if (house_.wall_m > 0.0)
            text_ +=
                fmt::format("{}: {} {}.\n", words("Walls", "Wände"), metres(house_.wall_m), words("thick", "dick"));
        for (const std::string& lost : house_.lost) text_ += "# " + one_line(lost) + "\n";
        std::vector<std::size_t> before;
        for (std::size_t s = 0; s < house_.storeys.size(); ++s) {
            const WordsHouse::Storey& storey = house_.storeys[s];
            text_ += fmt::format("\n{}: {}, {} {}, {} {}.\n", words("Storey", "Stockwerk"), quoted(storey.name),
                                 metres(storey.floor_m), words("above the ground", "über dem Boden"),
                                 metres(storey.height_m), words("high", "hoch"));
            before.clear();
            for (std::size_t r = 0; r < house_.rooms.size(); ++r) {
                if (house_.rooms[r].storey != s) continue;
                room(r, before);
                before.push_back(r);
            }
        }
        return text_;
    }

private:
    const char* words(const char* english, const char* german) const { return german_ ? german : english; }

    std::string number(double value) const {
        std::string text = fmt::format("{:.4f}", value);
        while (text.ends_with('0')) text.pop_back();
        if (text.ends_with('.')) text.pop_back();
        if (text == "-0") text = "0";
        if (german_) std::replace(text.begin(), text.end(), '.', ',');
        return text;
    }
    std::string metres(double value) const { return number(value) + (german_ ? " Meter" : " metres"); }

    std::string quoted(const std::string& name, bool whole = false) const {
        if (whole && name.find_first_of(".;!\"\n,:") == std::string::npos) return name;
        return needs_quotation_marks(name, language_) ? "\"" + name + "\"" : name;
    }

    std::string way(const Vec2& at) const {
        const std::string east = number(std::abs(at.x)), north = number(std::abs(at.y));
        if (german_)
            return fmt::format("{} Meter nach {} und {} Meter nach {}", east, at.x < 0 ? "Westen" : "Osten", north,
                               at.y < 0 ? "Süden" : "Norden");
        return fmt::format("{} metres {} and {} metres {}", east, at.x < 0 ? "west" : "east", north,
                           at.y < 0 ? "south" : "north");
    }
    std::string at(const Vec2& place) const { return words("at ", "bei ") + way(place); }

    static const char* side(int side, bool german) {
        constexpr std::array<const char*, 8> kEnglish{"north", "north-east", "east", "south-east",
                                                      "south", "south-west", "west", "north-west"},
            kGerman{"Norden", "Nordosten", "Osten", "Südosten", "Süden", "Südwesten", "Westen", "Nordwesten"};
        return (german ? kGerman : kEnglish)[static_cast<std::size_t>(side)];
    }

    // "north of Hall, flush with its west end": against one that is written before, where that is exact.
    std::string beside(std::size_t r, const std::vector<std::size_t>& before) const {
        const Box& own = boxes_[r];
        const auto exact = [](const Box& box) {
            return on_grid(box.least.x) && on_grid(box.least.y) && on_grid(box.most.x) && on_grid(box.most.y);
        };
        if (!exact(own)) return {};
        std::string best;
        int best_score = 1000;
        for (const std::size_t o : before) {
            const Box& other = boxes_[o];
            const bool alone = std::count_if(before.begin(), before.end(), [&](std::size_t b) {
                                   return folded(names_[b]) == folded(names_[o]);
                               }) == 1;
            if (!other.plain || !exact(other) || !alone) continue;
            for (const int s : {0, 2, 4, 6}) {
                const int axis = s == 0 || s == 4 ? 0 : 1, across = 1 - axis;
                const double gap =
                    s == 0 || s == 2 ? own.least[across] - other.most[across] : other.least[across] - own.most[across];
                const double common =
                    std::min(own.most[axis], other.most[axis]) - std::max(own.least[axis], other.least[axis]);
                if (std::abs(gap) > 1e-6 || common < 0.5) continue;
                const double low = own.least[axis] - other.least[axis], high = own.most[axis] - other.most[axis],
                             middle = 0.5 * (low + high);
                if (!on_grid(middle)) continue;
                std::string text = german_ ? fmt::format("{} von {}", german_side(s), quoted(names_[o]))
                                           : fmt::format("{} of {}", side(s, false), quoted(names_[o]));
                int score = 0;
                if (std::abs(middle) > 1e-6 && (std::abs(low) < 1e-6 || std::abs(high) < 1e-6)) {
                    const int end = axis == 0 ? (std::abs(low) < 1e-6 ? 6 : 2) : (std::abs(low) < 1e-6 ? 4 : 0);
                    text += german_ ? fmt::format(", bündig am {}n Ende", german_adjective(end))
                                    : fmt::format(", flush with its {} end", side(end, false));
                    score = 1;
                } else if (std::abs(middle) > 1e-6) {
                    const int to = axis == 0 ? (middle < 0 ? 6 : 2) : (middle < 0 ? 4 : 0);
                    text += german_ ? fmt::format(", {} weiter nach {}", metres(std::abs(middle)), side(to, true))
                                    : fmt::format(", {} further {}", metres(std::abs(middle)), side(to, false));
                    score = 2;
                }
                if (score >= best_score) continue;
                best_score = score;
                best = text;
            }
        }
        return best;
    }
    static const char* german_side(int s) {
        return s == 0 ? "nördlich" : s == 2 ? "östlich" : s == 4 ? "südlich" : "westlich";
    }
    static const char* german_adjective(int s) {
        return s == 0 ? "nördliche" : s == 2 ? "östliche" : s == 4 ? "südliche" : "westliche";
    }

    void room(std::size_t r, const std::vector<std::size_t>& before) {
        const WordsHouse::Room& room = house_.rooms[r];
        const Box& box = boxes_[r];
        text_ += fmt::format("\n{}: {}", words("Room", "Raum"), quoted(names_[r]));
        if (box.plain) {
            text_ += fmt::format(", {} {} {}", number(box.most.x - box.least.x), words("by", "mal"),
                                 metres(box.most.y - box.least.y));
            const std::string relation = beside(r, before);
            text_ += ", " + (relation.empty() ? words("corner at ", "Ecke bei ") + way(box.least) : relation);
        }
        if (room.kind != WordsHouse::Kind::Room)
            text_ += fmt::format(", {} {}",
                                 room.kind == WordsHouse::Kind::Stairs ? words("stairs to", "Treppe nach")
                                                                       : words("lift to", "Aufzug nach"),
                                 quoted(house_.storeys[room.to_storey].name));
        if (std::abs(room.raised_m) > kLevel_m)
            text_ += german_ ? fmt::format(", um {} {}", metres(std::abs(room.raised_m)),
                                           room.raised_m > 0.0 ? "erhöht" : "vertieft")
                             : fmt::format(", {} by {}", room.raised_m > 0.0 ? "raised" : "sunk",
                                           metres(std::abs(room.raised_m)));
        if (room.height_m > 0.0) text_ += fmt::format(", {} {}", metres(room.height_m), words("high", "hoch"));
        if (!room.floor_material.empty())
            text_ += german_ ? fmt::format(", Boden aus {}", material(room.floor_material))
                             : fmt::format(", floor of {}", material(room.floor_material));
        if (!box.plain)
            for (std::size_t i = 0; i < room.rings.size(); ++i) {
                text_ += fmt::format(", {}", i == 0 ? words("corners", "Ecken") : words("hole", "Loch"));
                for (std::size_t k = 0; k < room.rings[i].size(); ++k)
                    text_ += fmt::format("{} {} {}", k == 0 ? "" : ",", number(room.rings[i][k].x),
                                         number(room.rings[i][k].y));
            }
        text_ += ".\n";
        for (const WordsHouse::Door& door : house_.doors)
            if (!door.rooms.empty() && door.rooms[0] == r) write_door(door);
        for (const WordsHouse::Lift& lift : house_.lifts)
            if (lift.from == r) write_lift(lift);
        things(r);
    }

    std::string material(const std::string& name) const { return word_of_material(name, language_); }

    void write_lift(const WordsHouse::Lift& lift) {
        text_ += fmt::format("{} {} {} {}, {}, {} {} {}", words("Lift from", "Aufzug von"), quoted(names_[lift.from]),
                             words("to", "zu"), quoted(names_[lift.to]), at(lift.at_m), number(lift.size_m.x),
                             words("by", "mal"), metres(lift.size_m.y));
        if (!lift.name.empty()) text_ += fmt::format(", {} {}", words("called", "genannt"), quoted(lift.name));
        text_ += ".\n";
    }

    void write_door(const WordsHouse::Door& door) {
        if (door.drop_m > 0.0 && door.rooms.size() > 1) {
            text_ +=
                fmt::format("{} {} {} {} {} {}, {}, {} {}.\n", words("Drop of", "Kante von"), metres(door.drop_m),
                            words("from", "von"), quoted(names_[door.rooms[0]]), words("to", "zu"),
                            quoted(names_[door.rooms[1]]), at(door.at_m), metres(door.width_m), words("wide", "breit"));
            return;
        }
        text_ += door.opening   ? words("Opening", "Öffnung")
                 : door.sliding ? words("Sliding door", "Schiebetür")
                                : words("Door", "Tür");
        text_ += door.rooms.size() > 1 ? fmt::format(" {} {}", words("to", "zu"), quoted(names_[door.rooms[1]]))
                                       : std::string(words(" outside", " nach draußen"));
        text_ += fmt::format(", {}, {} {}", at(door.at_m), metres(door.width_m), words("wide", "breit"));
        if (door.by_itself) text_ += words(", opens by itself", ", öffnet sich von selbst");
        if (!door.name.empty()) text_ += fmt::format(", {} {}", words("called", "genannt"), quoted(door.name));
        text_ += ".\n";
    }

    void things(std::size_t r) {
        const WordsHouse::Room& room = house_.rooms[r];
        const WordsHouse::Storey& storey = house_.storeys[room.storey];
        const double floor_m = storey.floor_m + room.raised_m;
        if (things_.empty()) find_things();
        for (std::size_t f = 0; f < scene_.features.size(); ++f) {
            const Aabb& box = scene_.features[f].bounds_m;
            if (!things_[f] || box.min_m.z < floor_m - 0.1 || box.min_m.z > floor_m + storey.height_m - 0.2 ||
                !inside(room.rings, Vec2(box.centre_m())))
                continue;
            const Vec3 size = box.size_m();
            if (size.x > boxes_[r].most.x - boxes_[r].least.x || size.y > boxes_[r].most.y - boxes_[r].least.y)
                continue;
            const Feature& feature = scene_.features[f];
            text_ += fmt::format("{}: {}, {} {} {} {} {}, {}", words("Thing", "Ding"), quoted(spoken_name(feature)),
                                 number(size.x), words("by", "mal"), number(size.y), words("by", "mal"), metres(size.z),
                                 at(Vec2(box.centre_m())));
            if (box.min_m.z - floor_m > 0.01)
                text_ +=
                    fmt::format(", {} {}", metres(box.min_m.z - floor_m), words("above the floor", "über dem Boden"));
            if (const Material& made = scene_.material(feature.material);
                !made.name.empty() && !material_of_word(made.name).empty())
                text_ += fmt::format(", {} {}", words("made of", "aus"), material(made.name));
            if (feature.landmark) text_ += words(", landmark", ", Landmarke");
            if (feature.clue) text_ += words(", clue", ", Hinweis");
            text_ += ".\n";
            things_[f] = false;
        }
        for (const Start& start : scene_.starts)
            if (start.base && !base_written_ && std::abs(start.feet_m.z - floor_m) < 0.5 &&
                inside(room.rings, Vec2(start.feet_m))) {
                const int side_of = static_cast<int>(std::lround(start.heading_rad / (0.25 * kPi)) % 8 + 8) % 8;
                text_ += fmt::format("Start, {}, {} {}", at(Vec2(start.feet_m)), words("facing", "Blick nach"),
                                     side(side_of, german_));
                if (!start.name.empty())
                    text_ += fmt::format(", {} {}", words("called", "genannt"), quoted(start.name));
                text_ += ".\n";
                base_written_ = true;
            }
    }

    // Named things that stand: no doors, stairs, lifts, walls.
    void find_things() {
        things_.assign(scene_.features.size(), false);
        for (const Solid& solid : scene_.solids)
            if (solid.role == SolidRole::Solid && solid.feature) {
                const Feature& feature = scene_.features[solid.feature.value];
                things_[solid.feature.value] = feature.kind == FeatureKind::Object && !feature.made_name &&
                                               !feature.name.empty() && !feature.bounds_m.empty();
            }
        if (scene_.stated)
            for (const StatedPortal& portal : scene_.stated->portals)
                if (portal.feature) things_[portal.feature.value] = false;
    }

    const WordsHouse& house_;
    const Scene& scene_;
    bool german_ = false;
    WordLanguage language_;
    std::vector<Box> boxes_;
    std::vector<std::string> names_;
    std::vector<bool> things_;  // of each feature: still to be written
    bool base_written_ = false;
    std::string text_;
};

// "Stairs, Level 1" without the level that was put behind it.
std::string without_level(const std::string& name, const std::string& level) {
    const std::string end = phrase("plan.on_level", {{"name", ""}, {"level", level}});
    return name.size() > end.size() && name.ends_with(end) ? name.substr(0, name.size() - end.size()) : name;
}

bool same_outline(const StatedRoom& a, const StatedRoom& b) {
    if (a.rings.size() != b.rings.size()) return false;
    for (std::size_t i = 0; i < a.rings.size(); ++i) {
        if (a.rings[i].size() != b.rings[i].size()) return false;
        for (std::size_t k = 0; k < a.rings[i].size(); ++k)
            if (glm::length(a.rings[i][k] - b.rings[i][k]) > 0.01) return false;
    }
    return true;
}

// A lift without a shaft, which the file states by itself: one with a shaft has the name of that.
bool is_platform(const Scene& scene, const StatedPortal& portal) {
    const Feature* feature = scene.find(portal.feature);
    if (!feature || feature->bounds_m.empty() || portal.rooms.size() != 2 || !portal.guid.empty()) return false;
    return scene.stated->rooms[portal.rooms[0]].storey != scene.stated->rooms[portal.rooms[1]].storey;
}

// An opening between floors of which one lies a step below the other.
void note_drop(const WordsHouse& house, WordsHouse::Door& door) {
    const WordsHouse::Room &one = house.rooms[door.rooms[0]], &other = house.rooms[door.rooms[1]];
    if (one.kind != WordsHouse::Kind::Room || other.kind != WordsHouse::Kind::Room || one.storey != other.storey)
        return;
    const double down_m = one.raised_m - other.raised_m;
    if (std::abs(down_m) < kStepDown_m) return;
    if (down_m < 0.0) std::swap(door.rooms[0], door.rooms[1]);
    door.drop_m = std::abs(down_m);
}

std::string floor_material(const Scene& scene, const StatedRoom& room) {
    constexpr std::size_t kMostSurfaces = 5'000;
    if (scene.surfaces.size() > kMostSurfaces) return {};
    for (const SurfacePolygon& surface : scene.surfaces) {
        if (surface.normal.z < 0.9 || scene.material(surface.material).name.empty()) continue;
        Ring ring;
        for (const Vec3& p : surface.polygon.points_m) ring.emplace_back(p);
        if (!ring.empty() && std::abs(surface.polygon.points_m[0].z - room.floor_m) < 0.05 &&
            inside({ring}, Vec2(room.at_m)))
            return material_of_word(scene.material(surface.material).name);
    }
    return {};
}

}  // namespace

WordsHouse stated_house(const Scene& scene, WordLanguage language) {
    const StatedBuilding& stated = *scene.stated;
    WordsHouse house;
    house.name = spoken_name(scene);
    house.wall_m = stated.wall_m;
    const bool german = language == WordLanguage::German;
    // Storeys that rooms lie on, from below.
    const auto storey_of = [&](const StatedRoom& room) {
        if (room.storey < stated.storeys.size()) return room.storey;
        std::uint32_t best = 0;
        for (std::uint32_t s = 0; s < stated.storeys.size(); ++s)
            if (std::abs(stated.storeys[s].floor_m - room.floor_m) <
                std::abs(stated.storeys[best].floor_m - room.floor_m))
                best = s;
        return best;
    };
    std::map<std::uint32_t, double> heights;
    for (const StatedRoom& room : stated.rooms)
        heights[storey_of(room)] = std::max(heights[storey_of(room)], room.height_m + kSlabs_m);
    std::map<std::uint32_t, std::size_t> number;
    std::vector<std::pair<double, std::uint32_t>> order;
    for (const auto& [s, height] : heights)
        order.emplace_back(s < stated.storeys.size() ? stated.storeys[s].floor_m : 0.0, s);
    std::sort(order.begin(), order.end());
    for (const auto& [floor_m, s] : order) {
        number[s] = house.storeys.size();
        std::string name = s < stated.storeys.size() ? one_line(stated.storeys[s].name) : std::string();
        if (name.empty()) name = fmt::format("{} {}", german ? "Ebene" : "Level", number[s]);
        house.storeys.push_back({name, floor_m, std::clamp(heights[s], kLeastStorey_m, kMostStorey_m)});
    }
    for (std::size_t s = 0; s + 1 < house.storeys.size(); ++s)
        house.storeys[s].height_m =
            std::clamp(house.storeys[s + 1].floor_m - house.storeys[s].floor_m, kLeastStorey_m, kMostStorey_m);
    // Stairs and lifts that have one outline on all their storeys are one.
    std::vector<std::size_t> parent(stated.rooms.size());
    for (std::size_t r = 0; r < parent.size(); ++r) parent[r] = r;
    const auto root = [&](std::size_t r) {
        while (parent[r] != r) r = parent[r];
        return r;
    };
    std::map<std::size_t, WordsHouse::Kind> kinds;
    std::vector<const StatedPortal*> platforms;
    for (const StatedPortal& portal : stated.portals) {
        if (portal.kind != StatedPortalKind::Stairs && portal.kind != StatedPortalKind::Lift) continue;
        if (portal.kind == StatedPortalKind::Lift && is_platform(scene, portal)) {
            platforms.push_back(&portal);
            continue;
        }
        bool one = portal.rooms.size() > 1;
        for (const std::uint32_t r : portal.rooms) one &= same_outline(stated.rooms[r], stated.rooms[portal.rooms[0]]);
        if (!one) {
            std::string names;
            for (const std::uint32_t r : portal.rooms) names += (names.empty() ? "" : ", ") + stated.rooms[r].name;
            house.lost.push_back(
                german ? fmt::format("Treppe oder Aufzug ohne eigenen Raum: {} ({}).", portal.name, names)
                       : fmt::format("Stairs or lift without a room of its own: {} ({}).", portal.name, names));
            continue;
        }
        for (const std::uint32_t r : portal.rooms) parent[root(r)] = root(portal.rooms[0]);
        kinds[root(portal.rooms[0])] =
            portal.kind == StatedPortalKind::Lift ? WordsHouse::Kind::Lift : WordsHouse::Kind::Stairs;
    }
    std::map<std::size_t, std::size_t> room_of_root;
    std::vector<std::size_t> room_of(stated.rooms.size());
    for (std::size_t r = 0; r < stated.rooms.size(); ++r) {
        const StatedRoom& from = stated.rooms[r];
        const std::size_t storey = number.at(storey_of(from)), top = root(r);
        if (const auto found = room_of_root.find(top); found != room_of_root.end()) {
            WordsHouse::Room& room = house.rooms[found->second];
            room.storey = std::min(room.storey, storey);
            room.to_storey = std::max(room.to_storey, storey);
            room_of[r] = found->second;
            continue;
        }
        WordsHouse::Room room;
        room.name = one_line(from.name);
        room.storey = room.to_storey = storey;
        room.rings = from.rings;
        room.floor_material = floor_material(scene, from);
        if (const double raised_m = from.floor_m - house.storeys[storey].floor_m;
            std::abs(raised_m) > kLevel_m && std::abs(raised_m) <= kMostRaise_m && !kinds.contains(top))
            room.raised_m = std::round(raised_m / kFinest_m) * kFinest_m;
        if (const auto kind = kinds.find(top); kind != kinds.end()) {
            room.kind = kind->second;
            room.name = without_level(room.name, house.storeys[storey].name);
        } else if (from.height_m > 0.0 &&
                   from.height_m < house.storeys[storey].height_m - kSlabs_m - room.raised_m - 0.01) {
            room.height_m = from.height_m;
        }
        room_of[r] = room_of_root[top] = house.rooms.size();
        house.rooms.push_back(std::move(room));
    }
    for (const StatedPortal& portal : stated.portals) {
        if (portal.kind != StatedPortalKind::Door && portal.kind != StatedPortalKind::Opening) continue;
        WordsHouse::Door door;
        door.opening = portal.kind == StatedPortalKind::Opening;
        for (const std::uint32_t r : portal.rooms)
            if (door.rooms.size() < 2) door.rooms.push_back(room_of[r]);
        // Of stairs and a room the room tells the storey.
        if (door.rooms.size() > 1 && house.rooms[door.rooms[0]].kind != WordsHouse::Kind::Room)
            std::swap(door.rooms[0], door.rooms[1]);
        if (door.opening && door.rooms.size() > 1) note_drop(house, door);
        door.at_m = Vec2(portal.place_m);
        door.width_m = std::max(portal.width_m, 0.1);
        if (const Feature* feature = scene.find(portal.feature)) {
            if (!feature->made_name) door.name = one_line(feature->name);
            for (const Mover& mover : scene.movers)
                if (mover.feature == portal.feature) {
                    door.sliding = mover.lift == Mover{}.lift && glm::length(mover.slide_m) > 0.1;
                    door.by_itself = mover.lift == Mover{}.lift && !mover.approach_m.empty();
                }
        }
        if (door.rooms.empty()) {
            house.lost.push_back(german ? fmt::format("Eine Tür ohne Raum: {}.", portal.name)
                                        : fmt::format("A door of no room: {}.", portal.name));
            continue;
        }
        house.doors.push_back(std::move(door));
    }
    for (const StatedPortal* portal : platforms) {
        WordsHouse::Lift lift{one_line(portal->name), room_of[portal->rooms[0]], room_of[portal->rooms[1]]};
        if (house.rooms[lift.from].storey > house.rooms[lift.to].storey) std::swap(lift.from, lift.to);
        const Aabb& box = scene.find(portal->feature)->bounds_m;
        lift.at_m = Vec2(box.centre_m());
        lift.size_m = Vec2(box.size_m());
        house.lifts.push_back(std::move(lift));
    }
    return house;
}

std::string text_of(const WordsHouse& house, const Scene& scene, WordLanguage language) {
    return Writer(house, scene, language).write();
}

}  // namespace handrail
