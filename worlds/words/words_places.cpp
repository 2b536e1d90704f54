// Places the rooms of a room description.
#include <algorithm>
#include <cmath>

#include "worlds/base/text.h"
#include "worlds/words/words_plan.h"

namespace handrail::words {

Vec2 side_direction(int side) {
    constexpr std::array<Vec2, 8> kSides{Vec2(0, 1),  Vec2(1, 1),   Vec2(1, 0),  Vec2(1, -1),
                                         Vec2(0, -1), Vec2(-1, -1), Vec2(-1, 0), Vec2(-1, 1)};
    // Compass directions of left, right, front and back on a page with north at the top.
    constexpr std::array<int, 4> kSeen{6, 2, 4, 0};
    return kSides[static_cast<std::size_t>(side < 8 ? side : kSeen[static_cast<std::size_t>(side - 8)])];
}

Vec2 offset_of(const SaidPart& part) {
    Vec2 offset{0.0};
    for (std::size_t i = 0; i < std::min(part.numbers.size(), part.sides.size()); ++i)
        offset += side_direction(part.sides[i]) * part.numbers[i];
    return offset;
}

namespace {

constexpr double kLeastSide_m = 0.2, kMostSide_m = 1000.0, kFarthest_m = 5000.0, kTouch_m = 0.3;
constexpr double kLeastRoom_m2 = 0.05, kLeastPiece_m2 = 1e-4;
constexpr std::size_t kMostCornersOfOne = 1500;

// Returns pairs of numbers as an outline. Empty if they do not form an outline.
std::optional<Ring> ring_of(const std::vector<double>& numbers) {
    Ring ring;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        const Vec2 p(numbers[i], numbers[i + 1]);
        if (!(std::abs(p.x) < kFarthest_m && std::abs(p.y) < kFarthest_m)) return std::nullopt;
        if (ring.empty() || glm::length(p - ring.back()) > 1e-3) ring.push_back(p);
    }
    while (ring.size() > 1 && glm::length(ring.front() - ring.back()) < 1e-3) ring.pop_back();
    if (ring.size() < 3 || ring.size() > kMostCornersOfOne || std::abs(signed_area(ring)) < kLeastPiece_m2)
        return std::nullopt;
    return ring;
}

}  // namespace

void WordsPlan::set_box(WordRoom& room, const Vec2& least) {
    // Positions are rounded to a tenth of a millimetre, so that numbers are read back as they were written.
    const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4; };
    Vec2 from = glm::clamp(least, Vec2(-kFarthest_m), Vec2(kFarthest_m));
    from = {rounded(from.x), rounded(from.y)};
    const Vec2 to = {rounded(from.x + room.size_m.x), rounded(from.y + room.size_m.y)};
    room.rings = {{from, {to.x, from.y}, to, {from.x, to.y}}};
    room.least = from;
    room.most = to;
}

void WordsPlan::set_sizes() {
    for (WordRoom& room : rooms_) {
        const int line = room.said.line;
        if (const SaidPart* corners = room.said.words.find(Statement::CornerList)) {
            std::vector<Ring> rings;
            bool damaged = false;
            for (const SaidPart& part : room.said.words.parts) {
                if (part.says != Statement::CornerList && part.says != Statement::Hole) continue;
                std::optional<Ring> ring = ring_of(part.numbers);
                damaged |= !ring;
                if (ring) rings.push_back(std::move(*ring));
            }
            rings = joined_rings(rings);
            if (!rings.empty() && !damaged && std::abs(signed_area(rings[0])) >= kLeastRoom_m2) {
                room.rings = std::move(rings);
                room.least = Vec2(1e300), room.most = Vec2(-1e300);
                for (const Ring& ring : room.rings)
                    for (const Vec2& p : ring) room.least = glm::min(room.least, p), room.most = glm::max(room.most, p);
                room.size_m = room.most - room.least;
                continue;
            }
            warn(line, phrase("rooms_text.odd_corners", {{"name", room_words(room)}, {"n", corners->numbers.size()}}),
                 phrase("rooms_text.then_size"));
            continue;
        }
        const SaidPart* size = room.said.words.find(Statement::Size2);
        if (!size) {
            warn(line, phrase("rooms_text.no_size", {{"name", room_words(room)}}), phrase("rooms_text.then_size"));
            continue;
        }
        const Vec2 stated_m(size->numbers[0], size->numbers[1]);
        const bool fits = stated_m.x >= kLeastSide_m && stated_m.y >= kLeastSide_m && stated_m.x <= kMostSide_m &&
                          stated_m.y <= kMostSide_m;
        if (fits) room.size_m = stated_m;
        else warn(line, phrase("rooms_text.odd_size", {{"name", room_words(room)}}), phrase("rooms_text.then_size"));
    }
}

