// Makes the outlines of rooms that were found from the floor. For each storey, it rasters the rooms and extends them to
// the middle of the walls. The borders in the raster become outlines.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <set>

#include "worlds/base/human_measures.h"
#include "worlds/base/text.h"
#include "worlds/exports/as_words.h"
#include "worlds/geometry/flat_parts.h"

namespace handrail::exports {
namespace {

constexpr double kHalfWall_m = 0.1, kDoorway_m = 0.65, kStoreyApart_m = 2.2, kNearSpan_m = 0.3, kLeastPiece_m2 = 0.3;

// Returns the room of each span in the floor without furniture. At most places, it is the room of the same place in the
// walkable space. Under furniture, it is the adjoining room.
std::vector<std::uint32_t> rooms_of_walls(const navigation::RoomGraph& graph, const navigation::WalkSpace& space) {
    const navigation::SpanGrid<navigation::WallSpan>& walls = *space.walls;
    std::vector<std::uint32_t> room(walls.spans.size(), navigation::kNothing);
    std::deque<std::uint32_t> open;
    const bool alike = walls.width == space.width && walls.depth == space.depth;
    for (std::uint32_t s = 0; s < space.spans.size(); ++s) {
        if (graph.room_of_span[s] == navigation::kNothing) continue;
        const Vec3 at = space.place_m(s);
        std::uint32_t found = navigation::kNothing;
        if (alike) {
            const std::uint32_t cell = space.spans[s].cell;
            for (std::uint32_t w = walls.first[cell]; w < walls.first[cell + 1]; ++w)
                if (std::abs(walls.place_m(w).z - at.z) < kNearSpan_m) found = w;
        } else {
            found = walls.nearest(at, walls.cell_m, kNearSpan_m, kNearSpan_m);
        }
        if (found == navigation::kNothing || room[found] != navigation::kNothing) continue;
        room[found] = graph.room_of_span[s];
        open.push_back(found);
    }
    while (!open.empty()) {
        const std::uint32_t s = open.front();
        open.pop_front();
        for (const std::uint32_t next : walls.spans[s].next)
            if (next != navigation::kNothing && room[next] == navigation::kNothing)
                room[next] = room[s], open.push_back(next);
    }
    return room;
}

class Raster {
public:
    Raster(std::uint32_t width, std::uint32_t depth)
        : width_(width), room_(std::size_t{width} * depth, navigation::kNothing) {}

    std::uint32_t& at(std::uint32_t cell) { return room_[cell]; }

    // Removes areas that are narrower than `cells`, such as the floor in doorways. Rooms that are mostly narrow do not
    // change.
    void open(std::uint32_t cells, std::size_t rooms) {
        const auto depth = static_cast<std::uint32_t>(room_.size() / width_);
        std::vector<std::uint32_t> along(room_.size(), 0), up(room_.size(), 0),
            kept(room_.size(), navigation::kNothing);
        std::vector<std::size_t> before(rooms, 0), after(rooms, 0);
        for (std::uint32_t c = static_cast<std::uint32_t>(room_.size()); c-- > 0;) {
            if (room_[c] == navigation::kNothing) continue;
            ++before[room_[c]];
            const bool east = (c + 1) % width_ != 0 && room_[c + 1] == room_[c];
            along[c] = east ? along[c + 1] + 1 : 1;
            const bool north = c + width_ < room_.size() && room_[c + width_] == room_[c];
            up[c] = along[c] < cells ? 0 : north ? up[c + width_] + 1 : 1;
        }
        for (std::uint32_t y = 0; y + cells <= depth; ++y)
            for (std::uint32_t x = 0; x + cells <= width_; ++x)
                if (const std::uint32_t c = y * width_ + x; room_[c] != navigation::kNothing && up[c] >= cells)
                    for (std::uint32_t row = 0; row < cells; ++row)
                        std::fill_n(kept.begin() + c + row * width_, cells, room_[c]);
        for (const std::uint32_t r : kept)
            if (r != navigation::kNothing) ++after[r];
        for (std::uint32_t c = 0; c < room_.size(); ++c)
            if (room_[c] != navigation::kNothing && after[room_[c]] * 2 < before[room_[c]]) kept[c] = room_[c];
        room_ = std::move(kept);
    }

