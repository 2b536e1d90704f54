#include "worlds/navigation/rooms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "worlds/base/language.h"
#include "worlds/navigation/open_places.h"
#include "worlds/navigation/reach.h"
#include "worlds/navigation/stated_rooms.h"
#include "worlds/scene/outer_ground.h"
#include "worlds/scene/surfaces.h"

namespace handrail::navigation {
namespace {

// If the span is on the ground that a reader added outside a building, returns that ground; else null.
const Feature* outer_ground_under(std::uint32_t span, const WalkSpace& space, const Scene& scene) {
    const std::uint32_t ground = span == kNothing ? kNothing : space.spans[span].ground;
    const Feature* feature =
        ground < space.obstacle_features.size() ? scene.find(space.obstacle_features[ground]) : nullptr;
    return feature && is_outer_ground(*feature) ? feature : nullptr;
}

const Feature* ground_at_middle(const Room& room, const WalkSpace& space, const Scene& scene) {
    return outer_ground_under(space.at(room.middle_m), space, scene);
}

constexpr double kLeastRoom_m2 = 0.8, kNiche_m2 = 3.0, kLeastBorder_m2 = 1.0;
constexpr double kNextStorey_m = 2.0;  // floors that are farther apart in height are on two storeys
constexpr double kHalfStorey_m = 1.1;  // the same limit if the file states both storeys
// Greatest distance between the height that a file states for a storey and the floors of its rooms.
constexpr double kOnStorey_m = 0.5;
constexpr double kMostNextTo_m = 10.0;  // greatest distance from the middle of a landmark to the floor next to it
constexpr double kOnePortal_m = 1.0;    // two stretches of a border with a smaller gap between them are one portal

MadeRoomName by_thing(const Feature& feature) {
    MadeRoomName called;
    called.thing = feature.name;
    called.thing_made = feature.made_name;
    called.thing_in = feature.name_in;
    return called;
}

std::string made_name(const MadeRoomName& made) {
    constexpr std::array kLooks{"room_name.niche", "room_name.corridor",   "room_name.small_room",
                                "room_name.room",  "room_name.large_room", "room_name.hall"};
    std::string thing = in_spoken_language(made.thing_made ? spoken_kind(made.thing) : made.thing, made.thing_in);
    if (made.with_thing)
        return phrase(made.look == RoomLook::Niche ? "room_name.niche_with" : "room_name.room_with",
                      {{"thing", thing}});
    if (!thing.empty()) return thing;
    const std::string look = phrase(kLooks[static_cast<std::size_t>(made.look)]);
    const std::string side = made.side_rad ? compass_word(*made.side_rad) : phrase("room_name.middle");
    const std::string name =
        phrase("room_name.by_size", {{"look", look}, {"wide", made.wide_m}, {"deep", made.deep_m}, {"side", side}});
    if (made.levels > 1 && !made.storey.empty())
        return phrase("room_name.on_storey", {{"room", name}, {"storey", made.storey}});
    if (made.levels == 2)
        return phrase(made.level == 0 ? "room_name.lower_level" : "room_name.upper_level", {{"room", name}});
    return made.levels > 2 ? phrase("room_name.level", {{"room", name}, {"level", made.level + 1}}) : name;
}

std::string unnumbered(const Room& room) {
    return room.map_name.empty() ? made_name(room.made) : in_spoken_language(room.map_name, room.map_name_in);
}

class Builder {
public:
    // `walls` is the same floor as `space`, but without furniture.
    Builder(const Scene& scene, const WalkSpace& space, const SpanGrid<WallSpan>& walls, const std::stop_token& stop)
        : scene_(scene), space_(space), walls_(walls), stop_(stop), label_(space.spans.size(), kNothing) {}

