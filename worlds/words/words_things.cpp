// Places the doors, windows, things and starts of a room description.
#include <algorithm>
#include <cmath>

#include "worlds/base/text.h"
#include "worlds/words/words_plan.h"

namespace handrail::words {
namespace {

constexpr double kNextToDoor_m = 0.15, kWindow_m = 1.2, kWindowHigh_m = 1.2, kSill_m = 0.9, kProud_m = 0.02;
constexpr double kLeastThing_m = 0.05, kMostThing_m = 200.0, kOut_m = 0.4;
constexpr std::size_t kMostThings = 30'000;
// If a room contains more things than this, no free place is searched for, because the time grows with the square of
// their number.
constexpr std::size_t kMostLookedAt = 300;

// Returns the distance from a place to the nearest edge of an outline. `side` receives the ends of that edge.
double away_from(const std::vector<Ring>& rings, const Vec2& at, std::pair<Vec2, Vec2>* side = nullptr) {
    double least = 1e300;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()], way = b - a;
            const double part = std::clamp(glm::dot(at - a, way) / std::max(glm::dot(way, way), 1e-12), 0.0, 1.0);
            const double off = glm::length(at - a - way * part);
            if (off >= least) continue;
            least = off;
            if (side) *side = {a, b};
        }
    return least;
}

std::string wall_words(int side) {
    constexpr std::array<std::string_view, 4> kKeys{"rooms_text.wall0", "rooms_text.wall2", "rooms_text.wall4",
                                                    "rooms_text.wall6"};
    return phrase(kKeys[static_cast<std::size_t>(side / 2)]);
}

// Returns the wall of the room to which a border belongs: the side of the room nearest to the border's middle.
int side_of_border(const Vec2& from, const Vec2& to, const Vec2& least, const Vec2& most) {
    const Vec2 middle = 0.5 * (from + to);
    const std::array<double, 4> off{std::abs(most.y - middle.y), std::abs(most.x - middle.x),
                                    std::abs(middle.y - least.y), std::abs(middle.x - least.x)};
    return 2 * static_cast<int>(std::min_element(off.begin(), off.end()) - off.begin());
}

// Returns the middle of a thing at the wall on that side. `least` and `most` bound the places that the middle can have.
Vec2 middle_at_wall(int side, double along, const Vec2& least, const Vec2& most) {
    switch (side) {
        case 0:
            return {along, most.y};
        case 2:
            return {most.x, along};
        case 4:
            return {along, least.y};
        default:
            return {least.x, along};
    }
}

}  // namespace

std::size_t WordsPlan::level_for(const WordRoom& a, const WordRoom* b) const {
    // A room with stairs is on several levels. Chooses the level on which the other room is, too.
    const std::size_t own = level_of_[a.storey];
    if (!b) return own;
    const auto on = [](const WordRoom& room, std::size_t level) {
        return std::find(room.levels.begin(), room.levels.end(), level) != room.levels.end();
    };
    if (on(*b, own)) return own;
    for (const std::size_t level : a.levels)
        if (on(*b, level)) return level;
    return own;
}

// Finds a room with that name on a common storey. If there are several, it is the one with the longest shared border,
// or, if the sentence gives a position, the one nearest to that position.
std::size_t WordsPlan::beside(std::size_t r, const std::string& name, const SaidPart* at, Border& border) {
    constexpr double kNear_m = 1.0;
    const auto found = by_name_.find(name_key(name, speaker_.language));
    if (found == by_name_.end()) return kNoRoom;
    std::size_t best = kNoRoom;
    double best_score = 0.0;
    for (const std::size_t other : found->second) {
        const WordRoom &a = rooms_[r], &b = rooms_[other];
        const bool meet = std::any_of(a.levels.begin(), a.levels.end(), [&](std::size_t level) {
            return std::find(b.levels.begin(), b.levels.end(), level) != b.levels.end();
        });
        if (other == r || !meet) continue;
        const std::optional<Border> common = shared(a, b);
        if (at) {
            const Vec2 place = offset_of(*at);
            const double off = std::max(away_from(a.rings, place), away_from(b.rings, place));
            if (off > kNear_m || (best != kNoRoom && off >= best_score)) continue;
            best_score = off;
            border = common.value_or(Border{place, place});
        } else {
            if (!common || (best != kNoRoom && common->length() <= best_score)) continue;
            best_score = common->length();
            border = *common;
        }
        best = other;
    }
    return best;
}

