#include "haptic/compile/simplify_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "haptic/compile/simplify_shapes.h"
#include "worlds/geometry/box_index.h"

namespace handrail::compile {
namespace {

constexpr double kDeepest_m = 1.5;  // greatest depth of a wall; a deeper passage is a corridor and is not widened
constexpr double kFrame_m = 0.1;    // depth of frames and skirtings at a doorway, which are cut together with the wall
// Depth of the strips in front of and behind the wall, beyond the frames, in which the plan looks for crossing walls.
constexpr double kStrip_m = 0.15;
constexpr double kLeastLeaf_m = 1.0;  // least height of a door leaf; lower leaves are hatches and flaps
// How far the opening may extend beyond its leaf on each side, in addition to half the leaf's width.
constexpr double kNextToLeaf_m = 0.5;
constexpr double kWidestChord_m = 6.0;  // longest line across an opening without a door, from wall to wall
// Number of distances at which the search steps aside, in each of eight directions, from the point where the rooms
// meet.
constexpr int kPlacesNextTo = 4;
constexpr double kNextTo_m = 0.15;    // distance between two such steps
constexpr double kHighest_m = 4.0;    // greatest distance from the middle of an opening to its floor or ceiling
constexpr double kAtAThing_m = 0.25;  // greatest distance from a mark or sound source to the thing that it belongs to
// Least width of a thing, as a share of the whole world's width, from which on it is never left out, because the world
// is about that thing.
constexpr double kOfTheWorld = 0.1;
constexpr double kLevel = 0.1;  // sine of the greatest tilt of a face that is treated as vertical

using namespace doorway;

// The vertical faces of one leaf, in its closed position.
struct Leaf {
    FeatureId feature;
    std::vector<Vec3> points_m;
    Vec3 through{0.0};  // normal of its largest face
    double area_m2 = 0.0;

    void add(std::span<const Vec3> face_m, const Vec3& shift_m) {
        for (const Vec3& p : face_m) points_m.push_back(p + shift_m);
        const Vec3 area = area_vector_m2(face_m);
        const double size = glm::length(area);
        if (!(size > 0.0) || std::abs(area.z) > kLevel * size) return;
        const double level = std::hypot(area.x, area.y);
        Vec3 way(area.x / level, area.y / level, 0.0);
        for (int axis = 0; axis < 2; ++axis)
            if (std::abs(way[axis]) > 1.0 - 1e-12) way = axis == 0 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        way = pointing_east(way);
        const bool first = way.x != through.x ? way.x > through.x : way.y > through.y;
        if (size < area_m2 * (1.0 - 1e-9) || (size < area_m2 * (1.0 + 1e-9) && !first)) return;
        area_m2 = size;
        through = way;
    }
    Range range(const Vec3& way) const {
        Range range = kNoRange;
        for (const Vec3& p : points_m) include(range, glm::dot(way, p));
        return range;
    }
};

class Planner {
public:
    Planner(const Scene& scene, const SimplifyOptions& options, const std::stop_token& stop,
            const std::function<void()>& looks)
        : scene_(scene),
          options_(options),
          stop_(stop),
          looks_(looks),
          gap_m_(kLeastGap_hand_m * options.world_m_per_hand_m),
          thing_m_(kLeastThing_hand_m * options.world_m_per_hand_m) {}

    Simplification run() {
        find_doors();
        for (std::size_t i = 0; i < options_.openings_m.size() && goes_on(); ++i) find_opening(static_cast<int>(i));
        share_walls();
        leave_out();
        if (stop_.stop_requested()) return {};
        std::erase_if(plan_.openings, [](const NarrowOpening& o) { return !o.widened() && !o.stays_narrow(); });
        return std::move(plan_);
    }

private:
    // Called before each step of the work. Returns false if another thread requested a stop.
    bool goes_on() {
        if (stop_.stop_requested()) return false;
        if (looks_) looks_();
        return true;
    }

    struct Hit {
        double way_m;
        std::uint32_t solid;
        Vec3 normal;
    };
    struct Probe {
        std::optional<Hit> hit;
        bool from_inside = false;
    };

    const BoxIndex& index() {
        if (!index_) {
            std::vector<Aabb> boxes;
            for (const Solid& solid : scene_.solids) boxes.push_back(solid.shape.bounds_m);
            index_.emplace(boxes);
        }
        return *index_;
    }

