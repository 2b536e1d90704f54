#include "haptic/render/proxy_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handrail::render {

using namespace proxy_parts;

namespace {

// Greatest number of sub-steps for a body in one move. A body that would need more jumps: it vanishes at its old pose
// and appears at the new one.
constexpr int kMostSubSteps = 64;
constexpr int kLongestWait = 500;  // greatest number of moves by which a body may lag behind its commanded pose

// Lead distances for following bodies. The solver follows bodies that are nearer than the lead plus the distance that
// the proxy can move or be pushed in a tick. The lead is enough for 100 ms of a fast hand (2 m/s). It is also so large
// that no body beyond it can reach the proxy without a jump (kMostSubSteps).
constexpr double kLeadMargins = 10.0, kLeadRadii = 40.0;

}  // namespace

void ProxySolver::spend_on_tracked(int work) noexcept {
    if (tracks_.count > kFewBodies && !tracks_.all) spend(static_cast<int>(tracks_.count) * work);
}

// Returns the distance around `at_m` within which every obstacle of the bodies is a candidate, at most `known`. While
// no body moves, all bodies whose obstacles were gathered share one bound, tracks_.known_m. The distance of every other
// body is computed from its own position.
double ProxySolver::known_of_bodies(const Vec3& at_m, double known) noexcept {
    spend_on_tracked(kKnownWork);
    const Vec3 at = anchor_m_ + at_m;
    if (!tracks_.moved) known = std::min(known, tracks_.known_m - glm::length(at_m));
    for (const std::uint16_t b : tracks_.ids()) {
        const ProxyTrack& track = tracks_.of(b);
        if (track.present && (tracks_.moved || !track.looked_at)) known = std::min(known, track.known_around_m(at));
    }
    return tracks_.far_short ? std::min(known, tracks_.far_m - glm::length(at - tracks_.far_from_m)) : known;
}

// Returns a lower bound for the distance from a place to any point of a body during the movements of this request.
double ProxySolver::least_distance_m(const HapticScene& scene, const Request& request, std::size_t body,
                                     const Vec3& from_m) const noexcept {
    constexpr double kNever = 1e300;
    const HapticBody& b = scene.bodies[body];
    const Vec3 origin = scene.origin_m + from_m;
    if (!request.bodies || !request.bodies->know(body))
        return b.present ? glm::length(b.start.position_m - origin) - b.reach_m * b.start.scale : kNever;
    const BodyPose& from = request.bodies->poses[body];
    const BodyPaths* const ways = request.bodies->ways;
    const BodyPose& to = ways && body < ways->to.size() ? ways->to[body] : from;
    if (!from.present && !to.present) return kNever;
    const Vec3 begin = from.at.position_m - origin;
    if (&from == &to) return glm::length(begin) - b.reach_m * from.at.scale;
    const Vec3 way = to.at.position_m - from.at.position_m;
    const double length2 = glm::dot(way, way);
    const double part = length2 > 0.0 ? std::clamp(-glm::dot(begin, way) / length2, 0.0, 1.0) : 0.0;
    return glm::length(begin + way * part) - b.reach_m * std::max(from.at.scale, to.at.scale);
}

// Gives a body a track. Returns false if all tracks are used.
bool ProxySolver::track_body(const HapticScene& scene, const Request& request, std::size_t body) noexcept {
    if (tracks_.follows(body)) return true;
    ProxyTrack* const added = tracks_.add(static_cast<std::uint16_t>(body));
    if (!added) return false;
    ProxyTrack& track = *added;
    const BodyPose pose = wanted(scene, request, body);
    stand(scene, track, pose.at);
    track.wanted = pose.at;
    track.reach_m = scene.bodies[body].reach_m * track.frame.scale;
    // A body that is already near when it gets its track has appeared or jumped here, so advance_bodies() lets it
    // appear instead of moving it.
    const bool near = track.known_around_m(local_m()) <= request.radius_m + request.path_cap_m;
    track.present = pose.present && !near;
    tracks_.behind = tracks_.behind || near;
    return true;
}