bool WordsPlan::place_against(WordRoom& room, const SaidPart& where, const WordRoom& other) {
    if (other.rings.empty()) return false;
    const Vec2 way = where.says == Statement::Above || where.sides.empty() ? Vec2(0.0) : side_direction(where.sides[0]);
    const double gap = where.numbers.empty() ? 0.0 : where.numbers[0];
    const Vec2 middle = 0.5 * (other.least + other.most), half = 0.5 * room.size_m;
    Vec2 least{0.0};
    const SaidPart* flush = room.said.words.find(Statement::Flush);
    for (int axis = 0; axis < 2; ++axis) {
        const double to = way[axis];
        double from = middle[axis] - half[axis];
        if (to > 0) from = other.most[axis] + gap;
        else if (to < 0) from = other.least[axis] - gap - room.size_m[axis];
        else if (flush && side_direction(flush->sides[0])[axis] > 0) from = other.most[axis] - room.size_m[axis];
        else if (flush && side_direction(flush->sides[0])[axis] < 0) from = other.least[axis];
        least[axis] = from;
    }
    for (const SaidPart& part : room.said.words.parts)
        if (part.says == Statement::Further) least += side_direction(part.sides[0]) * part.numbers[0];
    set_box(room, least);
    return true;
}

void WordsPlan::place_by_assumption(std::size_t r) {
    WordRoom& room = rooms_[r];
    // Places the room east of the previous room on its storey. The first room of a storey is placed above the first
    // room of the text.
    const WordRoom* before = nullptr;
    for (std::size_t i = r; i-- > 0 && !before;)
        if (rooms_[i].storey == room.storey && !rooms_[i].rings.empty()) before = &rooms_[i];
    for (std::size_t i = 0; i < rooms_.size() && !before; ++i)
        if (rooms_[i].storey == room.storey && !rooms_[i].rings.empty()) before = &rooms_[i];
    if (before) {
        SaidPart east;
        east.says = Statement::SideOf;
        east.sides = {2};
        warn(room.said.line, phrase("rooms_text.no_place", {{"name", room_words(room)}}),
             phrase("rooms_text.then_east", {{"name", room_words(*before)}}));
        place_against(room, east, *before);
        return;
    }
    const bool first = r == 0 || rooms_[0].rings.empty();
    set_box(room, first ? Vec2(0.0) : rooms_[0].least);
    if (!first)
        warn(room.said.line, phrase("rooms_text.no_place", {{"name", room_words(room)}}),
             phrase("rooms_text.then_above", {{"name", room_words(rooms_[0])}}));
}

void WordsPlan::place_rooms() {
    struct Relation {
        const SaidPart* part = nullptr;
        std::size_t other = kNoRoom;
    };
    std::vector<Relation> relations(rooms_.size());
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        WordRoom& room = rooms_[r];
        if (!room.rings.empty()) continue;
        if (const SaidPart* corner = room.said.words.find(Statement::CornerAt)) {
            set_box(room, offset_of(*corner));
            continue;
        }
        const SaidPart* where = room.said.words.find(Statement::SideOf);
        if (!where) where = room.said.words.find(Statement::Above);
        if (!where) continue;
        // If the sentence contains "above" or "below", the named room must be on another storey.
        std::size_t other = room_named(where->name, r);
        if (where->says == Statement::Above)
            if (const auto same = by_name_.find(name_key(where->name, speaker_.language)); same != by_name_.end())
                for (const std::size_t o : same->second)
                    if (rooms_[o].storey != room.storey) other = o;
        if (other == kNoRoom) {
            warn(room.said.line,
                 phrase("rooms_text.unknown_room",
                        {{"name", one_line(where->name.substr(0, 100))}, {"near", nearest_room(where->name)}}),
                 phrase("rooms_text.then_place_open"));
            continue;
        }
        relations[r] = {where, other};
    }
    if (rooms_[0].rings.empty() && !relations[0].part) set_box(rooms_[0], Vec2(0.0));
    for (;;) {
        bool moved = false, open = false;
        for (std::size_t r = 0; r < rooms_.size(); ++r) {
            if (!rooms_[r].rings.empty()) continue;
            ++work_;
            const bool done =
                relations[r].part && place_against(rooms_[r], *relations[r].part, rooms_[relations[r].other]);
            moved |= done;
            open |= !done;
        }
        if (!open) return;
        if (moved) continue;
        // Chooses the first room whose position does not depend on another room. If all remaining rooms depend on each
        // other in a circle, chooses the first of them.
        std::size_t next = kNoRoom;
        for (std::size_t r = 0; r < rooms_.size(); ++r)
            if (rooms_[r].rings.empty() && (next == kNoRoom || (relations[next].part && !relations[r].part))) next = r;
        place_by_assumption(next);
    }
}