    // Finds the first solid of the building on the straight line from `from` along `way`, at most `reach_m` away.
    Probe probe(const Vec3& from, const Vec3& way, double reach_m) {
        Aabb box{from, from};
        box.include(from + way * reach_m);
        index().find(box, found_);
        Probe result;
        for (const std::uint32_t i : found_) {
            if (!is_wall(scene_, scene_.solids[i])) continue;
            double in = -std::numeric_limits<double>::infinity(), out = reach_m;
            Vec3 normal(0.0);
            for (const Plane& plane : scene_.solids[i].shape.planes) {
                const double off = signed_distance(plane, from), slope = glm::dot(plane.normal, way);
                if (slope == 0.0) {
                    if (off >= 0.0) out = -1.0;
                } else if (slope > 0.0) {
                    out = std::min(out, -off / slope);
                } else if (-off / slope > in) {
                    in = -off / slope;
                    normal = plane.normal;
                }
            }
            if (in >= out || out <= 0.0) continue;
            if (in < -kTolerance.merge_m) result.from_inside = true;
            else if (!result.hit || in < result.hit->way_m) result.hit = Hit{std::max(0.0, in), i, normal};
        }
        return result;
    }

    // ---- doors ----

    void find_doors() {
        std::map<std::uint32_t, Leaf> leaves;
        const auto leaf_of = [&](FeatureId id) {
            Leaf& leaf = leaves[id.value];
            leaf.feature = id;
            return &leaf;
        };
        const auto add_solid = [](Leaf& leaf, const Solid& solid, const Vec3& shift_m) {
            for (const Polygon& face : solid.shape.faces) leaf.add(face.points_m, shift_m);
        };
        const auto add_triangle = [](Leaf& leaf, const MeshTriangle& t, const Vec3& shift_m) {
            leaf.add(std::array{t.a_m, t.b_m, t.c_m}, shift_m);
        };
        for (const Solid& solid : scene_.solids) {
            if (!goes_on()) return;
            if ((solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) && is_leaf(scene_, solid))
                add_solid(*leaf_of(solid.feature), solid, Vec3(0.0));
        }
        for (const MeshTriangle& t : scene_.triangles) {
            if (!goes_on()) return;
            if (is_kind(scene_, t.feature, FeatureKind::Door)) add_triangle(*leaf_of(t.feature), t, Vec3(0.0));
        }
        for (const PlacedModel& placed : scene_.placed) {
            if (!goes_on()) return;
            if (!is_kind(scene_, placed.feature, FeatureKind::Door)) continue;
            const auto mover = std::find_if(scene_.movers.begin(), scene_.movers.end(),
                                            [&](const Mover& m) { return m.feature == placed.feature; });
            if (mover == scene_.movers.end()) continue;
            // A placed leaf may be open now, so its points are computed for the closed position.
            Leaf& leaf = *leaf_of(placed.feature);
            for (const Solid& solid : placed.model->solids) add_solid(leaf, solid, mover->pivot_m);
            for (const MeshTriangle& t : placed.model->triangles) add_triangle(leaf, t, mover->pivot_m);
        }
        for (const auto& [id, leaf] : leaves) {
            if (!goes_on()) return;
            find_doorway(leaf);
        }
    }

    void find_doorway(const Leaf& leaf) {
        if (!(leaf.area_m2 > 0.0)) return;
        NarrowOpening opening;
        opening.doors = {leaf.feature};
        opening.along = pointing_east(left_of(leaf.through));
        const Range s = leaf.range(opening.along), t = leaf.range(opening.left()), z = leaf.range({0.0, 0.0, 1.0});
        if (length(s) >= gap_m_ || length(z) < kLeastLeaf_m || length(s) <= length(t)) return;
        const double middle_s = 0.5 * (s[0] + s[1]), middle_t = 0.5 * (t[0] + t[1]);
        opening.low_m = s[0];
        opening.high_m = s[1];
        std::array<Vec3, 3> places;
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i] = opening.along * middle_s + opening.left() * middle_t +
                        Vec3(0.0, 0.0, z[0] + length(z) * (0.2 + 0.3 * static_cast<double>(i)));
        const double reach_m = 1.5 * length(s) + kNextToLeaf_m;
        Sides sides = look_aside(opening.along, places, reach_m);
        // If the leaf is sunk into its frame, the probes start inside the wall. The leaf's own width is then the width
        // of the opening.
        if (!sides.inside) {
            if (sides.low) opening.low_m = middle_s - *sides.low;
            if (sides.high) opening.high_m = middle_s + *sides.high;
        }
        if (opening.width_m() >= gap_m_ || opening.width_m() <= 0.0) return;
        for (NarrowOpening& known : plan_.openings)
            if (same_doorway(known, opening, t, z)) {
                known.doors.push_back(leaf.feature);
                return;
            }
        widen(opening, places, t, z, sides);
    }

