#include "worlds/navigation/walk_space.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_map>

#include "worlds/base/language.h"
#include "worlds/navigation/stated_stairs.h"
#include "worlds/navigation/walk_clearance.h"
#include "worlds/navigation/walk_flood.h"

namespace handrail::navigation {
namespace {

constexpr double kCoarsest_m = 0.4;
constexpr double kStairWindow_m = 0.6;  // distance on either side of a span over which the search for stairs extends
constexpr double kStairRise_m = 0.35;   // least rise over both sides together for stairs

// Computes, for each span, the distance from the nearest border span, and which border span that is. All borders spread
// at the same time, each over the spans that are nearer to it than to any other. After a stop request, the result is
// incomplete.
template <class Span, class Counts>
std::vector<float> distance_from(const SpanGrid<Span>& space, Counts counts, std::vector<std::uint32_t>& source,
                                 const std::stop_token& stop) {
    struct Wave {
        std::uint32_t span, source;
    };
    struct Place {  // the data of a span that the search reads, in half a cache line
        std::uint32_t next[4];
        std::uint32_t x = 0, y = 0;  // column and row of the span
        float found = 1e6F;
        std::uint32_t source = kNothing;
    };
    const auto count = static_cast<std::uint32_t>(space.spans.size());
    std::vector<Place> places(count);
    std::vector<std::vector<Wave>> buckets(1);
    for (std::uint32_t s = 0; s < count; ++s) {
        Place& place = places[s];
        std::copy(std::begin(space.spans[s].next), std::end(space.spans[s].next), place.next);
        place.x = space.spans[s].cell % space.width;
        place.y = space.spans[s].cell / space.width;
        if (counts(s)) buckets[0].push_back({s, s});
    }
    const auto distance = [](const Place& a, const Place& b) {
        const double dx = static_cast<double>(a.x) - static_cast<double>(b.x),
                     dy = static_cast<double>(a.y) - static_cast<double>(b.y);
        return std::sqrt(dx * dx + dy * dy);  // distance in cells
    };
    for (std::size_t b = 0; b < buckets.size() && !stop.stop_requested(); ++b) {
        for (std::size_t i = 0; i < buckets[b].size(); ++i) {
            const Wave wave = buckets[b][i];
            Place& here = places[wave.span];
            const Place& from = places[wave.source];
            const auto far = static_cast<float>((distance(here, from) + 0.5) * space.cell_m);
            if (!(far < here.found)) continue;
            here.found = far;
            here.source = wave.source;
            for (const std::uint32_t n : here.next) {
                if (n == kNothing) continue;
                const double next_far = distance(places[n], from);
                if (!((next_far + 0.5) * space.cell_m < static_cast<double>(places[n].found))) continue;
                const auto bucket = std::max(static_cast<std::size_t>(next_far * 2.0), b);
                if (bucket >= buckets.size()) buckets.resize(bucket + 1);
                buckets[bucket].push_back({n, wave.source});
            }
        }
        std::vector<Wave>().swap(buckets[b]);  // frees the bucket, which no later wave uses
    }
    std::vector<float> found(count);
    source.resize(count);
    for (std::uint32_t s = 0; s < count; ++s) {
        found[s] = places[s].found;
        source[s] = places[s].source;
    }
    return found;
}

template <class Span>
bool is_border(const Span& span) {
    return std::any_of(std::begin(span.next), std::end(span.next), [](std::uint32_t n) { return n == kNothing; });
}

// Measures the distance of each span from the nearest border, and stores which obstacle is at that border.
void measure_clearance(WalkSpace& space, const std::stop_token& stop) {
    std::vector<std::uint32_t> source;
    const std::vector<float> clearance = distance_from(
        space, [&](std::uint32_t s) { return is_border(space.spans[s]); }, source, stop);
    for (std::uint32_t s = 0; s < space.spans.size(); ++s) {
        space.spans[s].clearance_m = clearance[s];
        if (source[s] == kNothing || source[s] == s) continue;
        space.spans[s].beside = space.spans[source[s]].beside;
        space.spans[s].near_edge = space.spans[source[s]].near_edge;
    }
}
void measure_clearance(SpanGrid<WallSpan>& walls, const std::stop_token& stop) {
    std::vector<std::uint32_t> source;
    const std::vector<float> clearance = distance_from(
        walls, [&](std::uint32_t s) { return is_border(walls.spans[s]); }, source, stop);
    for (std::uint32_t s = 0; s < walls.spans.size(); ++s) walls.spans[s].clearance_m = clearance[s];
}

// Marks the spans on stairs, where the floor rises step by step.
template <class Span>
void find_stairs(SpanGrid<Span>& space, double step_up_m) {
    const auto reach = static_cast<std::size_t>(std::max(2L, std::lround(kStairWindow_m / space.cell_m)));
    const double least_range_m = std::max(0.6, 2.0 * step_up_m);
    const auto count = static_cast<std::uint32_t>(space.spans.size());
    // Scans each row of consecutive spans, first to the east, then to the north. Each step also leads back, so the
    // other two directions need no search.
    struct RowCell {
        float floor_m = 0.0F;
        std::uint32_t next = kNothing;
    };
    std::vector<RowCell> treads(count), row;
    std::vector<std::uint32_t> of_row;
    for (const int d : {0, 1}) {
        for (std::uint32_t s = 0; s < count; ++s) treads[s] = {space.spans[s].floor_m, space.spans[s].next[d]};
        for (std::uint32_t start = 0; start < count; ++start) {
            if (space.spans[start].next[d + 2] != kNothing) continue;
            row.clear();
            of_row.clear();
            for (std::uint32_t s = start; s != kNothing; s = treads[s].next) {
                row.push_back(treads[s]);
                of_row.push_back(s);
            }
            for (std::size_t i = 0; i < row.size(); ++i) {
                const RowCell &ahead = row[std::min(i + reach, row.size() - 1)], &behind = row[i - std::min(i, reach)];
                if (std::abs(static_cast<double>(ahead.floor_m) - static_cast<double>(behind.floor_m)) >= kStairRise_m)
                    space.spans[of_row[i]].stairs = 1;
            }
        }
    }
    std::vector<bool> seen(count, false);
    std::vector<std::uint32_t> piece;
    for (std::uint32_t s = 0; s < count; ++s) {
        if (seen[s] || !space.spans[s].stairs) continue;
        piece.assign(1, s);
        seen[s] = true;
        float low = space.spans[s].floor_m, high = low;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            low = std::min(low, space.spans[piece[i]].floor_m);
            high = std::max(high, space.spans[piece[i]].floor_m);
            for (const std::uint32_t n : space.spans[piece[i]].next)
                if (n != kNothing && space.spans[n].stairs && !seen[n]) {
                    seen[n] = true;
                    piece.push_back(n);
                }
        }
        if (static_cast<double>(high - low) < least_range_m)
            for (const std::uint32_t p : piece) space.spans[p].stairs = 0;
    }
}

// Keeps only one drop for about each metre of an edge, because people could step off almost anywhere along it.
void thin_drops(WalkSpace& space) {
    std::unordered_map<std::uint64_t, std::size_t> kept;
    std::vector<WalkLink> thin;
    const auto tile = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(std::lround(1.0 / space.cell_m)));
    for (const WalkLink& link : space.links) {
        const WalkSpan &from = space.spans[link.from], &to = space.spans[link.to];
        const std::uint64_t x = from.cell % space.width / tile, y = from.cell / space.width / tile;
        const auto level = static_cast<std::uint64_t>(std::lround(static_cast<double>(from.floor_m) * 2.0)) & 0xfff;
        const auto below = static_cast<std::uint64_t>(std::lround(static_cast<double>(to.floor_m) * 2.0)) & 0xfff;
        const std::uint64_t key = (x << 44) ^ (y << 24) ^ (level << 12) ^ below;
        const auto [found, is_new] = kept.try_emplace(key, thin.size());
        if (is_new) thin.push_back(link);
        else if (from.clearance_m > space.spans[thin[found->second].from].clearance_m) thin[found->second] = link;
    }
    space.links = std::move(thin);
}