double WordsPlan::along_wall(const Said& said, const WordRoom& room, const Border& wall, bool& placed) {
    const SaidPart *along = said.words.find(Statement::Along), *from = said.words.find(Statement::FromWall);
    placed = along || from || said.words.find(Statement::MiddleOf) || said.words.find(Statement::Middle);
    double at = 0.5 * wall.length();
    if (along) {
        at = along->numbers[0];
    } else if (from) {
        const int end = wall_side(room, from->sides[0]);
        const bool far_end = end == 0 || end == 2;
        at = far_end ? wall.length() - from->numbers[0] : from->numbers[0];
    }
    if (at < -1e-6 || at > wall.length() + 1e-6) {
        const double length = wall.length();
        warn(said.line, phrase("rooms_text.beyond_wall", {{"length", length}}), phrase("rooms_text.then_at_end"));
        at = std::clamp(at, 0.0, length);
    }
    return at;
}

bool WordsPlan::stated_before(const floorplan::PlanDoor& door, bool placed) const {
    constexpr double kSame_m = 0.6;
    for (const floorplan::PlanDoor& other : plan_.doors) {
        if (other.levels != door.levels || other.spaces != door.spaces || other.line == door.line) continue;
        if (door.spaces[0].size() < 2) continue;
        if (!placed || glm::length(other.at - door.at) < kSame_m) return true;
    }
    return false;
}

void WordsPlan::add_doors(std::size_t r) {
    for (const Said& said : rooms_[r].doors) {
        if (plan_.doors.size() >= kMostThings) return;
        if (said.words.kind == SentenceKind::Lift) add_lift(r, said);
        else if (said.words.kind == SentenceKind::Flight) add_flight(r, said);
        else add_door(said.words.kind == SentenceKind::Drop ? room_from(r, said) : r, said);
    }
}

std::size_t WordsPlan::room_over(std::size_t r, const std::string& name, const Vec2& place) const {
    std::size_t found = kNoRoom;
    double nearest_m = 1e300;
    const auto named = by_name_.find(name_key(name, speaker_.language));
    if (named == by_name_.end()) return kNoRoom;
    for (const std::size_t other : named->second) {
        if (other == r || rooms_[other].storey == rooms_[r].storey) continue;
        const double off_m = inside(rooms_[other].rings, place) ? 0.0 : away_from(rooms_[other].rings, place);
        if (off_m < nearest_m) nearest_m = off_m, found = other;
    }
    return found;
}

// The stairs rise from the lower of the two rooms. If the text gives no size, they are a metre wide and long enough to
// be easy to climb.
void WordsPlan::add_flight(std::size_t paragraph, const Said& said) {
    constexpr double kFlight_m = 1.0, kLeastFlight_m = 0.6, kMostFlight_m = 30.0, kEasySlope = 1.5;
    const std::size_t r = room_from(paragraph, said);
    const WordRoom& room = rooms_[r];
    const SaidPart *to = said.words.find(Statement::To), *at = said.words.find(Statement::At),
                   *size = said.words.find(Statement::Size2), *up = said.words.find(Statement::UpSide),
                   *back = said.words.find(Statement::UpAndBack), *called = said.words.find(Statement::Called);
    const Vec2 place = at ? offset_of(*at) : 0.5 * (room.least + room.most);
    const std::size_t other = to ? room_over(r, to->name, place) : kNoRoom;
    if (other == kNoRoom) {
        const std::string name = to ? one_line(to->name.substr(0, 100)) : std::string();
        warn(said.line, phrase("rooms_text.stairs_to_nowhere", {{"name", name}}), phrase("rooms_text.then_left_out"));
        return;
    }
    floorplan::PlanFlight flight;
    flight.name = called ? one_line(called->name.substr(0, 200)) : std::string();
    flight.line = said.line;
    // Stairs from a room on several storeys begin at its highest storey. Stairs to such a room lead to its lowest
    // storey.
    const bool rises = room.levels.back() < rooms_[other].levels.back();
    flight.from = rises ? r : other, flight.to = rises ? other : r;
    flight.high = rooms_[flight.to].levels.back();
    for (const std::size_t level : rooms_[flight.from].levels)
        if (level < flight.high) flight.low = level;
    for (const std::size_t level : rooms_[flight.to].levels)
        if (level > flight.low) flight.high = std::min(flight.high, level);
    const double rise_m = plan_.levels[flight.high].floor_m - plan_.levels[flight.low].floor_m;
    const SaidPart* side = back ? back : up;
    Vec2 wide = size ? Vec2(size->numbers[0], size->numbers[1]) : Vec2(kFlight_m, kEasySlope * rise_m);
    if (!size && side && side_direction(wall_side(room, side->sides[0])).x != 0.0) std::swap(wide.x, wide.y);
    wide = glm::clamp(wide, Vec2(kLeastFlight_m), Vec2(kMostFlight_m));
    flight.up = side              ? side_direction(wall_side(room, side->sides[0]))
                : wide.x > wide.y ? Vec2(1.0, 0.0)
                                  : Vec2(0.0, 1.0);
    flight.back = back != nullptr;
    flight.least = place - 0.5 * wide, flight.most = place + 0.5 * wide;
    plan_.flights.push_back(std::move(flight));
}