    RoomGraph build() {
        const auto stairs = [](const WalkSpan& s) { return s.stairs && s.door == kNothing && !s.liquid; };
        const auto liquid = [](const WalkSpan& s) { return s.liquid && s.door == kNothing; };
        const std::array<std::function<void()>, 11> stages{
            [&] { take_open_places(); },
            // Makes rooms of floor that is in no open place, such as the floor on top of furniture.
            [&] { pieces_of([](const WalkSpan& s) { return plain(s); }, RoomKind::Room); },
            [&] { pieces_of(stairs, RoomKind::Stairs); },
            [&] { pieces_of(liquid, RoomKind::Liquid); },
            [&] { absorb_crumbs(); },
            [&] { find_door_sides(); },
            [&] { spread_into_doors(); },
            [&] { number_rooms(); },
            [&] { measure(); },
            [&] { join(); },
            [&] { name(); },
        };
        for (const auto& stage : stages) {
            if (stop_.stop_requested()) return {};
            stage();
        }
        if (stop_.stop_requested()) return {};
        return std::move(graph_);
    }

private:
    static bool plain(const WalkSpan& s) { return s.door == kNothing && !s.stairs && !s.liquid; }
    double clearance(std::uint32_t s) const { return static_cast<double>(space_.spans[s].clearance_m); }
    double area(std::size_t cells) const { return static_cast<double>(cells) * space_.cell_area_m2(); }

