#include "haptic/render/proxy_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handrail::render {

using namespace proxy_parts;

namespace {

// kLoose defines how exact the free distance must be. A lower bound L with kLoose * distance <= L is enough. Finding
// the exact distance could take very long, because in the middle of a round room all walls are equally near. Finding
// such a bound takes a few nodes.
constexpr double kLoose = 0.7;

// Share of the range from `needed_m` to the full reach within which obstacles get an exact cut at their closest point.
// Farther obstacles get a quick cut. With 0, the proxy reaches loose cuts and takes more rounds. With 1, a tick takes
// 1,000 more instructions on a sphere of a million triangles.
constexpr double kExact = 0.3;
constexpr double kFarther = 1.03;  // where obstacles are dense, factor on the range of the last gathering

constexpr int kLeastLooks = 128;  // least number of visits, so that a move that has begun to gather makes progress
// Range of a gathering, as a factor on the needed range, if there are more near obstacles than kComfortableCandidates.
constexpr double kCrowdedReach = 1.15;

bool nearer(double distance_a, std::uint32_t a, double distance_b, std::uint32_t b) noexcept {
    return distance_a != distance_b ? distance_a < distance_b : a < b;
}

}  // namespace

// Starts the proxy among the obstacles of one body that has just appeared, or of the still part of the scene.
void ProxySolver::place_in(const HapticScene& scene, std::uint16_t body, double radius_m) noexcept {
    if (body != kStill && !tracks_.of(body).present) return;
    const HapticScene& shape = body == kStill ? scene : *scene.bodies[body].shape;
    const Vec3 at = local_m();
    const double scale = body == kStill ? 1.0 : tracks_.of(body).frame.scale;
    const Vec3 own = body == kStill ? at : tracks_.of(body).frame.to_own(at) - shape.origin_m;
    const int most_looks = std::clamp((work_.left - kRoundsWork) / kLookWork, 4, kMostLooks);
    int looks = most_looks;
    const double known =
        shape.obstacle_bvh.nearest_first(own, radius_m / scale, looks, queue_, [&](std::uint32_t item, double&) {
            const double distance = shape.closest(item, own).distance_m * scale;
            if (shape.solid(item) && distance <= 0.0) {
                ghosts_.add({item, body});
            } else if (shape.obstacles[item].side == TouchSide::Both || shape.in_front_m(item, own) >= 0.0) {
                radius_m_ = std::min(radius_m_, std::max(distance, kSmallestRadius_m));
            }
        });
    work_.looks += most_looks - looks;
    spend((most_looks - looks) * kLookWork);
    // If the visits ran out, obstacles that were not visited may begin at the distance `known`.
    if (looks <= 0) radius_m_ = std::min(radius_m_, std::max(known * scale, kSmallestRadius_m));
}

// Collects the `most` nearest obstacles of a shape within `reach_m` into nearest_, each with a cut. Obstacles that are
// not very near are ranked by the distance of their cut. Returns the distance within which all obstacles were found:
// reach_m, or less if there were too many or the visits ran out. All lengths are in the shape's own metres.
double ProxySolver::gather_nearest(const HapticScene& shape, std::uint16_t body, const Vec3& at, double reach_m,
                                   double needed_m, std::size_t most) noexcept {
    const auto before = [](const Candidate& a, const Candidate& b) {
        return nearer(a.distance_m, a.obstacle, b.distance_m, b.obstacle);
    };
    std::uint32_t normals = 0;
    nearest_count_ = 0;
    const auto drop_farthest = [&] {
        const auto begin = nearest_.begin(), last = begin + static_cast<std::ptrdiff_t>(most > 0 ? most - 1 : 0);
        std::nth_element(begin, last, begin + static_cast<std::ptrdiff_t>(nearest_count_), before);
        nearest_count_ = most;
        return last->distance_m;
    };
    double known =
        shape.obstacle_bvh.nearest_first(at, reach_m, work_.looks_left, queue_, [&](std::uint32_t item, double& reach) {
            if (ghosts_.count() > 0 && ghosts_.has({item, body})) return;
            // The entries behind those that were kept still contain numbers of normals, which are now free for reuse.
            Candidate& candidate = nearest_[nearest_count_];
            if (nearest_count_ == normals) candidate.normal = normals++;
            Vec3& normal = nearest_normals_[candidate.normal];
            double distance = shape.quick_support(item, at, normal);
            if (distance > reach) return;
            if (distance < needed_m + kExact * (reach - needed_m)) {
                work_.looks_left -= shape.obstacles[item].planes * kPlaneWork / kLookWork;
                const ClosestPoint found = shape.closest(item, at);
                distance = -glm::dot(found.normal, found.point_m - at);
                if (found.distance_m > reach) return;
                normal = found.normal;
            }
            candidate.distance_m = distance;
            candidate.obstacle = item;
            if (++nearest_count_ == most + kSpareCandidates) reach = std::min(reach, drop_farthest());
        });
    if (nearest_count_ > most) known = std::min(known, drop_farthest());
    return known;
}