    // Extends all rooms at the same time into unassigned cells, by this many cells. Corners stay square.
    void grow(int cells) {
        std::vector<std::uint32_t> edge;
        for (std::uint32_t c = 0; c < room_.size(); ++c)
            if (room_[c] != navigation::kNothing) edge.push_back(c);
        for (int step = 0; step < cells; ++step) {
            std::vector<std::uint32_t> next;
            for (const std::uint32_t c : edge)
                for (const std::uint32_t n : beside(c, true))
                    if (n != navigation::kNothing && room_[n] == navigation::kNothing)
                        room_[n] = room_[c], next.push_back(n);
            edge = std::move(next);
        }
    }

    // Makes a room a rectangle if it nearly fills its bounding box, and if other rooms cover hardly any of that box.
    void square(std::size_t rooms) {
        struct Extent {
            std::uint32_t west = navigation::kNothing, east = 0, south = navigation::kNothing, north = 0;
            std::size_t cells = 0;
        };
        std::vector<Extent> extents(rooms);
        for (std::uint32_t c = 0; c < room_.size(); ++c) {
            if (room_[c] == navigation::kNothing) continue;
            Extent& e = extents[room_[c]];
            const std::uint32_t x = c % width_, y = c / width_;
            e.west = std::min(e.west, x), e.east = std::max(e.east, x);
            e.south = std::min(e.south, y), e.north = std::max(e.north, y);
            ++e.cells;
        }
        for (std::uint32_t r = 0; r < rooms; ++r) {
            const Extent& e = extents[r];
            if (e.cells == 0) continue;
            const std::size_t all = std::size_t{e.east - e.west + 1} * (e.north - e.south + 1);
            std::map<std::uint32_t, std::size_t> lost;  // number of cells that each other room would lose
            std::size_t others = 0;
            for (std::uint32_t y = e.south; y <= e.north; ++y)
                for (std::uint32_t x = e.west; x <= e.east; ++x)
                    if (const std::uint32_t other = room_[y * width_ + x]; other != navigation::kNothing && other != r)
                        ++others, ++lost[other];
            if (others * 30 > all || e.cells * 10 < all * 7) continue;
            if (std::any_of(lost.begin(), lost.end(),
                            [&](const auto& other) { return other.second * 4 > extents[other.first].cells; }))
                continue;
            for (std::uint32_t y = e.south; y <= e.north; ++y)
                for (std::uint32_t x = e.west; x <= e.east; ++x) room_[y * width_ + x] = r;
        }
    }

