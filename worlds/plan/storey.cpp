#include "worlds/plan/storey.h"

#include <algorithm>
#include <map>
#include <set>

#include "worlds/base/language.h"
#include "worlds/navigation/room_outlines.h"
#include "worlds/plan/storey_grid.h"
#include "worlds/scene/outer_ground.h"
#include "worlds/scene/stated_building.h"

namespace handrail::plan {
namespace {

constexpr double kAround_m = 0.6;       // width of the strip around the rooms whose content is shown as well
constexpr double kBaseNear_m = 5.0;     // the base is shown, too, if it is within this distance of the rooms
constexpr double kSillFrom_m = 0.3;     // a part whose top is less than this above the floor can be stepped over
constexpr double kWindowDeep_m = 0.45;  // greatest depth of a part that closes a window
// A part that extends at least this far below the top of a person's head stops the person.
constexpr double kUnderHead_m = 0.05;
constexpr double kThingFrom_m = 0.25, kLeastThing_m = 0.05;
// Measures of a partition between walls and of a pane of glass that closes a front: greatest thickness, least length
// and least height.
constexpr double kPartitionThin_m = 0.2;
constexpr double kPaneThin_m = 0.12, kPaneLong_m = 0.4, kPaneHigh_m = 1.2;
constexpr double kStep_m = 0.6;
constexpr double kLongestTread_m = 1.5;  // greatest length of a tread of a wide solid step; a longer part is a stage
// Greatest distance, in steps of 5 cm, between a gap and the place where the rooms meet.
constexpr int kNextToSteps = 8;
constexpr double kWidestGap_m = 4.0;  // greatest distance between the jambs; a wider opening is not a gap in a wall

constexpr double kNextToPortal_m = 0.5;  // distance by which an opening may extend beyond the width of its portal
constexpr double kStandsIn_m = 0.15;     // length of an opening that a thing must cover to close it
constexpr double kFloorNearPortal_m = 2.0;
// Floors whose heights differ by more than kFloorsApart_m are above each other. If at least kLeastHidden_m2 of a room
// is hidden, the second plan shows the room. That plan extends kAroundUpper_m beyond its rooms.
constexpr double kFloorNearJoint_m = 0.8, kFloorsApart_m = 1.0, kLeastHidden_m2 = 1.0, kAroundUpper_m = 2.0;

bool inside_any(const std::vector<PlanOutline>& outlines, const Vec2& at) {
    return std::any_of(outlines.begin(), outlines.end(), [&](const PlanOutline& o) { return within(o, at); });
}

// Returns the centroid of the area within a closed line.
Vec2 middle_of(const std::vector<Vec2>& loop, double& area_m2) {
    Vec2 sum(0.0);
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = loop[i] - loop.front(), b = loop[(i + 1) % loop.size()] - loop.front();
        sum += (a + b) * cross_of(a, b);
        twice += cross_of(a, b);
    }
    area_m2 = 0.5 * std::abs(twice);
    return twice == 0.0 ? loop.front() : loop.front() + sum / (3.0 * twice);
}

bool is_structure(const Scene& scene, FeatureId id) {
    const Feature* feature = scene.find(id);
    if (!feature) return true;
    return feature->kind == FeatureKind::Wall || feature->kind == FeatureKind::Floor ||
           feature->kind == FeatureKind::Ceiling || feature->kind == FeatureKind::Slope;
}

void clear_floor(Storey& storey) {
    StoreyFloor& floor = storey.floor;
    const Vec2 size = storey.max_m - storey.min_m;
    floor.wide = std::max(0, static_cast<int>(std::ceil(size.x / floor.cell_m)));
    floor.high = std::max(0, static_cast<int>(std::ceil(size.y / floor.cell_m)));
    floor.room.assign(static_cast<std::size_t>(floor.wide) * static_cast<std::size_t>(floor.high),
                      navigation::kNothing);
}

// Makes a storey step by step. The members are listed in the order in which their content becomes known.
class StoreyMaker {
    // A thing, or a part that stops only bodies and not the hand. It becomes a wall if nothing else separates two
    // rooms.
    struct Barrier {
        FeatureId feature = kNoFeature;
        std::vector<PlanOutline> outlines_m = {};
        // The area where the barrier stops a body, if that area is larger than its outlines.
        std::vector<PlanOutline> reach_m = {};
        bool wall = false;
    };

public:
    // `upper` is empty for the first plan of a storey. For the second plan, it contains the rooms of that plan, as
    // indices in the graph.
    StoreyMaker(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space, int number,
                std::set<std::uint32_t> upper = {})
        : scene_(scene), graph_(graph), space_(space), level_(number - 1), upper_(std::move(upper)) {
        made_.number = number;
        made_.upper = !upper_.empty();
        made_.count = storey_count(graph);
        made_.world = spoken_name(scene);
        for (const navigation::WalkSpan& span : space.spans)
            if (span.ground != navigation::kNothing && span.ground < space.obstacle_features.size())
                trodden_.insert(space.obstacle_features[span.ground].value);
        for (const FreeBody& body : scene.bodies) moving_.insert(body.feature.value);
    }

    Storey make() {
        take_rooms();
        take_portals();
        take_walls();
        if (!made_.rooms.empty()) drop_spaces_under_steps();
        take_things();  // also adds to the walls the things that close windows
        take_low_roofs();
        if (!made_.rooms.empty()) close_rooms();
        if (!made_.rooms.empty()) drop_ledges();
        take_gaps();
        if (!made_.rooms.empty()) open_portals();
        drop_far_walls(made_);
        find_beyond(made_);
        return std::move(made_);
    }

private:
    double cut_m() const { return made_.floor_m + kPlanCutAboveFeet_m; }

    // True if most of the room's floor is on the ground that a reader added around a building.
    bool on_outer_ground(std::uint32_t room) const {
        std::size_t all = 0, outer = 0;
        for (std::uint32_t i = 0; i < space_.spans.size(); ++i) {
            if (graph_.room_of_span[i] != room) continue;
            ++all;
            const std::uint32_t ground = space_.spans[i].ground;
            const Feature* feature =
                ground < space_.obstacle_features.size() ? scene_.find(space_.obstacle_features[ground]) : nullptr;
            outer += feature && is_outer_ground(*feature) ? 1 : 0;
        }
        return 2 * outer > all;
    }