// Adds the obstacles of one shape within `reach_m` of a place to the candidates, each with a new cut. If there are too
// many, it adds the nearest. Returns the distance within which all obstacles are candidates. All lengths are in the
// shape's own metres.
double ProxySolver::collect(const HapticScene& shape, std::uint16_t body, const Vec3& at, double reach_m,
                            double needed_m, std::size_t room) noexcept {
    const std::size_t comfortable = std::min<std::size_t>(kComfortableCandidates, room);
    bool& crowded = body == kStill ? crowded_ : tracks_.of(body).crowded;
    const auto look = [&](double reach, std::size_t most) {
        const int looks = std::clamp((work_.left - kRoundsWork) / kLookWork, kLeastLooks, kMostLooks);
        work_.looks_left = looks;
        const double known = gather_nearest(shape, body, at, reach, needed_m, most);
        work_.looks += looks - work_.looks_left;
        spend((looks - work_.looks_left) * kLookWork);
        return known;
    };
    double known = 0.0;
    if (!crowded) {
        // If obstacles are dense, this searches about as far as the last time. Searching farther would double the time,
        // only to drop the obstacles that it found.
        const double likely =
            body == kStill ? std::clamp(kFarther * dense_m_, needed_m, std::max(reach_m, needed_m)) : reach_m;
        known = look(likely, comfortable);
        if (likely < reach_m && known == likely && nearest_count_ < comfortable / 2) known = look(reach_m, comfortable);
        if (body == kStill) dense_m_ = known;
    }
    if (known < needed_m) {
        // Every candidate costs time in every round, so the second search reaches only a little farther than needed.
        known = look(std::min(std::max(reach_m, needed_m), kCrowdedReach * needed_m), room);
        crowded = nearest_count_ > comfortable;
        step_.truncated = step_.truncated || known < needed_m;
    }
    for (std::size_t k = 0; k < nearest_count_; ++k) {
        const Candidate& found = nearest_[k];
        const bool one_sided = shape.one_sided_sheets && shape.obstacles[found.obstacle].side != TouchSide::Both;
        cuts_.add({found.obstacle, body}, {nearest_normals_[found.normal], -found.distance_m}, one_sided);
    }
    return known;
}

// Makes every obstacle within `reach_m` of the proxy a candidate.
void ProxySolver::gather(const HapticScene& scene, double reach_m, double needed_m) noexcept {
    ++gatherings_;
    if (gathers_on_) return gather_waiting(scene, reach_m, needed_m);
    const Vec3 at = local_m();
    path_.move_anchor(proxy_m_);
    anchor_m_ = at;
    proxy_m_ = Vec3(0.0);
    basis_.count = 0;
    if (cuts_.one_sided > 0) cuts_.remember_awake();
    cuts_.clear();
    known_m_ = collect(scene, kStill, at, reach_m, needed_m, kMaxCandidates);
    if (cuts_.count == 0) {
        double best = std::max(kFarthestLook_m, 2.0 * reach_m);
        const double free_m = scene.obstacle_bvh.nearest_first(
            at, kLoose * best, work_.looks_left, queue_, [&](std::uint32_t item, double& reach) {
                if (ghosts_.count() > 0 && ghosts_.has({item, kStill})) return;
                best = std::min(best, scene.closest(item, at).distance_m);
                reach = std::min(reach, kLoose * best);
            });
        known_m_ = std::max(known_m_, free_m);
    }
    spend_on_tracked(kKnownWork);
    tracks_.known_m = std::numeric_limits<double>::infinity();
    tracks_.moved = tracks_.unknown = false;
    std::size_t near = 0;
    for (const std::uint16_t b : tracks_.ids()) {
        ProxyTrack& track = tracks_.of(b);
        track.unknown = track.looked_at = false;
        if (!track.present) continue;
        track.reach_m = scene.bodies[b].reach_m * track.frame.scale;
        track.looked_at = track.known_around_m(at) <= reach_m;  // if false, no part of the body is nearer than reach_m
        if (track.looked_at) ++near;
    }
    // Gathers the obstacles of all near bodies now if the budget allows. Otherwise the remaining bodies follow in the
    // next moves.
    for (std::size_t k = 0; near > 0; ++k) {
        ProxyTrack& track = tracks_.of(tracks_.followed[k]);
        if (!track.present || !track.looked_at) continue;
        track.known_from_m = track.frame.to_own(at);
        if (work_.left > 0) {
            look_at_body(scene, tracks_.followed[k], reach_m, needed_m, near);
        } else {
            track.known_m = -1.0;
            track.unknown = tracks_.unknown = true;
        }
        tracks_.known_m = std::min(tracks_.known_m, track.known_m);
        --near;
    }
    gathers_on_ = tracks_.unknown;
    if (cuts_.one_sided > 0) turn_sheets(scene);
    cuts_.awake_count = 0;
}