// A lift leads to the room of that name on another storey that contains the platform, or else to the nearest such room.
void WordsPlan::add_lift(std::size_t paragraph, const Said& said) {
    constexpr double kPlatform_m = 1.4, kLeastPlatform_m = 0.8, kMostPlatform_m = 20.0;
    const std::size_t r = room_from(paragraph, said);
    const WordRoom& room = rooms_[r];
    const SaidPart *to = said.words.find(Statement::To), *at = said.words.find(Statement::At),
                   *size = said.words.find(Statement::Size2), *called = said.words.find(Statement::Called);
    const Vec2 place = at ? offset_of(*at) : 0.5 * (room.least + room.most);
    const std::size_t other = to ? room_over(r, to->name, place) : kNoRoom;
    if (other == kNoRoom || room.levels.size() != 1 || rooms_[other].levels.size() != 1) {
        const std::string name = to ? one_line(to->name.substr(0, 100)) : std::string();
        warn(said.line, phrase("rooms_text.lift_to_nowhere", {{"name", name}}), phrase("rooms_text.then_left_out"));
        return;
    }
    Vec2 wide = size ? Vec2(size->numbers[0], size->numbers[1]) : Vec2(kPlatform_m);
    wide = glm::clamp(wide, Vec2(kLeastPlatform_m), Vec2(kMostPlatform_m));
    floorplan::PlanLift lift;
    lift.name = called ? one_line(called->name.substr(0, 200)) : std::string();
    lift.ring = {place - 0.5 * wide, place + Vec2(0.5, -0.5) * wide, place + 0.5 * wide,
                 place + Vec2(-0.5, 0.5) * wide};
    lift.line = said.line;
    const bool up = room.levels[0] < rooms_[other].levels[0];
    lift.from = up ? r : other, lift.to = up ? other : r;
    lift.low = rooms_[lift.from].levels[0], lift.high = rooms_[lift.to].levels[0];
    plan_.lifts.push_back(std::move(lift));
}

// A door to the outside is in the first wall that has no room behind it.
std::optional<WordsPlan::Border> WordsPlan::first_outer_wall(const WordRoom& room) {
    for (const int side : {4, 0, 6, 2}) {
        const Border wall = wall_of(room, side);
        const Vec2 beyond = wall.at(0.5 * wall.length()) + side_direction(side) * kOut_m;
        work_ += rooms_.size();
        if (std::none_of(rooms_.begin(), rooms_.end(), [&](const WordRoom& other) {
                return other.storey == room.storey && inside(other.rings, beyond);
            }))
            return wall;
    }
    return std::nullopt;
}

