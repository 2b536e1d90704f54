#include "worlds/navigation/rooms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

constexpr double kDoorway_m = 0.35;    // clearance of the body's middle: an opening of at most 1.2 m
constexpr double kDoorwayShare = 0.6;  // and narrower than this share of what lies on both sides
constexpr double kWideShare = 0.5;     // a wider opening
constexpr double kLeastPiece_m2 = 0.3, kLeastWide_m2 = 4.0, kLeastRoom_m2 = 0.8, kNiche_m2 = 3.0, kLeastBorder_m2 = 1.0;
constexpr double kHuge_m2 = 150.0, kHugeShare = 0.75, kLeastOfHuge_m2 = 10.0;
constexpr double kLong = 6.0;  // a huge place of so many squares as wide as its widest part is corridors
constexpr double kStorey_m = 2.0;
constexpr double kOnePortal_m = 1.0;  // gaps in a border smaller than that do not make two portals

MadeRoomName by_thing(const Feature& feature) {
    MadeRoomName called;
    called.thing = feature.name;
    called.thing_made = feature.made_name;
    called.thing_in = feature.name_in;
    return called;
}

std::string made_name(const MadeRoomName& made) {
    constexpr std::array kLooks{"room_name.niche", "room_name.corridor", "room_name.small_room", "room_name.room", "room_name.large_room", "room_name.hall"};
    const std::string thing = in_spoken_language(made.thing_made ? spoken_kind(made.thing) : made.thing, made.thing_in);
    if (made.with_thing) return phrase(made.look == RoomLook::Niche ? "room_name.niche_with" : "room_name.room_with", {{"thing", thing}});
    if (!thing.empty()) return thing;
    const std::string look = phrase(kLooks[static_cast<std::size_t>(made.look)]);
    const std::string side = made.side_rad ? compass_word(*made.side_rad) : phrase("room_name.middle");
    const std::string name = phrase("room_name.by_size", {{"look", look}, {"wide", made.wide_m}, {"deep", made.deep_m}, {"side", side}});
    if (made.levels == 2) return phrase(made.level == 0 ? "room_name.lower_level" : "room_name.upper_level", {{"room", name}});
    return made.levels > 2 ? phrase("room_name.level", {{"room", name}, {"level", made.level + 1}}) : name;
}

std::string unnumbered(const Room& room) { return room.map_name.empty() ? made_name(room.made) : in_spoken_language(room.map_name, room.map_name_in); }

class Builder {
public:
    // walls: the same floor without furniture.
    Builder(const Scene& scene, const WalkSpace& space, const WalkSpace& walls)
        : scene_(scene), space_(space), walls_(walls), label_(space.spans.size(), kNothing) {}

    RoomGraph build() {
        watershed();
        pieces_of(plain, RoomKind::Room);  // on top of what was left aside
        pieces_of([](const WalkSpan& s) { return s.stairs && s.door == kNothing && !s.liquid; }, RoomKind::Stairs);
        pieces_of([](const WalkSpan& s) { return s.liquid && s.door == kNothing; }, RoomKind::Liquid);
        absorb_crumbs();
        find_door_sides();
        spread_into_doors();
        number_rooms();
        measure();
        join();
        name();
        return std::move(graph_);
    }

private:
    struct Basin {
        double peak_m = 0.0;
        std::size_t cells = 0;
        std::string name;
    };
    static bool plain(const WalkSpan& s) { return s.door == kNothing && !s.stairs && !s.liquid; }
    double clearance(std::uint32_t s) const { return static_cast<double>(space_.spans[s].clearance_m); }
    double area(std::size_t cells) const { return static_cast<double>(cells) * space_.cell_area_m2(); }

    std::uint32_t root(std::uint32_t s) {
        while (parent_[s] != s) s = parent_[s] = parent_[parent_[s]];
        return s;
    }

    bool cut(const Basin& a, const Basin& b, std::uint32_t at) const {
        if (!a.name.empty() && !b.name.empty()) return a.name != b.name;
        const double s = wide_m(at), peak = std::min(a.peak_m, b.peak_m), least = area(std::min(a.cells, b.cells)), both = area(a.cells + b.cells);
        if (both > kHuge_m2 && s <= kHugeShare * peak && least >= kLeastOfHuge_m2) return true;
        const bool doorway = s < kDoorway_m && s <= kDoorwayShare * peak && least >= kLeastPiece_m2;
        const bool wide = s <= kWideShare * peak && least >= kLeastWide_m2;
        return doorway || wide;
    }

