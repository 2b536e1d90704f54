#include "haptic/render/proxy_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handrail {
namespace {

constexpr double kTouching_m = 1e-8;     // a cut that is this near to its obstacle touches it
constexpr double kFarthestLook_m = 4.0;  // free-space bounds beyond this save nothing more
// Free-space distance is only needed as a lower bound L with kLoose * distance <= L: an exact answer has no useful worst case (in the middle
// of a round room everything is equally near), this one visits a few nodes.
constexpr double kLoose = 0.7;

// Of the way from what is needed now to how far is looked: nearer obstacles get the cut at their closest point, farther ones a quick one. None: the ball then
// meets loose cuts and takes more rounds; all: 1,000 instructions more per tick on a sphere of a million triangles.
constexpr double kExact = 0.3;
constexpr double kFarther = 1.03;  // than the last gathering went, where obstacles are dense

constexpr int kMostSubSteps = 64;  // of a body's way within one move; faster ones count as gone here and appeared there
constexpr int kHurryMoves = 8;     // moves in which the ball reaches a goal that only a vanished thing kept it from

// Sheets of one side. A ball belongs to a side when its centre is not behind the sheet by more than rounding; the difference between falling asleep and
// waking keeps a ball that rests at the border from changing its mind.
constexpr double kSleeps_m = 1e-9;
constexpr double kWakes_m = 1e-10;
constexpr double kNoCut_m = -1e30;  // offset of a half-space that holds everything

bool nearer(double distance_a, std::uint32_t a, double distance_b, std::uint32_t b) noexcept {
    return distance_a != distance_b ? distance_a < distance_b : a < b;
}

}  // namespace

ProxySolver::ProxySolver()
    : cuts_(kMaxCandidates),
      obstacles_(kMaxCandidates),
      owners_(kMaxCandidates, kStill),
      own_cuts_(kMaxCandidates),
      looked_ahead_(kMaxCandidates),
      sheets_(kMaxCandidates),
      awake_(kMaxCandidates),
      nearest_(kMaxCandidates + kSpareCandidates),
      nearest_normals_(kMaxCandidates + kSpareCandidates),
      ghosts_(kMaxGhosts),
      tracks_(HapticScene::kMostBodies) {}

void ProxySolver::reset() noexcept {
    placed_ = false;
    basis_.count = 0;
    known_m_ = -1.0;
    dense_m_ = kFarthestLook_m;
    ghost_count_ = 0;
    gatherings_ = 0;
    carrier_ = kStill;
    hurry_ = 0;
}

bool ProxySolver::is_ghost(std::uint32_t obstacle, std::uint16_t body) const noexcept {
    const auto end = ghosts_.begin() + ghost_count_;
    return std::find_if(ghosts_.begin(), end, [&](const Ghost& g) { return g.obstacle == obstacle && g.body == body; }) != end;
}

ClosestPoint ProxySolver::closest_of_body(const HapticScene& scene, std::uint32_t obstacle, std::uint16_t body, const Vec3& local_m) const noexcept {
    const HapticScene& shape = *scene.bodies[body].shape;
    const PlacedFrame& frame = tracks_[body].frame;
    ClosestPoint found = shape.closest(obstacle, frame.to_own(local_m) - shape.origin_m);
    found.point_m = frame.to_world(found.point_m + shape.origin_m);
    found.normal = frame.turned(found.normal);
    found.distance_m *= frame.scale;
    return found;
}

Vec3 ProxySolver::to_own(const HapticScene& scene, const Hold& hold, const Vec3& world_m) const noexcept {
    const Vec3 local = world_m - scene.origin_m;
    return hold.body == kStill ? local : tracks_[hold.body].frame.to_own(local) - scene.bodies[hold.body].shape->origin_m;
}

template <class Has>
HalfSpace ProxySolver::support(const HapticScene& scene, int candidate, const Vec3& at, double& distance_m) const noexcept {
    const auto i = static_cast<std::size_t>(candidate);
    const ClosestPoint found = !Has::kBodies || owners_[i] == kStill ? scene.closest(obstacles_[i], anchor_m_ + at)
                                                                     : closest_of_body(scene, obstacles_[i], owners_[i], anchor_m_ + at);
    distance_m = found.distance_m;
    return {found.normal, glm::dot(found.normal, found.point_m - anchor_m_)};
}

// A body's cut is kept in the body's frame too, where it stays valid however the body moves.
template <class Has>
void ProxySolver::keep_cut(int candidate, const HalfSpace& cut) noexcept {
    const auto i = static_cast<std::size_t>(candidate);
    cuts_[i] = cut;
    if (!Has::kBodies || owners_[i] == kStill) return;
    const PlacedFrame& frame = tracks_[owners_[i]].frame;
    own_cuts_[i] = {frame.turned_back(cut.normal), (cut.offset_m + glm::dot(cut.normal, anchor_m_ - frame.position_m)) / frame.scale};
}