    // Returns the outlines of the largest piece of a room, in cells: the outer one first, then the holes that other
    // rooms fill.
    std::vector<Ring> outline(std::uint32_t r, double cell_m) const {
        std::vector<std::uint32_t> piece_of(room_.size(), navigation::kNothing);
        std::vector<std::size_t> sizes;
        for (std::uint32_t c = 0; c < room_.size(); ++c) {
            if (room_[c] != r || piece_of[c] != navigation::kNothing) continue;
            const auto piece = static_cast<std::uint32_t>(sizes.size());
            sizes.push_back(0);
            std::vector<std::uint32_t> open{c};
            piece_of[c] = piece;
            while (!open.empty()) {
                const std::uint32_t now = open.back();
                open.pop_back();
                ++sizes.back();
                for (const std::uint32_t n : beside(now, false))
                    if (n != navigation::kNothing && room_[n] == r && piece_of[n] == navigation::kNothing)
                        piece_of[n] = piece, open.push_back(n);
            }
        }
        if (sizes.empty()) return {};
        const auto largest = static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
        if (static_cast<double>(sizes[largest]) * cell_m * cell_m < kLeastPiece_m2) return {};
        // For each corner, the ends of the edges that begin there. Each edge has the room on its left.
        std::map<std::pair<int, int>, std::vector<std::pair<int, int>>> edges;
        const auto own = [&](int x, int y) {
            if (x < 0 || y < 0 || x >= static_cast<int>(width_)) return false;
            const std::size_t c = static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
            return c < piece_of.size() && piece_of[c] == largest;
        };
        for (std::uint32_t c = 0; c < room_.size(); ++c) {
            if (piece_of[c] != largest) continue;
            const int x = static_cast<int>(c % width_), y = static_cast<int>(c / width_);
            if (!own(x, y - 1)) edges[{x, y}].emplace_back(x + 1, y);
            if (!own(x + 1, y)) edges[{x + 1, y}].emplace_back(x + 1, y + 1);
            if (!own(x, y + 1)) edges[{x + 1, y + 1}].emplace_back(x, y + 1);
            if (!own(x - 1, y)) edges[{x, y + 1}].emplace_back(x, y);
        }
        std::vector<Ring> rings;
        while (!edges.empty()) {
            const std::pair<int, int> first = edges.begin()->first;
            std::pair<int, int> now = first, way{0, 0};
            Ring ring;
            do {
                auto found = edges.find(now);
                if (found == edges.end()) break;
                // If two edges begin at a corner, chooses the left one, so that no ring crosses itself.
                std::size_t take = 0;
                for (std::size_t i = 0; i < found->second.size(); ++i) {
                    const std::pair<int, int> next{found->second[i].first - now.first,
                                                   found->second[i].second - now.second};
                    if (way.first * next.second - way.second * next.first > 0) take = i;
                }
                const std::pair<int, int> to = found->second[take];
                found->second.erase(found->second.begin() + static_cast<std::ptrdiff_t>(take));
                if (found->second.empty()) edges.erase(found);
                const std::pair<int, int> next{to.first - now.first, to.second - now.second};
                if (next != way) ring.emplace_back(now.first, now.second);
                way = next;
                now = to;
            } while (now != first);
            if (ring.size() > 3) rings.push_back(std::move(ring));
        }
        // Removes the first corner of a ring if it is in the middle of a straight side.
        for (Ring& ring : rings) {
            const Vec2 before = ring.back(), &here = ring[0], after = ring[1];
            if ((before.x == here.x && here.x == after.x) || (before.y == here.y && here.y == after.y))
                ring.erase(ring.begin());
        }
        std::stable_sort(rings.begin(), rings.end(), [](const Ring& a, const Ring& b) {
            return std::abs(signed_area(a)) > std::abs(signed_area(b));
        });
        std::vector<Ring> kept;
        for (std::size_t i = 0; i < rings.size(); ++i)
            if (i == 0 || (signed_area(rings[i]) < 0 && holds_another(rings[i], r))) kept.push_back(rings[i]);
        return kept;
    }

private:
    std::array<std::uint32_t, 8> beside(std::uint32_t cell, bool corners) const {
        const std::uint32_t x = cell % width_, rows = static_cast<std::uint32_t>(room_.size() / width_),
                            y = cell / width_;
        const bool west = x > 0, east = x + 1 < width_, south = y > 0, north = y + 1 < rows;
        return {east ? cell + 1 : navigation::kNothing,
                north ? cell + width_ : navigation::kNothing,
                west ? cell - 1 : navigation::kNothing,
                south ? cell - width_ : navigation::kNothing,
                corners && east && north ? cell + width_ + 1 : navigation::kNothing,
                corners && west && north ? cell + width_ - 1 : navigation::kNothing,
                corners && west && south ? cell - width_ - 1 : navigation::kNothing,
                corners && east && south ? cell - width_ + 1 : navigation::kNothing};
    }

