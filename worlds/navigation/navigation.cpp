#include "worlds/navigation/navigation.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <queue>
#include <set>

#include "worlds/base/language.h"
#include "worlds/navigation/route_place.h"

namespace handrail::navigation {
namespace {

// Greatest distance from a requested place, such as an object, to the nearest place where people can stand.
constexpr double kGoalReach_m = 3.0;
constexpr double kStartReach_m = 1.0;
constexpr double kNarrow_m = 0.25;          // floor with less clearance is narrow
constexpr double kStairsAnnounced_m = 0.4;  // a passage over stairs with a smaller rise is not announced
constexpr double kOneFlight_m = 1.0;  // two passages over stairs with a smaller distance between them are one passage
constexpr double kGameCell_m = 0.1, kBuildingCell_m = 0.05;
constexpr double kThroughLeaf_per_m = 30.0;  // cost of each metre through a leaf; worth about 15 metres of detour
constexpr double kNextToLeaf_per_m = 3.0;
// Distance before and after a leaf within which a route may change to go around it.
constexpr double kRoundLeaf_m = 3.0;
constexpr double kOutOfLeaf_m = 1.0;
constexpr double kMostGameDrop_m = 20.0, kMostPlannedDrop_m = 1.0;

}  // namespace

WalkerMeasures walker_measures(const Scene& scene, double radius_m, double height_m, double step_up_m) {
    WalkerMeasures body;
    body.radius_m = radius_m;
    body.height_m = height_m;
    body.step_up_m = step_up_m;
    body.cell_m = scene.game_map ? kGameCell_m : kBuildingCell_m;
    body.most_drop_m = scene.game_map ? kMostGameDrop_m : kMostPlannedDrop_m;
    return body;
}

Result<std::shared_ptr<Navigation>> Navigation::make(const Scene& scene, const WalkerMeasures& body,
                                                     const std::stop_token& stop) {
    Result<WalkSpace> space = make_walk_space(scene, body, stop);
    if (!space) return tl::unexpected(space.error());
    return over(scene, std::move(*space), stop);
}

Result<std::shared_ptr<Navigation>> Navigation::over(const Scene& scene, WalkSpace space, const std::stop_token& stop) {
    std::shared_ptr<Navigation> made(new Navigation);
    made->space_ = std::move(space);
    try {
        if (Result<NavMesh> mesh = NavMesh::make(made->space_, stop))
            made->mesh_ = std::make_unique<NavMesh>(std::move(*mesh));
        if (made->mesh_ && made->mesh_->far_links() > 0)
            made->space_.said.push_back(phrase("navigation.far_links", {{"n", made->mesh_->far_links()}}));
    } catch (const std::bad_alloc&) {  // If memory is short, routes are planned without a mesh, from cell to cell.
    }
    if (stop.stop_requested()) return fail(phrase("navigation.given_up"), scene.source_file);

    const WalkSpace& all = made->space_;
    made->piece_.assign(all.spans.size(), kNothing);
    std::uint32_t pieces = 0;
    std::vector<std::uint32_t> open;
    for (std::uint32_t s = 0; s < all.spans.size(); ++s) {
        if (made->piece_[s] != kNothing) continue;
        open.assign(1, s);
        made->piece_[s] = pieces;
        while (!open.empty()) {
            const std::uint32_t here = open.back();
            open.pop_back();
            for (const std::uint32_t n : all.spans[here].next)
                if (n != kNothing && made->piece_[n] == kNothing) {
                    made->piece_[n] = pieces;
                    open.push_back(n);
                }
        }
        ++pieces;
    }
    made->leads_to_.resize(pieces);
    for (const WalkLink& link : all.links) {
        const std::uint32_t a = made->piece_[link.from], b = made->piece_[link.to];
        if (a == b) continue;
        made->leads_to_[a].push_back(b);
        if (link.both_ways) made->leads_to_[b].push_back(a);
    }
    for (const Mover& mover : scene.movers) {
        made->door_features_.push_back(mover.feature);
        made->door_groups_.push_back(mover.group);
        const Feature* feature = scene.find(mover.feature);
        made->door_places_.push_back(feature && !feature->bounds_m.empty() ? feature->bounds_m.centre_m() : Vec3(0.0));
    }
    return made;
}

std::uint32_t Navigation::span_from(const Vec3& feet_m) const {
    return space_.nearest(feet_m, kStartReach_m, 0.6, 3.0);
}

std::uint32_t Navigation::span_to(const Vec3& at_m) const {
    if (const std::uint32_t near = space_.nearest(at_m, kStartReach_m, 0.6, 3.0); near != kNothing) return near;
    return space_.nearest(at_m, kGoalReach_m, 1.5, 4.0);
}

std::optional<Vec3> Navigation::nearest_place(const Vec3& at_m) const {
    const std::uint32_t span = span_to(at_m);
    if (span == kNothing) return std::nullopt;
    return space_.place_m(out_of_leaf(span));
}

std::vector<bool> Navigation::pieces_from(std::uint32_t span) const {
    std::vector<bool> reached(leads_to_.size(), false);
    std::vector<std::uint32_t> open{piece_[span]};
    reached[piece_[span]] = true;
    while (!open.empty()) {
        const std::uint32_t here = open.back();
        open.pop_back();
        for (const std::uint32_t n : leads_to_[here])
            if (!reached[n]) {
                reached[n] = true;
                open.push_back(n);
            }
    }
    return reached;
}

bool Navigation::reachable(const Vec3& from_m, const Vec3& to_m) const {
    const std::uint32_t from = span_from(from_m), to = span_to(to_m);
    return from != kNothing && to != kNothing && pieces_from(from)[piece_[to]];
}

void Navigation::block(std::span<const Aabb> boxes) {
    blocked_.clear();
    const double reach_m = space_.body.radius_m;
    for (const Aabb& box : boxes) {
        if (box.empty()) continue;
        if (blocked_.empty()) blocked_.assign(space_.spans.size(), false);
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s) {
            const Vec3 at = space_.place_m(s);
            if (at.z >= box.max_m.z || at.z + space_.body.height_m <= box.min_m.z) continue;
            const Vec3 near = glm::clamp(at, box.min_m, box.max_m);
            if (std::hypot(at.x - near.x, at.y - near.y) < reach_m) blocked_[s] = true;
        }
    }
}