void WordsPlan::find_overlaps() {
    constexpr double kOverlap_m = 0.05;
    std::vector<std::size_t> order(rooms_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return rooms_[a].least.x < rooms_[b].least.x; });
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            ++work_;
            const WordRoom &a = rooms_[std::min(order[i], order[k])], &b = rooms_[std::max(order[i], order[k])];
            if (rooms_[order[k]].least.x > rooms_[order[i]].most.x - kOverlap_m) break;
            const Vec2 common = glm::min(a.most, b.most) - glm::max(a.least, b.least);
            const bool boxes =
                a.rings.size() == 1 && b.rings.size() == 1 && a.rings[0].size() == 4 && b.rings[0].size() == 4;
            if (a.storey != b.storey || !boxes || common.x < kOverlap_m || common.y < kOverlap_m) continue;
            warn(b.said.line, phrase("rooms_text.overlap", {{"name", room_words(b)}, {"other", room_words(a)}}),
                 phrase("rooms_text.then_overlap"));
        }
}

int WordsPlan::wall_side(const WordRoom& room, int side) {
    if (side < 8) return side / 2 * 2;
    // Left, right, front and back are the sides of a person who walks along the longer side of the room, to the east or
    // to the north.
    const bool eastwards = room.size_m.x >= room.size_m.y;
    // Compass directions of left, right, front, back.
    constexpr std::array<int, 4> kEastwards{0, 4, 2, 6}, kNorthwards{6, 2, 0, 4};
    return (eastwards ? kEastwards : kNorthwards)[static_cast<std::size_t>(side - 8)];
}

// Returns the wall of a room on this side. For an outline with more than four corners, returns the longest wall that
// faces this side.
WordsPlan::Border WordsPlan::wall_of(const WordRoom& room, int side) {
    const Vec2 out = side_direction(side);
    Border best;
    double most = -1.0;
    const Ring& ring = room.rings[0];
    const double turn = signed_area(ring) > 0 ? 1.0 : -1.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const Vec2 along = b - a;
        const double score = turn * (along.y * out.x - along.x * out.y);
        if (score > most) most = score, best = {a, b};
    }
    // Orders the ends so that the border runs from west to east, or from south to north.
    const Vec2 way = best.to - best.from;
    if (std::abs(way.x) >= std::abs(way.y) ? way.x < 0 : way.y < 0) std::swap(best.from, best.to);
    return best;
}

// Returns the longest border that the outlines of both rooms share.
std::optional<WordsPlan::Border> WordsPlan::shared(const WordRoom& a, const WordRoom& b) {
    if (glm::any(glm::greaterThan(a.least, b.most + kTouch_m)) ||
        glm::any(glm::greaterThan(b.least, a.most + kTouch_m)))
        return std::nullopt;
    std::optional<Border> best;
    for (const Ring& ring : a.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &p = ring[i], way = ring[(i + 1) % ring.size()] - p;
            const double length = glm::length(way);
            if (length < 1e-6) continue;
            const Vec2 along = way / length;
            for (const Ring& other : b.rings) {
                work_ += other.size();
                for (std::size_t k = 0; k < other.size(); ++k) {
                    const Vec2 from = other[k] - p, to = other[(k + 1) % other.size()] - p;
                    const double off_from = along.x * from.y - along.y * from.x,
                                 off_to = along.x * to.y - along.y * to.x;
                    if (std::abs(off_from) > kTouch_m || std::abs(off_to) > kTouch_m) continue;
                    const double t0 = glm::dot(from, along), t1 = glm::dot(to, along);
                    const double begin = std::max(0.0, std::min(t0, t1)), end = std::min(length, std::max(t0, t1));
                    if (end - begin < 0.3 || (best && end - begin <= best->length())) continue;
                    best = Border{p + along * begin, p + along * end};
                }
            }
        }
    if (!best) return std::nullopt;
    const Vec2 way = best->to - best->from;
    if (std::abs(way.x) >= std::abs(way.y) ? way.x < 0 : way.y < 0) std::swap(best->from, best->to);
    return best;
}