    bool is_shown(std::uint32_t room) const {
        if (graph_.rooms[room].level != level_) return false;
        return !made_.upper || upper_.contains(room) ||
               std::any_of(graph_.portals.begin(), graph_.portals.end(), [&](const navigation::Portal& portal) {
                   return (portal.rooms[0] == room && upper_.contains(portal.rooms[1])) ||
                          (portal.rooms[1] == room && upper_.contains(portal.rooms[0]));
               });
    }

    void take_rooms() {
        const std::vector<navigation::RoomOutline> outlines = navigation::room_outlines(graph_, space_);
        double floor = 0.0, area = 0.0;
        Vec2 low(std::numeric_limits<double>::infinity()), high(-low);
        for (std::uint32_t i = 0; i < graph_.rooms.size(); ++i) {
            const navigation::Room& room = graph_.rooms[i];
            if (!is_shown(i) || outlines[i].loops_m.empty()) continue;
            StoreyRoom mine;
            mine.room = i;
            mine.name = room.name;
            mine.kind = room.kind;
            mine.loops_m = outlines[i].loops_m;
            mine.area_m2 = room.area_m2;
            mine.min_m = Vec2(std::numeric_limits<double>::infinity());
            mine.max_m = -mine.min_m;
            double largest = -1.0;
            for (const auto& loop : mine.loops_m) {
                double loop_area = 0.0;
                const Vec2 middle = middle_of(loop, loop_area);
                if (loop_area > largest) largest = loop_area, mine.middle_m = middle;
                for (const Vec2& p : loop) {
                    mine.min_m = glm::min(mine.min_m, p);
                    mine.max_m = glm::max(mine.max_m, p);
                }
            }
            mine.outside = on_outer_ground(i);
            mine.shut = graph_.rooms.size() > 1 && std::none_of(graph_.portals.begin(), graph_.portals.end(),
                                                                [&](const navigation::Portal& portal) {
                                                                    return portal.rooms[0] == i || portal.rooms[1] == i;
                                                                });
            mine.elsewhere = made_.upper && !upper_.contains(i);
            if (!mine.outside && !mine.elsewhere) {
                low = glm::min(low, mine.min_m);
                high = glm::max(high, mine.max_m);
            }
            const double weight = mine.elsewhere                                              ? 0.0
                                  : room.kind == navigation::RoomKind::Stairs || mine.outside ? 1e-6 * room.area_m2
                                                                                              : room.area_m2;
            floor += weight * room.floor_m;
            area += weight;
            made_.rooms.push_back(std::move(mine));
        }
        if (made_.rooms.empty()) return;
        if (!(low.x <= high.x))  // every room is on the ground outside
            for (const StoreyRoom& room : made_.rooms) {
                low = glm::min(low, room.min_m);
                high = glm::max(high, room.max_m);
            }
        if (area <= 0.0) return made_.rooms.clear();
        take_base();
        if (made_.base && glm::all(glm::greaterThan(made_.base->place_m, low - Vec2(kBaseNear_m))) &&
            glm::all(glm::lessThan(made_.base->place_m, high + Vec2(kBaseNear_m)))) {
            low = glm::min(low, made_.base->place_m);
            high = glm::max(high, made_.base->place_m);
        }
        made_.floor_m = floor / area;
        if (scene_.stated) made_.name = stated_storey_name(*scene_.stated, made_.floor_m);
        const double margin = space_.body.radius_m + (made_.upper ? kAroundUpper_m : kAround_m);
        made_.min_m = low - Vec2(margin);
        made_.max_m = high + Vec2(margin);
        take_floor();
        find_hidden();
        put_middles_on_floor();
        take_stairs_of_others(outlines);
    }

    void take_stairs_of_others(const std::vector<navigation::RoomOutline>& outlines) {
        std::map<std::uint32_t, std::uint32_t> mine;
        for (std::uint32_t i = 0; i < made_.rooms.size(); ++i) mine[made_.rooms[i].room] = i;
        std::set<std::uint32_t> taken;
        for (const navigation::Portal& portal : graph_.portals)
            for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
                const std::uint32_t flight = portal.rooms[side];
                const auto here = mine.find(portal.rooms[1 - side]);
                if (here == mine.end() || mine.contains(flight) ||
                    graph_.rooms[flight].kind != navigation::RoomKind::Stairs || outlines[flight].loops_m.empty() ||
                    !taken.insert(flight).second)
                    continue;
                made_.stairs_of_others.push_back({here->second, outlines[flight].loops_m});
            }
    }

    // The middle of a bent room, or of a room around others, may be in another room. Such a middle is moved to the
    // nearest place on the room's own floor.
    void put_middles_on_floor() {
        const StoreyFloor& floor = made_.floor;
        std::vector<double> nearest(made_.rooms.size(), std::numeric_limits<double>::infinity());
        std::vector<Vec2> middles(made_.rooms.size());
        for (std::size_t i = 0; i < floor.room.size(); ++i) {
            const std::uint32_t room = floor.room[i];
            if (room == navigation::kNothing) continue;
            const auto wide = static_cast<std::size_t>(floor.wide);
            const Vec2 at = made_.min_m + (Vec2(i % wide, i / wide) + Vec2(0.5)) * floor.cell_m;
            const double far = glm::length(at - made_.rooms[room].middle_m);
            if (far >= nearest[room]) continue;
            nearest[room] = far;
            middles[room] = at;
        }
        for (std::uint32_t room = 0; room < made_.rooms.size(); ++room) {
            const std::uint32_t there = floor_at(made_, made_.rooms[room].middle_m);
            if (there != room && there != navigation::kNothing && std::isfinite(nearest[room]))
                made_.rooms[room].middle_m = middles[room];
        }
    }