void link_lifts_and_teleporters(const Scene& scene, WalkSpace& space) {
    const auto lift_of = [&](std::uint32_t span) -> FeatureId {
        const std::uint32_t ground = space.spans[span].ground;
        if (ground == kNothing || ground >= space.obstacle_features.size()) return kNoFeature;
        const FeatureId feature = space.obstacle_features[ground];
        const Feature* found = scene.find(feature);
        return found && found->kind == FeatureKind::Lift ? feature : kNoFeature;
    };
    // Lifts, each with the distance of its column from the middle of the lift.
    std::vector<std::pair<double, WalkLink>> lifts;
    // Key: the lift, and two of the heights at which it stops, in centimetres.
    std::map<std::tuple<std::uint32_t, long, long>, std::size_t> lift_number;
    for (std::uint32_t cell = 0; cell + 1 < space.first.size(); ++cell)
        for (std::uint32_t low = space.first[cell]; low < space.first[cell + 1]; ++low) {
            const FeatureId feature = lift_of(low);
            if (!feature) continue;
            for (std::uint32_t high = low + 1; high < space.first[cell + 1]; ++high) {
                if (lift_of(high) != feature) continue;
                const Vec3 off = space.place_m(low) - scene.features[feature.value].bounds_m.centre_m();
                const double far = std::hypot(off.x, off.y);
                const WalkLink link{PassageKind::Lift, low, high, true, feature};
                const auto [known, is_new] =
                    lift_number.try_emplace({feature.value, std::lround(100.0F * space.spans[low].floor_m),
                                             std::lround(100.0F * space.spans[high].floor_m)},
                                            lifts.size());
                if (is_new) lifts.emplace_back(far, link);
                else if (far < lifts[known->second].first) lifts[known->second] = {far, link};
            }
        }
    for (const auto& lift : lifts) space.links.push_back(lift.second);
    for (const Switch& s : scene.switches) {
        const Feature* volume = scene.find(s.volume);
        if (!s.leads_elsewhere || !volume || volume->bounds_m.empty()) continue;
        const Vec3 c = volume->bounds_m.centre_m(), size = volume->bounds_m.size_m();
        const std::uint32_t from =
            space.nearest({c.x, c.y, volume->bounds_m.min_m.z}, 0.5 * std::max(size.x, size.y) + 0.3, size.z, 1.0);
        const std::uint32_t to = space.nearest(s.feet_m, 1.0, 0.6, 3.0);
        if (from != kNothing && to != kNothing && from != to)
            space.links.push_back({PassageKind::Teleporter, from, to, false, s.volume});
    }
}

}  // namespace