// Returns the nearest span that is not blocked, for a walker who starts inside or at the edge of a blocked box. The
// search does not cross spans under a door leaf. Returns kNothing if there is none.
std::uint32_t Navigation::out_of_blocked(std::uint32_t span) const {
    std::vector<std::uint32_t> open{span};
    std::set<std::uint32_t> seen{span};
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (!blocked_[open[i]]) return open[i];
        for (const std::uint32_t n : space_.spans[open[i]].next)
            if (n != kNothing && space_.spans[n].door == kNothing && seen.insert(n).second) open.push_back(n);
    }
    return kNothing;
}

bool Navigation::meets_blocked(const Way& way) const {
    bool meets = false;
    for (const std::vector<Vec3>& leg : way.legs_m)
        for (std::size_t i = 1; i < leg.size(); ++i)
            space_.straight(leg[i - 1], leg[i], [&](std::uint32_t s) { meets = meets || blocked_[s]; });
    return meets;
}

// Plans over the cells, on foot, around the blocked boxes. If no route leads to the goal, sets `to` to the nearest
// place that the walker can reach.
std::optional<Navigation::Way> Navigation::round_blocked(std::uint32_t from, std::uint32_t& to, const Vec3& to_m,
                                                         RoutePreference preference) const {
    std::vector<std::uint32_t> cells = over_cells(from, to, preference);
    if (cells.empty()) {
        std::vector<bool> seen(space_.spans.size(), false);
        std::vector<std::uint32_t> open{from};
        seen[from] = true;
        double nearest_m = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (const double far_m = glm::length(space_.place_m(open[i]) - to_m); far_m < nearest_m) {
                nearest_m = far_m;
                to = open[i];
            }
            for (const std::uint32_t n : space_.spans[open[i]].next)
                if (n != kNothing && !seen[n] && !blocked_[n]) {
                    seen[n] = true;
                    open.push_back(n);
                }
        }
        cells = over_cells(from, to, preference);
        if (cells.empty()) return std::nullopt;
    }
    Way way;
    for (const std::uint32_t s : cells) way.legs_m.back().push_back(space_.place_m(s));
    finish(way, to, preference);
    return way;
}