// Stops following bodies that are farther away than `far_m` and do not affect the force.
void ProxySolver::untrack_far(const HapticScene& scene, double far_m) noexcept {
    const Vec3 at = local_m();
    tracks_.keep_those([&](std::uint16_t b, const ProxyTrack& track) {
        const double distance = glm::length(at - track.frame.position_m) - scene.bodies[b].reach_m * track.frame.scale;
        return track.looked_at || carrier_ == b || (track.present && distance < far_m) || ghosts_.has_of(b);
    });
}

// Examines every body of the scene once and follows those that are near. Most ticks skip this, because it is not needed
// while the hand stays within 0.2 m and the bodies' movements are known. If more bodies are near than there are tracks,
// the distance is halved until the tracks suffice.
void ProxySolver::track_near(const HapticScene& scene, const Request& request) noexcept {
    tracks_.far_from_m = local_m();
    tracks_.far_m = tracks_.all
                        ? std::numeric_limits<double>::infinity()
                        : tracks_.near_m + std::max(kLeadMargins * request.margin_m, kLeadRadii * request.radius_m);
    if (tracks_.bodies > kFewBodies && !tracks_.all) spend(static_cast<int>(tracks_.bodies) * kGlanceWork);
    for (std::size_t b = 0; b < tracks_.bodies; ++b)
        tracks_.least_m[b] = least_distance_m(scene, request, b, tracks_.far_from_m);
    const auto wants_track = [&](std::size_t b) {
        return !tracks_.follows(b) && (tracks_.least_m[b] < tracks_.far_m || tracks_.all);
    };
    for (;;) {
        untrack_far(scene, tracks_.far_m);
        std::size_t wants = 0;
        for (std::size_t b = 0; b < tracks_.bodies; ++b) wants += wants_track(b) ? 1U : 0U;
        if (tracks_.count + wants <= tracks_.followed.size() || !(tracks_.far_m > 1e-3 * request.radius_m)) break;
        tracks_.far_m = tracks_.all ? tracks_.near_m : 0.5 * tracks_.far_m;
        tracks_.all = false;
    }
    for (std::size_t b = 0; b < tracks_.bodies; ++b)
        if (wants_track(b) && !track_body(scene, request, b)) {
            tracks_.far_m = -1.0;  // no distance is known to be free of other bodies
            break;
        }
}

// Does the same as track_near(), but only for the bodies that begin a new movement.
void ProxySolver::track_coming(const HapticScene& scene, const Request& request) noexcept {
    const Vec3 here = scene.origin_m + tracks_.far_from_m;
    for (const MovingBody& moving : request.bodies->ways->moving) {
        const std::size_t b = moving.body;
        if (b >= tracks_.bodies) continue;
        // A cheap first check, with the middle of the movement, excludes most bodies because they are far away.
        const Vec3 off = moving.middle_m - here;
        const double beyond = tracks_.far_m + moving.half_path_m + scene.bodies[b].reach_m * moving.most_scale;
        if (glm::dot(off, off) > beyond * beyond || tracks_.follows(b)) continue;
        const double distance = least_distance_m(scene, request, b, tracks_.far_from_m);
        if (distance < tracks_.far_m && !track_body(scene, request, b))
            tracks_.far_m = std::min(tracks_.far_m, distance);
    }
}

// Ensures that every body that may come near is followed. Called once in each move.
void ProxySolver::watch_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept {
    const std::uint64_t number = request.bodies ? request.bodies->ways_number() : 0;
    const double near_m = near_for(radius_m, request.margin_m, request.path_cap_m);
    const Vec3 way = local_m() - tracks_.far_from_m;
    const bool went = glm::dot(way, way) > tracks_.far_enough_m2 || near_m > tracks_.near_m;
    if (number == tracks_.ways && !went) return;
    const BodyPaths* const ways = request.bodies ? request.bodies->ways : nullptr;
    const bool follows = ways && ways->number_before != 0 && ways->number_before == tracks_.ways;
    if (went || (number != tracks_.ways && !follows)) {
        // The distance gets a margin, so that no new search is needed if the hand becomes only a little faster.
        tracks_.near_m = 1.5 * near_m;
        track_near(scene, request);
    } else {
        track_coming(scene, request);
    }
    tracks_.ways = number;
    tracks_.far_short = tracks_.far_m < tracks_.near_m;
    const double free_m = tracks_.far_m - tracks_.near_m;
    tracks_.far_enough_m2 = tracks_.far_short ? -1.0 : free_m < 1e150 ? free_m * free_m : free_m;
}