    bool holds_another(const Ring& hole, std::uint32_t r) const {
        Vec2 least(1e300), most(-1e300);
        for (const Vec2& p : hole) least = glm::min(least, p), most = glm::max(most, p);
        for (auto y = static_cast<std::size_t>(least.y); y < static_cast<std::size_t>(most.y); ++y)
            for (auto x = static_cast<std::size_t>(least.x); x < static_cast<std::size_t>(most.x); ++x) {
                const std::uint32_t other = room_[y * width_ + x];
                if (other != navigation::kNothing && other != r) return true;
            }
        return false;
    }

    std::uint32_t width_;
    std::vector<std::uint32_t> room_;
};

struct DropFound {
    std::uint32_t from = 0, to = 0;
    Vec3 place_m{0.0};
};

// Describes drops between two rooms. Raises or lowers both rooms from their storey, and makes the edge an opening with
// a drop. If the two rooms must have the same height for another reason, such as a level opening, the drop is only
// mentioned in `lost`.
void lay_drops(WordsHouse& house, const navigation::RoomGraph& graph, const std::vector<DropFound>& drops,
               bool german) {
    constexpr double kLeastDrop_m = 0.3;
    const auto level = [&](std::uint32_t room) {
        return graph.rooms[room].floor_m - house.storeys[house.rooms[room].storey].floor_m;
    };
    for (const DropFound& drop : drops) {
        const double down_m =
            std::round((graph.rooms[drop.from].floor_m - graph.rooms[drop.to].floor_m) * 100.0) * 0.01;
        if (down_m < kLeastDrop_m || down_m > kMostDrop_m) continue;
        for (const std::uint32_t room : {drop.from, drop.to})
            if (std::abs(level(room)) > 0.05) house.rooms[room].raised_m = std::round(level(room) * 100.0) * 0.01;
    }
    for (const DropFound& drop : drops) {
        WordsHouse::Door door;
        door.opening = true;
        door.rooms = {drop.from, drop.to};
        door.at_m = Vec2(drop.place_m);
        door.width_m = 1.0;
        door.drop_m = house.rooms[drop.from].raised_m - house.rooms[drop.to].raised_m;
        if (door.drop_m >= kLeastDrop_m) house.doors.push_back(std::move(door));
        else
            house.lost.push_back(german ? fmt::format("Hinab geht es von {} nach {}.", house.rooms[drop.from].name,
                                                      house.rooms[drop.to].name)
                                        : fmt::format("One drops from {} to {}.", house.rooms[drop.from].name,
                                                      house.rooms[drop.to].name));
    }
}

// Builds the house step by step, because each step depends on the previous steps: storeys, rooms, their outlines, and
// doors and flights between them.
class FoundHouse {
public:
    FoundHouse(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space, bool german)
        : scene_(scene), graph_(graph), space_(space), german_(german) {
        house_.name = spoken_name(scene);
        house_.wall_material = wall_material(scene);
    }

    WordsHouse write() {
        if (graph_.rooms.empty() || !space_.walls) return std::move(house_);
        add_storeys();
        add_rooms();
        for (std::size_t storey = 0; storey < house_.storeys.size(); ++storey) outline_rooms(storey);
        outline_small_rooms();
        for (const navigation::Portal& portal : graph_.portals) join(portal);
        lay_drops(house_, graph_, drops_, german_);
        return std::move(house_);
    }

private:
    // Finds the storeys from the floor heights of all rooms that are not stairs. Floors whose heights differ by less
    // than a storey form one group; the most frequent height of a group becomes the height of its storey.
    void add_storeys() {
        std::vector<double> floors;
        for (const navigation::Room& room : graph_.rooms)
            if (room.kind != navigation::RoomKind::Stairs) floors.push_back(room.floor_m);
        if (floors.empty()) floors.push_back(graph_.rooms[0].floor_m);
        std::sort(floors.begin(), floors.end());
        std::map<long, int> votes;
        const auto close_storey = [&] {
            const auto best = std::max_element(votes.begin(), votes.end(),
                                               [](const auto& a, const auto& b) { return a.second < b.second; });
            house_.storeys.push_back({{}, static_cast<double>(best->first) * 0.01, 3.0});
            votes.clear();
        };
        double lowest = floors[0];
        for (const double floor : floors) {
            if (floor - lowest > kStoreyApart_m) close_storey(), lowest = floor;
            ++votes[std::lround(floor * 100.0)];
        }
        close_storey();
        std::vector<WordsHouse::Storey>& storeys = house_.storeys;
        for (std::size_t s = 0; s < storeys.size(); ++s) {
            storeys[s].name = fmt::format("{} {}", german_ ? "Ebene" : "Level", s);
            if (s + 1 < storeys.size())
                storeys[s].height_m = std::max(storeys[s + 1].floor_m - storeys[s].floor_m, 2.3);
        }
    }