void WordsPlan::add_door(std::size_t r, const Said& said) {
    const WordRoom& room = rooms_[r];
    const SaidPart *to = said.words.find(Statement::To), *wide = said.words.find(Statement::Wide);
    const SaidPart* wall_said = nullptr;
    for (const Statement says : {Statement::InWall, Statement::MiddleOf, Statement::Along})
        if (const SaidPart* part = said.words.find(says); part && !part->sides.empty()) wall_said = part;
    if (wall_said && wall_said->sides[0] >= 8) left_and_right_ = true;
    const SaidPart* at = said.words.find(Statement::At);
    floorplan::PlanDoor door;
    door.kind = said.words.kind == SentenceKind::Opening || said.words.kind == SentenceKind::Drop
                    ? floorplan::PlanDoorKind::Opening
                : said.words.kind == SentenceKind::SlidingDoor ? floorplan::PlanDoorKind::Sliding
                                                               : floorplan::PlanDoorKind::Hinged;
    door.by_itself = said.words.find(Statement::ByItself) != nullptr;
    door.line = said.line;
    door.id = phrase("rooms_text.line", {{"line", said.line}});
    if (const SaidPart* called = said.words.find(Statement::Called)) door.name = one_line(called->name.substr(0, 200));
    if (wide) door.width_m = std::clamp(wide->numbers[0], 0.1, 100.0);
    Border border;
    std::size_t other = kNoRoom;
    bool placed = false;
    const auto lost = [&](const std::string& message) { warn(said.line, message, phrase("rooms_text.then_left_out")); };
    if (to && by_name_.find(name_key(to->name, speaker_.language)) == by_name_.end()) {
        lost(phrase("rooms_text.unknown_room",
                    {{"name", one_line(to->name.substr(0, 100))}, {"near", nearest_room(to->name)}}));
        return;
    }
    if (to) {
        other = beside(r, to->name, at, border);
        if (other == kNoRoom) {
            lost(phrase("rooms_text.not_beside",
                        {{"name", room_words(room)}, {"other", one_line(to->name.substr(0, 100))}}));
            return;
        }
    }
    if (at) {
        door.at = offset_of(*at);
        placed = true;
        if (!to) {
            std::pair<Vec2, Vec2> side;
            away_from(room.rings, door.at, &side);
            border = {side.first, side.second};
        }
    } else {
        Border wall = border;
        if (wall_said) {
            const int side = wall_side(room, wall_said->sides[0]);
            wall = wall_of(room, side);
            if (to && side != side_of_border(border.from, border.to, room.least, room.most)) {
                warn(said.line,
                     phrase("rooms_text.not_at_wall",
                            {{"other", room_words(rooms_[other])}, {"wall", wall_words(side)}}),
                     phrase("rooms_text.then_at_border"));
                wall = border;
                wall_said = nullptr;
            }
        } else if (!to) {
            const std::optional<Border> outer = first_outer_wall(room);
            if (!outer) {
                lost(phrase("rooms_text.no_outer_wall", {{"name", room_words(room)}}));
                return;
            }
            wall = *outer;
        } else if (said.words.find(Statement::Along) || said.words.find(Statement::FromWall)) {
            // The position is measured along the whole wall that the other room touches.
            const Border whole = wall_of(room, side_of_border(border.from, border.to, room.least, room.most));
            const auto off = [&](const Vec2& p) {
                const Vec2 way = whole.to - whole.from, rel = p - whole.from;
                return std::abs(way.x * rel.y - way.y * rel.x) / std::max(glm::length(way), 1e-9);
            };
            if (off(border.from) < kOut_m && off(border.to) < kOut_m) wall = whole;
        }
        double along = along_wall(said, room, wall, placed);
        // If the text gives no position and the other room shares only a part of the wall, the door is in the middle of
        // that part.
        if (!placed && to) {
            wall = border;
            along = 0.5 * wall.length();
        }
        door.at = wall.at(along);
        border = to ? border : wall;
        if (!placed && door.kind != floorplan::PlanDoorKind::Opening) ++middle_doors_;
    }
    if (door.kind == floorplan::PlanDoorKind::Opening && !wide)
        door.width_m = std::max(border.length() - plan_.wall_m - 0.04, 0.6);
    const WordRoom* there = other == kNoRoom ? nullptr : &rooms_[other];
    door.levels = {level_for(room, there)};
    std::vector<std::size_t> joined{r};
    if (there) joined.push_back(other);
    std::sort(joined.begin(), joined.end());
    door.spaces = {joined};
    const auto note = [&](std::size_t of, std::size_t to_room) {
        const WordRoom& here = rooms_[of];
        doors_of_[of].push_back(
            {door.at, door.width_m.value_or(0.9), side_of_border(door.at, door.at, here.least, here.most),
             to_room == kNoRoom ? std::string() : name_key(rooms_[to_room].said.words.name, speaker_.language)});
    };
    // Leaves out the second door if the author described one door in both of its rooms.
    if (stated_before(door, placed)) return;
    note(r, other);
    if (there) note(other, r);
    plan_.doors.push_back(std::move(door));
}

// Returns the wall of a window and the position along that wall, as the sentence states them. If the sentence gives a
// place, the wall is the side of the outline nearest to that place.
WordsPlan::InWall WordsPlan::place_of_window(const Said& said, const WordRoom& room) {
    if (const SaidPart* at = said.words.find(Statement::At)) {
        const Vec2 place = offset_of(*at);
        std::pair<Vec2, Vec2> found;
        away_from(room.rings, place, &found);
        const Border wall{found.first, found.second};
        const double along = glm::dot(place - wall.from, wall.to - wall.from) / std::max(wall.length(), 1e-9);
        return {wall, side_of_border(place, place, room.least, room.most), along};
    }
    int side = -1;
    for (const Statement says : {Statement::InWall, Statement::MiddleOf, Statement::Along, Statement::FromWall})
        if (const SaidPart* part = said.words.find(says); part && !part->sides.empty() && side < 0) {
            left_and_right_ |= part->sides[0] >= 8;
            side = wall_side(room, part->sides[0]);
        }
    if (side < 0) {
        warn(said.line, phrase("rooms_text.window_without_wall", {{"name", room_words(room)}}),
             phrase("rooms_text.then_north_wall"));
        side = 0;
    }
    const Border wall = wall_of(room, side);
    bool placed = false;
    return {wall, side, along_wall(said, room, wall, placed)};
}

