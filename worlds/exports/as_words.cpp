#include "worlds/exports/as_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/geometry/flat_parts.h"

namespace handrail::exports {
namespace {

constexpr double kFinest_m = 1e-4;
constexpr double kLevel_m = 0.02;  // two floors with a smaller difference in height are level with each other

bool on_grid(double value) { return std::abs(value / kFinest_m - std::round(value / kFinest_m)) < 1e-3; }

struct Box {
    Vec2 least{1e300}, most{-1e300};
    bool plain = false;  // true: the outline is exactly this rectangle
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

// Returns true if the ring is a hole by the even-odd rule, that is if an odd number of the other rings surround it.
bool is_hole(const std::vector<Ring>& rings, std::size_t which) {
    const Vec2 on = 0.5 * (rings[which][0] + rings[which][1]);
    int around = 0;
    for (std::size_t k = 0; k < rings.size(); ++k) around += k != which && handrail::inside({rings[k]}, on) ? 1 : 0;
    return around % 2 == 1;
}

class Writer {
public:
    Writer(const WordsHouse& house, const Scene& scene, words::WordLanguage language)
        : house_(house), scene_(scene), german_(language == words::WordLanguage::German), language_(language) {
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
            const int same = ++count[{house.rooms[r].storey, words::folded(name)}];
            names_.push_back(same > 1 ? fmt::format("{} {}", name, same) : name);
        }
    }

    std::string write() {
        text_ += fmt::format("{}: {}.\n", words("Building", "Gebäude"), quoted(house_.name, true));
        text_ += german_ ? "Sprache: Deutsch.\n" : "Language: English.\n";
        write_walls();
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
        return words::needs_quotation_marks(name, language_) ? "\"" + name + "\"" : name;
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

    // Describes the place of room `r` relative to a room that is already written: "north of Hall, flush with its west
    // end". Returns nothing if that description would not be exact.
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
                                   return words::folded(names_[b]) == words::folded(names_[o]);
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
                text_ += fmt::format(", {}", is_hole(room.rings, i) ? words("hole", "Loch")
                                             : i == 0               ? words("corners", "Ecken")
                                                                    : words("and corners", "und Ecken"));
                for (std::size_t k = 0; k < room.rings[i].size(); ++k)
                    text_ += fmt::format("{} {} {}", k == 0 ? "" : ",", number(room.rings[i][k].x),
                                         number(room.rings[i][k].y));
            }
        text_ += ".\n";
        for (const WordsHouse::Door& door : house_.doors)
            if (!door.rooms.empty() && door.rooms[0] == r) write_door(door);
        for (const WordsHouse::Lift& lift : house_.lifts)
            if (lift.from == r) write_lift(lift);
        for (const WordsHouse::Flight& flight : house_.flights)
            if (flight.from == r) write_flight(flight);
        things(r);
    }

    void write_walls() {
        std::string said;
        if (house_.wall_m > 0.0) said = fmt::format("{} {}", metres(house_.wall_m), words("thick", "dick"));
        if (!words::material_of_word(house_.wall_material).empty())
            said += fmt::format("{}{} {}", said.empty() ? "" : ", ", words("made of", "aus"),
                                material(house_.wall_material));
        if (!said.empty()) text_ += fmt::format("{}: {}.\n", words("Walls", "Wände"), said);
    }

    std::string material(const std::string& name) const { return words::word_of_material(name, language_); }

    void write_lift(const WordsHouse::Lift& lift) {
        text_ += fmt::format("{} {} {} {}, {}, {} {} {}", words("Lift from", "Aufzug von"), quoted(names_[lift.from]),
                             words("to", "zu"), quoted(names_[lift.to]), at(lift.at_m), number(lift.size_m.x),
                             words("by", "mal"), metres(lift.size_m.y));
        if (!lift.name.empty()) text_ += fmt::format(", {} {}", words("called", "genannt"), quoted(lift.name));
        text_ += ".\n";
    }