template <class Span>
std::uint32_t SpanGrid<Span>::nearest(const Vec3& feet_m, double level_m, double up_m, double down_m) const {
    if (!is_finite(feet_m) || width == 0) return kNothing;
    const double fx = (feet_m.x - origin_m.x) / cell_m, fy = (feet_m.y - origin_m.y) / cell_m;
    if (std::abs(fx) > 1e8 || std::abs(fy) > 1e8) return kNothing;
    const auto cx = static_cast<std::int64_t>(std::floor(fx)), cy = static_cast<std::int64_t>(std::floor(fy));
    // Skips rings that are entirely outside the grid. Of the other rings, only the part inside is searched.
    const auto outside = [](std::int64_t c, std::int64_t count) {
        return std::max<std::int64_t>({std::int64_t{0}, -c, c - (count - 1)});
    };
    const auto across = [](std::int64_t c, std::int64_t count) {
        return std::max(std::abs(c), std::abs(count - 1 - c));
    };
    const std::int64_t from = std::max(outside(cx, width), outside(cy, depth)),
                       to = std::max(across(cx, width), across(cy, depth));
    const auto rings = static_cast<std::int64_t>(std::min(level_m / cell_m, static_cast<double>(to)));
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t found = kNothing;
    for (std::int64_t ring = from; ring <= rings && (static_cast<double>(ring) - 1.0) * cell_m < best; ++ring)
        for (std::int64_t y = std::max<std::int64_t>(cy - ring, 0);
             y <= std::min<std::int64_t>(cy + ring, std::int64_t{depth} - 1); ++y) {
            // True: all cells of this row are on the ring; false: only its two ends are.
            const bool whole = std::abs(y - cy) == ring;
            const std::int64_t low = whole ? std::max<std::int64_t>(cx - ring, 0) : cx - ring,
                               high = whole ? std::min<std::int64_t>(cx + ring, std::int64_t{width} - 1) : cx + ring;
            for (std::int64_t x = low; x <= high; x += whole ? 1 : 2 * ring) {
                if (x < 0 || x >= width) continue;
                const auto cell = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
                for (std::uint32_t s = first[cell]; s < first[cell + 1]; ++s) {
                    const Vec3 off = place_m(s) - feet_m;
                    if (off.z > up_m || off.z < -down_m) continue;
                    const double far = std::hypot(off.x, off.y) + std::abs(off.z);
                    if (far < best) {
                        best = far;
                        found = s;
                    }
                }
            }
        }
    return found;
}
template struct SpanGrid<WalkSpan>;
template struct SpanGrid<WallSpan>;