void WordsPlan::add_windows(std::size_t r) {
    const WordRoom& room = rooms_[r];
    for (const Said& said : room.windows) {
        if (plan_.things.size() >= kMostThings) return;
        const auto [wall, side, along] = place_of_window(said, room);
        const SaidPart *wide = said.words.find(Statement::Wide), *high = said.words.find(Statement::High),
                       *sill = said.words.find(Statement::AboveFloor);
        const double width = std::clamp(wide ? wide->numbers[0] : kWindow_m, 0.2, std::max(wall.length() - 0.1, 0.2));
        floorplan::PlanThing window;
        const SaidPart* called = said.words.find(Statement::Called);
        window.name = called ? one_line(called->name.substr(0, 200)) : phrase("rooms_text.window");
        window.window = true;
        window.material = "glass";
        window.level = level_of_[room.storey];
        window.from_m = std::clamp(sill ? sill->numbers[0] : kSill_m, 0.0, 20.0) + room.raised_m.value_or(0.0);
        window.height_m = std::clamp(high ? high->numbers[0] : kWindowHigh_m, 0.1, 20.0);
        window.line = said.line;
        window.landmark = said.words.find(Statement::Landmark) != nullptr;
        window.clue = said.words.find(Statement::Clue) != nullptr;
        const double at = std::clamp(along, std::min(0.5 * width, 0.5 * wall.length()),
                                     std::max(wall.length() - 0.5 * width, 0.5 * wall.length()));
        const Vec2 way = (wall.to - wall.from) / std::max(wall.length(), 1e-9),
                   across = Vec2(-way.y, way.x) * (0.5 * plan_.wall_m + kProud_m);
        const Vec2 from = wall.at(at) - way * (0.5 * width), to = wall.at(at) + way * (0.5 * width);
        window.parts = {{from - across, to - across, to + across, from + across}};
        windows_here_.push_back({wall.at(at), width, side, {}});
        plan_.things.push_back(std::move(window));
    }
}

bool WordsPlan::stands_free(const WordRoom& room, const Vec2& at, const Vec2& half, bool doors_alone) const {
    constexpr double kBeforeDoor_m = 1.0, kWithin_m = 0.01;
    const Vec2 in(0.5 * plan_.wall_m - 1e-6);
    if (glm::any(glm::lessThan(at - half, room.least + in)) || glm::any(glm::greaterThan(at + half, room.most - in)))
        return false;
    for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
        if (!inside(room.rings, at + corner * glm::max(half - kWithin_m, Vec2(0.0)))) return false;
    for (const Opening& door : doors_here_)
        if (glm::length(glm::max(glm::abs(door.at - at) - half, Vec2(0.0))) <= kBeforeDoor_m) return false;
    return doors_alone || std::none_of(placed_here_.begin(), placed_here_.end(), [&](const Placed& other) {
               return glm::all(glm::greaterThan(other.most, at - half + 1e-6)) &&
                      glm::all(glm::lessThan(other.least, at + half - 1e-6));
           });
}

// Finds a place where the thing is out of the way. Tries these places in turn: a free corner; a free place along the
// walls or farther in; a place that keeps the doors free; the middle.
Vec2 WordsPlan::free_corner(const WordRoom& room, const Vec3& size_m) const {
    constexpr int kMostPlaces = 40;
    constexpr double kStep_m = 0.25;
    const Vec2 half(0.5 * size_m.x, 0.5 * size_m.y), in(0.5 * plan_.wall_m);
    const Vec2 least = room.least + in + half, most = room.most - in - half;
    for (const Vec2& at : {Vec2(least.x, most.y), most, Vec2(most.x, least.y), least})
        if (stands_free(room, at, half)) return at;
    const Vec2 span = glm::max(most - least, Vec2(0.0));
    const auto places = [&](double length) { return std::clamp(static_cast<int>(length / kStep_m), 1, kMostPlaces); };
    const int wide = places(span.x), deep = places(span.y);
    for (const bool doors_alone : {false, true}) {
        if (!doors_alone && placed_here_.size() > kMostLookedAt) continue;
        for (const bool along_walls : {true, false})
            for (int y = deep; y >= 0; --y)
                for (int x = 0; x <= wide; ++x) {
                    const bool at_wall = x == 0 || y == 0 || x == wide || y == deep;
                    const Vec2 at = least + span * Vec2(static_cast<double>(x) / wide, static_cast<double>(y) / deep);
                    if (at_wall == along_walls && stands_free(room, at, half, doors_alone)) return at;
                }
    }
    return 0.5 * (room.least + room.most);
}