// Returns the room in which a lift, drop or flight begins: the room that the sentence names, else the room that the
// paragraph describes.
std::size_t WordsPlan::room_from(std::size_t room, const Said& said) const {
    const SaidPart* from = said.words.find(Statement::FromRoom);
    if (!from || name_key(from->name, speaker_.language) == name_key(rooms_[room].said.words.name, speaker_.language))
        return room;
    const std::size_t named = room_named(from->name);
    return named == kNoRoom ? room : named;
}

// Sets the floor heights that the text states. If a drop leads to a room without a stated height, the floor of that
// room is lower by the height of the drop.
void WordsPlan::set_raises() {
    constexpr double kMostRaise_m = 1.5;
    for (WordRoom& room : rooms_) {
        const SaidPart *raised = room.said.words.find(Statement::Raised), *sunk = room.said.words.find(Statement::Sunk);
        if (!raised && !sunk) continue;
        const double stated_m = raised ? raised->numbers[0] : -sunk->numbers[0];
        room.raised_m = std::clamp(stated_m, -kMostRaise_m, kMostRaise_m);
        if (*room.raised_m != stated_m)
            warn(room.said.line, phrase("rooms_text.odd_raise", {{"name", room_words(room)}}),
                 phrase("rooms_text.then_raise", {{"metres", std::abs(*room.raised_m)}}));
    }
    for (std::size_t r = 0; r < rooms_.size(); ++r)
        for (const Said& said : rooms_[r].doors) {
            const SaidPart *drop = said.words.find(Statement::DropOf), *to = said.words.find(Statement::To);
            if (said.words.kind != SentenceKind::Drop || !drop || !to) continue;
            const std::size_t from = room_from(r, said), other = room_named(to->name, from);
            if (other == kNoRoom || rooms_[other].storey != rooms_[from].storey || rooms_[other].raised_m) continue;
            rooms_[other].raised_m =
                std::clamp(rooms_[from].raised_m.value_or(0.0) - drop->numbers[0], -kMostRaise_m, kMostRaise_m);
        }
}

void WordsPlan::add_spaces() {
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        WordRoom& room = rooms_[r];
        const std::size_t own = level_of_[room.storey];
        room.levels = {own};
        const SaidPart *stairs = room.said.words.find(Statement::Stairs), *lift = room.said.words.find(Statement::Lift),
                       *up = room.said.words.find(Statement::UpTo);
        floorplan::PlanSpace space;
        space.name = one_line(room.said.words.name.substr(0, 200));
        space.id = phrase("rooms_text.line", {{"line", room.said.line}});
        space.line = room.said.line;
        space.rings = room.rings;
        if (const SaidPart* part = stairs ? stairs : lift ? lift : up) {
            const std::string key = name_key(part->name, speaker_.language), own_key = folded(space.name);
            std::size_t to = own;
            for (std::size_t s = 0; s < storeys_.size(); ++s)
                if (name_key(storeys_[s].name, speaker_.language) == key) to = level_of_[s];
            if (to == own) {
                to = std::min(own + 1, plan_.levels.size() - 1);
                const std::string next = to == own ? std::string() : plan_.levels[to].name;
                warn(room.said.line, phrase("rooms_text.no_storey", {{"name", one_line(part->name.substr(0, 100))}}),
                     next.empty() ? phrase("rooms_text.then_no_stairs")
                                  : phrase("rooms_text.then_to_storey", {{"name", next}}));
            }
            const bool is_lift =
                !stairs &&
                (lift || own_key.find("lift") != std::string::npos || own_key.find("elevator") != std::string::npos ||
                 own_key.find("aufzug") != std::string::npos || own_key.find("fahrstuhl") != std::string::npos);
            if (to != own) {
                space.kind = is_lift ? floorplan::PlanSpaceKind::Lift : floorplan::PlanSpaceKind::Stairs;
                room.levels.clear();
                for (std::size_t l = std::min(own, to); l <= std::max(own, to); ++l) room.levels.push_back(l);
            }
        }
        space.levels = room.levels;
        if (room.levels.size() == 1) space.raised_m = room.raised_m.value_or(0.0);
        if (const SaidPart* railing = room.said.words.find(Statement::Railing))
            warn(room.said.line,
                 phrase("rooms_text.railing", {{"height", railing->numbers[0]}, {"name", room_words(room)}}),
                 phrase("rooms_text.then_walls"));
        if (const SaidPart* high = room.said.words.find(Statement::High)) space.height_m = high->numbers[0];
        if (const SaidPart* floor = room.said.words.find(Statement::Floor)) space.floor_material = floor->name;
        plan_.spaces.push_back(std::move(space));
    }
}

}  // namespace handrail::words