// Starts the ball at a place: solids around it become ghosts, anything else nearer than the radius shrinks the ball.
void ProxySolver::place(const HapticScene& scene, const Vec3& local_m, double radius_m) noexcept {
    placed_ = true;
    basis_.count = 0;
    known_m_ = -1.0;
    ghost_count_ = 0;
    count_ = 0;
    one_sided_count_ = 0;
    carrier_ = kStill;
    scene_origin_m_ = scene.origin_m;
    anchor_m_ = local_m;
    ball_m_ = Vec3(0.0);
    radius_m_ = radius_m;
    place_in(scene, kStill, radius_m);
    for (std::size_t b = 0; b < body_count_; ++b) place_in(scene, static_cast<std::uint16_t>(b), radius_m);
}

// The same for the obstacles of one body that has just appeared, or of everything still.
void ProxySolver::place_in(const HapticScene& scene, std::uint16_t body, double radius_m) noexcept {
    if (body != kStill && !tracks_[body].present) return;
    const HapticScene& shape = body == kStill ? scene : *scene.bodies[body].shape;
    const Vec3 at = local_m();
    const double scale = body == kStill ? 1.0 : tracks_[body].frame.scale;
    const Vec3 own = body == kStill ? at : tracks_[body].frame.to_own(at) - shape.origin_m;
    int looks = kMostLooks;
    const double known = shape.obstacle_bvh.nearest_first(own, radius_m / scale, looks, queue_, [&](std::uint32_t item, double&) {
        const double distance = shape.closest(item, own).distance_m * scale;
        if (shape.solid(item) && distance <= 0.0) {
            if (ghost_count_ < kMaxGhosts) ghosts_[static_cast<std::size_t>(ghost_count_++)] = {item, body};
        } else if (shape.obstacles[item].side == TouchSide::Both || shape.in_front_m(item, own) >= 0.0) {
            radius_m_ = std::min(radius_m_, std::max(distance, kSmallestRadius_m));
        }
    });
    looks_ += kMostLooks - looks;
    // Where there was too much to look at, what was not looked at may begin here.
    if (looks <= 0) radius_m_ = std::min(radius_m_, std::max(known * scale, kSmallestRadius_m));
}

void ProxySolver::release_ghosts(const HapticScene& scene, const Vec3& goal_local_m, double radius_m, double exit_m) noexcept {
    for (int i = ghost_count_ - 1; i >= 0; --i) {
        const Ghost ghost = ghosts_[static_cast<std::size_t>(i)];
        const auto distance = [&](const Vec3& at) {
            return (ghost.body == kStill ? scene.closest(ghost.obstacle, at) : closest_of_body(scene, ghost.obstacle, ghost.body, at)).distance_m;
        };
        if (distance(goal_local_m) <= radius_m + exit_m || distance(local_m()) < radius_m) continue;
        ghosts_[static_cast<std::size_t>(i)] = ghosts_[static_cast<std::size_t>(--ghost_count_)];
        known_m_ = -1.0;
    }
}