    void take_floor() {
        StoreyFloor& floor = made_.floor;
        clear_floor(made_);
        std::vector<std::uint32_t> mine(graph_.rooms.size(), navigation::kNothing);
        for (std::uint32_t i = 0; i < made_.rooms.size(); ++i) mine[made_.rooms[i].room] = i;
        // At a place with several floors, the lower one is shown, because a roof on which people can stand may belong
        // to the storey below it. There is one exception: ground that a reader added does not replace the floor of a
        // raised walkway or deck with entrances above it.
        const auto is_ground = [&](std::uint32_t room) { return made_.rooms[room].outside || made_.rooms[room].shut; };
        std::vector<double> height_m(floor.room.size(), std::numeric_limits<double>::infinity());
        for (std::uint32_t i = 0; i < space_.spans.size(); ++i) {
            const std::uint32_t room = graph_.room_of_span[i];
            if (room == navigation::kNothing || mine[room] == navigation::kNothing) continue;
            const Vec3 at = space_.place_m(i);
            const auto place = cell_at(at);
            if (!place) continue;
            const std::size_t cell = *place;
            const std::uint32_t known = floor.room[cell], here = mine[room];
            if (made_.upper) {  // the upper rooms have priority; other rooms are shown where they are level with them
                if (made_.rooms[here].elsewhere &&
                    (known != navigation::kNothing || std::abs(at.z - made_.floor_m) > kFloorsApart_m))
                    continue;
                if (known != navigation::kNothing && !made_.rooms[known].elsewhere && at.z <= height_m[cell]) continue;
            } else {
                const bool same_kind = known == navigation::kNothing || is_ground(known) == is_ground(here);
                if (same_kind ? at.z >= height_m[cell] : is_ground(here)) continue;
            }
            height_m[cell] = at.z;
            floor.room[cell] = here;
        }
        floor_height_m_ = std::move(height_m);
    }

    // Returns the cell of the floor at this place; empty outside the plan.
    std::optional<std::size_t> cell_at(const Vec3& at) const {
        const StoreyFloor& floor = made_.floor;
        const int x = static_cast<int>(std::floor((at.x - made_.min_m.x) / floor.cell_m));
        const int y = static_cast<int>(std::floor((at.y - made_.min_m.y) / floor.cell_m));
        if (x < 0 || y < 0 || x >= floor.wide || y >= floor.high) return std::nullopt;
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(floor.wide) + static_cast<std::size_t>(x);
    }

    // Finds rooms that other rooms hide. Flights are left out, because the plan shows their lower ends. Rooms to which
    // nothing leads are left out too, because nobody can walk into them.
    void find_hidden() {
        if (made_.upper) return;
        std::map<std::uint32_t, std::uint32_t> mine;
        for (std::uint32_t i = 0; i < made_.rooms.size(); ++i)
            if (const StoreyRoom& room = made_.rooms[i];
                !room.outside && !room.shut && room.kind != navigation::RoomKind::Stairs)
                mine[room.room] = i;
        std::vector<double> hidden_m2(made_.rooms.size(), 0.0);
        std::vector<double> seen_m2 = hidden_m2;
        for (std::uint32_t i = 0; i < space_.spans.size(); ++i) {
            const auto room = mine.find(graph_.room_of_span[i]);
            if (room == mine.end()) continue;
            const Vec3 at = space_.place_m(i);
            const auto cell = cell_at(at);
            if (!cell) continue;
            const std::uint32_t there = made_.floor.room[*cell];
            if (there == room->second) seen_m2[there] += space_.cell_area_m2();
            else if (there != navigation::kNothing && at.z > floor_height_m_[*cell] + kFloorsApart_m)
                hidden_m2[room->second] += space_.cell_area_m2();
        }
        for (std::uint32_t i = 0; i < made_.rooms.size(); ++i) {
            if (hidden_m2[i] < kLeastHidden_m2) continue;
            made_.hidden.push_back(i);
            made_.rooms[i].elsewhere = seen_m2[i] < kLeastHidden_m2;
        }
    }

    // Returns the part of an outline that is within the plan.
    PlanOutline shown(const PlanOutline& outline) const {
        PlanOutline kept = outline;
        for (const int axis : {0, 1})
            for (const double sign : {1.0, -1.0}) {
                const double limit = sign > 0.0 ? made_.max_m[axis] : made_.min_m[axis];
                const PlanOutline before = std::move(kept);
                kept.clear();
                for (std::size_t i = 0; i < before.size(); ++i) {
                    const Vec2 &a = before[i], &b = before[(i + 1) % before.size()];
                    const double in_a = sign * (limit - a[axis]), in_b = sign * (limit - b[axis]);
                    if (in_a >= 0.0) kept.push_back(a);
                    if ((in_a < 0.0) != (in_b < 0.0)) kept.push_back(a + (b - a) * (in_a / (in_a - in_b)));
                }
                if (kept.size() < 3) return {};
            }
        return kept;
    }

    // True if a person can stand on top of this section: it is a step or a stage, not a sill.
    bool stood_on(const PlanOutline& section, double top_m) const {
        Vec2 middle(0.0);
        for (const Vec2& p : section) middle += p;
        middle /= static_cast<double>(section.size());
        const std::uint32_t span = space_.at(Vec3(middle.x, middle.y, top_m));
        return span != navigation::kNothing && std::abs(space_.place_m(span).z - top_m) < 0.1;
    }

    std::optional<double> floor_m_at(const Vec3& at) const {
        const std::uint32_t span = space_.at(at);
        return span == navigation::kNothing ? std::nullopt : std::optional<double>(space_.place_m(span).z);
    }