    static bool same_doorway(const NarrowOpening& a, const NarrowOpening& b, const Range& t, const Range& z) {
        constexpr double kSame_m = 0.05;
        return a.along == b.along && std::abs(a.low_m - b.low_m) < kSame_m && std::abs(a.high_m - b.high_m) < kSame_m &&
               overlap({a.front_m, a.back_m}, t) && overlap({a.floor_m, a.top_m}, z);
    }

    struct Sides {
        std::optional<double> low, high;  // distance to the nearest wall; empty: there is none
        std::vector<std::uint32_t> low_solids, high_solids;
        bool inside = false;
    };
    Sides look_aside(const Vec3& way, std::span<const Vec3> places, double reach_m) {
        Sides sides;
        const auto look = [&](const Vec3& from, const Vec3& to, std::optional<double>& nearest,
                              std::vector<std::uint32_t>& solids) {
            const Probe seen = probe(from, to, reach_m);
            sides.inside = sides.inside || seen.from_inside;
            if (!seen.hit) return;
            nearest = std::min(nearest.value_or(seen.hit->way_m), seen.hit->way_m);
            if (std::find(solids.begin(), solids.end(), seen.hit->solid) == solids.end())
                solids.push_back(seen.hit->solid);
        };
        for (const Vec3& place : places) {
            look(place, -way, sides.low, sides.low_solids);
            look(place, way, sides.high, sides.high_solids);
        }
        return sides;
    }

    // ---- openings without a door ----

    static std::array<Vec3, 3> heights(const Vec3& soles) {
        return {soles + Vec3(0, 0, 0.4), soles + Vec3(0, 0, 0.9), soles + Vec3(0, 0, 1.5)};
    }

    void find_opening(int number) {
        // Two rooms may meet in the wall, but often they meet before or behind it. So the search finds the shortest
        // line that ends at walls on both sides, then turns the line perpendicular to the wall at its end.
        const Vec3 given_m = options_.openings_m[static_cast<std::size_t>(number)];
        Vec3 soles = given_m, way(0.0);
        double shortest_m = kWidestChord_m;
        for (int at = 0; at <= 8 * kPlacesNextTo && !stop_.stop_requested(); ++at) {
            const double aside_m = kNextTo_m * ((at + 7) / 8);
            const Vec3 place = given_m + forward_of_heading(radians_from_degrees(45.0 * at)) * aside_m;
            const int step_deg = at == 0 ? 5 : 15;
            for (int degrees = 90; degrees > -90; degrees -= step_deg) {
                const Vec3 towards = forward_of_heading(radians_from_degrees(degrees));
                const Sides sides = look_aside(towards, heights(place), kWidestChord_m);
                if (sides.inside || !sides.low || !sides.high || *sides.low + *sides.high > shortest_m - 1e-6) continue;
                shortest_m = *sides.low + *sides.high;
                way = towards;
                soles = place;
            }
        }
        if (way == Vec3(0.0)) return;
        const std::array<Vec3, 3> places = heights(soles);
        for (const Vec3& place : places)
            if (const Probe seen = probe(place, way, kWidestChord_m); seen.hit) {
                const double level = std::hypot(seen.hit->normal.x, seen.hit->normal.y);
                if (level < 1.0 - kLevel || std::abs(glm::dot(seen.hit->normal, way)) < 0.7) continue;
                way =
                    level == 1.0 ? seen.hit->normal : Vec3(seen.hit->normal.x / level, seen.hit->normal.y / level, 0.0);
                break;
            }
        NarrowOpening opening;
        opening.place = number;
        opening.along = pointing_east(way);
        Sides sides = look_aside(opening.along, places, kWidestChord_m);
        if (!sides.low || !sides.high || sides.inside) return;
        const double middle_s = glm::dot(opening.along, soles), middle_t = glm::dot(opening.left(), soles);
        opening.low_m = middle_s - *sides.low;
        opening.high_m = middle_s + *sides.high;
        if (opening.width_m() >= gap_m_) return;
        const Range t{middle_t, middle_t}, z{soles.z, soles.z + 1.9};
        for (const NarrowOpening& known : plan_.openings)
            if (known.along == opening.along && overlap({known.low_m, known.high_m}, {opening.low_m, opening.high_m}) &&
                overlap({known.front_m - kFrame_m, known.back_m + kFrame_m}, t) &&
                overlap({known.floor_m, known.top_m}, z))
                return;
        widen(opening, places, t, z, sides);
    }