    double wide_m(std::uint32_t s) const { return static_cast<double>(walls_.spans[s].clearance_m); }

    // From the widest places down to the narrowest: what meets in a narrow place stays apart.
    void watershed() {
        std::vector<std::uint32_t> order;
        for (std::uint32_t s = 0; s < walls_.spans.size(); ++s)
            if (plain(walls_.spans[s])) order.push_back(s);
        std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return wide_m(a) > wide_m(b); });
        parent_.resize(walls_.spans.size());
        std::iota(parent_.begin(), parent_.end(), 0U);
        std::vector<Basin> basins(walls_.spans.size());
        std::vector<bool> done(walls_.spans.size(), false);
        for (const RoomName& given : scene_.room_names) {
            std::uint32_t s = walls_.nearest(given.at_m, 1.5, 1.0, 3.0);
            if (s == kNothing) continue;
            for (bool higher = true; higher;) {  // to the widest place around
                higher = false;
                for (const std::uint32_t n : walls_.spans[s].next)
                    if (n != kNothing && plain(walls_.spans[n]) && wide_m(n) > wide_m(s)) {
                        s = n;
                        higher = true;
                        break;
                    }
            }
            if (basins[s].name.empty()) basins[s].name = given.name;
        }
        for (const std::uint32_t s : order) {
            done[s] = true;
            basins[s].peak_m = wide_m(s);
            basins[s].cells = 1;
            // First to the neighbour with most room, so that a border's cell goes where it belongs.
            std::array<std::uint32_t, 4> around = {kNothing, kNothing, kNothing, kNothing};
            std::size_t count = 0;
            for (const std::uint32_t n : walls_.spans[s].next)
                if (n != kNothing && plain(walls_.spans[n]) && done[n]) around[count++] = root(n);
            std::stable_sort(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(count),
                             [&](std::uint32_t a, std::uint32_t b) { return basins[a].peak_m > basins[b].peak_m; });
            bool first = true;
            for (std::size_t i = 0; i < count; ++i) {
                const std::uint32_t a = root(s), b = root(around[i]);
                if (a == b) continue;
                if (!first && cut(basins[a], basins[b], s)) continue;
                // The one with more room goes on.
                const std::uint32_t keep = basins[a].peak_m > basins[b].peak_m ? a : b, gone = keep == a ? b : a;
                parent_[gone] = keep;
                basins[keep].cells += basins[gone].cells;
                if (basins[keep].name.empty()) basins[keep].name = basins[gone].name;
                first = false;
            }
        }
        std::map<std::uint32_t, std::uint32_t> number;
        of_walls_.assign(walls_.spans.size(), kNothing);
        for (std::uint32_t s = 0; s < walls_.spans.size(); ++s) {
            if (!plain(walls_.spans[s])) continue;
            const std::uint32_t r = root(s);
            const auto [found, is_new] = number.try_emplace(r, static_cast<std::uint32_t>(kinds_.size()));
            if (is_new) {
                kinds_.push_back(RoomKind::Room);
                names_.push_back(basins[r].name);
            }
            of_walls_[s] = found->second;
        }
        part_long_ones();
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s)
            if (plain(space_.spans[s]))
                if (const std::uint32_t under = walls_.at(space_.place_m(s)); under != kNothing) label_[s] = of_walls_[under];
    }

    // A huge place that is nowhere wide is corridors: no wall comes together anywhere in it, but it turns and branches. Each straight stretch becomes a
    // place of its own: a cell belongs to the longer of the two level runs through it, and a run never leaves the place.
    void part_long_ones() {
        const std::size_t count = kinds_.size();
        std::vector<std::size_t> cells(count, 0);
        std::vector<double> widest_m(count, 0.0);
        for (std::uint32_t s = 0; s < of_walls_.size(); ++s)
            if (const std::uint32_t l = of_walls_[s]; l != kNothing) {
                ++cells[l];
                widest_m[l] = std::max(widest_m[l], 2.0 * (wide_m(s) + walls_.body.radius_m));
            }
        std::vector<bool> parts(count, false);
        for (std::size_t l = 0; l < count; ++l) parts[l] = names_[l].empty() && area(cells[l]) > kHuge_m2 && area(cells[l]) > kLong * widest_m[l] * widest_m[l];
        const std::vector<std::uint32_t> east = runs(0, 2), north = runs(1, 3);
        const auto along = [&](std::uint32_t s) { return east[s] >= north[s]; };
        std::vector<std::uint32_t> stretch(of_walls_.size(), kNothing), open;
        std::vector<std::size_t> size;
        for (std::uint32_t s = 0; s < of_walls_.size(); ++s) {
            if (of_walls_[s] == kNothing || !parts[of_walls_[s]] || stretch[s] != kNothing) continue;
            open.assign(1, s);
            stretch[s] = static_cast<std::uint32_t>(size.size());
            size.push_back(0);
            while (!open.empty()) {
                const std::uint32_t here = open.back();
                open.pop_back();
                ++size.back();
                for (const std::uint32_t n : walls_.spans[here].next)
                    if (n != kNothing && of_walls_[n] == of_walls_[s] && stretch[n] == kNothing && along(n) == along(s)) {
                        stretch[n] = stretch[s];
                        open.push_back(n);
                    }
            }
        }
        // Recesses and crumbs of slanting walls go to the longest border.
        std::vector<std::uint32_t> goes(size.size());
        std::iota(goes.begin(), goes.end(), 0U);
        for (int round = 0; round < 8; ++round) {
            std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> border;
            std::fill(size.begin(), size.end(), 0);
            for (std::uint32_t s = 0; s < stretch.size(); ++s) {
                if (stretch[s] == kNothing) continue;
                ++size[stretch[s]];
                for (const std::uint32_t n : walls_.spans[s].next)
                    if (n != kNothing && stretch[n] != kNothing && stretch[n] != stretch[s] && of_walls_[n] == of_walls_[s]) ++border[{stretch[s], stretch[n]}];
            }
            bool any = false;
            for (std::uint32_t part = 0; part < size.size(); ++part) {
                goes[part] = part;
                if (size[part] == 0 || area(size[part]) >= kLeastOfHuge_m2) continue;
                std::size_t longest = 0;
                for (auto it = border.lower_bound({part, 0}); it != border.end() && it->first.first == part; ++it) {
                    const std::uint32_t other = it->first.second;
                    if (size[other] < size[part] || (size[other] == size[part] && other > part) || it->second <= longest) continue;
                    longest = it->second;
                    goes[part] = other;
                    any = true;
                }
            }
            if (!any) break;
            for (std::uint32_t& part : stretch)
                if (part != kNothing) part = goes[part];
        }
        std::map<std::uint32_t, std::uint32_t> label;
        std::vector<bool> kept(count, false);  // the first stretch of a place keeps its label
        for (std::uint32_t s = 0; s < stretch.size(); ++s) {
            if (stretch[s] == kNothing) continue;
            const auto [found, is_new] = label.try_emplace(stretch[s], of_walls_[s]);
            if (is_new && kept[of_walls_[s]]) {
                found->second = static_cast<std::uint32_t>(kinds_.size());
                kinds_.push_back(RoomKind::Room);
                names_.emplace_back();
            } else if (is_new) {
                kept[of_walls_[s]] = true;
            }
            of_walls_[s] = found->second;
        }
    }

    // Of each cell of a place, how many of it lie in one row with it, that way and back.
    std::vector<std::uint32_t> runs(std::size_t way, std::size_t back) const {
        const auto on = [&](std::uint32_t s, std::size_t to) {
            const std::uint32_t n = walls_.spans[s].next[to];
            return n != kNothing && of_walls_[n] == of_walls_[s] && walls_.spans[n].next[(to + 2) % 4] == s ? n : kNothing;
        };
        std::vector<std::uint32_t> length(of_walls_.size(), 0), row;
        for (std::uint32_t s = 0; s < of_walls_.size(); ++s) {
            if (of_walls_[s] == kNothing || on(s, back) != kNothing) continue;
            row.clear();
            for (std::uint32_t at = s; at != kNothing; at = on(at, way)) row.push_back(at);
            for (const std::uint32_t at : row) length[at] = static_cast<std::uint32_t>(row.size());
        }
        return length;
    }

    template <class Is>
    void pieces_of(Is is, RoomKind kind) {
        std::vector<std::uint32_t> open;
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s) {
            if (label_[s] != kNothing || !is(space_.spans[s])) continue;
            const auto made = static_cast<std::uint32_t>(kinds_.size());
            kinds_.push_back(kind);
            names_.emplace_back();
            open.assign(1, s);
            label_[s] = made;
            while (!open.empty()) {
                const std::uint32_t here = open.back();
                open.pop_back();
                for (const std::uint32_t n : space_.spans[here].next)
                    if (n != kNothing && label_[n] == kNothing && is(space_.spans[n])) {
                        label_[n] = made;
                        open.push_back(n);
                    }
            }
        }
    }

    // What is too small to be a room goes to the neighbour it has the longest border with.
    void absorb_crumbs() {
        for (int round = 0; round < 4; ++round) {
            std::vector<std::size_t> cells(kinds_.size(), 0);
            std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> border;
            for (std::uint32_t s = 0; s < space_.spans.size(); ++s) {
                if (label_[s] == kNothing) continue;
                ++cells[label_[s]];
                for (const std::uint32_t n : space_.spans[s].next)
                    if (n != kNothing && label_[n] != kNothing && label_[n] != label_[s]) ++border[{label_[s], label_[n]}];
            }
            std::vector<std::uint32_t> goes(kinds_.size());
            std::iota(goes.begin(), goes.end(), 0U);
            bool any = false;
            for (std::uint32_t l = 0; l < kinds_.size(); ++l) {
                const double least = kinds_[l] == RoomKind::Room ? kLeastRoom_m2 : kLeastBorder_m2;
                if (cells[l] == 0 || area(cells[l]) >= least || !names_[l].empty()) continue;
                std::size_t longest = 0;
                for (auto it = border.lower_bound({l, 0}); it != border.end() && it->first.first == l; ++it) {
                    const std::uint32_t other = it->first.second;
                    if (goes[other] != other || cells[other] < cells[l] || (cells[other] == cells[l] && other > l) || it->second <= longest) continue;
                    longest = it->second;
                    goes[l] = other;
                    any = true;
                }
            }
            if (!any) break;
            for (std::uint32_t& l : label_)
                if (l != kNothing) l = goes[l];
        }
    }

    // Which rooms each door lies between, before its own places go to one of them.
    void find_door_sides() {
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s) {
            if (space_.spans[s].door == kNothing) continue;
            const std::uint32_t group = scene_.movers[space_.spans[s].door].group;
            for (const std::uint32_t n : space_.spans[s].next)
                if (n != kNothing && label_[n] != kNothing) ++door_sides_[group][label_[n]];
        }
    }

    void spread_into_doors() {
        std::vector<std::uint32_t> open;
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s)
            if (label_[s] != kNothing) open.push_back(s);
        for (std::size_t i = 0; i < open.size(); ++i)
            for (const std::uint32_t n : space_.spans[open[i]].next)
                if (n != kNothing && label_[n] == kNothing) {
                    label_[n] = label_[open[i]];
                    open.push_back(n);
                }
        // Doors that lead nowhere else are places of their own.
        pieces_of([](const WalkSpan&) { return true; }, RoomKind::Niche);
    }

    void number_rooms() {
        std::vector<std::uint32_t> number(kinds_.size(), kNothing);
        for (std::uint32_t& l : label_) {
            if (number[l] == kNothing) {
                number[l] = static_cast<std::uint32_t>(graph_.rooms.size());
                Room room;
                room.kind = kinds_[l];
                room.map_name = names_[l];
                for (const RoomName& given : scene_.room_names)
                    if (given.name == room.map_name && room.map_name_in.empty()) room.map_name_in = given.name_in;
                graph_.rooms.push_back(room);
            }
            l = number[l];
        }
        std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> sides;
        for (const auto& [group, labels] : door_sides_)
            for (const auto& [l, count] : labels)
                if (number[l] != kNothing) sides[group][number[l]] += count;
        door_sides_ = std::move(sides);
        graph_.room_of_span = label_;
    }

    void measure() {
        std::vector<std::size_t> cells(graph_.rooms.size(), 0), rim(graph_.rooms.size(), 0);
        std::vector<double> widest(graph_.rooms.size(), -1.0);
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s) {
            Room& room = graph_.rooms[label_[s]];
            const Vec3 place = space_.place_m(s);
            ++cells[label_[s]];
            for (const std::uint32_t n : space_.spans[s].next) rim[label_[s]] += n == kNothing ? 1 : 0;
            room.floor_m += place.z;
            room.bounds_m.include(place - Vec3(0.5 * space_.cell_m, 0.5 * space_.cell_m, 0.0));
            room.bounds_m.include(place + Vec3(0.5 * space_.cell_m, 0.5 * space_.cell_m, 0.0));
            if (clearance(s) > widest[label_[s]]) {
                widest[label_[s]] = clearance(s);
                room.middle_m = place;
            }
        }
        for (std::size_t r = 0; r < graph_.rooms.size(); ++r) {
            Room& room = graph_.rooms[r];
            room.floor_m /= static_cast<double>(std::max<std::size_t>(cells[r], 1));
            room.area_m2 = area(cells[r]) + static_cast<double>(rim[r]) * space_.cell_m * space_.body.radius_m;
            room.bounds_m.min_m -= Vec3(space_.body.radius_m, space_.body.radius_m, 0.0);
            room.bounds_m.max_m += Vec3(space_.body.radius_m, space_.body.radius_m, 0.0);
            if (room.kind == RoomKind::Room && room.area_m2 < kNiche_m2 && room.map_name.empty()) room.kind = RoomKind::Niche;
        }
        std::vector<std::size_t> by_height(graph_.rooms.size());
        std::iota(by_height.begin(), by_height.end(), std::size_t{0});
        std::stable_sort(by_height.begin(), by_height.end(), [&](std::size_t a, std::size_t b) { return graph_.rooms[a].floor_m < graph_.rooms[b].floor_m; });
        double base = graph_.rooms.empty() ? 0.0 : graph_.rooms[by_height[0]].floor_m;
        for (const std::size_t r : by_height) {
            Room& room = graph_.rooms[r];
            if (room.kind == RoomKind::Room && room.floor_m > base + kStorey_m) {
                base = room.floor_m;
                ++levels_;
            }
            room.level = levels_ - 1;
        }
    }

    void join() {
        for (const auto& [group, sides] : door_sides_) {
            if (sides.size() < 2) continue;
            std::vector<std::pair<std::uint32_t, std::size_t>> by_border(sides.begin(), sides.end());
            std::stable_sort(by_border.begin(), by_border.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
            Portal portal;
            portal.kind = PassageKind::Door;
            portal.rooms = {std::min(by_border[0].first, by_border[1].first), std::max(by_border[0].first, by_border[1].first)};
            Aabb box;
            for (const Mover& mover : scene_.movers) {
                if (mover.group != group) continue;
                box.include(scene_.features[mover.feature.value].bounds_m);
                if (!portal.feature) portal.feature = mover.feature;
            }
            const Vec3 centre = box.centre_m();
            portal.width_m = std::max(box.size_m().x, box.size_m().y);
            portal.place_m = {centre.x, centre.y, box.min_m.z};
            graph_.portals.push_back(portal);
        }
        // Borders that no door marks, stretch by stretch.
        struct Stretch {
            Vec3 sum{0.0};
            Aabb box;
            std::size_t cells = 0;
        };
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Stretch>> borders;
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s)
            for (const std::uint32_t n : space_.spans[s].next) {
                if (n == kNothing || label_[n] <= label_[s]) continue;
                if (space_.spans[n].door != kNothing || space_.spans[s].door != kNothing) continue;
                const Vec3 place = 0.5 * (space_.place_m(s) + space_.place_m(n));
                std::vector<Stretch>& stretches = borders[{label_[s], label_[n]}];
                Stretch* joined = nullptr;
                for (std::size_t i = 0; i < stretches.size();) {
                    const Vec3 off = glm::max(stretches[i].box.min_m - place, place - stretches[i].box.max_m);
                    if (std::max({off.x, off.y, off.z - 1.0}) > kOnePortal_m) {
                        ++i;
                        continue;
                    }
                    if (!joined) {
                        joined = &stretches[i++];
                        continue;
                    }
                    joined->sum += stretches[i].sum;
                    joined->cells += stretches[i].cells;
                    joined->box.include(stretches[i].box);
                    stretches.erase(stretches.begin() + static_cast<std::ptrdiff_t>(i));
                }
                if (!joined) joined = &stretches.emplace_back();
                joined->sum += place;
                joined->cells += 1;
                joined->box.include(place);
            }
        for (const auto& [rooms, stretches] : borders)
            for (const Stretch& stretch : stretches) {
                Portal portal;
                portal.rooms = {rooms.first, rooms.second};
                const bool stairs = graph_.rooms[rooms.first].kind == RoomKind::Stairs || graph_.rooms[rooms.second].kind == RoomKind::Stairs;
                portal.kind = stairs ? PassageKind::Stairs : PassageKind::Opening;
                portal.place_m = stretch.sum / static_cast<double>(stretch.cells);
                portal.width_m = std::hypot(stretch.box.size_m().x, stretch.box.size_m().y) + 2.0 * space_.body.radius_m;
                graph_.portals.push_back(portal);
            }
        for (const WalkLink& link : space_.links) {
            const std::uint32_t a = label_[link.from], b = label_[link.to];
            const bool known =
                a == b || std::any_of(graph_.portals.begin(), graph_.portals.end(), [&](const Portal& p) {
                    return p.kind == link.kind && p.rooms[0] == a && p.rooms[1] == b && (link.kind == PassageKind::Drop || p.feature == link.feature);
                });
            if (known) continue;
            graph_.portals.push_back({link.kind, {a, b}, space_.place_m(link.from), 1.0, link.feature, !link.both_ways});
        }
    }

    // By what stands in it and nowhere else, else by size and place.
    void name() {
        std::vector<MadeRoomName> content(graph_.rooms.size());
        for (const Feature& feature : scene_.features) {
            if (!feature.landmark || feature.bounds_m.empty() || feature.kind == FeatureKind::Door) continue;
            const Vec3 c = feature.bounds_m.centre_m(), size = feature.bounds_m.size_m();
            const std::uint32_t s = space_.nearest({c.x, c.y, feature.bounds_m.min_m.z}, 0.5 * std::max(size.x, size.y) + 1.0, 0.6, 2.0);
            if (s != kNothing && content[label_[s]].thing.empty()) content[label_[s]] = by_thing(feature);
        }
        std::vector<Aabb> levels(static_cast<std::size_t>(levels_));
        for (const Room& room : graph_.rooms) levels[static_cast<std::size_t>(room.level)].include(room.bounds_m);
        for (std::uint32_t r = 0; r < graph_.rooms.size(); ++r) {
            Room& room = graph_.rooms[r];
            if (!room.map_name.empty()) continue;
            if (room.kind == RoomKind::Stairs) room.made = ground_name(r);
            else if (room.kind == RoomKind::Liquid) room.made = liquid_name(r);
            else if (content[r].thing.empty()) room.made = by_size(room, levels[static_cast<std::size_t>(room.level)]);
            else {
                room.made = content[r];
                room.made.with_thing = true;
                if (room.kind == RoomKind::Niche) room.made.look = RoomLook::Niche;
            }
        }
        graph_.language = spoken_language();
        std::map<std::string, int> seen;
        for (Room& room : graph_.rooms) {
            room.same_name = ++seen[unnumbered(room)];
            room.name = own_name(room);
        }
    }

    MadeRoomName ground_name(std::uint32_t room) const {
        for (std::uint32_t s = 0; s < label_.size(); ++s)
            if (label_[s] == room && space_.spans[s].ground < space_.obstacle_features.size())
                if (const Feature* feature = scene_.find(space_.obstacle_features[space_.spans[s].ground]);
                    feature && feature->kind == FeatureKind::Object && !feature->name.empty())
                    return by_thing(*feature);
        return {.thing = "stairs", .thing_made = true};
    }
    MadeRoomName liquid_name(std::uint32_t room) const {
        for (const Solid& solid : scene_.solids)
            if (solid.role == SolidRole::Liquid && solid.feature && contains(solid.shape, graph_.rooms[room].middle_m + Vec3(0.0, 0.0, 0.3)))
                return by_thing(scene_.features[solid.feature.value]);
        return {.thing = "water", .thing_made = true};
    }
    MadeRoomName by_size(const Room& room, const Aabb& level) const {
        const Vec3 size = room.bounds_m.size_m(), all = level.size_m(), off = room.middle_m - level.centre_m();
        const double least = std::min(size.x, size.y), most = std::max(size.x, size.y);
        MadeRoomName made;
        made.look = room.kind == RoomKind::Niche        ? RoomLook::Niche
                    : most > 3.0 * least && (least < 2.5 || most > 12.0) ? RoomLook::Corridor
                    : room.area_m2 < 6.0                ? RoomLook::SmallRoom
                    : room.area_m2 > 250.0              ? RoomLook::Hall
                    : room.area_m2 > 80.0               ? RoomLook::LargeRoom
                                                        : RoomLook::Room;
        made.wide_m = static_cast<int>(std::nearbyint(std::max(1.0, size.x)));
        made.deep_m = static_cast<int>(std::nearbyint(std::max(1.0, size.y)));
        if (std::abs(off.x) >= 0.15 * all.x || std::abs(off.y) >= 0.15 * all.y) made.side_rad = std::atan2(off.x, off.y);
        made.level = room.level;
        made.levels = levels_;
        return made;
    }

    const Scene& scene_;
    const WalkSpace &space_, &walls_;
    std::vector<std::uint32_t> label_, parent_;
    std::vector<std::uint32_t> of_walls_;  // label of each span of walls_
    std::vector<RoomKind> kinds_;
    std::vector<std::string> names_;
    std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> door_sides_;
    int levels_ = 1;
    RoomGraph graph_;
};

}  // namespace