Vec2 WordsPlan::nearest_free(const WordRoom& room, const Vec2& at, const Vec2& half) const {
    constexpr double kStep_m = 0.1;
    constexpr int kMostSteps = 100;
    if (placed_here_.size() > kMostLookedAt) return at;
    for (int step = 0; step <= kMostSteps; ++step)
        for (const int side : {2, 6, 0, 4, 1, 3, 5, 7})
            if (const Vec2 there = at + side_direction(side) * (kStep_m * step); stands_free(room, there, half))
                return there;
    return at;
}

// Places the thing at the first free side of the other thing. If there is none, uses the free place nearest to the
// other thing, or else the first side that is inside the room.
Vec2 WordsPlan::place_next_to(const Placed& other, const WordRoom& room, const Vec2& half) const {
    const double inside_m = 0.5 * plan_.wall_m;
    const Vec2 least = room.least + inside_m, most = room.most - inside_m, there = 0.5 * (other.least + other.most);
    const std::array<Vec2, 4> places{Vec2(other.most.x + half.x, there.y), Vec2(other.least.x - half.x, there.y),
                                     Vec2(there.x, other.most.y + half.y), Vec2(there.x, other.least.y - half.y)};
    for (const Vec2& place : places)
        if (stands_free(room, place, half)) return place;
    Vec2 nearest = there;
    double nearest_m = 1e300;
    for (const Vec2& place : places) {
        const Vec2 free = nearest_free(room, place, half);
        if (const double off_m = glm::length(free - there); off_m < nearest_m && stands_free(room, free, half))
            nearest_m = off_m, nearest = free;
    }
    if (nearest_m < 1e300) return nearest;
    for (const Vec2& place : places)
        if (glm::all(glm::greaterThanEqual(place - half, least - 1e-6)) &&
            glm::all(glm::lessThanEqual(place + half, most + 1e-6)))
            return place;
    return places[3];
}

// Returns the number of the side whose wall the sentence names; -1 if it names none.
int WordsPlan::stated_side(const Said& said, const WordRoom& room) {
    int side = -1;
    for (const Statement says : {Statement::InWall, Statement::MiddleOf, Statement::Along})
        if (const SaidPart* part = said.words.find(says); part && !part->sides.empty() && side < 0) {
            left_and_right_ |= part->sides[0] >= 8;
            side = wall_side(room, part->sides[0]);
        }
    return side;
}

// Returns the middle of the room, or the place at the stated distances from its walls. Returns nothing if the sentence
// states neither.
std::optional<Vec2> WordsPlan::place_from_walls(const Said& said, const WordRoom& room, const Vec3& size_m) {
    const double inside_m = 0.5 * plan_.wall_m;
    const Vec2 least = room.least + inside_m, most = room.most - inside_m;
    Vec2 place = 0.5 * (least + most);
    bool placed = said.words.find(Statement::Middle) != nullptr;
    for (const SaidPart& part : said.words.parts) {
        if (part.says != Statement::FromWall) continue;
        placed = true;
        const double away = part.numbers[0];
        switch (wall_side(room, part.sides[0])) {
            case 0:
                place.y = most.y - away - 0.5 * size_m.y;
                break;
            case 2:
                place.x = most.x - away - 0.5 * size_m.x;
                break;
            case 4:
                place.y = least.y + away + 0.5 * size_m.y;
                break;
            default:
                place.x = least.x + away + 0.5 * size_m.x;
                break;
        }
    }
    return placed ? std::optional(place) : std::nullopt;
}