std::uint32_t WalkSpace::at(const Vec3& feet_m) const {
    const double reach = 1.5 * body.step_up_m;
    return nearest(feet_m, 0.0, reach, reach);
}

bool WalkSpace::straight(const Vec3& from_m, const Vec3& to_m,
                         const std::function<void(std::uint32_t)>& touched) const {
    std::uint32_t here = nearest(from_m, 1.5 * cell_m, 1.5 * body.step_up_m + 0.1, 1.5 * body.step_up_m + 0.1);
    if (here == kNothing) return false;
    if (touched) touched(here);
    // Follows the line from cell to cell, across their sides.
    const Vec3 start = place_m(here);
    const double dx = to_m.x - start.x, dy = to_m.y - start.y;
    auto x = static_cast<std::int64_t>(spans[here].cell % width),
         y = static_cast<std::int64_t>(spans[here].cell / width);
    const auto to_x = static_cast<std::int64_t>(std::floor((to_m.x - origin_m.x) / cell_m)),
               to_y = static_cast<std::int64_t>(std::floor((to_m.y - origin_m.y) / cell_m));
    const double inf = std::numeric_limits<double>::infinity();
    const double step_x = dx != 0.0 ? cell_m / std::abs(dx) : inf, step_y = dy != 0.0 ? cell_m / std::abs(dy) : inf;
    double next_x = 0.5 * step_x, next_y = 0.5 * step_y;
    while (x != to_x || y != to_y) {
        const bool along_x = next_x < next_y;
        if (std::min(next_x, next_y) > 1.0 + std::max(step_x == inf ? 0.0 : step_x, step_y == inf ? 0.0 : step_y))
            break;
        const int d = along_x ? (dx > 0.0 ? 0 : 2) : (dy > 0.0 ? 1 : 3);
        const std::uint32_t n = spans[here].next[d];
        if (n == kNothing) return false;
        here = n;
        if (touched) touched(here);
        (along_x ? x : y) += along_x ? (dx > 0.0 ? 1 : -1) : (dy > 0.0 ? 1 : -1);
        (along_x ? next_x : next_y) += along_x ? step_x : step_y;
    }
    return std::abs(place_m(here).z - to_m.z) <= 1.5 * body.step_up_m + 0.1;
}

std::vector<std::string> said_of(const WalkSpace& space, const WalkerMeasures& requested) {
    std::vector<std::string> said;
    if (space.body.cell_m > requested.cell_m)
        said.push_back(phrase("navigation.coarse", {{"centimetres", std::lround(space.body.cell_m * 100.0)}}));
    if (space.outdoors_m > 0.0) said.push_back(phrase("navigation.outdoors", {{"metres", space.outdoors_m}}));
    if (space.part) said.push_back(phrase("navigation.part"));
    return said;
}