    // ---- widening ----

    // Plans how far to widen an opening. `places` are the points from which the distances to both sides were measured.
    // `t` and `z` are the ranges of the door leaf. If there is no leaf, they are those of the point on the floor.
    void widen(NarrowOpening opening, std::span<const Vec3> places, const Range& t, const Range& z,
               const Sides& sides) {
        opening.wanted_m = gap_m_;
        const Vec3 middle = places[places.size() / 2];
        const Probe below = probe(middle, {0, 0, -1}, kHighest_m), above = probe(middle, {0, 0, 1}, kHighest_m);
        // If a hole is under the door, for example where floors end at the wall, the doorway begins at the leaf's lower
        // edge and not at the bottom of the hole.
        opening.floor_m = below.hit ? middle.z - below.hit->way_m : z[0];
        if (opening.floor_m < z[0] - kFrame_m) opening.floor_m = z[0];
        opening.top_m = above.hit ? middle.z + above.hit->way_m : -std::numeric_limits<double>::infinity();
        Range wall = kNoRange;
        double low_room_m = gap_m_, high_room_m = gap_m_;
        for (const bool high : {false, true}) {
            const std::vector<std::uint32_t>& solids = high ? sides.high_solids : sides.low_solids;
            const Range beside =
                high ? Range{opening.high_m, opening.high_m + 0.2} : Range{opening.low_m - 0.2, opening.low_m};
            Range depth = kNoRange;
            for (const std::uint32_t i : solids) include(depth, depth_of(i, opening, beside, z));
            if (depth[0] <= depth[1]) depth = with_layers(opening, high, beside, depth, z);
            if (length(depth) > kDeepest_m) (high ? high_room_m : low_room_m) = 0.0;
            else include(wall, depth);
            if (!above.hit)
                for (const std::uint32_t i : solids)
                    opening.top_m = std::max(opening.top_m, scene_.solids[i].shape.bounds_m.max_m.z);
        }
        opening.felt_low_m = opening.low_m;
        opening.felt_high_m = opening.high_m;
        opening.front_m = t[0];
        opening.back_m = t[1];
        if (opening.top_m < z[1]) opening.top_m = z[1];
        if (wall[0] > wall[1]) {
            // If there is no wall on either side, the opening is not a doorway. If the walls are deeper than
            // kDeepest_m, it is a corridor, which is reported if it has a door.
            const bool corridor = low_room_m == 0.0 || high_room_m == 0.0;
            if (corridor && !opening.doors.empty()) plan_.openings.push_back(std::move(opening));
            return;
        }
        low_room_m = std::min(low_room_m, room_m(opening, false, wall));
        high_room_m = std::min(high_room_m, room_m(opening, true, wall));
        rooms_.push_back({plan_.openings.size(), low_room_m, high_room_m});
        opening.front_m = std::min(t[0], wall[0] - kFrame_m);
        opening.back_m = std::max(t[1], wall[1] + kFrame_m);
        plan_.openings.push_back(std::move(opening));
    }

    // Returns the depth range of a solid next to the opening.
    Range depth_of(std::uint32_t solid, const NarrowOpening& opening, const Range& beside, const Range& z) {
        const Vec3 up(0.0, 0.0, 1.0);
        const ConvexSolid part =
            common(scene_.solids[solid].shape,
                   {{opening.along, beside[1]}, {-opening.along, -beside[0]}, {up, z[1]}, {-up, -(z[0] + kStep_m)}});
        return part.faces.empty() ? kNoRange : along(part, opening.left());
    }

    // Extends the depth range by the further layers of the wall, because a wall may consist of several.
    Range with_layers(const NarrowOpening& opening, bool high, const Range& beside, Range depth, const Range& z) {
        constexpr double kFlush_m = 0.05;
        for (bool grew = true; grew && length(depth) <= kDeepest_m;) {
            grew = false;
            const Range near{depth[0] - kFlush_m, depth[1] + kFlush_m}, tall{z[0] + kStep_m, z[1]};
            index().find(box_around(opening.along, beside, near, tall), found_);
            for (const std::uint32_t i : std::vector<std::uint32_t>(found_)) {
                if (!is_wall(scene_, scene_.solids[i])) continue;
                const Range one = depth_of(i, opening, beside, z);
                if (one[0] > one[1] || length(one) > kDeepest_m || !overlap(one, near)) continue;
                const Range s = along(scene_.solids[i].shape, opening.along);
                if (high ? s[0] > opening.high_m + kFlush_m : s[1] < opening.low_m - kFlush_m) continue;
                const double was = length(depth);
                include(depth, one);
                grew = grew || length(depth) > was + 1e-9;
            }
        }
        return depth;
    }