RoomGraph make_rooms(const Scene& scene, const WalkSpace& space) {
    WalkBody body = space.body;
    body.walls_only = true;
    const Result<WalkSpace> walls = make_walk_space(scene, body);
    return Builder(scene, space, walls ? *walls : space).build();
}

std::string own_name(const Room& room) {
    std::string name = unnumbered(room);
    return room.same_name > 1 ? phrase("room_name.another", {{"room", name}, {"number", room.same_name}}) : name;
}

const std::string& known_as(const Room& room) { return room.given ? room.name : room.map_name; }

void say_room_names(RoomGraph& graph) {
    if (std::string spoken = spoken_language(); graph.language != spoken) graph.language = std::move(spoken);
    else return;
    for (Room& room : graph.rooms)
        if (!room.given) room.name = own_name(room);
}

std::uint32_t room_at(const RoomGraph& graph, const WalkSpace& space, const Vec3& feet_m) {
    std::uint32_t span = space.at(feet_m);
    if (span == kNothing) span = space.nearest(feet_m, 0.5, 0.6, 0.6);
    return span == kNothing || span >= graph.room_of_span.size() ? kNothing : graph.room_of_span[span];
}

std::vector<std::string> give_names(RoomGraph& graph, const WalkSpace& space, const std::vector<GivenName>& names) {
    std::vector<std::string> homeless;
    std::vector<bool> taken(graph.rooms.size(), false);
    for (const GivenName& given : names) {
        const std::uint32_t room = room_at(graph, space, given.at_m);
        if (room == kNothing || taken[room]) {
            homeless.push_back(given.name);
            continue;
        }
        taken[room] = true;
        graph.rooms[room].name = given.name;
        graph.rooms[room].given = true;
    }
    return homeless;
}

std::vector<std::uint32_t> exits_of(const RoomGraph& graph, std::uint32_t room, const Vec3& feet_m, double heading_rad) {
    std::vector<std::pair<double, std::uint32_t>> exits;
    for (std::uint32_t p = 0; p < graph.portals.size(); ++p) {
        const Portal& portal = graph.portals[p];
        if (portal.rooms[0] != room && (portal.one_way || portal.rooms[1] != room)) continue;
        const Vec3 off = portal.place_m - feet_m;
        double turn = std::fmod(std::atan2(off.x, off.y) - heading_rad, 2.0 * kPi);
        if (turn < -1e-9) turn += 2.0 * kPi;
        exits.emplace_back(turn, p);
    }
    std::stable_sort(exits.begin(), exits.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::uint32_t> found;
    for (const auto& exit : exits) found.push_back(exit.second);
    return found;
}

}  // namespace handrail