    // Assigns each plain span to the open place below it. Open places were found on the floor without furniture.
    void take_open_places() {
        places_ = open_places(scene_, walls_, space_.cell_area_m2(), space_.body.radius_m, stop_);
        kinds_.assign(places_.names.size(), RoomKind::Room);
        names_ = places_.names;
        const double reach_m = 1.5 * space_.body.step_up_m;
        for (std::uint32_t s = 0; s < space_.spans.size() && !places_.of_span.empty(); ++s)
            if (plain(space_.spans[s]))
                if (const std::uint32_t under = walls_.nearest(space_.place_m(s), 0.0, reach_m, reach_m);
                    under != kNothing)
                    label_[s] = places_.of_span[under];
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

    // Joins pieces that are too small to be rooms to a neighbour. The neighbour is the one with which a piece has the
    // longest common border.
    void absorb_crumbs() {
        for (int round = 0; round < 4 && !stop_.stop_requested(); ++round) {
            std::vector<std::size_t> cells(kinds_.size(), 0);
            std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> border;
            for (std::uint32_t s = 0; s < space_.spans.size(); ++s) {
                if (label_[s] == kNothing) continue;
                ++cells[label_[s]];
                for (const std::uint32_t n : space_.spans[s].next)
                    if (n != kNothing && label_[n] != kNothing && label_[n] != label_[s])
                        ++border[{label_[s], label_[n]}];
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
                    if (goes[other] != other || cells[other] < cells[l] || (cells[other] == cells[l] && other > l) ||
                        it->second <= longest)
                        continue;
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

    // Finds the rooms on both sides of each door, before the spans in the doorway become part of one of them.
    void find_door_sides() {
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s) {
            if (space_.spans[s].door == kNothing) continue;
            const std::uint32_t group = scene_.movers[space_.spans[s].door].group;
            for (const std::uint32_t n : space_.spans[s].next)
                if (n != kNothing && label_[n] != kNothing) ++door_sides_[group][label_[n]];
        }
        if (scene_.stated) take_stated_doors();
    }

    // Replaces the two sides of a door that were found with those that the file states. If the file states only one
    // room, the other side is outside, unless rooms were found on both sides.
    void take_stated_doors() {
        for (const StatedPortal& stated : scene_.stated->portals) {
            const auto mover = std::find_if(scene_.movers.begin(), scene_.movers.end(),
                                            [&](const Mover& m) { return m.feature == stated.feature; });
            if (stated.kind != StatedPortalKind::Door || mover == scene_.movers.end() || stated.rooms.empty() ||
                stated.rooms.size() > 2)
                continue;
            std::map<std::uint32_t, std::size_t>& found = door_sides_[mover->group];
            if (stated.rooms.size() == 1 && found.size() > 1) continue;
            const std::uint32_t a = places_.of_stated[stated.rooms[0]],
                                b = stated.rooms.size() == 2 ? places_.of_stated[stated.rooms[1]] : places_.outside;
            if (a != kNothing && b != kNothing && !found.empty()) found = {{a, 1}, {b, 1}};
        }
    }
    bool beside_stated_door(const std::pair<std::uint32_t, std::uint32_t>& rooms, const Vec3& at_m) const {
        // An opening within this distance of a door is the doorway of that door, whose border is a walker's radius away
        // from the leaf.
        constexpr double kSame_m = 1.0;
        return scene_.stated && std::any_of(graph_.portals.begin(), graph_.portals.end(), [&](const Portal& p) {
                   return p.kind == PassageKind::Door && p.rooms[0] == rooms.first && p.rooms[1] == rooms.second &&
                          glm::length(p.place_m - at_m) < kSame_m;
               });
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
        // The doorways of doors that lead nowhere become rooms of their own.
        pieces_of([](const WalkSpan&) { return true; }, RoomKind::Niche);
    }

    void number_rooms() {
        std::vector<std::uint32_t> number(kinds_.size(), kNothing);
        // For each name, its first translation. Nothing iterates over this map, because its order is arbitrary.
        std::unordered_map<std::string_view, const OtherLanguages*> names_in;
        for (const RoomName& given : scene_.room_names)
            if (!given.name_in.empty()) names_in.try_emplace(given.name, &given.name_in);
        for (std::uint32_t& l : label_) {
            if (number[l] == kNothing) {
                number[l] = static_cast<std::uint32_t>(graph_.rooms.size());
                Room room;
                room.kind = kinds_[l];
                room.map_name = names_[l];
                if (const auto found = names_in.find(room.map_name); found != names_in.end())
                    room.map_name_in = *found->second;
                graph_.rooms.push_back(room);
            }
            l = number[l];
        }
        std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> sides;
        for (const auto& [group, labels] : door_sides_)
            for (const auto& [l, count] : labels)
                if (number[l] != kNothing) sides[group][number[l]] += count;
        door_sides_ = std::move(sides);
        if (places_.outside != kNothing) outside_room_ = number[places_.outside];
        graph_.room_of_span = label_;
    }

    // If two rooms are open to each other, the widest place of a room may be on the border between them. On the border
    // it would be unclear in which room a person is. This function moves such a middle to the place farthest from walls
    // and borders.
    void draw_middles_in() {
        constexpr double kOffBorder_m = 0.25;
        const auto most = static_cast<std::uint32_t>(std::lround(kOffBorder_m / space_.cell_m));
        std::vector<bool> drawn_in(graph_.rooms.size(), false);
        for (std::size_t r = 0; r < graph_.rooms.size(); ++r) {
            const std::uint32_t middle = space_.at(graph_.rooms[r].middle_m);
            if (middle == kNothing || label_[middle] != r) continue;
            std::vector<std::uint32_t> near{middle};
            std::unordered_set<std::uint32_t> seen{middle};
            std::size_t end = 0;
            for (std::uint32_t ring = 0; ring < most && !drawn_in[r]; ++ring)
                for (const std::size_t next_end = near.size(); end < next_end; ++end)
                    for (const std::uint32_t n : space_.spans[near[end]].next) {
                        if (n == kNothing || !seen.insert(n).second) continue;
                        drawn_in[r] = drawn_in[r] || label_[n] != r;
                        near.push_back(n);
                    }
        }
        if (std::none_of(drawn_in.begin(), drawn_in.end(), [](bool in) { return in; })) return;
        // Measures the distance of each span from the borders, in rings that grow inwards.
        std::vector<float> off_m(space_.spans.size(), std::numeric_limits<float>::max());
        std::vector<std::uint32_t> ring;
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s)
            if (drawn_in[label_[s]] &&
                std::any_of(std::begin(space_.spans[s].next), std::end(space_.spans[s].next),
                            [&](std::uint32_t n) { return n != kNothing && label_[n] != label_[s]; })) {
                off_m[s] = 0.0F;
                ring.push_back(s);
            }
        for (std::size_t i = 0; i < ring.size(); ++i)
            for (const std::uint32_t n : space_.spans[ring[i]].next)
                if (n != kNothing && label_[n] == label_[ring[i]] && off_m[n] == std::numeric_limits<float>::max()) {
                    off_m[n] = off_m[ring[i]] + static_cast<float>(space_.cell_m);
                    ring.push_back(n);
                }
        std::vector<double> widest(graph_.rooms.size(), -1.0);
        for (const std::uint32_t s : ring) {
            const std::uint32_t r = label_[s];
            const double wide = std::min(clearance(s), static_cast<double>(off_m[s]));
            if (!goal_[s] || wide <= widest[r]) continue;
            widest[r] = wide;
            graph_.rooms[r].middle_m = space_.place_m(s);
        }
    }

    // Finds the spans that may be the middle of a room, to which routes lead. A room may consist of several pieces. If
    // people can reach any part of it from the base, its middle must be in such a part.
    void find_goals() {
        goal_.assign(space_.spans.size(), true);
        const Start* const base = base_of(scene_);
        const std::uint32_t first = base ? space_.at(base->feet_m) : kNothing;
        if (first == kNothing) return;
        const std::vector<bool> reached = spans_reached(space_, first);
        std::vector<bool> comes_to(graph_.rooms.size(), false);
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s)
            if (reached[s]) comes_to[label_[s]] = true;
        // The middle of the ground outside must be on the ground itself, not on a path that crosses it.
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s)
            goal_[s] = (reached[s] || !comes_to[label_[s]]) &&
                       (label_[s] != outside_room_ || outer_ground_under(s, space_, scene_));
    }