bool ProxySolver::bodies_are_far(const HapticScene& scene, const Request& request) noexcept {
    all_far_in_ = nullptr;
    if (!placed_ || scene_ != &scene || generation_ != scene.generation || hurry_ > 0) return false;
    watch_bodies(scene, request, std::max(request.radius_m, kSmallestRadius_m));
    if (tracks_.count > 0 || tracks_.far_short) return false;
    all_far_in_ = &scene;
    tracks_.number = request.bodies ? request.bodies->number : 0;
    tracks_.behind = false;
    return true;
}

// Places every body near the proxy at its current pose, without a movement in between.
void ProxySolver::take_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept {
    tracks_.clear();
    tracks_.bodies = std::min(scene.bodies.size(), tracks_.slots.size());
    tracks_.number = request.bodies ? request.bodies->number : 0;
    tracks_.behind = false;
    tracks_.far_enough_m2 = -1.0;
    tracks_.near_m = 0.0;
    if (tracks_.bodies > 0) watch_bodies(scene, request, radius_m);
    for (const std::uint16_t b : tracks_.ids()) tracks_.of(b).present = wanted(scene, request, b).present;
    tracks_.behind = false;
}

BodyPose ProxySolver::wanted(const HapticScene& scene, const Request& request, std::size_t body) noexcept {
    return request.bodies && request.bodies->know(body)
               ? request.bodies->at(body)
               : BodyPose{scene.bodies[body].start, scene.bodies[body].present};
}

void ProxySolver::stand(const HapticScene& scene, ProxyTrack& track, const Placement& at) noexcept {
    track.at = at;
    track.frame = PlacedFrame(at);
    track.frame.position_m -= scene.origin_m;
}

void ProxySolver::drop_body(std::uint16_t body) noexcept {
    for (int k = 0; k < basis_.count; ++k)
        if (cuts_.owners[static_cast<std::size_t>(basis_.index[static_cast<std::size_t>(k)])] == body)
            hurry_ = kHurryMoves;
    drop_candidates(body);
    ghosts_.remove_of(body);
    if (carrier_ == body) carrier_ = kStill;
}

void ProxySolver::drop_candidates(std::uint16_t body) noexcept {
    drop_candidates_of([body](std::uint16_t owner) { return owner == body; });
}