    std::size_t storey_at(double z_m) const {
        std::size_t best = 0;
        for (std::size_t s = 1; s < house_.storeys.size(); ++s)
            if (std::abs(house_.storeys[s].floor_m - z_m) < std::abs(house_.storeys[best].floor_m - z_m)) best = s;
        return best;
    }

    void add_rooms() {
        of_wall_ = rooms_of_walls(graph_, space_);
        const navigation::SpanGrid<navigation::WallSpan>& walls = *space_.walls;
        std::vector<Aabb> extent(graph_.rooms.size());
        for (std::uint32_t s = 0; s < walls.spans.size(); ++s)
            if (of_wall_[s] != navigation::kNothing) extent[of_wall_[s]].include(walls.place_m(s));
        const FloorMaterials floor_materials(scene_);
        for (std::size_t r = 0; r < graph_.rooms.size(); ++r) {
            const navigation::Room& room = graph_.rooms[r];
            const bool stairs = room.kind == navigation::RoomKind::Stairs && !extent[r].empty();
            WordsHouse::Room made;
            made.name = room.name;
            made.storey = made.to_storey = storey_at(stairs ? extent[r].min_m.z : room.floor_m);
            made.floor_material = floor_materials.at(Vec3(Vec2(room.middle_m), room.floor_m));
            if (stairs) made.to_storey = std::max(made.storey, storey_at(extent[r].max_m.z));
            if (made.to_storey > made.storey) made.kind = WordsHouse::Kind::Stairs;
            house_.rooms.push_back(std::move(made));
        }
    }

    // Makes the outlines of the rooms whose lowest storey is `storey`.
    void outline_rooms(std::size_t storey) {
        const navigation::SpanGrid<navigation::WallSpan>& walls = *space_.walls;
        const auto cells = static_cast<int>(std::lround((space_.body.radius_m + kHalfWall_m) / walls.cell_m));
        const auto border = static_cast<std::uint32_t>(cells + 2);
        const std::uint32_t width = walls.width + 2 * border, depth = walls.depth + 2 * border;
        Raster raster(width, depth);
        for (std::uint32_t s = 0; s < walls.spans.size(); ++s) {
            const std::uint32_t room = of_wall_[s];
            if (room == navigation::kNothing || house_.rooms[room].storey != storey) continue;
            const std::uint32_t x = walls.spans[s].cell % walls.width, y = walls.spans[s].cell / walls.width;
            raster.at((y + border) * width + x + border) = room;
        }
        raster.open(static_cast<std::uint32_t>(std::lround(kDoorway_m / walls.cell_m)), graph_.rooms.size());
        raster.grow(cells);
        raster.square(graph_.rooms.size());
        for (std::uint32_t r = 0; r < graph_.rooms.size(); ++r) {
            if (house_.rooms[r].storey != storey) continue;
            for (Ring& ring : raster.outline(r, walls.cell_m)) {
                for (Vec2& p : ring) {
                    p = Vec2(walls.origin_m) + (p - static_cast<double>(border)) * walls.cell_m;
                    p = {std::round(p.x * 1e4) * 1e-4, std::round(p.y * 1e4) * 1e-4};
                }
                house_.rooms[r].rings.push_back(std::move(ring));
            }
        }
    }