    bool is_on_stated_storey(double floor_m) const {
        return scene_.stated && std::any_of(scene_.stated->storeys.begin(), scene_.stated->storeys.end(),
                                            [&](const StatedStorey& storey) {
                                                return storey.rooms > 0 &&
                                                       std::abs(storey.floor_m - floor_m) <= kOnStorey_m;
                                            });
    }

    void measure() {
        find_goals();
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
            if (goal_[s] && clearance(s) > widest[label_[s]]) {
                widest[label_[s]] = clearance(s);
                room.middle_m = place;
            }
        }
        draw_middles_in();
        for (std::size_t r = 0; r < graph_.rooms.size(); ++r) {
            Room& room = graph_.rooms[r];
            room.floor_m /= static_cast<double>(std::max<std::size_t>(cells[r], 1));
            room.area_m2 = area(cells[r]) + static_cast<double>(rim[r]) * space_.cell_m * space_.body.radius_m;
            room.bounds_m.min_m -= Vec3(space_.body.radius_m, space_.body.radius_m, 0.0);
            room.bounds_m.max_m += Vec3(space_.body.radius_m, space_.body.radius_m, 0.0);
            if (room.kind == RoomKind::Room && room.area_m2 < kNiche_m2 && room.map_name.empty())
                room.kind = RoomKind::Niche;
        }
        std::vector<std::size_t> by_height(graph_.rooms.size());
        std::iota(by_height.begin(), by_height.end(), std::size_t{0});
        std::stable_sort(by_height.begin(), by_height.end(), [&](std::size_t a, std::size_t b) {
            return graph_.rooms[a].floor_m < graph_.rooms[b].floor_m;
        });
        double base = graph_.rooms.empty() ? 0.0 : graph_.rooms[by_height[0]].floor_m;
        for (const std::size_t r : by_height) {
            Room& room = graph_.rooms[r];
            const bool half =
                room.floor_m > base + kHalfStorey_m && is_on_stated_storey(room.floor_m) && is_on_stated_storey(base);
            if (room.kind == RoomKind::Room && (room.floor_m > base + kNextStorey_m || half)) {
                base = room.floor_m;
                ++levels_;
            }
            room.level = levels_ - 1;
        }
    }