    // True for a ramp or a flight of solid steps. A person walks up on the solid through the height of the cut, so it
    // is not a wall.
    bool climbed(const ConvexSolid& solid, const PlanOutline& outline) const {
        constexpr double kSameFloor_m = 0.15;
        for (const Polygon& face : solid.faces) {
            std::vector<Vec2> crossing;
            for (std::size_t i = 0; i < face.points_m.size(); ++i) {
                const Vec3 &a = face.points_m[i], &b = face.points_m[(i + 1) % face.points_m.size()];
                if ((a.z > cut_m()) == (b.z > cut_m())) continue;
                const double t = (cut_m() - a.z) / (b.z - a.z);
                crossing.emplace_back(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
            }
            if (crossing.size() != 2) continue;
            const Vec2 middle = 0.5 * (crossing[0] + crossing[1]);
            const auto floor = floor_m_at(Vec3(middle.x, middle.y, cut_m()));
            if (floor && std::abs(*floor - cut_m()) < kSameFloor_m) return true;
        }
        Vec2 middle(0.0);
        for (const Vec2& p : outline) middle += p / static_cast<double>(outline.size());
        const double top_m = solid.bounds_m.max_m.z;
        const std::uint32_t span = space_.at(Vec3(middle.x, middle.y, top_m));
        if (span == navigation::kNothing || std::abs(space_.place_m(span).z - top_m) > kSameFloor_m) return false;
        const std::uint32_t room = graph_.room_of_span[span];
        return (room != navigation::kNothing && graph_.rooms[room].kind == navigation::RoomKind::Stairs) ||
               (narrowest_m(outline) <= kLongestTread_m && leads_below_cut(span));
    }

    // True if a person can walk straight from the span `from` to below the cut within the length of a single tread.
    bool leads_below_cut(std::uint32_t from) const {
        const auto cells = static_cast<int>(std::ceil(kLongestTread_m / std::sqrt(space_.cell_area_m2())));
        for (const std::size_t way : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
            std::uint32_t span = from;
            for (int i = 0; i < cells && span != navigation::kNothing; ++i) {
                span = space_.spans[span].next[way];
                if (span != navigation::kNothing && space_.place_m(span).z < cut_m()) return true;
            }
        }
        return false;
    }

    // Returns the outline of the part of a solid that stops a person on the storey's floor. Empty if it stops nobody.
    PlanOutline stopping(const ConvexSolid& solid) const {
        const double bottom_m = solid.bounds_m.min_m.z, top_m = solid.bounds_m.max_m.z;
        if (bottom_m > cut_m() || top_m < made_.floor_m + kSillFrom_m) return {};
        const bool sill = top_m <= cut_m();
        const double at_m = sill ? 0.5 * (std::max(bottom_m, made_.floor_m) + top_m) : cut_m();
        PlanOutline outline = shown(section_at(solid, at_m));
        if (outline.size() < 3 || (sill && stood_on(outline, top_m))) return {};
        return outline;
    }

    void take_walls() {
        for (const Solid& solid : scene_.solids) {
            if (solid.role != SolidRole::Solid || !is_structure(scene_, solid.feature)) continue;
            PlanOutline outline = stopping(solid.shape);
            if (outline.empty()) continue;
            (climbed(solid.shape, outline) ? climbed_m_ : made_.walls_m).push_back(with_square_ends(outline));
        }
        for (const MeshTriangle& triangle : scene_.triangles)
            if (is_structure(scene_, triangle.feature))
                if (auto sheet = cut(triangle)) made_.sheets_m.push_back(*sheet);
    }

    // Makes mitred ends of a wall square. Otherwise there would be a notch in the corner where the neighbouring wall
    // has no mitre. An end stays mitred if the added corner would cover floor.
    PlanOutline with_square_ends(PlanOutline outline) const {
        for (std::size_t ends = 0; ends < 2; ++ends) {
            const auto squared = squared_wall(outline);
            if (!squared) break;
            const std::vector<Vec2> added(squared->added.begin(), squared->added.end());
            const Vec2 low = glm::min(glm::min(added[0], added[1]), added[2]);
            const Vec2 high = glm::max(glm::max(added[0], added[1]), added[2]);
            for (double y = low.y; y <= high.y; y += 0.5 * made_.floor.cell_m)
                for (double x = low.x; x <= high.x; x += 0.5 * made_.floor.cell_m)
                    if (within_loop(added, {x, y}) && floor_at(made_, {x, y}) != navigation::kNothing) return outline;
            outline = squared->outline;
        }
        return outline;
    }

    std::optional<std::array<Vec2, 2>> cut(const MeshTriangle& triangle) const {
        std::vector<Vec2> points;
        const std::array<Vec3, 3> corners{triangle.a_m, triangle.b_m, triangle.c_m};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
            if ((a.z > cut_m()) == (b.z > cut_m())) continue;
            const double t = (cut_m() - a.z) / (b.z - a.z);
            points.emplace_back(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
        }
        if (points.size() != 2) return std::nullopt;
        for (const Vec2& p : points)
            if (p.x < made_.min_m.x || p.y < made_.min_m.y || p.x > made_.max_m.x || p.y > made_.max_m.y)
                return std::nullopt;
        return std::array<Vec2, 2>{points[0], points[1]};
    }

    void take_things() {
        struct Found {
            std::vector<Vec2> points;
            Barrier barrier = {};
            double low_m = std::numeric_limits<double>::infinity(), high_m = -low_m;
        };
        std::map<std::uint32_t, Found> found;
        const auto at_hand = [&](double bottom_m, double top_m) {
            return bottom_m < cut_m() && top_m > made_.floor_m + kThingFrom_m;
        };
        const auto is_thing = [&](FeatureId id) {
            const Feature* feature = scene_.find(id);
            return feature && feature->kind == FeatureKind::Object && !trodden_.contains(id.value);
        };
        for (const Solid& solid : scene_.solids) {
            const Aabb& bounds = solid.shape.bounds_m;
            if (solid.role != SolidRole::Solid || !is_thing(solid.feature) || !at_hand(bounds.min_m.z, bounds.max_m.z))
                continue;
            Found& mine = found[solid.feature.value];
            if (PlanOutline outline = stopping(solid.shape); !outline.empty())
                mine.barrier.outlines_m.push_back(std::move(outline));
            for (const Polygon& face : solid.shape.faces)
                for (const Vec3& p : face.points_m) mine.points.emplace_back(p.x, p.y);
            mine.low_m = std::min(mine.low_m, bounds.min_m.z);
            mine.high_m = std::max(mine.high_m, bounds.max_m.z);
        }
        for (const MeshTriangle& t : scene_.triangles) {
            const double low_m = std::min({t.a_m.z, t.b_m.z, t.c_m.z}), high_m = std::max({t.a_m.z, t.b_m.z, t.c_m.z});
            if (!is_thing(t.feature) || !at_hand(low_m, high_m)) continue;
            Found& mine = found[t.feature.value];
            for (const Vec3& p : {t.a_m, t.b_m, t.c_m}) mine.points.emplace_back(p.x, p.y);
            mine.low_m = std::min(mine.low_m, low_m);
            mine.high_m = std::max(mine.high_m, high_m);
        }
        for (const Solid& solid : scene_.solids)
            if (solid.role == SolidRole::BodyClip)
                if (PlanOutline outline = stopping(solid.shape); !outline.empty())
                    barriers_.push_back({kNoFeature, {std::move(outline)}});
        const std::vector<PlanOutline> walls = made_.walls_m;
        for (auto& [id, mine] : found) {
            if (moving_.contains(id)) {
                ++made_.moving;
                continue;
            }
            const PlanOutline hull = convex_hull(std::move(mine.points));
            if (hull.empty()) continue;
            const PlanBox box = box_around(hull);
            const auto ends_in_wall = [&](double end) {
                return inside_any(walls, box.middle_m + box.along * (end * (box.half_m.x + kLeastThing_m)));
            };
            const bool stands =
                2.0 * box.half_m.x >= kPaneLong_m && mine.high_m > cut_m() && mine.high_m - mine.low_m >= kPaneHigh_m;
            const bool glass = scene_.material(scene_.features[id].material).name == "glass";
            const bool pane = stands && glass && 2.0 * box.half_m.y <= kPaneThin_m;
            const bool ends[2] = {ends_in_wall(-1.0), ends_in_wall(1.0)};
            const bool partition = stands && 2.0 * box.half_m.y <= kPartitionThin_m && (ends[0] || ends[1]);
            if (pane || partition || (2.0 * box.half_m.y <= kWindowDeep_m && ends[0] && ends[1])) {
                if (PlanOutline outline = shown(hull); outline.size() >= 3) {
                    made_.windows_m.push_back(outline);
                    made_.walls_m.push_back(std::move(outline));
                }
                continue;
            }
            if (mine.barrier.outlines_m.empty() && mine.high_m > made_.floor_m + kSillFrom_m)
                if (PlanOutline outline = shown(hull); outline.size() >= 3)
                    mine.barrier.outlines_m.push_back(std::move(outline));
            mine.barrier.feature = FeatureId{id};
            barriers_.push_back(std::move(mine.barrier));
            if (inside_any(walls, box.middle_m) || !on_storey(box.middle_m)) continue;
            const Feature& feature = scene_.features[id];
            made_.things.push_back({FeatureId{id}, spoken_name(feature), box, feature.landmark});
        }
        std::stable_sort(made_.things.begin(), made_.things.end(), [](const StoreyThing& a, const StoreyThing& b) {
            if (a.landmark != b.landmark) return a.landmark;
            return a.box.half_m.x * a.box.half_m.y > b.box.half_m.x * b.box.half_m.y;
        });
    }

    bool covers_floor(const PlanOutline& outline) const {
        const StoreyFloor& floor = made_.floor;
        for (std::size_t i = 0; i < floor.room.size(); ++i) {
            const auto wide = static_cast<std::size_t>(floor.wide);
            const Vec2 at = made_.min_m + (Vec2(i % wide, i / wide) + Vec2(0.5)) * floor.cell_m;
            if (floor.room[i] != navigation::kNothing && within(outline, at)) return true;
        }
        return false;
    }

    // Adds the line at which a sloping roof stops a person's head to the walls. Such a roof stops the head before a
    // hand touches it, and it may extend down to eaves far outside of the plan.
    void take_low_roofs() {
        const double head_m = made_.floor_m + space_.body.height_m - kUnderHead_m;
        for (const Solid& solid : scene_.solids) {
            const double bottom_m = solid.shape.bounds_m.min_m.z, top_m = solid.shape.bounds_m.max_m.z;
            if (solid.role != SolidRole::Solid || !is_structure(scene_, solid.feature) || bottom_m > head_m ||
                top_m < head_m || !stopping(solid.shape).empty())
                continue;
            Barrier roof;
            PlanOutline line = shown(section_at(solid.shape, head_m));
            if (line.size() < 3 || covers_floor(line)) continue;
            std::vector<Vec2> points = line;
            for (const double at_m : {cut_m(), 0.5 * (cut_m() + head_m)}) {
                const PlanOutline lower = section_at(solid.shape, std::max(at_m, bottom_m + kUnderHead_m));
                points.insert(points.end(), lower.begin(), lower.end());
            }
            roof.reach_m.push_back(shown(convex_hull(std::move(points))));
            roof.outlines_m.push_back(std::move(line));
            barriers_.push_back(std::move(roof));
        }
    }

    // --- openings from the route graph

    // Adds the exits to other storeys. Balconies are left out. They belong to the ground outside, which is on another
    // storey, so they would look like exits to another storey.
    void take_exits(const std::map<std::uint32_t, std::uint32_t>& mine) {
        for (const navigation::Portal& portal : graph_.portals)
            for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
                const auto here = mine.find(portal.rooms[side]);
                const std::uint32_t there = portal.rooms[1 - side];
                if (here == mine.end() || mine.contains(there) || graph_.rooms[there].level == level_ ||
                    portal.one_way || portal.kind == navigation::PassageKind::Drop ||
                    portal.kind == navigation::PassageKind::Teleporter || made_.rooms[here->second].outside ||
                    on_outer_ground(there) || !is_seen(portal) ||
                    graph_.rooms[there].kind == navigation::RoomKind::Stairs ||
                    made_.rooms[here->second].kind == navigation::RoomKind::Stairs)
                    continue;
                made_.exits.push_back({portal.kind,
                                       here->second,
                                       graph_.rooms[there].name,
                                       {portal.place_m.x, portal.place_m.y},
                                       portal.width_m});
            }
    }