    // Makes the outline of a room that is too small to be traced: a square metre around the middle of the room.
    void outline_small_rooms() {
        for (std::size_t r = 0; r < graph_.rooms.size(); ++r) {
            if (!house_.rooms[r].rings.empty()) continue;
            const Vec2 at(std::round(graph_.rooms[r].middle_m.x * 100.0) * 0.01,
                          std::round(graph_.rooms[r].middle_m.y * 100.0) * 0.01);
            house_.rooms[r].rings = {{at - 0.5, Vec2(at.x + 0.5, at.y - 0.5), at + 0.5, Vec2(at.x - 0.5, at.y + 0.5)}};
        }
    }

    void join(const navigation::Portal& portal) {
        if (portal.kind == navigation::PassageKind::Door || portal.kind == navigation::PassageKind::Opening ||
            portal.kind == navigation::PassageKind::Stairs)
            return add_door(portal);
        const WordsHouse::Room &a = house_.rooms[portal.rooms[0]], &b = house_.rooms[portal.rooms[1]];
        const bool rooms = a.kind == WordsHouse::Kind::Room && b.kind == WordsHouse::Kind::Room;
        if (portal.kind == navigation::PassageKind::Drop && rooms && a.storey == b.storey)
            return drops_.push_back({portal.rooms[0], portal.rooms[1], portal.place_m});
        const Feature* feature = scene_.find(portal.feature);
        if (portal.kind == navigation::PassageKind::Lift && rooms && feature && a.storey != b.storey)
            return add_lift(portal, *feature);
        const char* kind = german_ ? "Ein Teleporter führt" : "A teleporter leads";
        if (portal.kind == navigation::PassageKind::Lift) kind = german_ ? "Ein Aufzug fährt" : "A lift goes";
        if (portal.kind == navigation::PassageKind::Drop) kind = german_ ? "Hinab geht es" : "One drops";
        house_.lost.push_back(german_ ? fmt::format("{} von {} nach {}.", kind, a.name, b.name)
                                      : fmt::format("{} from {} to {}.", kind, a.name, b.name));
    }

    void add_door(const navigation::Portal& portal) {
        WordsHouse::Door door;
        door.opening = portal.kind != navigation::PassageKind::Door;
        door.rooms = {portal.rooms[0], portal.rooms[1]};
        if (house_.rooms[door.rooms[0]].kind == WordsHouse::Kind::Stairs) std::swap(door.rooms[0], door.rooms[1]);
        door.at_m = Vec2(portal.place_m);
        door.width_m = std::clamp(portal.width_m, 0.6, 8.0);
        if (const Feature* feature = scene_.find(portal.feature); feature && !door.opening && !feature->made_name)
            door.name = one_line(spoken_name(*feature));
        house_.doors.push_back(std::move(door));
    }

    void add_lift(const navigation::Portal& portal, const Feature& lift) {
        std::size_t from = portal.rooms[0], to = portal.rooms[1];
        if (house_.rooms[from].storey > house_.rooms[to].storey) std::swap(from, to);
        const auto fine = [](double value) { return std::round(value * 1e3) * 1e-3; };
        const Vec3 at = lift.bounds_m.centre_m(), size = lift.bounds_m.size_m();
        house_.lifts.push_back({lift.made_name ? std::string() : one_line(spoken_name(lift)), from, to,
                                Vec2(fine(at.x), fine(at.y)), Vec2(fine(size.x), fine(size.y))});
    }

    const Scene& scene_;
    const navigation::RoomGraph& graph_;
    const navigation::WalkSpace& space_;
    const bool german_;
    WordsHouse house_;
    std::vector<std::uint32_t> of_wall_;  // for each span of the floor without furniture: its room
    std::vector<DropFound> drops_;
};

}  // namespace

WordsHouse found_house(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                       words::WordLanguage language) {
    const bool german = language == words::WordLanguage::German;
    WordsHouse house = FoundHouse(scene, graph, space, german).write();
    if (!house.rooms.empty()) furnish(house, scene, language);
    return house;
}

}  // namespace handrail::exports