    void join() {
        struct Leaves {
            Aabb box;
            FeatureId first = kNoFeature;
        };
        std::map<std::uint32_t, Leaves> leaves_of;  // the leaves of each group
        for (const Mover& mover : scene_.movers) {
            Leaves& leaves = leaves_of[mover.group];
            leaves.box.include(scene_.features[mover.feature.value].bounds_m);
            if (!leaves.first) leaves.first = mover.feature;
        }
        for (const auto& [group, sides] : door_sides_) {
            if (sides.size() < 2) continue;
            std::vector<std::pair<std::uint32_t, std::size_t>> by_border(sides.begin(), sides.end());
            std::stable_sort(by_border.begin(), by_border.end(),
                             [](const auto& a, const auto& b) { return a.second > b.second; });
            Portal portal;
            portal.kind = PassageKind::Door;
            portal.rooms = {std::min(by_border[0].first, by_border[1].first),
                            std::max(by_border[0].first, by_border[1].first)};
            const Aabb& box = leaves_of[group].box;
            portal.feature = leaves_of[group].first;
            const Vec3 centre = box.centre_m();
            portal.width_m = std::max(box.size_m().x, box.size_m().y);
            portal.place_m = {centre.x, centre.y, box.min_m.z};
            graph_.portals.push_back(portal);
        }
        // Finds the portals without a door: stretches of the border between two rooms.
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
                const bool stairs = graph_.rooms[rooms.first].kind == RoomKind::Stairs ||
                                    graph_.rooms[rooms.second].kind == RoomKind::Stairs;
                portal.kind = stairs ? PassageKind::Stairs : PassageKind::Opening;
                portal.place_m = stretch.sum / static_cast<double>(stretch.cells);
                if (beside_stated_door(rooms, portal.place_m)) continue;
                portal.width_m =
                    std::hypot(stretch.box.size_m().x, stretch.box.size_m().y) + 2.0 * space_.body.radius_m;
                graph_.portals.push_back(portal);
            }
        std::set<std::tuple<PassageKind, std::uint32_t, std::uint32_t, std::uint32_t>>
            // Two rooms have at most one drop in each direction. Links of other kinds make one portal for each feature.
            known;
        for (const WalkLink& link : space_.links) {
            const std::uint32_t a = label_[link.from], b = label_[link.to];
            if (a == b ||
                !known.emplace(link.kind, a, b, link.kind == PassageKind::Drop ? kNothing : link.feature.value).second)
                continue;
            graph_.portals.push_back(
                {link.kind, {a, b}, space_.place_m(link.from), 1.0, link.feature, !link.both_ways});
        }
    }

    // Names each room by an object in it. If a room has no object, its size and place give the name.
    void name() {
        std::vector<MadeRoomName> content(graph_.rooms.size());
        for (const Feature& feature : scene_.features) {
            if (!feature.landmark || feature.bounds_m.empty() || feature.kind == FeatureKind::Door) continue;
            const Vec3 c = feature.bounds_m.centre_m(), size = feature.bounds_m.size_m();
            if (stop_.stop_requested()) return;
            const double beside_m = std::min(0.5 * std::max(size.x, size.y) + 1.0, kMostNextTo_m);
            const std::uint32_t s = space_.nearest({c.x, c.y, feature.bounds_m.min_m.z}, beside_m, 0.6, 2.0);
            if (s != kNothing && content[label_[s]].thing.empty()) content[label_[s]] = by_thing(feature);
        }
        std::vector<Aabb> levels(static_cast<std::size_t>(levels_));
        for (const Room& room : graph_.rooms) levels[static_cast<std::size_t>(room.level)].include(room.bounds_m);
        const std::vector<std::string> storeys = storey_names();
        const std::vector<const Feature*> grounds = grounds_of_stairs();
        std::set<std::string> ways;
        for (std::size_t r = 0; scene_.stated && r < scene_.stated->rooms.size(); ++r)
            if (scene_.stated->rooms[r].is_way) ways.insert(scene_.stated->rooms[r].name);
        for (std::uint32_t r = 0; r < graph_.rooms.size(); ++r) {
            Room& room = graph_.rooms[r];
            room.is_way = ways.contains(room.map_name);
            if (!room.map_name.empty()) continue;
            if (room.kind == RoomKind::Stairs)
                room.made = grounds[r] ? by_thing(*grounds[r]) : MadeRoomName{.thing = "stairs", .thing_made = true};
            else if (room.kind == RoomKind::Liquid) room.made = liquid_name(r);
            else if (const Feature* ground = scene_.stated ? ground_at_middle(room, space_, scene_) : nullptr)
                room.made = by_thing(*ground);
            else if (content[r].thing.empty()) room.made = by_size(room, levels[static_cast<std::size_t>(room.level)]);
            else {
                room.made = content[r];
                room.made.with_thing = true;
                if (room.kind == RoomKind::Niche) room.made.look = RoomLook::Niche;
            }
            room.made.storey = storeys[static_cast<std::size_t>(room.level)];
        }
        number_room_names(graph_);
    }