// Moves every body to its commanded pose and pushes the proxy out of its way, as far as the work budget allows.
void ProxySolver::advance_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept {
    tracks_.number = request.bodies ? request.bodies->number : 0;
    const double margin = std::max(request.margin_m, 2.0 * request.path_cap_m);
    if (tracks_.unknown) gather(scene, radius_m + margin, 2.0 * radius_m);
    spend_on_tracked(kSupportWork);
    double steps = 0.0;
    for (const std::uint16_t id : tracks_.ids()) {
        ProxyTrack& track = tracks_.of(id);
        const BodyPose pose = wanted(scene, request, id);
        track.from = track.to = track.at;
        if (track.present == pose.present && track.at == pose.at) {
            track.wanted = pose.at;
            track.jumped = false;
            continue;
        }
        if (!track.present && !pose.present) {
            stand(scene, track, pose.at);
            track.wanted = pose.at;
            continue;
        }
        const double reach = scene.bodies[id].reach_m;
        const double travel = farthest_travel_m(track.at, pose.at, reach);
        const double needs = travel / (0.5 * radius_m_);
        // Each command is compared with the one before to decide whether a body jumps. The distance that adds up while
        // the body waits is not included.
        track.waited = tracks_.behind ? track.waited + 1 : 0;
        track.jumped =
            track.jumped ||
            (track.wanted == track.at ? travel : farthest_travel_m(track.wanted, pose.at, reach)) / (0.5 * radius_m_) >
                kMostSubSteps;
        track.wanted = pose.at;
        const double gap = glm::length(track.frame.position_m - local_m()) - reach * track.frame.scale - travel;
        const bool near = gap <= radius_m + request.path_cap_m;
        // A body that is far from the proxy before and after the move has no effect, even if it passes the proxy in
        // between.
        const double gap_there = glm::length(pose.at.position_m - scene.origin_m - local_m()) - reach * pose.at.scale;
        const bool met = track.looked_at || gap_there <= radius_m + request.path_cap_m;
        // If a body has been unable to move for a long time and its commanded pose is far away, it jumps there.
        const bool gone = track.waited > kLongestWait && gap_there > radius_m + request.path_cap_m + request.margin_m &&
                          work_.left > 0;
        if (track.present != pose.present || (near && track.jumped) || gone) {
            if (!met) {
                stand(scene, track, pose.at);
                track.from = track.to = pose.at;
                track.present = pose.present;
                track.reach_m = reach * track.frame.scale;
                track.jumped = false;
                continue;
            }
            if (track.present) drop_body(id);
            stand(scene, track, pose.at);
            track.from = track.to = pose.at;
            track.present = pose.present;
            track.jumped = track.unknown = track.looked_at = false;
            track.waited = 0;
            track.reach_m = reach * track.frame.scale;
            known_m_ = -1.0;
            place_in(scene, id, radius_m);
            continue;
        }
        tracks_.moved = tracks_.moved || track.looked_at;
        if (!near && !track.looked_at) {
            stand(scene, track, pose.at);
            track.reach_m = reach * track.frame.scale;
            track.from = track.to = pose.at;
            track.jumped = false;
            continue;
        }
        track.to = pose.at;
        if (near) steps = std::max(steps, needs);
    }
    path_.size = 0;
    const double count = std::max(1.0, std::ceil(steps));
    const int most = static_cast<int>(std::min(count, static_cast<double>(kMostSubSteps)));
    tracks_.behind = true;
    for (int k = 1; k <= most && !tracks_.unknown; ++k) {
        const bool last = k == count;
        if (!sub_step(scene, request, radius_m, last ? 1.0 : k / count)) break;
        if (last) tracks_.behind = false;
        else if (work_.left <= 0) break;
    }
    step_.waits = step_.waits || tracks_.behind;
}

// Moves all bodies by one sub-step. Returns false and moves no body if there was no time to gather the obstacles that
// come near.
bool ProxySolver::sub_step(const HapticScene& scene, const Request& request, double radius_m, double part) noexcept {
    Vec3 target = proxy_m_;
    bool any = false;
    for (const std::uint16_t b : tracks_.ids()) {
        ProxyTrack& track = tracks_.of(b);
        track.moved = !(track.from == track.to);
        if (!track.moved) continue;
        any = any || track.present;
        const PlacedFrame before = track.frame;
        track.before = track.at;
        stand(scene, track, part == 1.0 ? track.to : between(track.from, track.to, part));
        if (cuts_.one_sided > 0) turn_sheets_of(scene, b, before);
        track.reach_m = scene.bodies[b].reach_m * track.frame.scale;
        if (carrier_ == b) target = track.frame.to_world(before.to_own(local_m())) - anchor_m_;
    }
    if (!any) return true;
    spend(kSubStepWork);
    spend_on_tracked(kCarryWork);
    const double carried = glm::length(target - proxy_m_);
    // The sum of half a radius for the push by a body, the radius itself, and a reserve of half a radius.
    const double needed = 2.0 * radius_m + carried;
    if (known_around(proxy_m_) < needed) {
        const Vec3 was = proxy_m_;
        gather(scene, needed + std::max(request.margin_m, 2.0 * request.path_cap_m), needed);
        target += proxy_m_ - was;
    }
    // Everything that comes near in a sub-step must be a candidate. Otherwise the proxy would touch an obstacle that it
    // does not know.
    if (tracks_.unknown || known_around(proxy_m_) < 1.5 * radius_m_ + carried) {
        for (const std::uint16_t b : tracks_.ids())
            if (ProxyTrack& track = tracks_.of(b); track.moved) stand(scene, track, track.before);
        renew_moved_cuts(scene);
        return false;
    }
    renew_moved_cuts(scene);
    make_room(scene, target);
    return true;
}