Vec2 WordsPlan::place_of_thing(const Said& said, const WordRoom& room, Vec3& size_m, bool usual) {
    const double inside_m = 0.5 * plan_.wall_m;
    const Vec2 least = room.least + inside_m, most = room.most - inside_m;
    // Turns things of usual size so that the longer side is along the wall.
    const auto turn_to = [&](int side) {
        const bool upright = side == 2 || side == 6;
        if (usual && (size_m.x > size_m.y) == upright && size_m.x != size_m.y) std::swap(size_m.x, size_m.y);
    };
    const auto against = [&](int side, double along) {
        turn_to(side);
        return middle_at_wall(side, along, least + 0.5 * Vec2(size_m), most - 0.5 * Vec2(size_m));
    };
    const auto along_of = [&](int side, const Vec2& place) { return side == 0 || side == 4 ? place.x : place.y; };
    // If the text does not give the position along the wall, the nearest free position is used.
    const auto against_free = [&](int side, double along) {
        constexpr double kSlide_m = 0.1;
        constexpr int kMostSlides = 300;
        const Vec2 first = against(side, along), half(0.5 * size_m.x, 0.5 * size_m.y);
        const Vec2 way = side == 0 || side == 4 ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0);
        for (int slide = 0; slide <= kMostSlides && placed_here_.size() <= kMostLookedAt; ++slide)
            for (const double to : {1.0, -1.0})
                if (const Vec2 at = first + way * (to * kSlide_m * slide); stands_free(room, at, half)) return at;
        return first;
    };
    if (const SaidPart* at = said.words.find(Statement::At)) return offset_of(*at);
    if (const SaidPart* offset = said.words.find(Statement::Offset)) return room.least + offset_of(*offset);
    if (const SaidPart* corner = said.words.find(Statement::InCorner)) {
        const int side = std::min(corner->sides[0], 7);
        const bool north = side == 7 || side == 0 || side == 1, east = side >= 1 && side <= 3;
        turn_to(north ? 0 : 4);
        return {east ? most.x - 0.5 * size_m.x : least.x + 0.5 * size_m.x,
                north ? most.y - 0.5 * size_m.y : least.y + 0.5 * size_m.y};
    }
    const auto no_such = [&](const std::string& message) {
        warn(said.line, message, phrase("rooms_text.then_corner"));
        return free_corner(room, size_m);
    };
    if (said.words.find(Statement::ByWindow)) {
        if (windows_here_.empty()) return no_such(phrase("rooms_text.no_window", {{"name", room_words(room)}}));
        const Opening& window = windows_here_.front();
        return against_free(window.side, along_of(window.side, window.at));
    }
    if (const SaidPart* by_door = said.words.find(Statement::ByDoor)) {
        const Opening* door = nullptr;
        const std::string key = name_key(by_door->name, speaker_.language);
        for (const Opening& opening : doors_here_)
            if (!door && (by_door->name.empty() || opening.to == key)) door = &opening;
        if (!door) return no_such(phrase("rooms_text.no_door", {{"name", room_words(room)}}));
        turn_to(door->side);
        const bool level = door->side == 0 || door->side == 4;
        const double away = 0.5 * door->width_m + kNextToDoor_m + 0.5 * (level ? size_m.x : size_m.y);
        const double at = along_of(door->side, door->at);
        const double end = (level ? most.x : most.y) - 0.5 * (level ? size_m.x : size_m.y);
        return against(door->side, at + away <= end ? at + away : at - away);
    }
    if (const SaidPart* next = said.words.find(Statement::NextTo)) {
        const auto found = placed_things_.find(name_key(next->name, speaker_.language));
        if (found == placed_things_.end())
            return no_such(phrase("rooms_text.no_thing",
                                  {{"name", room_words(room)}, {"thing", one_line(next->name.substr(0, 100))}}));
        return place_next_to(found->second, room, Vec2(0.5 * size_m.x, 0.5 * size_m.y));
    }
    const int side = stated_side(said, room);
    if (side >= 0) {
        const Border wall = wall_of(room, side);
        bool placed = false;
        const double along = along_of(side, wall.at(along_wall(said, room, wall, placed)));
        return placed ? against(side, along) : against_free(side, along);
    }
    if (const auto place = place_from_walls(said, room, size_m)) return *place;
    ++without_place_;
    return free_corner(room, size_m);
}

void WordsPlan::add_things(std::size_t r) {
    const WordRoom& room = rooms_[r];
    for (const Said& said : room.things) {
        if (plan_.things.size() >= kMostThings) return;
        if (said.words.parts.empty() && !said.words.explicit_kind && !usually_known(said.words.name)) {
            warn(said.line, phrase("rooms_text.not_understood", {{"words", one_line(said.words.name.substr(0, 120))}}),
                 phrase("rooms_text.then_left_out"));
            continue;
        }
        for (int one = 0; one < said.words.count && plan_.things.size() < kMostThings; ++one)
            add_thing(room, said, one == 0);
    }
}