    void write_flight(const WordsHouse::Flight& flight) {
        text_ += fmt::format("{} {} {} {}, {}, {} {} {}, {} {}", words("Stairs from", "Treppe von"),
                             quoted(names_[flight.from]), words("to", "zu"), quoted(names_[flight.to]), at(flight.at_m),
                             number(flight.size_m.x), words("by", "mal"), metres(flight.size_m.y),
                             words("up to the", "hinauf nach"), side(flight.side, german_));
        if (flight.back) text_ += words(" and back", " und zurück");
        if (!flight.name.empty()) text_ += fmt::format(", {} {}", words("called", "genannt"), quoted(flight.name));
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

    // The side of an outline to which a window pane belongs: the nearest side that runs along the pane.
    struct Side {
        std::size_t ring = 0, corner = 0;
        Vec2 at{0.0};
        double along_m = 0.0, wide_m = 0.0;
    };
    Side side_of_pane(const WordsHouse::Room& room, const Aabb& box) const {
        Side best;
        double best_m = 1e300;
        const Vec2 middle(box.centre_m()), size(box.size_m());
        for (std::size_t k = 0; k < room.rings.size(); ++k)
            for (std::size_t i = 0; i < room.rings[k].size(); ++i) {
                const Ring& ring = room.rings[k];
                const Vec2 &a = ring[i], way = ring[(i + 1) % ring.size()] - a;
                const double length = glm::length(way);
                if (length < 1e-6) continue;
                const Vec2 along = way / length, flat = glm::abs(along);
                const double at_m = std::clamp(glm::dot(middle - a, along), 0.0, length);
                const double off_m = glm::length(middle - a - along * at_m) + size.x * flat.y + size.y * flat.x;
                if (off_m >= best_m) continue;
                best_m = off_m;
                best = {k, i, a + along * at_m, at_m, glm::dot(size, flat)};
            }
        return best;
    }

    void write_window(const WordsHouse::Thing& window, const WordsHouse::Room& room, const Box& box, double floor_m) {
        const Side found = side_of_pane(room, window.box_m);
        text_ += words("Window", "Fenster");
        if (box.plain) {
            // In a rectangle, the text names the side by its wall and measures from the west or south.
            const bool level = std::abs(found.at.y - box.most.y) < 1e-6 || std::abs(found.at.y - box.least.y) < 1e-6;
            const int wall = level ? (std::abs(found.at.y - box.most.y) < 1e-6 ? 0 : 4)
                                   : (std::abs(found.at.x - box.most.x) < 1e-6 ? 2 : 6);
            text_ += german_ ? fmt::format(" in der {}n Wand", german_adjective(wall))
                             : fmt::format(" in the {} wall", side(wall, false));
            text_ += fmt::format(", {} {}", metres(level ? found.at.x - box.least.x : found.at.y - box.least.y),
                                 words("along", "entlang"));
        } else {
            text_ += ", " + at(found.at);
        }
        text_ += fmt::format(", {} {}, {} {}, {} {}", metres(found.wide_m), words("wide", "breit"),
                             metres(window.box_m.size_m().z), words("high", "hoch"),
                             metres(std::max(window.box_m.min_m.z - floor_m, 0.0)),
                             words("above the floor", "über dem Boden"));
        if (!window.name.empty()) text_ += fmt::format(", {} {}", words("called", "genannt"), quoted(window.name));
    }

    void write_thing(const WordsHouse::Thing& thing, double floor_m) {
        const Vec3 size = thing.box_m.size_m();
        text_ += fmt::format("{}: {}, {} {} {} {} {}, {}",
                             thing.fixture ? words("Fixture", "Einbau") : words("Thing", "Ding"), quoted(thing.name),
                             number(size.x), words("by", "mal"), number(size.y), words("by", "mal"), metres(size.z),
                             at(Vec2(thing.box_m.centre_m())));
        if (thing.box_m.min_m.z - floor_m > 0.01)
            text_ += fmt::format(", {} {}", metres(thing.box_m.min_m.z - floor_m),
                                 words("above the floor", "über dem Boden"));
        if (!words::material_of_word(thing.material).empty())
            text_ += fmt::format(", {} {}", words("made of", "aus"), material(thing.material));
    }

    void things(std::size_t r) {
        const WordsHouse::Room& room = house_.rooms[r];
        const double floor_m = house_.storeys[room.storey].floor_m + room.raised_m;
        for (const WordsHouse::Thing& thing : house_.things) {
            if (thing.room != r) continue;
            if (thing.window) write_window(thing, room, boxes_[r], floor_m);
            else write_thing(thing, floor_m);
            if (thing.landmark) text_ += words(", landmark", ", Landmarke");
            if (thing.clue) text_ += words(", clue", ", Hinweis");
            text_ += ".\n";
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

    const WordsHouse& house_;
    const Scene& scene_;
    bool german_ = false;
    words::WordLanguage language_;
    std::vector<Box> boxes_;
    std::vector<std::string> names_;
    bool base_written_ = false;
    std::string text_;
};

}  // namespace

std::string text_of(const WordsHouse& house, const Scene& scene, words::WordLanguage language) {
    return Writer(house, scene, language).write();
}

}  // namespace handrail::exports