double Navigation::span_cost(std::uint32_t span, RoutePreference preference) const {
    if (!blocked_.empty() && blocked_[span]) return std::numeric_limits<double>::infinity();
    const double plain = cost_per_m(space_.spans[span], preference);
    if (leaf_marks_.empty() || leaf_marks_[span] == kNoLeaf) return plain;
    return plain + (leaf_marks_[span] == kInLeaf ? kThroughLeaf_per_m : kNextToLeaf_per_m);
}

double Navigation::cost(const Vec3& from_m, const Vec3& to_m, RoutePreference preference) const {
    double sum = 0.0;
    std::size_t count = 0;
    if (!space_.straight(from_m, to_m, [&](std::uint32_t s) {
            sum += span_cost(s, preference);
            ++count;
        }))
        return std::numeric_limits<double>::infinity();
    return glm::length(to_m - from_m) * sum / static_cast<double>(std::max<std::size_t>(count, 1));
}

// Plans from cell to cell. This is used if a leg of a mesh path is not walkable, because the mesh simplifies outlines a
// little.
std::vector<std::uint32_t> Navigation::over_cells(std::uint32_t from, std::uint32_t to,
                                                  RoutePreference preference) const {
    std::vector<float>& best = search_.best;
    std::vector<std::uint32_t>&came = search_.came, &touched = search_.touched;
    if (best.empty()) {
        best.assign(space_.spans.size(), std::numeric_limits<float>::infinity());
        came.assign(space_.spans.size(), kNothing);
    }
    touched.assign(1, from);
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const Vec3 goal = space_.place_m(to);
    best[from] = 0.0F;
    open.emplace(0.0, from);
    while (!open.empty()) {
        const double estimate = open.top().first;
        const std::uint32_t here = open.top().second;
        open.pop();
        if (here == to) break;
        const Vec3 at = space_.place_m(here);
        if (estimate > static_cast<double>(best[here]) + glm::length(goal - at) + 1e-4) continue;
        const auto go = [&](std::uint32_t n) {
            if (n == kNothing) return;
            const Vec3 there = space_.place_m(n);
            const double through = static_cast<double>(best[here]) + glm::length(there - at) * span_cost(n, preference);
            if (!(static_cast<float>(through) < best[n])) return;
            if (std::isinf(best[n])) touched.push_back(n);
            best[n] = static_cast<float>(through);
            came[n] = here;
            open.emplace(through + glm::length(goal - there), n);
        };
        for (int d = 0; d < 4; ++d) {
            const std::uint32_t side = space_.spans[here].next[d];
            go(side);
            if (side == kNothing) continue;
            const std::uint32_t other = space_.spans[here].next[(d + 1) % 4],
                                corner = space_.spans[side].next[(d + 1) % 4];
            if (other != kNothing && corner != kNothing && space_.spans[other].next[d] == corner) go(corner);
        }
    }
    std::vector<std::uint32_t> way;
    if (from == to || came[to] != kNothing)
        for (std::uint32_t s = to; s != kNothing; s = came[s]) way.push_back(s);
    std::reverse(way.begin(), way.end());
    for (const std::uint32_t s : touched) {
        best[s] = std::numeric_limits<float>::infinity();
        came[s] = kNothing;
    }
    return way;
}