// `first` is true for the first of several things that the sentence mentions.
void WordsPlan::add_thing(const WordRoom& room, const Said& said, bool first) {
    const SaidPart *size3 = said.words.find(Statement::Size3), *size2 = said.words.find(Statement::Size2),
                   *high = said.words.find(Statement::High), *sill = said.words.find(Statement::AboveFloor);
    Vec3 size = usual_size_m(said.words.name);
    const SaidPart* flat = size3 ? size3 : size2;
    if (flat) size = Vec3(flat->numbers[0], flat->numbers[1], size.z);
    if (size3) size.z = size3->numbers[2];
    if (high) size.z = high->numbers[0];
    if (!flat) ++usual_sizes_;
    if (first && !flat && !said.words.explicit_kind && !usually_known(said.words.name))
        warn(said.line, phrase("rooms_text.unknown_thing", {{"name", one_line(said.words.name.substr(0, 100))}}),
             phrase("rooms_text.then_thing", {{"x", size.x}, {"y", size.y}, {"z", size.z}}));
    size = glm::clamp(size, Vec3(kLeastThing_m), Vec3(kMostThing_m));
    Vec2 at = place_of_thing(said, room, size, !flat);
    if (!first) at = nearest_free(room, at, Vec2(0.5 * size.x, 0.5 * size.y));
    const double inside_m = 0.5 * plan_.wall_m;
    const Vec2 half(0.5 * size.x, 0.5 * size.y), least = room.least + inside_m + half,
                                                 most = room.most - inside_m - half;
    const Vec2 within = glm::min(glm::max(at, least), glm::max(most, least));
    if (glm::length(within - at) > 0.01 && !said.words.find(Statement::At)) {
        warn(said.line,
             phrase("rooms_text.does_not_fit",
                    {{"thing", one_line(said.words.name.substr(0, 100))}, {"name", room_words(room)}}),
             phrase("rooms_text.then_moved_in"));
        at = within;
    }
    floorplan::PlanThing thing;
    thing.name = one_line(said.words.name.substr(0, 200));
    thing.level = level_of_[room.storey];
    thing.height_m = size.z;
    thing.from_m = (sill ? std::clamp(sill->numbers[0], 0.0, 20.0) : 0.0) + room.raised_m.value_or(0.0);
    thing.fixture = said.words.fixture;
    thing.landmark = said.words.find(Statement::Landmark) != nullptr;
    thing.clue = said.words.find(Statement::Clue) != nullptr;
    if (const SaidPart* made = said.words.find(Statement::MadeOf)) thing.material = made->name;
    thing.line = said.line;
    thing.parts = {{at - half, {at.x + half.x, at.y - half.y}, at + half, {at.x - half.x, at.y + half.y}}};
    placed_here_.push_back({at - half, at + half});
    placed_things_[name_key(thing.name, speaker_.language)] = placed_here_.back();
    plan_.things.push_back(std::move(thing));
}

void WordsPlan::add_start(const Said& said) {
    std::size_t r = start_rooms_[static_cast<std::size_t>(&said - starts_.data())];
    if (const SaidPart* in = said.words.find(Statement::In)) {
        const std::size_t named = room_named(in->name);
        if (named == kNoRoom)
            warn(said.line,
                 phrase("rooms_text.unknown_room",
                        {{"name", one_line(in->name.substr(0, 100))}, {"near", nearest_room(in->name)}}),
                 phrase("rooms_text.then_starts_in", {{"name", room_words(rooms_[r])}}));
        else r = named;
    }
    const WordRoom& room = rooms_[r];
    floorplan::PlanStart start;
    start.level = level_of_[room.storey];
    start.raised_m = room.raised_m.value_or(0.0);
    start.line = said.line;
    const SaidPart *called = said.words.find(Statement::Called), *facing = said.words.find(Statement::Facing);
    start.name = called ? one_line(called->name.substr(0, 200)) : room_words(room);
    if (facing) start.heading_rad = wall_side(room, facing->sides[0]) * 0.25 * kPi;
    if (facing && facing->sides[0] < 8) start.heading_rad = facing->sides[0] * 0.25 * kPi;
    windows_here_.clear();
    placed_things_.clear();
    placed_here_.clear();
    doors_here_ = doors_of_[r];
    Vec3 body(0.5, 0.5, 1.8);
    const int without = without_place_;
    start.at = place_of_thing(said, room, body, false);
    if (without_place_ > without) start.at = 0.5 * (room.least + room.most);
    without_place_ = without;
    // The middle of an outline with more than four corners may be outside of it.
    if (!inside(room.rings, start.at)) {
        double largest = 0.0;
        for (const Ring& part : convex_parts(room.rings))
            if (const double area = signed_area(part); area > largest) {
                largest = area;
                start.at = Vec2(0.0);
                for (const Vec2& p : part) start.at += p / static_cast<double>(part.size());
            }
    }
    plan_.starts.push_back(std::move(start));
}

}  // namespace handrail::words