    // Returns how far the opening may be widened to one side. The opening must not pass a crossing wall in front of or
    // behind its own wall, because another room may be beyond the crossing wall. Nor may the opening reach a solid that
    // cannot be cut.
    double room_m(const NarrowOpening& opening, bool high, const Range& wall) {
        const double edge_m = high ? opening.high_m : opening.low_m;
        const Range s = high ? Range{edge_m, edge_m + gap_m_} : Range{edge_m - gap_m_, edge_m};
        const Range z{opening.floor_m + kStep_m, opening.top_m - kFrame_m};
        double room = gap_m_;
        const auto look = [&](const Range& t, auto&& counts) {
            if (!(t[0] < t[1]) || !(z[0] < z[1])) return;
            index().find(box_around(opening.along, s, t, z), found_);
            for (const std::uint32_t i : std::vector<std::uint32_t>(found_)) {
                if (!counts(scene_.solids[i])) continue;
                const ConvexSolid part = common(scene_.solids[i].shape, box_planes(opening.along, s, t, z));
                if (part.faces.empty()) continue;
                const Range met = along(part, opening.along);
                room = std::min(room, std::max(0.0, high ? met[0] - edge_m : edge_m - met[1]));
            }
        };
        const auto stands_across = [&](const Solid& solid) {
            return is_standing(scene_, solid) && !is_thing(scene_, solid.feature);
        };
        const auto not_to_be_cut = [&](const Solid& solid) {
            return (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) && !is_wall(scene_, solid) &&
                   !is_door_of(opening, solid);
        };
        look({wall[0] - kFrame_m - kStrip_m, wall[0] - kFrame_m}, stands_across);
        look({wall[1] + kFrame_m, wall[1] + kFrame_m + kStrip_m}, stands_across);
        const double inside_m = std::min(0.01, 0.1 * length(wall));
        look({wall[0] + inside_m, wall[1] - inside_m}, not_to_be_cut);
        return room;
    }

    static bool is_door_of(const NarrowOpening& opening, const Solid& solid) {
        return std::find(opening.doors.begin(), opening.doors.end(), solid.feature) != opening.doors.end();
    }

    // Distributes the widening. The wall between two openings must stay wide enough to be felt. Within that limit, each
    // opening grows equally to both sides, or more to the side that has room.
    void share_walls() {
        for (Room& of_a : rooms_) {
            if (!goes_on()) return;
            for (Room& of_b : rooms_) {
                const NarrowOpening &a = plan_.openings[of_a.opening], &b = plan_.openings[of_b.opening];
                if (&a == &b || glm::dot(a.along, b.along) < 1.0 - 1e-9 || a.high_m > b.low_m ||
                    !overlap({a.front_m, a.back_m}, {b.front_m, b.back_m}) ||
                    !overlap({a.floor_m, a.top_m}, {b.floor_m, b.top_m}))
                    continue;
                const double each_m = std::max(0.0, 0.5 * (b.low_m - a.high_m - thing_m_));
                of_a.high_m = std::min(of_a.high_m, each_m);
                of_b.low_m = std::min(of_b.low_m, each_m);
            }
        }
        for (const Room& room : rooms_) {
            NarrowOpening& opening = plan_.openings[room.opening];
            const double more_m = gap_m_ - opening.width_m();
            const double high = std::min(std::max(0.5 * more_m, more_m - room.low_m), room.high_m),
                         low = std::min(more_m - high, room.low_m);
            opening.felt_low_m -= low;
            opening.felt_high_m += high;
        }
    }

    // ---- small things ----