// Returns the nearest span that the walker can reach on foot and that is outside every leaf. Returns `span` itself if
// there is none nearby.
std::uint32_t Navigation::out_of_leaf(std::uint32_t span) const {
    if (!in_leaf(span)) return span;
    const Vec3 from = space_.place_m(span);
    std::vector<std::uint32_t> open{span};
    std::uint32_t best = span;
    double nearest_m = kOutOfLeaf_m;
    std::vector<bool> seen(space_.spans.size(), false);
    seen[span] = true;
    for (std::size_t i = 0; i < open.size(); ++i)
        for (const std::uint32_t n : space_.spans[open[i]].next) {
            if (n == kNothing || seen[n]) continue;
            seen[n] = true;
            const double away_m = glm::length(space_.place_m(n) - from);
            if (away_m >= kOutOfLeaf_m) continue;
            open.push_back(n);
            if (!in_leaf(n) && away_m < nearest_m) {
                nearest_m = away_m;
                best = n;
            }
        }
    return best;
}

// Returns the first and last distance along the points at which a leaf is in the walker's way.
Navigation::Stretch Navigation::in_leaves(std::span<const Vec3> points_m) const {
    Stretch found{std::numeric_limits<double>::infinity(), -1.0};
    double before_m = 0.0;
    for (std::size_t i = 1; i < points_m.size() && !leaf_marks_.empty(); ++i) {
        const Vec3 from = points_m[i - 1], way = points_m[i] - from;
        const double length_m = glm::length(way);
        space_.straight(from, points_m[i], [&](std::uint32_t s) {
            if (leaf_marks_[s] != kInLeaf) return;
            const double along_m =
                before_m +
                (length_m > 0.0 ? std::clamp(glm::dot(space_.place_m(s) - from, way) / length_m, 0.0, length_m) : 0.0);
            found.from_m = std::min(found.from_m, along_m);
            found.to_m = std::max(found.to_m, along_m);
        });
        before_m += length_m;
    }
    return found;
}

bool Navigation::meets_leaf(std::span<const Vec3> points_m) const { return in_leaves(points_m).to_m >= 0.0; }

// Replaces the part of the route that leads through leaves, together with a little before and after it. The new part is
// planned from cell to cell, because the mesh does not know leaves.
void Navigation::go_round_leaves(std::vector<Vec3>& points_m, RoutePreference preference) const {
    const Stretch across = in_leaves(points_m);
    if (across.to_m < 0.0) return;
    const double from_m = across.from_m - kRoundLeaf_m, to_m = across.to_m + kRoundLeaf_m;
    const auto span_at = [&](double along_m) {
        const double up_m = space_.body.step_up_m + 0.2;
        return space_.nearest(place_along(points_m, along_m), 4.0 * space_.cell_m, up_m, up_m);
    };
    const std::uint32_t from = span_at(from_m), to = span_at(to_m);
    if (from == kNothing || to == kNothing) return;
    const std::vector<std::uint32_t> cells = over_cells(from, to, preference);
    if (cells.empty()) return;
    std::vector<Vec3> round;
    double along_m = 0.0;
    for (std::size_t i = 0; i < points_m.size(); ++i) {
        if (i > 0) along_m += glm::length(points_m[i] - points_m[i - 1]);
        if (along_m < from_m) round.push_back(points_m[i]);
    }
    for (const std::uint32_t s : cells) round.push_back(space_.place_m(s));
    along_m = 0.0;
    for (std::size_t i = 0; i < points_m.size(); ++i) {
        if (i > 0) along_m += glm::length(points_m[i] - points_m[i - 1]);
        if (along_m > to_m) round.push_back(points_m[i]);
    }
    points_m = std::move(round);
}

// Leaves out points if the straight line between their neighbours costs no more.
void Navigation::straighten(std::vector<Vec3>& points_m, RoutePreference preference) const {
    if (points_m.size() < 3) return;
    std::vector<double> so_far{0.0};
    for (std::size_t i = 1; i < points_m.size(); ++i) {
        double leg = cost(points_m[i - 1], points_m[i], preference);
        if (!std::isfinite(leg)) leg = 4.0 * glm::length(points_m[i] - points_m[i - 1]);
        so_far.push_back(so_far.back() + leg);
    }
    std::vector<Vec3> kept{points_m.front()};
    for (std::size_t at = 0; at + 1 < points_m.size();) {
        std::size_t to = at + 1;
        for (std::size_t far = points_m.size() - 1; far > at + 1; --far)
            if (cost(points_m[at], points_m[far], preference) <= so_far[far] - so_far[at] + 1e-6) {
                to = far;
                break;
            }
        kept.push_back(points_m[to]);
        at = to;
    }
    points_m = std::move(kept);
}