namespace {

// Possible column sizes from best to worst, each with the range within which the ground outside is included. Columns
// wider than 20 cm are hardly fine enough for doors, so ground is left out before such columns are used.
struct Fineness {
    double columns;  // multiple of the requested width
    double outdoors_m;
};
constexpr Fineness kFineness[] = {{1, 100}, {2, 100}, {2, 25},  {4, 100}, {4, 25},
                                  {4, 8},   {4, 0.5}, {8, 100}, {8, 25},  {8, 8}};

// The result of flooding everything that can be reached, with the finest columns that do not exceed the limits. `flood`
// is null if there is no floor or a stop was requested.
struct Flooded {
    std::unique_ptr<NearGround> ground;
    std::unique_ptr<Flood> flood;
    bool stopped = false;
};
Flooded flood_as_fine_as_can_be(const Scene& scene, WalkerMeasures& body, const Obstacles& obstacles,
                                const std::stop_token& stop, const WalkTrial* trial) {
    std::vector<Fineness> tried;
    for (const Fineness& each : kFineness)
        if (each.columns == 1.0 || body.cell_m * each.columns <= kCoarsest_m * 1.0001) tried.push_back(each);
    const double requested_m = body.cell_m;
    Flooded made;
    for (std::size_t k = 0; k < tried.size(); ++k) {
        const bool last = k + 1 == tried.size();
        body.cell_m = requested_m * tried[k].columns;
        made.ground = std::make_unique<NearGround>(scene, obstacles, tried[k].outdoors_m);
        const double most_m2 = static_cast<double>(Flood::most_spans(body.cell_m)) * body.cell_m * body.cell_m;
        const bool looks = !last && !(trial && trial->within);
        if (looks && !(standable_m2(obstacles, body, *made.ground, most_m2) <= most_m2)) continue;
        made.flood = std::make_unique<Flood>(scene, body, obstacles, *made.ground, last, stop, trial);
        const Flood::End end = made.flood->run();
        if (end == Flood::End::TooLarge) continue;
        if (end == Flood::End::Stopped || stop.stop_requested()) made.stopped = true;
        if (made.stopped || made.flood->reached() == 0) made.flood.reset();
        return made;
    }
    return made;  // not reached, because the last attempt is never too large
}

void note_what_is_out(const Flooded& flooded, WalkSpace& space) {
    if (flooded.flood->ground_left_out()) space.outdoors_m = flooded.ground->within_m();
    space.part = flooded.flood->is_part();
}

}  // namespace

Result<WalkSpace> make_trial_space(const Scene& scene, const WalkerMeasures& body, const WalkTrial& trial,
                                   const std::stop_token& stop) {
    WalkSpace space;
    space.body = body;
    const Obstacles obstacles(scene, body, trial.within ? &trial.within->box_m : nullptr);
    const Flooded made = flood_as_fine_as_can_be(scene, space.body, obstacles, stop, &trial);
    if (!made.flood)
        return fail(phrase(made.stopped ? "navigation.given_up" : "navigation.no_floor"), scene.source_file);
    if (!made.flood->write(space)) return fail(phrase("navigation.given_up"), scene.source_file);
    note_what_is_out(made, space);
    if (trial.clearance) measure_clearance(space, stop);
    thin_drops(space);
    if (trial.within) return space;
    link_lifts_and_teleporters(scene, space);
    link_stated_stairs(scene, space);
    return space;
}

Result<WalkSpace> make_walk_space(const Scene& scene, const WalkerMeasures& body, const std::stop_token& stop) {
    const auto given_up = [&] { return fail(phrase("navigation.given_up"), scene.source_file); };
    WalkSpace space;
    space.body = body;
    auto walls = std::make_shared<SpanGrid<WallSpan>>();
    {
        const Obstacles obstacles(scene, body);
        if (stop.stop_requested()) return given_up();
        const Flooded made = flood_as_fine_as_can_be(scene, space.body, obstacles, stop, nullptr);
        if (made.stopped) return given_up();
        if (!made.flood) return fail(phrase("navigation.no_floor"), scene.source_file);
        if (!made.flood->write(space)) return given_up();
        if (made.flood->reached_without_furniture() > 0 && !made.flood->write(*walls)) return given_up();
        note_what_is_out(made, space);
    }
    space.said = said_of(space, body);
    measure_clearance(space, stop);
    find_stairs(space, body.step_up_m);
    thin_drops(space);
    link_lifts_and_teleporters(scene, space);
    link_stated_stairs(scene, space);
    if (stop.stop_requested()) return given_up();
    measure_clearance(*walls, stop);
    find_stairs(*walls, body.step_up_m);
    if (stop.stop_requested()) return given_up();
    if (!walls->spans.empty()) space.walls = std::move(walls);
    return space;
}

}  // namespace handrail::navigation