    void take_portals() {
        std::map<std::uint32_t, std::uint32_t> mine;
        for (std::uint32_t i = 0; i < made_.rooms.size(); ++i) mine[made_.rooms[i].room] = i;
        take_exits(mine);
        for (const navigation::Portal& portal : graph_.portals) {
            const auto a = mine.find(portal.rooms[0]), b = mine.find(portal.rooms[1]);
            if (a == mine.end() || b == mine.end() || a->second == b->second || !is_seen(portal)) continue;
            made_.portals.push_back(
                {portal.kind, {a->second, b->second}, {portal.place_m.x, portal.place_m.y}, portal.width_m});
        }
        take_crossings();
    }

    // Finds the crossings between rooms whose floors the plan shows on both sides.
    void take_crossings() {
        const auto room_shown = [&](std::uint32_t span) {
            const std::uint32_t room = graph_.room_of_span[span];
            const auto cell = cell_at(space_.place_m(span));
            const std::uint32_t there = cell ? made_.floor.room[*cell] : navigation::kNothing;
            return there != navigation::kNothing && made_.rooms[there].room == room ? there : navigation::kNothing;
        };
        std::map<std::array<std::uint32_t, 2>, std::vector<Vec2>> places;
        for (std::uint32_t span = 0; span < space_.spans.size(); ++span)
            for (const std::uint32_t next : space_.spans[span].next) {
                if (next == navigation::kNothing || next < span ||
                    graph_.room_of_span[span] == graph_.room_of_span[next])
                    continue;
                const std::uint32_t a = room_shown(span), b = room_shown(next);
                if (a == navigation::kNothing || b == navigation::kNothing) continue;
                const Vec3 at = 0.5 * (space_.place_m(span) + space_.place_m(next));
                places[{std::min(a, b), std::max(a, b)}].emplace_back(at.x, at.y);
            }
        for (auto& [rooms, at_m] : places) made_.crossings.push_back({rooms, std::move(at_m)});
    }