// Moves the turning points of a route to places with more clearance, if that does not make the route worse. The route
// then leads through the middle of doors, and keeps a distance from corners.
void Navigation::keep_clear(std::vector<Vec3>& points_m, RoutePreference preference) const {
    if (preference == RoutePreference::Shortest || points_m.size() < 2) return;
    // Adds a turning point in each narrow place.
    std::vector<Vec3> more{points_m.front()};
    for (std::size_t i = 1; i < points_m.size(); ++i) {
        std::uint32_t narrowest = kNothing;
        space_.straight(points_m[i - 1], points_m[i], [&](std::uint32_t s) {
            if (narrowest == kNothing || space_.spans[s].clearance_m < space_.spans[narrowest].clearance_m)
                narrowest = s;
        });
        if (narrowest != kNothing && static_cast<double>(space_.spans[narrowest].clearance_m) < kNarrow_m) {
            const Vec3 place = space_.place_m(narrowest);
            if (glm::length(place - points_m[i - 1]) > kNarrow_m && glm::length(place - points_m[i]) > kNarrow_m)
                more.push_back(place);
        }
        more.push_back(points_m[i]);
    }
    for (int round = 0; round < 4; ++round) {
        bool moved = false;
        for (std::size_t i = 1; i + 1 < more.size(); ++i)
            for (const double by : {0.3, 0.1, space_.cell_m}) {
                double best = cost(more[i - 1], more[i], preference) + cost(more[i], more[i + 1], preference);
                Vec3 to = more[i];
                for (int way = 0; way < 8; ++way) {
                    const Vec3 aim = more[i] + forward_of_heading(way * kPi / 4.0) * by;
                    const std::uint32_t s = space_.at(aim);
                    if (s == kNothing) continue;
                    const Vec3 place = space_.place_m(s);
                    const double there = cost(more[i - 1], place, preference) + cost(place, more[i + 1], preference);
                    if (there < best - 1e-6) {
                        best = there;
                        to = place;
                    }
                }
                moved = moved || to != more[i];
                more[i] = to;
            }
        if (!moved) break;
    }
    points_m = std::move(more);
    straighten(points_m, preference);
}

// Adds to the route the doors and stairs on a walked leg, and the points where these stairs begin and end.
void Navigation::add_passages(Route& route, const std::vector<Vec3>& leg) const {
    std::uint32_t door = kNothing;
    bool on_stairs = false;
    std::uint32_t stairs_from = kNothing;
    double stairs_at_m = 0.0, stairs_end_m = -1e9;
    FeatureId stairs_ground = kNoFeature;
    const auto add_point = [&](const Vec3& p) {
        const double further = glm::length(p - route.points_m.back());
        route.length_m += further;
        if (further > 1e-9) route.points_m.push_back(p);
    };
    const auto end_stairs = [&](std::uint32_t at) {
        on_stairs = false;
        const double rise = space_.place_m(at).z - space_.place_m(stairs_from).z;
        RoutePassage* before = route.passages.empty() ? nullptr : &route.passages.back();
        if (before && before->kind == PassageKind::Stairs && before->rise_m * rise > 0.0 &&
            stairs_at_m - stairs_end_m < kOneFlight_m) {
            before->rise_m += rise;
            if (!before->feature) before->feature = stairs_ground;
        } else {
            route.passages.push_back(
                {PassageKind::Stairs, space_.place_m(stairs_from), stairs_at_m, rise, stairs_ground});
        }
        stairs_end_m = route.length_m + glm::length(space_.place_m(at) - route.points_m.back());
    };
    if (route.points_m.empty() || glm::length(leg.front() - route.points_m.back()) > 1e-9)
        route.points_m.push_back(leg.front());  // A link joins the ends of two legs and adds no length.
    std::uint32_t last = kNothing;
    for (std::size_t i = 1; i < leg.size(); ++i) {
        const Vec3 from = leg[i - 1], to = leg[i];
        const double length = glm::length(to - from);
        space_.straight(from, to, [&](std::uint32_t s) {
            const Vec3 here = space_.place_m(s);
            const double along =
                length > 0.0 ? std::clamp(glm::dot(here - from, to - from) / (length * length), 0.0, 1.0) : 0.0;
            const Vec3 on_line = [&] {
                Vec3 p = from + (to - from) * along;
                p.z = here.z;
                return p;
            }();
            const double at_m = route.length_m + glm::length(on_line - route.points_m.back());
            const WalkSpan& span = space_.spans[s];
            const std::uint32_t group = span.door == kNothing ? kNothing : door_groups_[span.door];
            if (group != kNothing && group != door) {
                const Vec3 centre = door_places_[span.door];
                route.passages.push_back(
                    {PassageKind::Door, {centre.x, centre.y, here.z}, at_m, 0.0, door_features_[span.door]});
            }
            door = group;
            if (span.stairs != on_stairs) {
                if (span.stairs) {
                    stairs_from = s;
                    stairs_at_m = at_m;
                    stairs_ground = kNoFeature;
                    on_stairs = true;
                } else {
                    end_stairs(s);
                }
                if (along > 0.0 && along < 1.0) add_point(on_line);
            }
            if (span.stairs && !stairs_ground && span.ground < space_.obstacle_features.size())
                stairs_ground = space_.obstacle_features[span.ground];
            last = s;
        });
        add_point(to);
    }
    if (on_stairs && last != kNothing) end_stairs(last);
}