    // Returns the name that the file gives to each level. The median floor height of the level's rooms selects the
    // storey of the file.
    std::vector<std::string> storey_names() const {
        std::vector<std::string> names(static_cast<std::size_t>(levels_));
        if (!scene_.stated) return names;
        std::vector<std::vector<double>> stated(names.size()), all(names.size());
        for (const Room& room : graph_.rooms) {
            const auto level = static_cast<std::size_t>(room.level);
            all[level].push_back(room.floor_m);
            if (!room.map_name.empty()) stated[level].push_back(room.floor_m);
        }
        for (std::size_t level = 0; level < names.size(); ++level) {
            std::vector<double>& floors = stated[level].empty() ? all[level] : stated[level];
            if (floors.empty()) continue;
            const auto middle = floors.begin() + static_cast<std::ptrdiff_t>(floors.size() / 2);
            std::nth_element(floors.begin(), middle, floors.end());
            names[level] = stated_storey_around(*scene_.stated, *middle);
        }
        return names;
    }

    // Returns, for each flight of stairs, the first named object on which people walk there.
    std::vector<const Feature*> grounds_of_stairs() const {
        std::vector<const Feature*> grounds(graph_.rooms.size(), nullptr);
        for (std::uint32_t s = 0; s < label_.size(); ++s) {
            const std::uint32_t room = label_[s], ground = space_.spans[s].ground;
            if (grounds[room] || graph_.rooms[room].kind != RoomKind::Stairs ||
                ground >= space_.obstacle_features.size())
                continue;
            const Feature* feature = scene_.find(space_.obstacle_features[ground]);
            if (feature && feature->kind == FeatureKind::Object && !feature->name.empty()) grounds[room] = feature;
        }
        return grounds;
    }
    MadeRoomName liquid_name(std::uint32_t room) const {
        for (const Solid& solid : scene_.solids)
            if (solid.role == SolidRole::Liquid && solid.feature &&
                contains(solid.shape, graph_.rooms[room].middle_m + Vec3(0.0, 0.0, 0.3)))
                return by_thing(scene_.features[solid.feature.value]);
        return {.thing = "water", .thing_made = true};
    }
    MadeRoomName by_size(const Room& room, const Aabb& level) const {
        const Vec3 size = room.bounds_m.size_m(), all = level.size_m(), off = room.middle_m - level.centre_m();
        const double least = std::min(size.x, size.y), most = std::max(size.x, size.y);
        MadeRoomName made;
        made.look = room.kind == RoomKind::Niche                         ? RoomLook::Niche
                    : most > 3.0 * least && (least < 2.5 || most > 12.0) ? RoomLook::Corridor
                    : room.area_m2 < 6.0                                 ? RoomLook::SmallRoom
                    : room.area_m2 > 250.0                               ? RoomLook::Hall
                    : room.area_m2 > 80.0                                ? RoomLook::LargeRoom
                                                                         : RoomLook::Room;
        made.wide_m = static_cast<int>(std::nearbyint(std::max(1.0, size.x)));
        made.deep_m = static_cast<int>(std::nearbyint(std::max(1.0, size.y)));
        if (std::abs(off.x) >= 0.15 * all.x || std::abs(off.y) >= 0.15 * all.y)
            made.side_rad = std::atan2(off.x, off.y);
        made.level = room.level;
        made.levels = levels_;
        return made;
    }