    // True if this plan of the storey shows the place where the portal's rooms adjoin. If both rooms are on both plans,
    // the portal appears on only one of them.
    bool is_seen(const navigation::Portal& portal) const {
        if (made_.upper && !upper_.contains(portal.rooms[0]) && !upper_.contains(portal.rooms[1])) return false;
        const Vec2 place(portal.place_m.x, portal.place_m.y);
        const double reach_m = 0.5 * portal.width_m + kFloorNearJoint_m;
        const auto near = [&](std::uint32_t room) {
            const int steps = static_cast<int>(std::ceil(reach_m / made_.floor.cell_m));
            for (int y = -steps; y <= steps; ++y)
                for (int x = -steps; x <= steps; ++x)
                    if (const Vec2 off = Vec2(x, y) * made_.floor.cell_m;
                        glm::length(off) <= reach_m && floor_at(made_, place + off) == room)
                        return true;
            return false;
        };
        return std::all_of(portal.rooms.begin(), portal.rooms.end(), [&](std::uint32_t room) {
            for (std::uint32_t i = 0; i < made_.rooms.size(); ++i)
                if (made_.rooms[i].room == room) return !has_two_plans(i) || near(i);
            return !made_.upper;
        });
    }
    bool has_two_plans(std::uint32_t place) const {
        return made_.upper || std::find(made_.hidden.begin(), made_.hidden.end(), place) != made_.hidden.end();
    }

    // Returns the index of the area beyond all rooms, which is treated as an additional room.
    std::uint32_t outside() const { return static_cast<std::uint32_t>(made_.rooms.size()); }
    StoreyGrid squares() const { return StoreyGrid::of(made_); }

    bool at_portal(const RoomBorder& border, const Vec2& at) const {
        return std::any_of(made_.portals.begin(), made_.portals.end(), [&](const StoreyPortal& portal) {
            return std::min(portal.rooms[0], portal.rooms[1]) == border.rooms[0] &&
                   std::max(portal.rooms[0], portal.rooms[1]) == border.rooms[1] &&
                   glm::distance(portal.place_m, at) <= 0.5 * portal.width_m + kNextToPortal_m;
        });
    }

    // True for a flight of stairs, which is drawn with lines of its own. Its banisters are not drawn as walls, because
    // they would leave no space for these lines.
    bool is_flight(std::uint32_t room) const {
        return room < made_.rooms.size() && made_.rooms[room].kind == navigation::RoomKind::Stairs;
    }

    // Turns barriers between two rooms into walls, unless the route graph leads through them.
    void close_rooms() {
        RoomGrid walls = squares().walls();
        for (bool more = true; more;) {
            RoomGrid grid = walls;
            spread_rooms(grid);
            std::vector<Vec2> open;
            for (const RoomBorder& border : borders_of(grid)) {
                if (is_flight(border.rooms[0]) || is_flight(border.rooms[1])) continue;
                for (const std::size_t square : border.squares)
                    if (const Vec2 at = squares().middle(grid, square); !at_portal(border, at)) open.push_back(at);
            }
            more = false;
            for (Barrier& barrier : barriers_)
                if (!barrier.wall && stands_in(barrier, open)) {
                    more = barrier.wall = true;
                    for (const PlanOutline& outline : barrier.outlines_m) squares().block(walls, outline);
                }
        }
        for (Barrier& barrier : barriers_) {
            if (!barrier.wall) continue;
            std::erase_if(made_.things, [&](const StoreyThing& thing) {
                return barrier.feature && thing.feature == barrier.feature;
            });
            for (PlanOutline& outline : barrier.outlines_m) made_.walls_m.push_back(std::move(outline));
        }
    }

    // Removes ledges outside windows and roofs over doors, to which nothing leads. They are no rooms of the plan, and
    // their labels would be outside the building.
    void drop_ledges() {
        RoomGrid grid = squares().walls();
        spread_rooms(grid);
        std::vector<std::uint32_t> kept(made_.rooms.size(), 0);
        for (const RoomBorder& border : borders_of(grid))
            if (border.rooms[1] == outside()) {
                const StoreyRoom& room = made_.rooms[border.rooms[0]];
                const bool named = !navigation::known_as(graph_.rooms[room.room]).empty();
                if (room.shut && (room.kind == navigation::RoomKind::Niche || !named))
                    kept[border.rooms[0]] = navigation::kNothing;
            }
        drop_rooms(std::move(kept));
    }

    // Removes the spaces under ramps, which nobody can enter. The steps of a ramp are not drawn as walls, so the floor
    // of such a space would seem to continue in front of the ramp.
    void drop_spaces_under_steps() {
        if (climbed_m_.empty()) return;
        std::vector<PlanOutline> steps;
        for (const PlanOutline& outline : climbed_m_) {
            PlanBox around = box_around(outline);
            around.half_m += Vec2(kLongestTread_m);
            const std::array<Vec2, 4> corners = around.corners_m();
            steps.emplace_back(corners.begin(), corners.end());
        }
        RoomGrid grid = squares().walls();
        spread_rooms(grid);
        std::vector<std::uint32_t> kept(made_.rooms.size(), 0);
        for (const RoomBorder& border : borders_of(grid)) {
            if (border.rooms[1] == outside()) continue;
            const bool shut[2] = {made_.rooms[border.rooms[0]].shut, made_.rooms[border.rooms[1]].shut};
            if (shut[0] != shut[1] &&
                std::any_of(border.squares.begin(), border.squares.end(),
                            [&](std::size_t square) { return inside_any(steps, squares().middle(grid, square)); }))
                kept[border.rooms[shut[0] ? 0 : 1]] = navigation::kNothing;
        }
        drop_rooms(std::move(kept));
    }