// Makes the near obstacles of one body candidates. `share` bodies divide the remaining room equally.
void ProxySolver::look_at_body(const HapticScene& scene, std::uint16_t body, double reach_m, double needed_m,
                               std::size_t share) noexcept {
    ProxyTrack& track = tracks_.of(body);
    const HapticScene& shape = *scene.bodies[body].shape;
    const PlacedFrame& frame = track.frame;
    const Vec3 at = local_m(), own = frame.to_own(at);
    const auto left = static_cast<std::size_t>(kMaxCandidates - cuts_.count);
    const std::size_t room = std::min(left, std::max<std::size_t>(left / share, 8));
    const int first = cuts_.count;
    track.unknown = false;
    track.known_from_m = own;
    track.known_m = collect(shape, body, own - shape.origin_m, reach_m / frame.scale, needed_m / frame.scale,
                            share == 1 ? left : room) *
                    frame.scale;
    track.short_of_room = track.known_m < needed_m;
    for (int i = first; i < cuts_.count; ++i) {
        // Converts the cut to the shape's own axes and metres, relative to `own`.
        const HalfSpace cut = cuts_.planes[static_cast<std::size_t>(i)];
        const Vec3 normal = frame.turned(cut.normal);
        keep_cut(i, {normal, cut.offset_m * frame.scale + glm::dot(normal, proxy_m_)});
    }
}

// Continues a gathering that takes more than one move. The still scene and each body are searched only if they have not
// been searched yet, or if the known distance has become too small. The candidates of the others stay valid.
void ProxySolver::gather_waiting(const HapticScene& scene, double reach_m, double needed_m) noexcept {
    reach_m = std::min(reach_m, 1.5 * needed_m);
    // If the proxy has moved less than this, another search would find nothing new.
    const double enough_m = 0.01 * radius_m_;
    const Vec3 at = local_m();
    const double still_known = known_m_ - glm::length(proxy_m_);
    const bool look_at_still = still_known < needed_m && (glm::length(proxy_m_) > enough_m || known_m_ < 0.0);
    if (cuts_.one_sided > 0) cuts_.remember_awake();
    path_.move_anchor(proxy_m_);
    for (int i = 0; i < cuts_.count; ++i) {
        HalfSpace& cut = cuts_.planes[static_cast<std::size_t>(i)];
        cut.offset_m -= glm::dot(cut.normal, proxy_m_);
    }
    anchor_m_ = at;
    proxy_m_ = Vec3(0.0);
    known_m_ = still_known;
    basis_.count = 0;
    tracks_.unknown = false;
    tracks_.moved = true;  // makes known_around() query each body separately
    if (look_at_still) {
        drop_candidates(kStill);
        known_m_ =
            collect(scene, kStill, at, reach_m, needed_m, static_cast<std::size_t>(kMaxCandidates - cuts_.count));
    }
    spend_on_tracked(2 * kKnownWork);
    std::size_t near = 0, left = 0;
    const auto wants_look = [&](const ProxyTrack& track) {
        if (!track.present) return false;
        if (!track.looked_at) return track.known_around_m(at) < needed_m;
        return track.unknown ||
               (track.known_around_m(at) < needed_m &&
                !(track.short_of_room &&
                  glm::length(track.frame.to_own(at) - track.known_from_m) * track.frame.scale <= enough_m));
    };
    bool any_leaves = false;
    for (const std::uint16_t b : tracks_.ids()) {
        ProxyTrack& track = tracks_.of(b);
        const bool is_far =
            track.present && track.looked_at && glm::length(at - track.frame.position_m) - track.reach_m > reach_m;
        track.leaves = is_far;
        if (is_far) track.looked_at = track.unknown = false;
        near += track.present && track.looked_at;
        if (wants_look(track)) {
            ++left;
            track.leaves = track.leaves || (track.looked_at && !track.unknown);
        }
        any_leaves = any_leaves || track.leaves;
    }
    if (any_leaves)
        drop_candidates_of([&](std::uint16_t owner) { return owner != kStill && tracks_.of(owner).leaves; });
    for (std::size_t k = 0; left > 0; ++k) {
        const std::uint16_t id = tracks_.followed[k];
        ProxyTrack& track = tracks_.of(id);
        if (!wants_look(track)) continue;
        track.looked_at = true;
        if (work_.left > 0) {
            look_at_body(scene, id, reach_m, needed_m, left);
        } else {
            track.known_from_m = track.frame.to_own(at);
            track.known_m = -1.0;
            track.unknown = tracks_.unknown = true;
        }
        --left;
    }
    gathers_on_ = tracks_.unknown || near > 1;
    if (cuts_.one_sided > 0) turn_sheets(scene);
    cuts_.awake_count = 0;
}

}  // namespace handrail::render