    const Scene& scene_;
    const WalkSpace& space_;
    const SpanGrid<WallSpan>& walls_;
    std::stop_token stop_;
    std::vector<bool> goal_;  // for each span: whether it may be the middle of its room
    OpenPlaces places_;
    // For each span: number of its room; while open places are found, the number of its open place.
    std::vector<std::uint32_t> label_;
    std::vector<RoomKind> kinds_;
    std::uint32_t outside_room_ = kNothing;  // room of the ground that a reader added
    std::vector<std::string> names_;
    std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> door_sides_;
    int levels_ = 1;
    RoomGraph graph_;
};

}  // namespace

RoomGraph make_rooms(const Scene& scene, const WalkSpace& space, const std::stop_token& stop) {
    if (space.walls) return Builder(scene, space, *space.walls, stop).build();
    // A copy of the floor with furniture. It is used if nobody can stand on the floor without furniture, or if that
    // floor was freed.
    SpanGrid<WallSpan> as_it_is{space.origin_m, space.cell_m, space.width, space.depth, space.first, {}};
    for (const WalkSpan& s : space.spans)
        as_it_is.spans.push_back({s.floor_m,
                                  {s.next[0], s.next[1], s.next[2], s.next[3]},
                                  s.clearance_m,
                                  s.cell & 0x1fffffffU,
                                  s.door != kNothing ? 1U : 0U,
                                  s.liquid ? 1U : 0U,
                                  s.stairs ? 1U : 0U});
    return Builder(scene, space, as_it_is, stop).build();
}

std::string own_name(const Room& room) {
    std::string name = unnumbered(room);
    return room.same_name > 1 ? phrase("room_name.another", {{"room", name}, {"number", room.same_name}}) : name;
}

const std::string& known_as(const Room& room) { return room.given ? room.name : room.map_name; }

void number_room_names(RoomGraph& graph) {
    graph.language = spoken_language();
    std::map<std::string, int> seen;
    for (Room& room : graph.rooms) {
        room.same_name = room.is_way ? 1 : ++seen[unnumbered(room)];
        room.name = own_name(room);
    }
}

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

bool stands_inside(const RoomGraph& graph, const WalkSpace& space, const Scene& scene, const Vec3& feet_m,
                   std::uint32_t room) {
    constexpr double kInside_m = 0.15;
    const auto room_of = [&](const Vec3& at_m) {
        const std::uint32_t span = space.at(at_m);
        return span == kNothing || span >= graph.room_of_span.size() ? kNothing : graph.room_of_span[span];
    };
    const StatedRoom* const outline = stated_room_at(scene, graph.rooms[room].middle_m);
    if (room_of(feet_m) != room || (outline && !holds(*outline, feet_m))) return false;
    for (int eighth = 0; eighth < 8; ++eighth) {
        const double way_rad = eighth * kPi / 4.0;
        const Vec3 beside_m = feet_m + Vec3(kInside_m * std::sin(way_rad), kInside_m * std::cos(way_rad), 0.0);
        const std::uint32_t there = room_of(beside_m);
        if (there != kNothing && (there != room || (outline && !holds(*outline, beside_m)))) return false;
    }
    return true;
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

std::vector<std::uint32_t> exits_of(const RoomGraph& graph, std::uint32_t room, const Vec3& feet_m,
                                    double heading_rad) {
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

bool is_outside(const Room& room, const WalkSpace& space, const Scene& scene) {
    return ground_at_middle(room, space, scene) != nullptr;
}

std::vector<Aabb> door_boxes(const Scene& scene, const RoomGraph& graph, FeatureId door) {
    std::vector<Aabb> boxes;
    std::vector<FeatureId> leaves{door};
    for (const Mover& one : scene.movers)
        for (const Mover& other : scene.movers)
            if (one.feature == door && other.group == one.group && other.feature != door)
                leaves.push_back(other.feature);
    for (const FeatureId leaf : leaves) {
        if (!scene.find(leaf)) continue;
        boxes.push_back(scene.features[leaf.value].bounds_m);
        for (const Portal& portal : graph.portals) {
            if (portal.feature != leaf) continue;
            const Vec3 half(0.5 * portal.width_m, 0.5 * portal.width_m, 0.0);
            boxes.push_back({portal.place_m - half, portal.place_m + half + Vec3(0.0, 0.0, 2.0)});
        }
    }
    return boxes;
}

}  // namespace handrail::navigation