    // For each room, `kept` is 0 to keep the room, or kNothing to remove it.
    void drop_rooms(std::vector<std::uint32_t> kept) {
        std::uint32_t count = 0;
        for (std::uint32_t& place : kept) place = place == navigation::kNothing ? navigation::kNothing : count++;
        if (count == 0 || count == kept.size()) return;
        for (std::uint32_t i = 0; i < kept.size(); ++i)
            if (kept[i] != navigation::kNothing && kept[i] != i) made_.rooms[kept[i]] = std::move(made_.rooms[i]);
        made_.rooms.resize(count);
        for (std::uint32_t& room : made_.floor.room)
            room = room == navigation::kNothing ? navigation::kNothing : kept[room];
        for (std::uint32_t& room : made_.hidden) room = kept[room];
        for (StoreyStairs& stairs : made_.stairs_of_others) stairs.room = kept[stairs.room];
        for (StoreyExit& exit : made_.exits) exit.room = kept[exit.room];
        for (StoreyPortal& portal : made_.portals)
            for (std::uint32_t& room : portal.rooms) room = kept[room];
        for (StoreyCrossings& crossings : made_.crossings)
            for (std::uint32_t& room : crossings.rooms) room = kept[room];
    }

    bool stands_in(const Barrier& barrier, const std::vector<Vec2>& open) const {
        std::size_t in = 0;
        for (const PlanOutline& outline : barrier.reach_m.empty() ? barrier.outlines_m : barrier.reach_m) {
            Vec2 low(std::numeric_limits<double>::infinity()), high(-low);
            for (const Vec2& p : outline) low = glm::min(low, p), high = glm::max(high, p);
            for (const Vec2& at : open)
                if (at.x >= low.x && at.y >= low.y && at.x <= high.x && at.y <= high.y && within(outline, at)) ++in;
        }
        // Divides by two, because a border has squares on both of its sides.
        return static_cast<double>(in) * squares().square_m() >= 2.0 * kStandsIn_m;
    }

    // Opens the walls of the cut where the route graph leads through them, for example at the edge of a raised floor.
    void open_portals() {
        RoomGrid grid = squares().walls();
        const RoomGrid floors = grid;
        spread_rooms(grid);
        const std::vector<RoomBorder> borders = borders_of(grid);
        for (const StoreyPortal& portal : made_.portals) {
            if (portal.kind != navigation::PassageKind::Door && portal.kind != navigation::PassageKind::Opening)
                continue;
            const bool open = std::any_of(borders.begin(), borders.end(), [&](const RoomBorder& border) {
                return std::any_of(border.squares.begin(), border.squares.end(), [&](std::size_t square) {
                    return border.rooms[0] == std::min(portal.rooms[0], portal.rooms[1]) &&
                           border.rooms[1] == std::max(portal.rooms[0], portal.rooms[1]) &&
                           glm::distance(squares().middle(grid, square), portal.place_m) <=
                               0.5 * portal.width_m + kNextToPortal_m;
                });
            });
            const auto a = nearest_floor(floors, portal.rooms[0], portal.place_m);
            const auto b = nearest_floor(floors, portal.rooms[1], portal.place_m);
            if (open || !a || !b || *a == *b) continue;
            const Vec2 through = (*b - *a) / glm::distance(*a, *b);
            made_.gaps.push_back({portal.kind,
                                  {},
                                  0.5 * (*a + *b),
                                  {through.y, -through.x},
                                  std::clamp(portal.width_m, 0.6, 1.2),
                                  0.5 * glm::distance(*a, *b),
                                  portal.rooms});
        }
    }

    std::optional<Vec2> nearest_floor(const RoomGrid& grid, std::uint32_t room, const Vec2& place) const {
        std::optional<Vec2> nearest;
        double least = kFloorNearPortal_m;
        const int reach = static_cast<int>(least / squares().square_m());
        const Vec2 from = (place - made_.min_m) / squares().square_m();
        for (int y = static_cast<int>(from.y) - reach; y <= static_cast<int>(from.y) + reach; ++y)
            for (int x = static_cast<int>(from.x) - reach; x <= static_cast<int>(from.x) + reach; ++x) {
                if (!grid.holds(x, y) || grid.room[grid.at(x, y)] != room) continue;
                const double far = glm::distance(squares().middle(x, y), place);
                if (far < least) least = far, nearest = squares().middle(x, y);
            }
        return nearest;
    }

    bool on_storey(const Vec2& at) const {
        return at.x > made_.min_m.x && at.y > made_.min_m.y && at.x < made_.max_m.x && at.y < made_.max_m.y;
    }

    // Returns the distance from `from` in the direction `way` to the next wall, or `most_m` if no wall is nearer.
    double free_m(const Vec2& from, const Vec2& way, double most_m) const {
        double least = most_m;
        const auto meet = [&](const Vec2& a, const Vec2& b) {
            const double across = cross_of(way, b - a);
            if (std::abs(across) < 1e-12) return;
            const double far = cross_of(a - from, b - a) / across, along = cross_of(a - from, way) / across;
            if (far >= 0.0 && far < least && along >= 0.0 && along <= 1.0) least = far;
        };
        for (const PlanOutline& wall : made_.walls_m)
            for (std::size_t i = 0; i < wall.size(); ++i) meet(wall[i], wall[(i + 1) % wall.size()]);
        for (const auto& sheet : made_.sheets_m) meet(sheet[0], sheet[1]);
        return least;
    }

    // Returns the directions along and perpendicular to the walls near a place. A gap in one of these walls can only
    // have such a direction.
    std::vector<Vec2> square_ways(const Vec2& place) const {
        // Sides shorter than kLeast_m are ends of walls, straight or mitred, so they are ignored.
        constexpr double kNear_m = 2.5, kLeast_m = 0.7;
        std::vector<Vec2> ways;
        const auto take = [&](const Vec2& a, const Vec2& b) {
            const double length = glm::length(b - a);
            if (length < kLeast_m) return;
            const Vec2 along = (b - a) / length;
            const double at = std::clamp(glm::dot(place - a, along), 0.0, length);
            if (glm::length(a + along * at - place) > kNear_m) return;
            for (const Vec2& way : {Vec2(along.y, -along.x), along})
                if (std::none_of(ways.begin(), ways.end(),
                                 [&](const Vec2& known) { return std::abs(cross_of(known, way)) < 1e-3; }))
                    ways.push_back(way);
        };
        for (const PlanOutline& wall : made_.walls_m)
            for (std::size_t i = 0; i < wall.size(); ++i) take(wall[i], wall[(i + 1) % wall.size()]);
        for (const auto& sheet : made_.sheets_m) take(sheet[0], sheet[1]);
        return ways;
    }