// Moves the cuts of the bodies that have just moved to the bodies' new poses. A cut that the proxy would violate is
// renewed at the proxy.
void ProxySolver::renew_moved_cuts(const HapticScene& scene) noexcept {
    for (int i = 0; i < cuts_.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (cuts_.owners[at] == kStill || !tracks_.of(cuts_.owners[at]).moved) continue;
        const PlacedFrame& frame = tracks_.of(cuts_.owners[at]).frame;
        const Vec3 normal = frame.turned(cuts_.own_planes[at].normal);
        cuts_.planes[at] = {
            normal, cuts_.own_planes[at].offset_m * frame.scale + glm::dot(normal, frame.position_m - anchor_m_)};
        work_.left -= kTurnWork;
        if (glm::dot(normal, proxy_m_) - cuts_.planes[at].offset_m >= radius_m_) continue;
        double distance = 0.0;
        keep_cut(i, support(scene, i, proxy_m_, distance));
        work_.left -= kSupportWork;
    }
    spend(0);
}

// Moves the proxy to the free place nearest to `target_m`. If there is no such place, the proxy shrinks as little as
// possible. If it does not fit even with the smallest radius, the moving bodies pass through it.
void ProxySolver::make_room(const HapticScene& scene, const Vec3& target_m) noexcept {
    ProjectionBasis room;
    const auto fits = [&] {
        room.count = 0;
        return project_many(target_m, room);
    };
    const auto take = [&] {
        step_.pushed = step_.pushed || room.point_m != proxy_m_;
        proxy_m_ = room.point_m;
    };
    if (fits()) return take();
    for (int i = 0; i < cuts_.count; ++i) {
        if (cuts_.asleep(i)) continue;
        // If time is short, renews only the cuts that the proxy violates. A smaller proxy then fits at its present
        // place.
        const HalfSpace held = wall(i);
        if (work_.left <= 0 && glm::dot(held.normal, proxy_m_) >= held.offset_m) continue;
        double distance = 0.0;
        keep_cut(i, support(scene, i, proxy_m_, distance));
        spend(kSupportWork);
    }
    if (fits()) return take();
    step_.squeezed = true;
    const double wanted = radius_m_;
    double low = kSmallestRadius_m, high = wanted;
    radius_m_ = low;
    if (!fits()) {
        radius_m_ = wanted;
        for (int i = cuts_.count - 1; i >= 0; --i) {
            const auto at = static_cast<std::size_t>(i);
            if (i >= cuts_.count || cuts_.owners[at] == kStill || !tracks_.of(cuts_.owners[at]).moved ||
                cuts_.asleep(i))
                continue;
            double distance = 0.0;
            support(scene, i, proxy_m_, distance);
            if (distance < radius_m_) ghosts_.add(cuts_.of(at));
        }
        known_m_ = -1.0;
        cuts_.count = 0;
        basis_.count = 0;
        gathers_on_ = tracks_.unknown = false;
        return;
    }
    ProjectionBasis best = room;
    for (int round = 0; round < 20 && work_.left > -kMostWork / 4; ++round) {
        radius_m_ = 0.5 * (low + high);
        if (fits()) {
            low = radius_m_;
            best = room;
        } else {
            high = radius_m_;
        }
    }
    radius_m_ = low;
    room = best;
    take();
}

}  // namespace handrail::render