// The `most` nearest obstacles of a shape within reach into nearest_, each with a cut; what is not near is ranked by how far its cut is. Returns how far
// all are known: reach_m, or less when there were more or the looks ran out. Own metres.
double ProxySolver::gather_nearest(const HapticScene& shape, std::uint16_t body, const Vec3& at, double reach_m, double needed_m, std::size_t most) noexcept {
    const auto before = [](const Candidate& a, const Candidate& b) { return nearer(a.distance_m, a.obstacle, b.distance_m, b.obstacle); };
    std::uint32_t normals = 0;
    nearest_count_ = 0;
    const auto drop_farthest = [&] {
        const auto begin = nearest_.begin(), last = begin + static_cast<std::ptrdiff_t>(most > 0 ? most - 1 : 0);
        std::nth_element(begin, last, begin + static_cast<std::ptrdiff_t>(nearest_count_), before);
        nearest_count_ = most;
        return last->distance_m;
    };
    double known = shape.obstacle_bvh.nearest_first(at, reach_m, looks_left_, queue_, [&](std::uint32_t item, double& reach) {
        if (ghost_count_ > 0 && is_ghost(item, body)) return;
        // Places behind the kept ones hold numbers of normals that are free again.
        Candidate& candidate = nearest_[nearest_count_];
        if (nearest_count_ == normals) candidate.normal = normals++;
        Vec3& normal = nearest_normals_[candidate.normal];
        double distance = shape.quick_support(item, at, normal);
        if (distance > reach) return;
        if (distance < needed_m + kExact * (reach - needed_m)) {
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

// Adds the obstacles of one shape within reach_m of a place to the candidates, each with a fresh cut; where that is too many, as far as the
// nearest go. Returns the distance up to which all are candidates. Own metres.
double ProxySolver::collect(const HapticScene& shape, std::uint16_t body, const Vec3& at, double reach_m, double needed_m) noexcept {
    const std::size_t room = static_cast<std::size_t>(kMaxCandidates - count_);
    const std::size_t comfortable = std::min<std::size_t>(kComfortableCandidates, room);
    looks_left_ = kMostLooks;
    // Where obstacles are dense, about as far as the last look went: looking farther first only to drop what was found takes half of the time.
    const double likely = body == kStill ? std::clamp(kFarther * dense_m_, needed_m, std::max(reach_m, needed_m)) : reach_m;
    double known = gather_nearest(shape, body, at, likely, needed_m, comfortable);
    if (likely < reach_m && known == likely && nearest_count_ < comfortable / 2) known = gather_nearest(shape, body, at, reach_m, needed_m, comfortable);
    looks_ += kMostLooks - looks_left_;
    if (body == kStill) dense_m_ = known;
    if (known < needed_m) {
        looks_left_ = kMostLooks;
        known = gather_nearest(shape, body, at, reach_m, needed_m, room);
        looks_ += kMostLooks - looks_left_;
        step_.truncated = step_.truncated || known < needed_m;
    }
    for (std::size_t k = 0; k < nearest_count_; ++k) {
        const auto i = static_cast<std::size_t>(count_++);
        cuts_[i] = {nearest_normals_[nearest_[k].normal], -nearest_[k].distance_m};
        obstacles_[i] = nearest_[k].obstacle;
        owners_[i] = body;
        looked_ahead_[i] = 0;
        sheets_[i] = Sheet::No;
        if (!shape.one_sided_sheets || shape.obstacles[obstacles_[i]].side == TouchSide::Both) continue;
        sheets_[i] = Sheet::Asleep;
        cuts_[i].offset_m = kNoCut_m;
        ++one_sided_count_;
    }
    return known;
}

// Makes every obstacle within reach_m of the ball a candidate.
void ProxySolver::gather(const HapticScene& scene, double reach_m, double needed_m) noexcept {
    ++gatherings_;
    const Vec3 at = local_m();
    for (int i = 0; i < path_size_; ++i) path_[static_cast<std::size_t>(i)] -= ball_m_;
    anchor_m_ = at;
    ball_m_ = Vec3(0.0);
    basis_.count = 0;
    if (one_sided_count_ > 0) remember_awake();
    count_ = 0;
    one_sided_count_ = 0;
    known_m_ = collect(scene, kStill, at, reach_m, needed_m);
    if (count_ == 0) {
        double best = std::max(kFarthestLook_m, 2.0 * reach_m);
        const double free_m = scene.obstacle_bvh.nearest_first(at, kLoose * best, looks_left_, queue_, [&](std::uint32_t item, double& reach) {
            if (ghost_count_ > 0 && is_ghost(item, kStill)) return;
            best = std::min(best, scene.closest(item, at).distance_m);
            reach = std::min(reach, kLoose * best);
        });
        known_m_ = std::max(known_m_, free_m);
    }
    bodies_known_m_ = std::numeric_limits<double>::infinity();
    bodies_moved_ = false;
    for (std::size_t b = 0; b < body_count_; ++b) {
        Track& track = tracks_[b];
        if (!track.present) continue;
        const PlacedFrame& frame = track.frame;
        const HapticScene& shape = *scene.bodies[b].shape;
        track.reach_m = scene.bodies[b].reach_m * frame.scale;
        track.known_m = glm::length(at - frame.position_m) - track.reach_m;  // no part of it is nearer than this
        track.looked_at = track.known_m <= reach_m;
        if (!track.looked_at) {
            bodies_known_m_ = std::min(bodies_known_m_, track.known_m);
            continue;
        }
        const Vec3 own = frame.to_own(at);
        track.known_from_m = own;
        const int first = count_;
        track.known_m = collect(shape, static_cast<std::uint16_t>(b), own - shape.origin_m, reach_m / frame.scale, needed_m / frame.scale) * frame.scale;
        for (int i = first; i < count_; ++i) {
            const HalfSpace cut = cuts_[static_cast<std::size_t>(i)];  // own axes and metres, from `own`
            keep_cut(i, {frame.turned(cut.normal), cut.offset_m * frame.scale});
        }
        bodies_known_m_ = std::min(bodies_known_m_, track.known_m);
    }
    if (one_sided_count_ > 0) turn_sheets(scene);
    awake_count_ = 0;
}

double ProxySolver::known_of_bodies(const Vec3& at_m, double known) const noexcept {
    for (std::size_t b = 0; b < body_count_; ++b) {
        const Track& track = tracks_[b];
        if (!track.present) continue;
        const Vec3 at = anchor_m_ + at_m;
        known = std::min(known, track.looked_at ? track.known_m - glm::length(track.frame.to_own(at) - track.known_from_m) * track.frame.scale
                                                : glm::length(at - track.frame.position_m) - track.reach_m);
    }
    return known;
}

// ---- bodies ----

// Takes every body as it stands, with no way in between.
void ProxySolver::take_bodies(const HapticScene& scene, const Request& request) noexcept {
    body_count_ = std::min(scene.bodies.size(), tracks_.size());
    bodies_number_ = request.bodies_number;
    for (std::size_t b = 0; b < body_count_; ++b) {
        const BodyPose pose = wanted(scene, request, b);
        tracks_[b] = {};
        stand(scene, tracks_[b], pose.at);
        tracks_[b].present = pose.present;
    }
}

BodyPose ProxySolver::wanted(const HapticScene& scene, const Request& request, std::size_t body) noexcept {
    return body < request.bodies.size() ? request.bodies[body] : BodyPose{scene.bodies[body].start, scene.bodies[body].present};
}

void ProxySolver::stand(const HapticScene& scene, Track& track, const Placement& at) noexcept {
    track.at = at;
    track.frame = PlacedFrame(at);
    track.frame.position_m -= scene.origin_m;
}

void ProxySolver::drop_body(std::uint16_t body) noexcept {
    for (int k = 0; k < basis_.count; ++k)
        if (owners_[static_cast<std::size_t>(basis_.index[static_cast<std::size_t>(k)])] == body) hurry_ = kHurryMoves;
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
        const auto from = static_cast<std::size_t>(i), to = static_cast<std::size_t>(kept);
        if (owners_[from] == body) continue;
        cuts_[to] = cuts_[from];
        obstacles_[to] = obstacles_[from];
        owners_[to] = owners_[from];
        own_cuts_[to] = own_cuts_[from];
        looked_ahead_[to] = looked_ahead_[from];
        sheets_[to] = sheets_[from];
        ++kept;
    }
    count_ = kept;
    basis_.count = 0;
    for (int i = ghost_count_ - 1; i >= 0; --i)
        if (ghosts_[static_cast<std::size_t>(i)].body == body) ghosts_[static_cast<std::size_t>(i)] = ghosts_[static_cast<std::size_t>(--ghost_count_)];
    if (carrier_ == body) carrier_ = kStill;
}

// Brings every body to where it is wanted, and the ball out of its way.
void ProxySolver::advance_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept {
    bodies_number_ = request.bodies_number;
    double steps = 0.0;
    for (std::size_t b = 0; b < body_count_; ++b) {
        Track& track = tracks_[b];
        const BodyPose pose = wanted(scene, request, b);
        const auto id = static_cast<std::uint16_t>(b);
        track.from = track.to = track.at;
        if (track.present == pose.present && track.at == pose.at) continue;
        if (!track.present && !pose.present) {
            stand(scene, track, pose.at);
            continue;
        }
        const double reach = scene.bodies[b].reach_m;
        const double travel = farthest_travel_m(track.at, pose.at, reach);
        const double needs = travel / (0.5 * radius_m_);
        const double gap = glm::length(track.frame.position_m - local_m()) - reach * track.frame.scale - travel;
        const bool near = gap <= radius_m + request.path_cap_m;
        if (track.present != pose.present || (near && needs > kMostSubSteps)) {
            if (track.present) drop_body(id);
            stand(scene, track, pose.at);
            track.from = track.to = pose.at;
            track.present = pose.present;
            known_m_ = -1.0;
            place_in(scene, id, radius_m);
            continue;
        }
        bodies_moved_ = true;
        if (!near && !track.looked_at) {
            stand(scene, track, pose.at);
            track.reach_m = reach * track.frame.scale;
            track.from = track.to = pose.at;
            continue;
        }
        track.to = pose.at;
        if (near) steps = std::max(steps, needs);
    }
    const int count = static_cast<int>(std::clamp(std::ceil(steps), 1.0, static_cast<double>(kMostSubSteps)));
    path_size_ = 0;
    for (int k = 1; k <= count; ++k) sub_step(scene, request, radius_m, k == count ? 1.0 : static_cast<double>(k) / count);
}

void ProxySolver::sub_step(const HapticScene& scene, const Request& request, double radius_m, double part) noexcept {
    Vec3 wish = ball_m_;
    bool any = false;
    for (std::size_t b = 0; b < body_count_; ++b) {
        Track& track = tracks_[b];
        track.moved = !(track.from == track.to);
        if (!track.moved) continue;
        any = any || track.present;
        const PlacedFrame before = track.frame;
        stand(scene, track, part == 1.0 ? track.to : between(track.from, track.to, part));
        if (one_sided_count_ > 0) turn_sheets_of(scene, static_cast<std::uint16_t>(b), before);
        track.reach_m = scene.bodies[b].reach_m * track.frame.scale;
        if (carrier_ == b) wish = track.frame.to_world(before.to_own(local_m())) - anchor_m_;
    }
    if (!any) return;
    const double carried = glm::length(wish - ball_m_);
    const double needed = 2.0 * radius_m + carried;  // a push of half a radius, and the radius itself
    if (known_around(ball_m_) < needed) {
        const Vec3 was = ball_m_;
        gather(scene, needed + std::max(request.margin_m, 2.0 * request.path_cap_m), needed);
        wish += ball_m_ - was;
    }
    for (int i = 0; i < count_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (owners_[at] == kStill || !tracks_[owners_[at]].moved) continue;
        const PlacedFrame& frame = tracks_[owners_[at]].frame;
        const Vec3 normal = frame.turned(own_cuts_[at].normal);
        cuts_[at] = {normal, own_cuts_[at].offset_m * frame.scale + glm::dot(normal, frame.position_m - anchor_m_)};
        if (glm::dot(normal, ball_m_) - cuts_[at].offset_m >= radius_m_) continue;
        double distance = 0.0;
        keep_cut(i, support(scene, i, ball_m_, distance));
    }
    make_room(scene, wish);
}

// The ball to the free place nearest to a wish; where there is none it shrinks as little as it must. Crushed altogether, it lets the bodies pass.
void ProxySolver::make_room(const HapticScene& scene, const Vec3& wish_m) noexcept {
    ProjectionBasis room;
    const auto fits = [&] {
        room.count = 0;
        return project_on_half_spaces(
            wish_m, count_, [this](int i) { return wall(i); }, room);
    };
    const auto take = [&] {
        step_.pushed = step_.pushed || room.point_m != ball_m_;
        ball_m_ = room.point_m;
    };
    if (fits()) return take();
    for (int i = 0; i < count_; ++i) {
        if (asleep(i)) continue;
        double distance = 0.0;
        keep_cut(i, support(scene, i, ball_m_, distance));
    }
    if (fits()) return take();
    step_.squeezed = true;
    const double wanted = radius_m_;
    double low = kSmallestRadius_m, high = wanted;
    radius_m_ = low;
    if (!fits()) {
        radius_m_ = wanted;
        for (int i = count_ - 1; i >= 0; --i) {
            const auto at = static_cast<std::size_t>(i);
            if (i >= count_ || owners_[at] == kStill || !tracks_[owners_[at]].moved || asleep(i)) continue;
            double distance = 0.0;
            support(scene, i, ball_m_, distance);
            if (distance < radius_m_ && ghost_count_ < kMaxGhosts) ghosts_[static_cast<std::size_t>(ghost_count_++)] = {obstacles_[at], owners_[at]};
        }
        known_m_ = -1.0;
        count_ = 0;
        basis_.count = 0;
        return;
    }
    ProjectionBasis best = room;
    for (int round = 0; round < 20; ++round) {
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

// ---- sheets of one side ----

double ProxySolver::in_front_m(const HapticScene& scene, int candidate, const PlacedFrame& frame, const Vec3& at_m) const noexcept {
    const auto i = static_cast<std::size_t>(candidate);
    const Vec3 local = anchor_m_ + at_m;
    if (owners_[i] == kStill) return scene.in_front_m(obstacles_[i], local);
    const HapticScene& shape = *scene.bodies[owners_[i]].shape;
    return shape.in_front_m(obstacles_[i], frame.to_own(local) - shape.origin_m) * frame.scale;
}

// Before candidates are gathered anew: what is awake stays so, even where a moving body has just come nearer than the ball's radius.
void ProxySolver::remember_awake() noexcept {
    awake_count_ = 0;
    for (int i = 0; i < count_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (sheets_[at] == Sheet::Awake) awake_[static_cast<std::size_t>(awake_count_++)] = {obstacles_[at], owners_[at]};
    }
}

// A sheet of one side acts while the ball is on that side, and only once the ball was there with room to spare: one that comes through from behind is not
// pushed out. True when a sheet woke or fell asleep.
bool ProxySolver::turn_sheets(const HapticScene& scene) noexcept {
    bool turned = false;
    for (int i = 0; i < count_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (sheets_[at] == Sheet::No) continue;
        const bool sleeps = sheets_[at] == Sheet::Asleep;
        const double in_front = in_front_m(scene, i, ball_m_);
        if (sleeps ? in_front < -kWakes_m : in_front >= -kSleeps_m) continue;
        if (sleeps) {
            double distance = 0.0;
            const HalfSpace cut = support(scene, i, ball_m_, distance);
            const auto end = awake_.begin() + awake_count_;
            const auto was_awake = [&](const Ghost& g) { return g.obstacle == obstacles_[at] && g.body == owners_[at]; };
            if (distance < radius_m_ - kSleeps_m && std::find_if(awake_.begin(), end, was_awake) == end) continue;
            keep_cut(i, cut);
        } else {
            keep_cut(i, {cuts_[at].normal, kNoCut_m});
        }
        sheets_[at] = sleeps ? Sheet::Awake : Sheet::Asleep;
        turned = true;
    }
    return turned;
}

// After a sub-step of a body: its sleeping sheets whose plane has passed over the ball. Sub-steps are half a radius long at most, so one whose own surface
// passed is still nearer than that, and any other had room to spare.
void ProxySolver::turn_sheets_of(const HapticScene& scene, std::uint16_t body, const PlacedFrame& before) noexcept {
    for (int i = 0; i < count_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (owners_[at] != body || sheets_[at] != Sheet::Asleep) continue;
        if (in_front_m(scene, i, before, ball_m_) >= -kWakes_m || in_front_m(scene, i, ball_m_) < -kWakes_m) continue;
        double distance = 0.0;
        const HalfSpace cut = support(scene, i, ball_m_, distance);
        if (distance <= 0.5 * radius_m_) continue;
        keep_cut(i, cut);
        sheets_[at] = Sheet::Awake;
    }
}

// How much of a step the ball may make before it comes round to the side of a sleeping sheet with room to spare, so that the sheet must wake there. Along a
// straight line the distance to a sheet falls first and rises then, so only where the line crosses the sheet's plane can this happen with the ball going
// on to touch.
double ProxySolver::fraction_to_waking(const HapticScene& scene, const Vec3& step) const noexcept {
    double fraction = 1.0;
    for (int i = 0; i < count_; ++i) {
        if (sheets_[static_cast<std::size_t>(i)] != Sheet::Asleep) continue;
        const double before = in_front_m(scene, i, ball_m_);
        if (before >= -kWakes_m) continue;
        const double after = in_front_m(scene, i, ball_m_ + step);
        if (after <= 0.0) continue;
        const double crossing = before / (before - after);
        if (crossing >= fraction) continue;
        double distance = 0.0;
        support(scene, i, ball_m_ + step * crossing, distance);
        if (distance >= radius_m_ - kSleeps_m) fraction = crossing;
    }
    return fraction;
}

bool ProxySolver::project() noexcept {
    if (count_ > 0) return project_on_half_spaces(goal_m_, std::span(cuts_).first(static_cast<std::size_t>(count_)), radius_m_, basis_);
    basis_.count = 0;
    basis_.point_m = goal_m_;
    return true;
}

// A ball that had to shrink grows while the space lets it: pushed out by its own cuts, never through another.
void ProxySolver::grow(const HapticScene& scene, double radius_m, double growth_m) noexcept {
    if (growth_m <= 0.0) return;
    for (int i = 0; i < count_; ++i) {
        if (asleep(i)) continue;
        double distance = 0.0;
        keep_cut(i, support(scene, i, ball_m_, distance));
    }
    const double before = radius_m_;
    double growth = std::min(growth_m, radius_m - radius_m_);
    for (int round = 0; round < 8; ++round, growth *= 0.5) {
        radius_m_ = before + growth;
        ProjectionBasis grown;
        const bool fits = project_on_half_spaces(
            ball_m_, count_, [this](int i) { return wall(i); }, grown);
        // In a corner the ball is pushed out farther than it grows; the push, too, is no more than was asked for.
        if (fits && glm::dot(grown.point_m - ball_m_, grown.point_m - ball_m_) <= growth_m * growth_m * (1.0 + 1e-9)) {
            ball_m_ = grown.point_m;
            return;
        }
    }
    radius_m_ = before;
}

double ProxySolver::fraction_inside(const Vec3& step) const noexcept {
    double fraction = 1.0;
    for (int i = 0; i < count_; ++i) {
        const HalfSpace h = wall(i);
        const double towards = -glm::dot(h.normal, step);
        if (towards <= 0.0) continue;
        const double gap = std::max(0.0, glm::dot(h.normal, ball_m_) - h.offset_m);
        if (gap < fraction * towards) fraction = gap / towards;
    }
    return fraction;
}

// Renews the cuts that hold the ball from where it is; true when one of them did not touch or has turned, so another round is due. Once per
// move a cut that does not touch is renewed from where the ball would go without it: sliding over a tessellated plane then takes one
// round per triangle instead of 5 to 20.
template <class Has>
bool ProxySolver::renew_holding_cuts(const HapticScene& scene) noexcept {
    std::array<Vec3, 3> ahead{goal_m_, goal_m_, goal_m_};
    const auto held = [this](int k) { return wall(basis_.index[static_cast<std::size_t>(k)]); };
    if (basis_.count == 2) {
        for (int a = 0; a < 2; ++a) {
            const HalfSpace other = held(1 - a);
            ahead[static_cast<std::size_t>(a)] += other.normal * std::max(0.0, other.offset_m - glm::dot(other.normal, goal_m_));
        }
    } else if (basis_.count == 3) {
        for (int a = 0; a < 3; ++a) {
            ProjectionBasis rest;
            project_on_half_spaces(
                goal_m_, 2, [&](int i) { return held((a + 1 + i) % 3); }, rest);
            ahead[static_cast<std::size_t>(a)] = rest.point_m;
        }
    }
    const Vec3 pull = goal_m_ - ball_m_;
    bool stale = false;
    for (int a = 0; a < basis_.count; ++a) {
        const int i = basis_.index[static_cast<std::size_t>(a)];
        const Vec3 old_normal = cuts_[static_cast<std::size_t>(i)].normal;
        double distance = 0.0;
        HalfSpace cut = support<Has>(scene, i, ball_m_, distance);
        const bool apart = distance - radius_m_ > kTouching_m;
        if (apart && looked_ahead_[static_cast<std::size_t>(i)] != moves_) {
            looked_ahead_[static_cast<std::size_t>(i)] = moves_;
            double distance_ahead = 0.0;
            const HalfSpace further = support<Has>(scene, i, ahead[static_cast<std::size_t>(a)], distance_ahead);
            if (distance_ahead > 1e-12 && glm::dot(further.normal, ball_m_) - further.offset_m >= radius_m_ - kProjectionTolerance_m) cut = further;
        }
        keep_cut<Has>(i, cut);
        const Vec3 turn = cut.normal - old_normal;
        stale = stale || apart || glm::dot(turn, turn) * glm::dot(pull, pull) > kTouching_m * kTouching_m;
    }
    return stale;
}

// Round the edge of a solid in one go: when one solid alone holds the ball and the goal lies within the ball's reach outside it, or below a smooth part of it,
// the nearest place is known. Two straight pieces lead there, the first in the cut at the ball, the second in the cut at the goal. Without it an edge
// pressed 4.5 mm deep by a 5 mm ball takes 45 rounds.
bool ProxySolver::arc_step(const HapticScene& scene, double way_left_m) noexcept {
    if (basis_.count != 1 || one_sided_count_ > 0) return false;
    const int i = basis_.index[0];
    const std::uint32_t obstacle = obstacles_[static_cast<std::size_t>(i)];
    const std::uint16_t body = owners_[static_cast<std::size_t>(i)];
    if (!shape_at(scene, i).solid(obstacle)) return false;
    double at_goal = 0.0, at_ball = 0.0;
    const HalfSpace goal_cut = support(scene, i, goal_m_, at_goal);
    if (!(at_goal < radius_m_)) return false;
    const HalfSpace ball_cut = support(scene, i, ball_m_, at_ball);
    const double turn = glm::dot(ball_cut.normal, goal_cut.normal);
    if (!(turn > 0.5 && turn < 1.0 - 1e-14)) return false;
    // A goal inside the solid may be nearer to another face than the one the ball would roll to, unless no edge lies between.
    const auto own = [&](const Vec3& normal) { return body == kStill ? normal : tracks_[body].frame.turned_back(normal); };
    if (at_goal <= 1e-12 && !shape_at(scene, i).smooth_between(obstacle, own(ball_cut.normal), own(goal_cut.normal))) return false;
    const Vec3 end = goal_m_ + goal_cut.normal * (radius_m_ - at_goal);
    ProjectionBasis bend;
    const std::array<HalfSpace, 2> both{HalfSpace{ball_cut.normal, ball_cut.offset_m + radius_m_}, HalfSpace{goal_cut.normal, goal_cut.offset_m + radius_m_}};
    if (!project_on_half_spaces(
            0.5 * (ball_m_ + end), 2, [&](int k) { return both[static_cast<std::size_t>(k)]; }, bend))
        return false;
    const Vec3 middle = bend.point_m;
    if (glm::length(middle - ball_m_) + glm::length(end - middle) > way_left_m) return false;
    for (int j = 0; j < count_; ++j) {
        if (j == i) continue;
        const HalfSpace h = wall(j);
        if (glm::dot(h.normal, middle) < h.offset_m - kProjectionTolerance_m || glm::dot(h.normal, end) < h.offset_m - kProjectionTolerance_m) return false;
    }
    keep_cut(i, goal_cut);
    path_[static_cast<std::size_t>(path_size_++)] = middle;
    path_[static_cast<std::size_t>(path_size_++)] = end;
    ball_m_ = end;
    basis_.multiplier_m[0] = radius_m_ - at_goal;
    basis_.point_m = end;
    return true;
}

template <class Has>
const ProxySolver::Step& ProxySolver::move(const HapticScene& scene, const Request& request) noexcept {
    const double radius = std::max(request.radius_m, kSmallestRadius_m);
    const Vec3 goal_local = request.goal_m - scene.origin_m;
    step_.begin();
    looks_ = 0;
    if (scene_ != &scene || generation_ != scene.generation) {
        // The same world with something added or removed: the ball is where it was, and what kept it from its goal may be gone.
        scene_ = &scene;
        generation_ = scene.generation;
        take_bodies(scene, request);
        if (placed_) hurry_ = kHurryMoves;
        place(scene, placed_ ? world_m() - scene.origin_m : goal_local, radius);
    } else if (!placed_) {
        take_bodies(scene, request);
        place(scene, goal_local, radius);
    }
    ++moves_;
    radius_m_ = std::min(radius_m_, radius);
    if (ghost_count_ > 0) release_ghosts(scene, goal_local, radius, request.ghost_exit_m);
    if (Has::kBodies && body_count_ > 0 && request.bodies_number != bodies_number_) advance_bodies(scene, request, radius);
    carrier_ = kStill;
    step_.ghosted = ghost_count_ > 0;

    // Everything the ball can meet on this move lies within its path's length and its radius. Where that is more than fits, the move is made in
    // stages, each as far as the candidates are known.
    double way_left = request.path_cap_m;
    if (hurry_ > 0) way_left = std::max(way_left, glm::length(goal_local - local_m()) / hurry_--);
    const double margin = std::max(request.margin_m, 2.0 * way_left);
    path_size_ = 0;
    const bool looks = request.most_rounds > 0;
    if (looks && known_around<Has>(ball_m_) < way_left + radius) gather(scene, radius + margin, radius + way_left);
    goal_m_ = goal_local - anchor_m_;
    if (Has::kOneSided && one_sided_count_ > 0) turn_sheets(scene);
    if (looks && radius_m_ < radius) grow(scene, radius, request.growth_m);
    path_[0] = ball_m_;
    path_size_ = 1;
    step_.converged = false;
    const int most_rounds = std::clamp(request.most_rounds, 1, kMaxIterations);
    int stages_left = looks ? kMaxStages : 0;
    while (step_.iterations < most_rounds) {
        ++step_.iterations;
        bool solved = project();
        Vec3 way = basis_.point_m - ball_m_;
        if (!solved) way *= fraction_inside(way);
        if (Has::kOneSided && one_sided_count_ > 0) {
            if (const double fraction = fraction_to_waking(scene, way); fraction < 1.0) {
                way *= fraction;
                solved = false;
            }
        }
        const double length = glm::length(way);
        const double known_way = known_around<Has>(ball_m_) - radius;
        if (length > 0.0 && length > std::min(way_left, known_way)) {
            const double part = std::clamp(known_way, 0.0, way_left);
            ball_m_ += way * (part / length);
            path_[static_cast<std::size_t>(path_size_++)] = ball_m_;
            way_left -= part;
            if (way_left > 0.0 && stages_left-- > 0 && looks_ < kMostLooks) {
                gather(scene, radius + margin, radius + way_left);
                goal_m_ = goal_local - anchor_m_;
                if (known_around<Has>(ball_m_) > radius) continue;
            }
            step_.capped = true;
            break;
        }
        way_left -= length;
        ball_m_ = solved ? basis_.point_m : ball_m_ + way;
        path_[static_cast<std::size_t>(path_size_++)] = ball_m_;
        if (Has::kOneSided && one_sided_count_ > 0 && turn_sheets(scene)) continue;
        if (basis_.count == 0) {
            step_.converged = solved;
            break;
        }
        if (!looks) break;
        if (!renew_holding_cuts<Has>(scene)) {
            step_.converged = solved;
            break;
        }
        if (solved && arc_step(scene, std::min(way_left, known_around<Has>(ball_m_) - radius))) {
            step_.converged = true;
            break;
        }
    }
    for (int k = 0; k < basis_.count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const auto i = static_cast<std::size_t>(basis_.index[at]);
        step_.holds[at] = {obstacles_[i], owners_[i], cuts_[i].normal, basis_.multiplier_m[at]};
    }
    step_.count = basis_.count;
    return step_;
}

template <class Has>
void ProxySolver::hold_back(const HapticScene& scene, double reach_m) noexcept {
    const Vec3 target = basis_.point_m;
    const double reach2 = reach_m * reach_m;
    const auto beyond = [&](const Vec3& p) { return glm::dot(p - target, p - target) - reach2; };
    if (beyond(ball_m_) >= 0.0) return;
    while (path_size_ > 1) {
        const Vec3 from = path_[static_cast<std::size_t>(path_size_ - 2)];
        const double outside = beyond(from);
        if (outside >= 0.0) {
            const Vec3 way = path_[static_cast<std::size_t>(path_size_ - 1)] - from;
            const double a = glm::dot(way, way), b = glm::dot(way, from - target);
            if (a > 0.0) ball_m_ = from + way * std::clamp((-b - std::sqrt(std::max(0.0, b * b - a * outside))) / a, 0.0, 1.0);
            path_[static_cast<std::size_t>(path_size_ - 1)] = ball_m_;
            break;
        }
        ball_m_ = from;
        --path_size_;
    }
    // Cuts renewed further along may lie across the place where the ball stopped.
    for (int i = 0; i < count_; ++i) {
        const HalfSpace h = wall(i);
        if (glm::dot(h.normal, ball_m_) >= h.offset_m - 0.1 * kProjectionTolerance_m) continue;
        double distance = 0.0;
        keep_cut<Has>(i, support<Has>(scene, i, ball_m_, distance));
    }
}

template const ProxySolver::Step& ProxySolver::move<PlainFeatures>(const HapticScene&, const Request&) noexcept;
template const ProxySolver::Step& ProxySolver::move<AllFeatures>(const HapticScene&, const Request&) noexcept;
template void ProxySolver::hold_back<PlainFeatures>(const HapticScene&, double) noexcept;
template void ProxySolver::hold_back<AllFeatures>(const HapticScene&, double) noexcept;

}  // namespace handrail