    // Finds the narrowest place of a passage. The rooms may adjoin slightly in front of or behind the wall between
    // them, so places on both sides are measured. If several are equally narrow, the one nearest to `place` is used.
    void measure(StoreyGap& gap, const Vec2& place, const Vec2& way, int first, int last, double& least) const {
        constexpr double kApart_m = 0.05;
        const Vec2 through(-way.y, way.x);
        for (int i = first; i <= last; ++i) {
            const Vec2 at = place + through * (kApart_m * ((i + 1) / 2) * (i % 2 == 0 ? 1.0 : -1.0));
            if (inside_any(made_.walls_m, at)) continue;
            const double ahead = free_m(at, way, kWidestGap_m), behind = free_m(at, -way, kWidestGap_m);
            if (ahead + behind >= least - 1e-6) continue;
            least = ahead + behind;
            gap.along = way;
            gap.place_m = at + way * (0.5 * (ahead - behind));
        }
    }

    void take_gaps() {
        std::map<std::uint32_t, std::uint32_t> mine;
        for (std::uint32_t i = 0; i < made_.rooms.size(); ++i) mine[made_.rooms[i].room] = i;
        for (const navigation::Portal& portal : graph_.portals) {
            const bool here =
                graph_.rooms[portal.rooms[0]].level == level_ || graph_.rooms[portal.rooms[1]].level == level_;
            if (!here ||
                (portal.kind != navigation::PassageKind::Door && portal.kind != navigation::PassageKind::Opening) ||
                !is_seen(portal))
                continue;
            const Vec2 place(portal.place_m.x, portal.place_m.y);
            if (std::abs(portal.place_m.z - made_.floor_m) > 1.5 || inside_any(made_.walls_m, place)) continue;
            StoreyGap gap;
            gap.kind = portal.kind;
            for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
                if (const auto room = mine.find(portal.rooms[side]); room != mine.end()) gap.rooms[side] = room->second;
            if (const Feature* feature = scene_.find(portal.feature)) gap.name = spoken_name(*feature);
            double least = kWidestGap_m;
            const std::vector<Vec2> ways = square_ways(place);
            for (const Vec2& way : ways) measure(gap, place, way, 0, 0, least);
            if (least >= kWidestGap_m)
                for (const Vec2& way : ways) measure(gap, place, way, 1, 2 * kNextToSteps, least);
            const Vec2 through(-gap.along.y, gap.along.x);
            // A window niche is as narrow as a gap, but it is excluded, because its pane is within one step.
            if (least >= kWidestGap_m || free_m(gap.place_m, through, kStep_m) < kStep_m ||
                free_m(gap.place_m, -through, kStep_m) < kStep_m)
                continue;
            gap.width_m = least;
            made_.gaps.push_back(std::move(gap));
        }
    }

    void take_base() {
        const Start* base = nullptr;
        for (const Start& start : scene_.starts)
            if (!base || (start.base && !base->base)) base = &start;
        if (!base) return;
        const std::uint32_t room = navigation::room_at(graph_, space_, base->feet_m);
        if (room == navigation::kNothing || graph_.rooms[room].level != level_) return;
        if (made_.upper && !upper_.contains(room)) return;
        made_.base = StoreyBase{{base->feet_m.x, base->feet_m.y}, base->heading_rad};
    }

    const Scene& scene_;
    const navigation::RoomGraph& graph_;
    const navigation::WalkSpace& space_;
    int level_;
    std::set<std::uint32_t> upper_;
    std::vector<double> floor_height_m_;        // height of the floor in each cell of StoreyFloor::room
    std::set<std::uint32_t> trodden_, moving_;  // features that a person walks on, and features that move
    std::vector<PlanOutline> climbed_m_;        // outlines that would be walls if people did not walk up on them
    std::vector<Barrier> barriers_;
    Storey made_;
};

}  // namespace

std::uint32_t floor_at(const Storey& storey, const Vec2& at) {
    const StoreyFloor& floor = storey.floor;
    const double x = std::floor((at.x - storey.min_m.x) / floor.cell_m);
    const double y = std::floor((at.y - storey.min_m.y) / floor.cell_m);
    if (!(x >= 0.0 && y >= 0.0 && x < floor.wide && y < floor.high)) return navigation::kNothing;
    return floor.room[static_cast<std::size_t>(y) * static_cast<std::size_t>(floor.wide) + static_cast<std::size_t>(x)];
}

int storey_count(const navigation::RoomGraph& graph) {
    int count = 0;
    for (const navigation::Room& room : graph.rooms) count = std::max(count, room.level + 1);
    return count;
}

int storey_of_start(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space) {
    const Start* base = nullptr;
    for (const Start& start : scene.starts)
        if (!base || (start.base && !base->base)) base = &start;
    const std::uint32_t room = base ? navigation::room_at(graph, space, base->feet_m) : navigation::kNothing;
    return room == navigation::kNothing ? 1 : graph.rooms[room].level + 1;
}

Result<Storey> storey_of(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                         int number) {
    const int count = storey_count(graph);
    if (number < 1 || number > count)
        return fail(phrase("export.no_storey", {{"storey", number}, {"count", count}}), scene.source_file);
    Storey made = StoreyMaker(scene, graph, space, number).make();
    if (made.rooms.empty())
        return fail(phrase("export.empty_storey", {{"storey", number}, {"count", count}}), scene.source_file);
    return made;
}

std::optional<Storey> upper_part_of(const Scene& scene, const navigation::RoomGraph& graph,
                                    const navigation::WalkSpace& space, const Storey& storey) {
    if (storey.upper || storey.hidden.empty()) return std::nullopt;
    std::set<std::uint32_t> upper;
    for (const std::uint32_t place : storey.hidden) upper.insert(storey.rooms[place].room);
    Storey made = StoreyMaker(scene, graph, space, storey.number, std::move(upper)).make();
    if (made.rooms.empty()) return std::nullopt;
    return made;
}

}  // namespace handrail::plan