// Finds the path over the mesh and moves its corners onto the floor.
std::optional<Navigation::Way> Navigation::over_mesh(std::uint32_t from, std::uint32_t to, RoutePreference preference,
                                                     bool over_links) {
    const std::optional<MeshPath> found = mesh_ ? mesh_->path(from, to, preference, over_links) : std::nullopt;
    if (!found || !found->complete) return std::nullopt;
    Way way;
    for (std::size_t i = 0; i < found->corners.size(); ++i) {
        const MeshPath::Corner& corner = found->corners[i];
        std::uint32_t on = space_.nearest(corner.place_m, 4.0 * space_.cell_m, space_.body.step_up_m + 0.2,
                                          space_.body.step_up_m + 0.2);
        if (i == 0) on = from;
        if (i + 1 == found->corners.size()) on = to;
        for (const std::uint32_t number :
             {i > 0 ? found->corners[i - 1].link : kNothing, corner.link}) {  // the corner is one end of a link
            if (number == kNothing) continue;
            const WalkLink& link = space_.links[number];
            const Vec3 a = space_.place_m(link.from), b = space_.place_m(link.to);
            on = glm::length(a - corner.place_m) < glm::length(b - corner.place_m) ? link.from : link.to;
        }
        if (on == kNothing) continue;
        way.legs_m.back().push_back(space_.place_m(on));
        if (corner.link != kNothing) {
            way.links.push_back(corner.link);
            way.legs_m.emplace_back();
        }
    }
    return way;
}

// Makes every leg walkable, leads it around leaves, straightens it and moves it away from walls.
void Navigation::finish(Way& way, std::uint32_t to, RoutePreference preference) const {
    for (std::vector<Vec3>& leg : way.legs_m) {
        if (leg.empty()) leg.push_back(space_.place_m(to));
        std::vector<Vec3> walked{leg.front()};
        for (std::size_t k = 1; k < leg.size(); ++k) {
            if (!space_.straight(leg[k - 1], leg[k])) {
                const std::uint32_t a = space_.nearest(leg[k - 1], space_.cell_m, 0.1, 0.1),
                                    b = space_.nearest(leg[k], space_.cell_m, 0.1, 0.1);
                if (a != kNothing && b != kNothing)
                    for (const std::uint32_t s : over_cells(a, b, preference)) walked.push_back(space_.place_m(s));
            }
            walked.push_back(leg[k]);
        }
        go_round_leaves(walked, preference);
        straighten(walked, preference);
        keep_clear(walked, preference);
        leg = std::move(walked);
    }
}

