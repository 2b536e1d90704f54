#include "app/results/measures.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

namespace handrail::results {
namespace {

double flat_distance(const Vec3& a, const Vec3& b) { return std::hypot(b.x - a.x, b.y - a.y); }

// A position relative to the line from a to b: the distance along the line from a, and the distance to the right of the
// line.
struct AlongLine {
    double along_m = 0.0, right_m = 0.0;
};
AlongLine along_line(const Vec3& a, const Vec3& b, const Vec3& p) {
    const double length_m = flat_distance(a, b);
    const double ux = (b.x - a.x) / length_m, uy = (b.y - a.y) / length_m;
    const double px = p.x - a.x, py = p.y - a.y;
    return {px * ux + py * uy, px * uy - py * ux};
}

double off_leg(const Vec3& a, const Vec3& b, const Vec3& p) {
    const double length_m = flat_distance(a, b);
    if (length_m == 0.0) return flat_distance(a, p);
    const AlongLine at = along_line(a, b, p);
    return std::hypot(at.along_m - std::clamp(at.along_m, 0.0, length_m), at.right_m);
}

// Returns the route without consecutive duplicate points.
std::vector<Vec3> legs_only(std::span<const Vec3> route_m) {
    std::vector<Vec3> route;
    for (const Vec3& place : route_m)
        if (route.empty() || flat_distance(route.back(), place) > 1e-9) route.push_back(place);
    return route;
}

}  // namespace

double walked_length_m(std::span<const WalkedPoint> walk) {
    double way_m = 0.0;
    const WalkedPoint* last = nullptr;
    for (const WalkedPoint& point : walk) {
        if (!last || point.leap) {
            last = &point;
            continue;
        }
        const double step_m = flat_distance(last->place_m, point.place_m);
        if (step_m < kPointSpacing_m) continue;
        way_m += step_m;
        last = &point;
    }
    return way_m;
}

double level_length_m(std::span<const Vec3> route_m) {
    double way_m = 0.0;
    for (std::size_t i = 1; i < route_m.size(); ++i) way_m += flat_distance(route_m[i - 1], route_m[i]);
    return way_m;
}

std::optional<double> path_ratio(double walked_m, double shortest_m, bool reached) {
    if (!reached || !(shortest_m >= 1.0)) return std::nullopt;
    return walked_m / shortest_m;
}

double free_s(const Span& span, std::span<const Span> busy) {
    std::vector<Span> all(busy.begin(), busy.end());
    std::sort(all.begin(), all.end(), [](const Span& a, const Span& b) { return a.from_s < b.from_s; });
    double left_s = 0.0, at_s = span.from_s;
    for (const Span& one : all) {
        if (one.from_s >= span.to_s) break;
        left_s += std::max(0.0, one.from_s - at_s);
        at_s = std::max(at_s, one.to_s);
    }
    return left_s + std::max(0.0, span.to_s - at_s);
}

Hesitations hesitations(std::span<const WalkedPoint> walk, std::span<const Span> busy) {
    Hesitations found;
    for (std::size_t first = 0; first < walk.size();) {
        std::size_t last = first;
        while (last + 1 < walk.size() && !walk[last + 1].leap &&
               flat_distance(walk[first].place_m, walk[last + 1].place_m) <= kPause_m)
            ++last;
        const Span still{walk[first].t_s, walk[last].t_s};
        if (still.to_s - still.from_s <= kPause_s) {
            ++first;
            continue;
        }
        if (const double pause_s = free_s(still, busy); pause_s > kPause_s) {
            ++found.count;
            found.sum_s += pause_s;
        }
        first = last + 1;
    }
    return found;
}

int contact_episodes(std::span<const Touch> touches) {
    std::map<std::uint32_t, double> last_s;
    int episodes = 0;
    for (const Touch& touch : touches) {
        const auto [at, is_new] = last_s.try_emplace(touch.thing, touch.t_s);
        if (is_new || touch.t_s - at->second > kSameContact_s) ++episodes;
        at->second = touch.t_s;
    }
    return episodes;
}

double pointing_error_rad(double pointed_rad, double right_rad) {
    const double error = std::remainder(pointed_rad - right_rad, 2.0 * std::numbers::pi);
    return error <= -std::numbers::pi ? error + 2.0 * std::numbers::pi : error;
}

std::optional<Pointing> pointing(std::span<const double> errors_rad) {
    if (errors_rad.empty()) return std::nullopt;
    const auto count = static_cast<double>(errors_rad.size());
    Pointing result;
    std::complex<double> mean = 0.0;
    for (const double error : errors_rad) {
        result.absolute_rad += std::abs(error) / count;
        mean += std::polar(1.0 / count, error);
    }
    result.signed_rad = std::arg(mean);
    result.agreement = std::abs(mean);
    result.biased = errors_rad.size() >= kLeastAnswers && result.agreement > kLeastAgreement;
    return result;
}

std::optional<double> distance_ratio(std::span<const Judged> answers) {
    if (answers.empty()) return std::nullopt;
    double sum = 0.0;
    for (const Judged& answer : answers) {
        if (!(answer.judged_m > 0.0) || !(answer.true_m > 0.0)) return std::nullopt;
        sum += std::log(answer.judged_m / answer.true_m);
    }
    return std::exp(sum / static_cast<double>(answers.size()));
}

std::optional<double> order_tau(std::span<const std::size_t> order) {
    const std::size_t n = order.size();
    if (n < 2) return std::nullopt;
    double agree = 0.0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) agree += order[i] < order[j] ? 1.0 : order[i] > order[j] ? -1.0 : 0.0;
    return agree / (0.5 * static_cast<double>(n) * static_cast<double>(n - 1));
}