    void leave_out() {
        Aabb world = scene_.bounds_m;
        for (const PlacedModel& placed : scene_.placed)
            if (const Feature* feature = scene_.find(placed.feature); feature && !feature->bounds_m.empty())
                world.include(feature->bounds_m);
        const double widest_m = world.empty() ? 0.0 : std::max(world.size_m().x, world.size_m().y);
        std::vector<bool> small(scene_.features.size(), false);
        bool any = false;
        for (std::size_t i = 0; i < small.size(); ++i) {
            if (!goes_on()) return;
            const Feature& feature = scene_.features[i];
            if (feature.kind != FeatureKind::Object || feature.landmark || feature.clue || feature.base ||
                feature.bounds_m.empty())
                continue;
            const Vec3 size = feature.bounds_m.size_m();
            const double wide_m = std::max(size.x, size.y);
            small[i] = wide_m < thing_m_ && wide_m < kOfTheWorld * widest_m;
            any = any || small[i];
        }
        if (!any) return;
        const auto keep = [&](FeatureId id) {
            if (id.value < small.size()) small[id.value] = false;
        };
        for (const Mover& mover : scene_.movers) keep(mover.feature);
        for (const Effect& effect : scene_.effects) keep(effect.belongs_to);
        // Mesh triangles are often pieces of one surface, so their features stay.
        for (const MeshTriangle& t : scene_.triangles) keep(t.feature);
        std::vector<Vec3> wanted = options_.kept_m;
        for (const SoundSource& sound : scene_.sounds) wanted.push_back(sound.position_m);
        for (std::size_t i = 0; i < small.size(); ++i) {
            if (!goes_on()) return;
            if (small[i] && std::any_of(wanted.begin(), wanted.end(), [&](const Vec3& p) {
                    return distance_to(scene_.features[i].bounds_m, p) <= kAtAThing_m;
                }))
                small[i] = false;
        }
        std::vector<bool> stands(small.size(), false);
        for (const Solid& solid : scene_.solids)
            if (solid.feature.value < small.size()) {
                if (solid.role == SolidRole::Solid) stands[solid.feature.value] = true;
                else small[solid.feature.value] = false;
            }
        for (const PlacedModel& placed : scene_.placed)
            if (placed.feature.value < small.size()) stands[placed.feature.value] = true;
        for (std::uint32_t i = 0; i < small.size(); ++i) {
            if (!goes_on()) return;
            if (small[i] && stands[i] && !closes_a_gap(FeatureId{i})) plan_.left_out.push_back(FeatureId{i});
        }
    }

    // Returns true if the wall would have a hole without the thing `id`. A window, which has walls on two opposite
    // sides, closes a gap. So does a piece of the wall itself.
    bool closes_a_gap(FeatureId id) {
        constexpr double kTouch_m = 0.02;
        const Feature& thing = scene_.features[id.value];
        const Aabb& box = thing.bounds_m;
        std::vector<Vec3> ways;
        index().find(grown(box, kTouch_m), found_);
        for (const std::uint32_t i : found_) {
            const Solid& solid = scene_.solids[i];
            const Aabb& wall = solid.shape.bounds_m;
            if (solid.feature == id || !is_wall(scene_, solid)) continue;
            // Skips the floor and the ceiling.
            if (std::min(wall.max_m.z, box.max_m.z) - std::max(wall.min_m.z, box.min_m.z) < kFrame_m) continue;
            const Vec3 middle = box.centre_m();
            Vec3 way = glm::clamp(middle, wall.min_m, wall.max_m) - middle;
            way.z = 0.0;
            if (thing.made_name || way == Vec3(0.0)) return true;
            ways.push_back(glm::normalize(way));
        }
        for (const Vec3& a : ways)
            for (const Vec3& b : ways)
                if (glm::dot(a, b) < -0.5) return true;
        return false;
    }

    static double distance_to(const Aabb& box, const Vec3& p) {
        return glm::length(glm::max(glm::max(box.min_m - p, p - box.max_m), Vec3(0.0)));
    }

    const Scene& scene_;
    const SimplifyOptions& options_;
    const std::stop_token& stop_;
    const std::function<void()>& looks_;
    double gap_m_, thing_m_;
    struct Room {
        std::size_t opening;
        double low_m, high_m;  // how far the opening may be widened on each side
    };
    Simplification plan_;
    std::vector<Room> rooms_;
    std::optional<BoxIndex> index_;
    std::vector<std::uint32_t> found_;
};

}  // namespace

Simplification plan_simplification(const Scene& scene, const SimplifyOptions& options, const std::stop_token& stop,
                                   const std::function<void()>& looks) {
    if (!(options.world_m_per_hand_m > 0.0) || !std::isfinite(options.world_m_per_hand_m)) return {};
    return Planner(scene, options, stop, looks).run();
}

}  // namespace handrail::compile