double Navigation::cost(const Way& way, RoutePreference preference) const {
    double sum = 0.0;
    for (const std::vector<Vec3>& leg : way.legs_m)
        for (std::size_t k = 1; k < leg.size(); ++k) sum += cost(leg[k - 1], leg[k], preference);
    for (std::size_t i = 0; i < way.links.size(); ++i)
        sum += NavMesh::cost_of(space_.links[way.links[i]],
                                glm::length(way.legs_m[i + 1].front() - way.legs_m[i].back()), preference);
    return sum;
}

// If the goal can be reached on foot and also over a link, for example by stairs and by a lift, compares both complete
// routes and returns the cheaper one.
std::optional<Navigation::Way> Navigation::best_over_mesh(std::uint32_t from, std::uint32_t to,
                                                          RoutePreference preference) {
    std::optional<Way> foot, linked;
    if (piece_[from] == piece_[to]) foot = over_mesh(from, to, preference, false);
    if (!space_.links.empty() && preference != RoutePreference::OnFoot) linked = over_mesh(from, to, preference, true);
    if (linked && linked->links.empty() && foot) linked.reset();
    if (foot) finish(*foot, to, preference);
    if (linked) finish(*linked, to, preference);
    return foot && !(linked && cost(*linked, preference) < cost(*foot, preference)) ? foot : linked;
}

Route Navigation::plan(const Vec3& from_m, const Vec3& to_m, RoutePreference preference) {
    Route route;
    const std::uint32_t from = span_from(from_m);
    if (from == kNothing || !is_finite(to_m)) return route;
    std::uint32_t to = span_to(to_m);
    const std::vector<bool> reached = pieces_from(from);
    route.reaches = to != kNothing && reached[piece_[to]];
    if (!route.reaches) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::uint32_t s = 0; s < space_.spans.size(); ++s)
            if (reached[piece_[s]])
                if (const double far = glm::length(space_.place_m(s) - to_m); far < nearest) {
                    nearest = far;
                    to = s;
                }
        route.short_of_m = nearest;
    }

    if (to != kNothing) to = out_of_leaf(to);

    // Plans over the mesh. If the mesh has no path, plans from cell to cell.
    std::optional<Way> way = best_over_mesh(from, to, preference);
    if (!way) {
        way.emplace();
        if (piece_[from] == piece_[to])
            for (const std::uint32_t s : over_cells(from, to, preference))
                way->legs_m.back().push_back(space_.place_m(s));
        if (way->legs_m.back().empty()) {
            route.reaches = false;
            way->legs_m.back().push_back(space_.place_m(from));
            route.short_of_m = glm::length(to_m - space_.place_m(from));
        }
        finish(*way, to, preference);
    }
    if (const std::uint32_t out = blocked_.empty() || !meets_blocked(*way) ? kNothing : out_of_blocked(from);
        out != kNothing) {
        const std::uint32_t wanted = to;
        if (std::optional<Way> round = round_blocked(out, to, to_m, preference)) {
            way = std::move(round);
            if (out != from) way->legs_m.front().insert(way->legs_m.front().begin(), space_.place_m(from));
        }
        if (to != wanted) {
            route.reaches = false;
            route.short_of_m = glm::length(space_.place_m(to) - to_m);
        }
    }
    for (std::size_t i = 0; i < way->legs_m.size(); ++i) {
        if (i > 0) {
            const WalkLink& link = space_.links[way->links[i - 1]];
            const double rise = way->legs_m[i].front().z - route.points_m.back().z;
            route.passages.push_back({link.kind, route.points_m.back(), route.length_m, rise, link.feature});
            route.drops = route.drops || link.kind == PassageKind::Drop;
        }
        add_passages(route, way->legs_m[i]);
    }
    // Stairs with a rise below kStairsAnnounced_m are not announced.
    std::erase_if(route.passages, [&](const RoutePassage& p) {
        return p.kind == PassageKind::Stairs && std::abs(p.rise_m) < kStairsAnnounced_m;
    });
    return route;
}

}  // namespace handrail::navigation