TurnsMet turns_met(std::span<const Vec3> route_m, std::span<const WalkedPoint> walk) {
    const std::vector<Vec3> route = legs_only(route_m);
    TurnsMet met;
    std::size_t begin = 0;  // index in the walk at which the leg before the current turn begins
    for (std::size_t i = 1; i + 1 < route.size(); ++i) {
        const Vec3 &from = route[i - 1], &turn = route[i], &next = route[i + 1];
        const double leg_m = flat_distance(from, turn);
        const AlongLine after = along_line(from, turn, next);
        // The angle of the turn; positive: to the right.
        const double turned_rad = std::atan2(after.right_m, after.along_m - leg_m);
        // Use only the part of the walk before the walker comes near the point after the turn.
        std::size_t end = begin;
        while (end < walk.size() && flat_distance(walk[end].place_m, next) >= kNearTurn_m) ++end;
        if (std::abs(turned_rad) < kTurn_rad) continue;
        ++met.turns;
        const double side = turned_rad > 0.0 ? 1.0 : -1.0;
        bool at_turn = false, missed = false, early = false;
        std::size_t past = begin;
        for (std::size_t p = begin; p < end; ++p) {
            const Vec3& place = walk[p].place_m;
            const AlongLine at = along_line(from, turn, place);
            at_turn = at_turn || (at.along_m >= leg_m - kNearTurn_m && std::abs(at.right_m) < kOff_m);
            // The last sample in which the walker was near the turn.
            if (glm::length(place - turn) < kNearTurn_m) past = p;
            if (!at_turn && at.along_m >= 0.0 && leg_m - at.along_m >= kEarly_m && side * at.right_m >= kEarlyOff_m)
                early = true;
            if (!at_turn) continue;
            // The walker missed the turn if they are past the turn and off the next leg. Being past the turn is not
            // enough: after a shallow turn, the next leg continues in nearly the same direction.
            const double off_m = off_leg(turn, next, place);
            missed = missed || (at.along_m - leg_m >= kPast_m && off_m >= 0.5 * kPast_m) ||
                     (off_m >= kOff_m && off_leg(from, turn, place) >= kOff_m);
        }
        met.missed += missed ? 1 : 0;
        met.early += early && !missed ? 1 : 0;
        if (missed) met.missed_m.push_back(turn);
        else if (early) met.early_m.push_back(turn);
        begin = std::max(begin, past);
    }
    return met;
}

}  // namespace handrail::results
