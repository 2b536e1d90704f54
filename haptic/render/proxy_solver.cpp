#include "haptic/render/proxy_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handrail {
namespace {

constexpr double kTouching_m = 1e-8;     // a cut that is this near to its obstacle touches it
constexpr double kFarthestLook_m = 4.0;  // free-space bounds beyond this save nothing more
// Free-space distance is only needed as a lower bound L with kLoose * distance <= L: an exact answer has no useful
// worst case (in the middle of a round room everything is equally near), this one visits a few nodes.
constexpr double kLoose = 0.7;

// Of the way from what is needed now to how far is looked: nearer obstacles get the cut at their closest point, farther
// ones a quick one. None: the ball then meets loose cuts and takes more rounds; all: 1,000 instructions more per tick
// on a sphere of a million triangles.
constexpr double kExact = 0.3;
constexpr double kFarther = 1.03;  // than the last gathering went, where obstacles are dense

constexpr int kMostSubSteps = 64;  // of a body's way within one move; faster ones count as gone here and appeared there
// What the parts of a move take, in nanoseconds on a processor of 2020 when nothing is in its caches' way. Only their
// sum against kMostWork matters.
constexpr int kLookWork = 50;     // a node or an obstacle looked at while gathering
constexpr int kSupportWork = 60;  // a cut renewed
constexpr int kRoundWork = 200;   // projecting and renewing what holds, besides looking through the candidates
constexpr int kScanWork = 2;      // a body or a cut looked at
constexpr int kCutsOfAWork =
    2;  // so many candidates a projection looks through in one, four at a time: about a nanosecond each
constexpr int kExchangeWork = 30;       // of a projection, besides that
constexpr int kSubStepWork = 300;       // of bodies, besides their candidates
constexpr int kTurnWork = 20;           // a cut of a moving body turned
constexpr std::size_t kFewBodies = 16;  // so many need not be counted
constexpr int kLeastLooks = 128;        // so that a move that has begun to look gets somewhere
constexpr double kCrowdedReach =
    1.15;  // of what is needed: how far candidates are gathered where more stand near than are comfortable

constexpr int kLongestWait = 500;  // moves that a body may lag behind where it was told to be
constexpr int kMostRubs =
    6;  // looks at what the ball touches where friction stops it; flat surfaces need two, round ones three
constexpr double kHangs = 0.1;  // of the ball's radius: so near a surface is one that the path bridged
constexpr int kHurryMoves = 8;  // moves in which the ball reaches a goal that only a vanished thing kept it from

// Sheets of one side. A ball belongs to a side when its centre is not behind the sheet by more than rounding; the
// difference between falling asleep and waking keeps a ball that rests at the border from changing its mind.
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
      tracks_(kMostTracked),
      slots_(HapticScene::kMostBodies, kNoSlot),
      tracked_(kMostTracked),
      free_slots_(kMostTracked) {
    for (std::size_t i = 0; i < free_slots_.size(); ++i)
        free_slots_[i] = static_cast<std::uint16_t>(free_slots_.size() - 1 - i);
}

void ProxySolver::reset() noexcept {
    placed_ = false;
    all_far_in_ = nullptr;
    basis_.count = 0;
    known_m_ = -1.0;
    dense_m_ = kFarthestLook_m;
    ghost_count_ = 0;
    gatherings_ = 0;
    carrier_ = kStill;
    hurry_ = 0;
    gathers_on_ = bodies_unknown_ = bodies_behind_ = crowded_ = false;
}

bool ProxySolver::is_ghost(std::uint32_t obstacle, std::uint16_t body) const noexcept {
    const auto end = ghosts_.begin() + ghost_count_;
    return std::find_if(ghosts_.begin(), end,
                        [&](const Ghost& g) { return g.obstacle == obstacle && g.body == body; }) != end;
}

ClosestPoint ProxySolver::closest_of_body(const HapticScene& scene, std::uint32_t obstacle, std::uint16_t body,
                                          const Vec3& local_m) const noexcept {
    const HapticScene& shape = *scene.bodies[body].shape;
    const PlacedFrame& frame = track_of(body).frame;
    ClosestPoint found = shape.closest(obstacle, frame.to_own(local_m) - shape.origin_m);
    found.point_m = frame.to_world(found.point_m + shape.origin_m);
    found.normal = frame.turned(found.normal);
    found.distance_m *= frame.scale;
    return found;
}

Vec3 ProxySolver::to_own(const HapticScene& scene, const Hold& hold, const Vec3& world_m) const noexcept {
    const Vec3 local = world_m - scene.origin_m;
    return hold.body == kStill ? local
                               : track_of(hold.body).frame.to_own(local) - scene.bodies[hold.body].shape->origin_m;
}

template <class Has>
HalfSpace ProxySolver::support(const HapticScene& scene, int candidate, const Vec3& at,
                               double& distance_m) const noexcept {
    const auto i = static_cast<std::size_t>(candidate);
    const ClosestPoint found = !Has::kBodies || owners_[i] == kStill
                                   ? scene.closest(obstacles_[i], anchor_m_ + at)
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
    const PlacedFrame& frame = track_of(owners_[i]).frame;
    own_cuts_[i] = {frame.turned_back(cut.normal),
                    (cut.offset_m + glm::dot(cut.normal, anchor_m_ - frame.position_m)) / frame.scale};
}

// Starts the ball at a place: solids around it become ghosts, anything else nearer than the radius shrinks the ball.
void ProxySolver::place(const HapticScene& scene, const Request& request, const Vec3& local_m,
                        double radius_m) noexcept {
    placed_ = true;
    all_far_in_ = nullptr;
    basis_.count = 0;
    known_m_ = -1.0;
    ghost_count_ = 0;
    count_ = 0;
    one_sided_count_ = 0;
    gathers_on_ = bodies_unknown_ = false;
    carrier_ = kStill;
    scene_origin_m_ = scene.origin_m;
    anchor_m_ = local_m;
    ball_m_ = Vec3(0.0);
    radius_m_ = radius_m;
    take_bodies(scene, request, radius_m);
    place_in(scene, kStill, radius_m);
    for (const std::uint16_t b : tracked_ids()) place_in(scene, b, radius_m);
}

// The same for the obstacles of one body that has just appeared, or of everything still.
void ProxySolver::place_in(const HapticScene& scene, std::uint16_t body, double radius_m) noexcept {
    if (body != kStill && !track_of(body).present) return;
    const HapticScene& shape = body == kStill ? scene : *scene.bodies[body].shape;
    const Vec3 at = local_m();
    const double scale = body == kStill ? 1.0 : track_of(body).frame.scale;
    const Vec3 own = body == kStill ? at : track_of(body).frame.to_own(at) - shape.origin_m;
    const int most_looks = std::clamp((work_left_ - kRoundsWork) / kLookWork, 4, kMostLooks);
    int looks = most_looks;
    const double known =
        shape.obstacle_bvh.nearest_first(own, radius_m / scale, looks, queue_, [&](std::uint32_t item, double&) {
            const double distance = shape.closest(item, own).distance_m * scale;
            if (shape.solid(item) && distance <= 0.0) {
                if (ghost_count_ < kMaxGhosts) ghosts_[static_cast<std::size_t>(ghost_count_++)] = {item, body};
            } else if (shape.obstacles[item].side == TouchSide::Both || shape.in_front_m(item, own) >= 0.0) {
                radius_m_ = std::min(radius_m_, std::max(distance, kSmallestRadius_m));
            }
        });
    looks_ += most_looks - looks;
    spend((most_looks - looks) * kLookWork);
    // Where there was too much to look at, what was not looked at may begin here.
    if (looks <= 0) radius_m_ = std::min(radius_m_, std::max(known * scale, kSmallestRadius_m));
}

void ProxySolver::release_ghosts(const HapticScene& scene, const Vec3& goal_local_m, double radius_m,
                                 double exit_m) noexcept {
    for (int i = ghost_count_ - 1; i >= 0; --i) {
        const Ghost ghost = ghosts_[static_cast<std::size_t>(i)];
        const auto distance = [&](const Vec3& at) {
            return (ghost.body == kStill ? scene.closest(ghost.obstacle, at)
                                         : closest_of_body(scene, ghost.obstacle, ghost.body, at))
                .distance_m;
        };
        if (distance(goal_local_m) <= radius_m + exit_m || distance(local_m()) < radius_m) continue;
        ghosts_[static_cast<std::size_t>(i)] = ghosts_[static_cast<std::size_t>(--ghost_count_)];
        known_m_ = -1.0;
        gathers_on_ = bodies_unknown_ = false;
    }
}

// The `most` nearest obstacles of a shape within reach into nearest_, each with a cut; what is not near is ranked by
// how far its cut is. Returns how far all are known: reach_m, or less when there were more or the looks ran out. Own
// metres.
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
        shape.obstacle_bvh.nearest_first(at, reach_m, looks_left_, queue_, [&](std::uint32_t item, double& reach) {
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

// Adds the obstacles of one shape within reach_m of a place to the candidates, each with a fresh cut; where that is too
// many, as far as the nearest go. Returns the distance up to which all are candidates. Own metres.
double ProxySolver::collect(const HapticScene& shape, std::uint16_t body, const Vec3& at, double reach_m,
                            double needed_m, std::size_t room) noexcept {
    const std::size_t comfortable = std::min<std::size_t>(kComfortableCandidates, room);
    bool& crowded = body == kStill ? crowded_ : track_of(body).crowded;
    const auto look = [&](double reach, std::size_t most) {
        const int looks = std::clamp((work_left_ - kRoundsWork) / kLookWork, kLeastLooks, kMostLooks);
        looks_left_ = looks;
        const double known = gather_nearest(shape, body, at, reach, needed_m, most);
        looks_ += looks - looks_left_;
        spend((looks - looks_left_) * kLookWork);
        return known;
    };
    double known = 0.0;
    if (!crowded) {
        // Where obstacles are dense, about as far as the last look went: looking farther first only to drop what was
        // found takes half of the time.
        const double likely =
            body == kStill ? std::clamp(kFarther * dense_m_, needed_m, std::max(reach_m, needed_m)) : reach_m;
        known = look(likely, comfortable);
        if (likely < reach_m && known == likely && nearest_count_ < comfortable / 2) known = look(reach_m, comfortable);
        if (body == kStill) dense_m_ = known;
    }
    if (known < needed_m) {
        // Every candidate costs time in every round: as far as is needed and a little more.
        known = look(std::min(std::max(reach_m, needed_m), kCrowdedReach * needed_m), room);
        crowded = nearest_count_ > comfortable;
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
    if (gathers_on_) return gather_waiting(scene, reach_m, needed_m);
    const Vec3 at = local_m();
    for (int i = 0; i < path_size_; ++i) path_[static_cast<std::size_t>(i)] -= ball_m_;
    anchor_m_ = at;
    ball_m_ = Vec3(0.0);
    basis_.count = 0;
    if (one_sided_count_ > 0) remember_awake();
    count_ = 0;
    one_sided_count_ = 0;
    known_m_ = collect(scene, kStill, at, reach_m, needed_m, kMaxCandidates);
    if (count_ == 0) {
        double best = std::max(kFarthestLook_m, 2.0 * reach_m);
        const double free_m = scene.obstacle_bvh.nearest_first(
            at, kLoose * best, looks_left_, queue_, [&](std::uint32_t item, double& reach) {
                if (ghost_count_ > 0 && is_ghost(item, kStill)) return;
                best = std::min(best, scene.closest(item, at).distance_m);
                reach = std::min(reach, kLoose * best);
            });
        known_m_ = std::max(known_m_, free_m);
    }
    bodies_known_m_ = std::numeric_limits<double>::infinity();
    bodies_moved_ = bodies_unknown_ = false;
    std::size_t near = 0;
    for (const std::uint16_t b : tracked_ids()) {
        Track& track = track_of(b);
        track.unknown = track.looked_at = false;
        if (!track.present) continue;
        track.reach_m = scene.bodies[b].reach_m * track.frame.scale;
        track.looked_at = known_of_body(track, at) <= reach_m;  // no part of it is nearer than this
        if (track.looked_at) ++near;
    }
    // All of them at once where that is not too much; else those that there is time for, and the others on the next
    // moves.
    for (std::size_t k = 0; near > 0; ++k) {
        Track& track = track_of(tracked_[k]);
        if (!track.present || !track.looked_at) continue;
        track.known_from_m = track.frame.to_own(at);
        if (work_left_ > 0) {
            look_at_body(scene, tracked_[k], reach_m, needed_m, near);
        } else {
            track.known_m = -1.0;
            track.unknown = bodies_unknown_ = true;
        }
        bodies_known_m_ = std::min(bodies_known_m_, track.known_m);
        --near;
    }
    gathers_on_ = bodies_unknown_;
    if (one_sided_count_ > 0) turn_sheets(scene);
    awake_count_ = 0;
}

// Makes candidates of what is near of one body, where `share` bodies share the room that is left.
void ProxySolver::look_at_body(const HapticScene& scene, std::uint16_t body, double reach_m, double needed_m,
                               std::size_t share) noexcept {
    Track& track = track_of(body);
    const HapticScene& shape = *scene.bodies[body].shape;
    const PlacedFrame& frame = track.frame;
    const Vec3 at = local_m(), own = frame.to_own(at);
    const auto left = static_cast<std::size_t>(kMaxCandidates - count_);
    const std::size_t room = std::min(left, std::max<std::size_t>(left / share, 8));
    const int first = count_;
    track.unknown = false;
    track.known_from_m = own;
    track.known_m = collect(shape, body, own - shape.origin_m, reach_m / frame.scale, needed_m / frame.scale,
                            share == 1 ? left : room) *
                    frame.scale;
    track.short_of_room = track.known_m < needed_m;
    for (int i = first; i < count_; ++i) {
        const HalfSpace cut = cuts_[static_cast<std::size_t>(i)];  // own axes and metres, from `own`
        const Vec3 normal = frame.turned(cut.normal);
        keep_cut(i, {normal, cut.offset_m * frame.scale + glm::dot(normal, ball_m_)});
    }
}

// While a gathering takes more than one move: of what stands still and of each body only what was not looked at yet, or
// of which too little is known by now. What is known of the others holds.
void ProxySolver::gather_waiting(const HapticScene& scene, double reach_m, double needed_m) noexcept {
    reach_m = std::min(reach_m, 1.5 * needed_m);
    const double enough_m = 0.01 * radius_m_;  // looking again from nearer than this would tell nothing new
    const Vec3 at = local_m();
    const double still_known = known_m_ - glm::length(ball_m_);
    const bool look_at_still = still_known < needed_m && (glm::length(ball_m_) > enough_m || known_m_ < 0.0);
    if (one_sided_count_ > 0) remember_awake();
    for (int i = 0; i < path_size_; ++i) path_[static_cast<std::size_t>(i)] -= ball_m_;
    for (int i = 0; i < count_; ++i) {
        HalfSpace& cut = cuts_[static_cast<std::size_t>(i)];
        cut.offset_m -= glm::dot(cut.normal, ball_m_);
    }
    anchor_m_ = at;
    ball_m_ = Vec3(0.0);
    known_m_ = still_known;
    basis_.count = 0;
    bodies_unknown_ = false;
    bodies_moved_ = true;  // known_around() then asks each body
    if (look_at_still) {
        drop_candidates(kStill);
        known_m_ = collect(scene, kStill, at, reach_m, needed_m, static_cast<std::size_t>(kMaxCandidates - count_));
    }
    std::size_t near = 0, left = 0;
    const auto wants_look = [&](const Track& track) {
        if (!track.present) return false;
        if (!track.looked_at) return known_of_body(track, at) < needed_m;
        return track.unknown ||
               (known_of_body(track, at) < needed_m &&
                !(track.short_of_room &&
                  glm::length(track.frame.to_own(at) - track.known_from_m) * track.frame.scale <= enough_m));
    };
    for (const std::uint16_t b : tracked_ids()) {
        Track& track = track_of(b);
        if (track.present && track.looked_at && glm::length(at - track.frame.position_m) - track.reach_m > reach_m) {
            drop_candidates(b);
            track.looked_at = track.unknown = false;
        }
        near += track.present && track.looked_at;
        left += wants_look(track);
    }
    for (std::size_t k = 0; left > 0; ++k) {
        const std::uint16_t id = tracked_[k];
        Track& track = track_of(id);
        if (!wants_look(track)) continue;
        if (track.looked_at && !track.unknown) drop_candidates(id);
        track.looked_at = true;
        if (work_left_ > 0) {
            look_at_body(scene, id, reach_m, needed_m, left);
        } else {
            track.known_from_m = track.frame.to_own(at);
            track.known_m = -1.0;
            track.unknown = bodies_unknown_ = true;
        }
        --left;
    }
    gathers_on_ = bodies_unknown_ || near > 1;
    if (one_sided_count_ > 0) turn_sheets(scene);
    awake_count_ = 0;
}

double ProxySolver::known_of_body(const Track& track, const Vec3& local_m) const noexcept {
    return track.looked_at
               ? track.known_m - glm::length(track.frame.to_own(local_m) - track.known_from_m) * track.frame.scale
               : glm::length(local_m - track.frame.position_m) - track.reach_m;
}

// Those that were looked at by one bound while none of them moves; every other by where it is.
double ProxySolver::known_of_bodies(const Vec3& at_m, double known) const noexcept {
    const Vec3 at = anchor_m_ + at_m;
    if (!bodies_moved_) known = std::min(known, bodies_known_m_ - glm::length(at_m));
    for (const std::uint16_t b : tracked_ids()) {
        const Track& track = track_of(b);
        if (track.present && (bodies_moved_ || !track.looked_at)) known = std::min(known, known_of_body(track, at));
    }
    return far_short_ ? std::min(known, far_m_ - glm::length(at - far_from_m_)) : known;
}

// ---- bodies ----

// A tick follows only bodies that the ball can meet soon. All others are known to stay farther than far_m_ from
// far_from_m_ on the ways that are being played; who comes nearer on the next ways is found when those begin, and the
// rest when the ball has gone on.

// Followed is whoever is nearer than the ball can be pushed or go within a tick by this much: as far as a fast hand
// goes in 100 ms (2 m/s), and so far that no body can come from beyond it to the ball without having jumped
// (kMostSubSteps).
constexpr double kLeadMargins = 10.0, kLeadRadii = 40.0;

// No point of a body comes nearer to a place on the ways of this request.
double ProxySolver::least_distance_m(const HapticScene& scene, const Request& request, std::size_t body,
                                     const Vec3& from_m) const noexcept {
    constexpr double kNever = 1e300;
    const HapticBody& b = scene.bodies[body];
    const Vec3 origin = scene.origin_m + from_m;
    if (!request.bodies || !request.bodies->know(body))
        return b.present ? glm::length(b.start.position_m - origin) - b.reach_m * b.start.scale : kNever;
    const BodyPose& from = request.bodies->poses[body];
    const BodyWays* const ways = request.bodies->ways;
    const BodyPose& to = ways && body < ways->to.size() ? ways->to[body] : from;
    if (!from.present && !to.present) return kNever;
    const Vec3 begin = from.at.position_m - origin, way = to.at.position_m - from.at.position_m;
    const double length2 = glm::dot(way, way);
    const double part = length2 > 0.0 ? std::clamp(-glm::dot(begin, way) / length2, 0.0, 1.0) : 0.0;
    return glm::length(begin + way * part) - b.reach_m * std::max(from.at.scale, to.at.scale);
}

// False when there is no track left.
bool ProxySolver::track_body(const HapticScene& scene, const Request& request, std::size_t body) noexcept {
    if (slots_[body] != kNoSlot) return true;
    if (tracked_count_ == tracked_.size()) return false;
    const auto id = static_cast<std::uint16_t>(body);
    const auto end = tracked_.begin() + static_cast<std::ptrdiff_t>(tracked_count_);
    const auto at = std::lower_bound(tracked_.begin(), end, id);
    std::copy_backward(at, end, end + 1);
    *at = id;
    slots_[body] = free_slots_[free_slots_.size() - 1 - tracked_count_++];
    const BodyPose pose = wanted(scene, request, body);
    Track& track = track_of(id);
    track = {};
    stand(scene, track, pose.at);
    track.wanted = pose.at;
    track.reach_m = scene.bodies[body].reach_m * track.frame.scale;
    // Whoever is near at once has appeared or jumped here, and is met so in advance_bodies().
    const bool near = known_of_body(track, local_m()) <= request.radius_m + request.path_cap_m;
    track.present = pose.present && !near;
    bodies_behind_ = bodies_behind_ || near;
    return true;
}

// Lets go of whoever is farther and has no part in what is felt.
void ProxySolver::untrack_far(const HapticScene& scene, double far_m) noexcept {
    const Vec3 at = local_m();
    const auto has_ghost = [&](std::uint16_t b) {
        const auto end = ghosts_.begin() + ghost_count_;
        return std::find_if(ghosts_.begin(), end, [&](const Ghost& g) { return g.body == b; }) != end;
    };
    std::size_t kept = 0;
    for (std::size_t k = 0; k < tracked_count_; ++k) {
        const std::uint16_t b = tracked_[k];
        const Track& track = track_of(b);
        const double distance = glm::length(at - track.frame.position_m) - scene.bodies[b].reach_m * track.frame.scale;
        if (track.looked_at || carrier_ == b || (track.present && distance < far_m) || has_ghost(b)) {
            tracked_[kept++] = b;
            continue;
        }
        free_slots_[free_slots_.size() - tracked_count_ + (k - kept)] = slots_[b];
        slots_[b] = kNoSlot;
    }
    tracked_count_ = kept;
}

// Looks at every body of the scene: some 3 ns each, once in 0.2 m of a hand's way at most while nothing moves.
void ProxySolver::track_near(const HapticScene& scene, const Request& request) noexcept {
    far_from_m_ = local_m();
    far_m_ = tracks_all_ ? std::numeric_limits<double>::infinity()
                         : near_m_ + std::max(kLeadMargins * request.margin_m, kLeadRadii * request.radius_m);
    untrack_far(scene, far_m_);
    spend(static_cast<int>(body_count_) * kScanWork);
    for (std::size_t b = 0; b < body_count_; ++b) {
        if (slots_[b] != kNoSlot || !(least_distance_m(scene, request, b, far_from_m_) < far_m_ || tracks_all_))
            continue;
        if (track_body(scene, request, b)) continue;
        // More than there are tracks: what lies nearer than half as far, and once more until it fits.
        if (!(far_m_ > 1e-3 * request.radius_m)) {
            far_m_ = -1.0;  // nothing is known
            break;
        }
        far_m_ = tracks_all_ ? near_m_ : 0.5 * far_m_;
        tracks_all_ = false;
        untrack_far(scene, far_m_);
        b = static_cast<std::size_t>(-1);
    }
}

// The same for those alone who move on new ways.
void ProxySolver::track_coming(const HapticScene& scene, const Request& request) noexcept {
    const Vec3 here = scene.origin_m + far_from_m_;
    for (const MovingBody& moving : request.bodies->ways->moving) {
        const std::size_t b = moving.body;
        if (b >= body_count_) continue;
        // Most are far at the first glance: from the middle of their way.
        const Vec3 off = moving.middle_m - here;
        const double beyond = far_m_ + moving.half_way_m + scene.bodies[b].reach_m * moving.most_scale;
        if (glm::dot(off, off) > beyond * beyond || slots_[b] != kNoSlot) continue;
        const double distance = least_distance_m(scene, request, b, far_from_m_);
        if (distance < far_m_ && !track_body(scene, request, b)) far_m_ = std::min(far_m_, distance);
    }
}

// Once a move: whoever may come near is followed.
void ProxySolver::watch_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept {
    const std::uint64_t number = request.bodies ? request.bodies->ways_number() : 0;
    const double near_m = near_for(radius_m, request.margin_m, request.path_cap_m);
    const Vec3 way = local_m() - far_from_m_;
    const bool went = glm::dot(way, way) > far_enough_m2_ || near_m > near_m_;
    if (number == ways_ && !went) return;
    const BodyWays* const ways = request.bodies ? request.bodies->ways : nullptr;
    const bool follows = ways && ways->number_before != 0 && ways->number_before == ways_;
    if (went || (number != ways_ && !follows)) {
        near_m_ = 1.5 * near_m;  // a hand that only grows a little faster needs no new look
        track_near(scene, request);
    } else {
        track_coming(scene, request);
    }
    ways_ = number;
    far_short_ = far_m_ < near_m_;
    const double free_m = far_m_ - near_m_;
    far_enough_m2_ = far_short_ ? -1.0 : free_m < 1e150 ? free_m * free_m : free_m;
}

bool ProxySolver::bodies_are_far(const HapticScene& scene, const Request& request) noexcept {
    all_far_in_ = nullptr;
    if (!placed_ || scene_ != &scene || generation_ != scene.generation || hurry_ > 0) return false;
    watch_bodies(scene, request, std::max(request.radius_m, kSmallestRadius_m));
    if (tracked_count_ > 0 || far_short_) return false;
    all_far_in_ = &scene;
    bodies_number_ = request.bodies ? request.bodies->number : 0;
    bodies_behind_ = false;
    return true;
}

// Takes every body near the ball as it stands, with no way in between.
void ProxySolver::take_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept {
    for (const std::uint16_t b : tracked_ids()) slots_[b] = kNoSlot;
    for (std::size_t i = 0; i < free_slots_.size(); ++i)
        free_slots_[i] = static_cast<std::uint16_t>(free_slots_.size() - 1 - i);
    tracked_count_ = 0;
    body_count_ = std::min(scene.bodies.size(), slots_.size());
    bodies_number_ = request.bodies ? request.bodies->number : 0;
    bodies_behind_ = false;
    far_enough_m2_ = -1.0;
    near_m_ = 0.0;
    if (body_count_ > 0) watch_bodies(scene, request, radius_m);
    for (const std::uint16_t b : tracked_ids()) track_of(b).present = wanted(scene, request, b).present;
    bodies_behind_ = false;
}

BodyPose ProxySolver::wanted(const HapticScene& scene, const Request& request, std::size_t body) noexcept {
    return request.bodies && request.bodies->know(body)
               ? request.bodies->at(body)
               : BodyPose{scene.bodies[body].start, scene.bodies[body].present};
}

void ProxySolver::stand(const HapticScene& scene, Track& track, const Placement& at) noexcept {
    track.at = at;
    track.frame = PlacedFrame(at);
    track.frame.position_m -= scene.origin_m;
}

void ProxySolver::drop_body(std::uint16_t body) noexcept {
    for (int k = 0; k < basis_.count; ++k)
        if (owners_[static_cast<std::size_t>(basis_.index[static_cast<std::size_t>(k)])] == body) hurry_ = kHurryMoves;
    drop_candidates(body);
    for (int i = ghost_count_ - 1; i >= 0; --i)
        if (ghosts_[static_cast<std::size_t>(i)].body == body)
            ghosts_[static_cast<std::size_t>(i)] = ghosts_[static_cast<std::size_t>(--ghost_count_)];
    if (carrier_ == body) carrier_ = kStill;
}

void ProxySolver::drop_candidates(std::uint16_t body) noexcept {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
        const auto from = static_cast<std::size_t>(i), to = static_cast<std::size_t>(kept);
        if (owners_[from] == body) {
            one_sided_count_ -= sheets_[from] != Sheet::No;
            continue;
        }
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
}

// Brings every body to where it is wanted, and the ball out of its way; as far as there is time.
void ProxySolver::advance_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept {
    bodies_number_ = request.bodies ? request.bodies->number : 0;
    const double margin = std::max(request.margin_m, 2.0 * request.path_cap_m);
    if (bodies_unknown_) gather(scene, radius_m + margin, 2.0 * radius_m);
    if (tracked_count_ > kFewBodies && !tracks_all_) spend(static_cast<int>(tracked_count_) * kSupportWork);
    double steps = 0.0;
    for (const std::uint16_t id : tracked_ids()) {
        Track& track = track_of(id);
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
        // What was told in one go counts, not what has come together while the body waited.
        track.waited = bodies_behind_ ? track.waited + 1 : 0;
        track.jumped =
            track.jumped ||
            (track.wanted == track.at ? travel : farthest_travel_m(track.wanted, pose.at, reach)) / (0.5 * radius_m_) >
                kMostSubSteps;
        track.wanted = pose.at;
        const double gap = glm::length(track.frame.position_m - local_m()) - reach * track.frame.scale - travel;
        const bool near = gap <= radius_m + request.path_cap_m;
        // Far from the ball before and after it changes nothing: a body that is not followed there is one that has not
        // come.
        const double gap_there = glm::length(pose.at.position_m - scene.origin_m - local_m()) - reach * pose.at.scale;
        const bool met = track.looked_at || gap_there <= radius_m + request.path_cap_m;
        // Whoever could not go for a long time, and is far by now, is let go.
        const bool gone = track.waited > kLongestWait && gap_there > radius_m + request.path_cap_m + request.margin_m &&
                          work_left_ > 0;
        if (track.present != pose.present || (near && track.jumped) || gone) {
            if (!met) {
                stand(scene, track, pose.at);
                track.from = track.to = pose.at;
                track.present = pose.present;
                track.reach_m = reach * track.frame.scale;
                track.jumped = false;
                continue;
            }
            spend(count_ * kScanWork);
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
        bodies_moved_ = bodies_moved_ || track.looked_at;
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
    path_size_ = 0;
    const double count = std::max(1.0, std::ceil(steps));
    const int most = static_cast<int>(std::min(count, static_cast<double>(kMostSubSteps)));
    bodies_behind_ = true;
    for (int k = 1; k <= most && !bodies_unknown_; ++k) {
        const bool last = k == count;
        if (!sub_step(scene, request, radius_m, last ? 1.0 : k / count)) break;
        if (last) bodies_behind_ = false;
        else if (work_left_ <= 0) break;
    }
    step_.waits = step_.waits || bodies_behind_;
}

// False, and all stays, where there was no time to look at what the bodies bring.
bool ProxySolver::sub_step(const HapticScene& scene, const Request& request, double radius_m, double part) noexcept {
    Vec3 wish = ball_m_;
    bool any = false;
    for (const std::uint16_t b : tracked_ids()) {
        Track& track = track_of(b);
        track.moved = !(track.from == track.to);
        if (!track.moved) continue;
        any = any || track.present;
        const PlacedFrame before = track.frame;
        track.before = track.at;
        stand(scene, track, part == 1.0 ? track.to : between(track.from, track.to, part));
        if (one_sided_count_ > 0) turn_sheets_of(scene, b, before);
        track.reach_m = scene.bodies[b].reach_m * track.frame.scale;
        if (carrier_ == b) wish = track.frame.to_world(before.to_own(local_m())) - anchor_m_;
    }
    if (!any) return true;
    spend(kSubStepWork);
    const double carried = glm::length(wish - ball_m_);
    const double needed = 2.0 * radius_m + carried;  // a push of half a radius, and the radius itself
    if (known_around(ball_m_) < needed) {
        const Vec3 was = ball_m_;
        gather(scene, needed + std::max(request.margin_m, 2.0 * request.path_cap_m), needed);
        wish += ball_m_ - was;
    }
    // What comes in a sub-step must be known, or it would be met too late.
    if (bodies_unknown_ || known_around(ball_m_) < 1.5 * radius_m_ + carried) {
        for (const std::uint16_t b : tracked_ids())
            if (Track& track = track_of(b); track.moved) stand(scene, track, track.before);
        renew_moved_cuts(scene);
        return false;
    }
    renew_moved_cuts(scene);
    make_room(scene, wish);
    return true;
}

// The cuts of bodies that have just moved, where they are now; those that the ball would break are renewed at the ball.
void ProxySolver::renew_moved_cuts(const HapticScene& scene) noexcept {
    for (int i = 0; i < count_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (owners_[at] == kStill || !track_of(owners_[at]).moved) continue;
        const PlacedFrame& frame = track_of(owners_[at]).frame;
        const Vec3 normal = frame.turned(own_cuts_[at].normal);
        cuts_[at] = {normal, own_cuts_[at].offset_m * frame.scale + glm::dot(normal, frame.position_m - anchor_m_)};
        work_left_ -= kTurnWork;
        if (glm::dot(normal, ball_m_) - cuts_[at].offset_m >= radius_m_) continue;
        double distance = 0.0;
        keep_cut(i, support(scene, i, ball_m_, distance));
        work_left_ -= kSupportWork;
    }
    spend(0);
}

// The ball to the free place nearest to a wish; where there is none it shrinks as little as it must. Crushed
// altogether, it lets the bodies pass.
void ProxySolver::make_room(const HapticScene& scene, const Vec3& wish_m) noexcept {
    ProjectionBasis room;
    const auto fits = [&] {
        room.count = 0;
        return project_many(wish_m, room);
    };
    const auto take = [&] {
        step_.pushed = step_.pushed || room.point_m != ball_m_;
        ball_m_ = room.point_m;
    };
    if (fits()) return take();
    for (int i = 0; i < count_; ++i) {
        if (asleep(i)) continue;
        // Where time is short, only those that the ball breaks: with them it fits where it is, if smaller.
        const HalfSpace held = wall(i);
        if (work_left_ <= 0 && glm::dot(held.normal, ball_m_) >= held.offset_m) continue;
        double distance = 0.0;
        keep_cut(i, support(scene, i, ball_m_, distance));
        spend(kSupportWork);
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
            if (i >= count_ || owners_[at] == kStill || !track_of(owners_[at]).moved || asleep(i)) continue;
            double distance = 0.0;
            support(scene, i, ball_m_, distance);
            if (distance < radius_m_ && ghost_count_ < kMaxGhosts)
                ghosts_[static_cast<std::size_t>(ghost_count_++)] = {obstacles_[at], owners_[at]};
        }
        known_m_ = -1.0;
        count_ = 0;
        basis_.count = 0;
        gathers_on_ = bodies_unknown_ = false;
        return;
    }
    ProjectionBasis best = room;
    for (int round = 0; round < 20 && work_left_ > -kMostWork / 4; ++round) {
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

double ProxySolver::in_front_m(const HapticScene& scene, int candidate, const PlacedFrame& frame,
                               const Vec3& at_m) const noexcept {
    const auto i = static_cast<std::size_t>(candidate);
    const Vec3 local = anchor_m_ + at_m;
    if (owners_[i] == kStill) return scene.in_front_m(obstacles_[i], local);
    const HapticScene& shape = *scene.bodies[owners_[i]].shape;
    return shape.in_front_m(obstacles_[i], frame.to_own(local) - shape.origin_m) * frame.scale;
}

// Before candidates are gathered anew: what is awake stays so, even where a moving body has just come nearer than the
// ball's radius.
void ProxySolver::remember_awake() noexcept {
    awake_count_ = 0;
    for (int i = 0; i < count_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (sheets_[at] == Sheet::Awake)
            awake_[static_cast<std::size_t>(awake_count_++)] = {obstacles_[at], owners_[at]};
    }
}

// A sheet of one side acts while the ball is on that side, and only once the ball was there with room to spare: one
// that comes through from behind is not pushed out. True when a sheet woke or fell asleep.
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
            const auto was_awake = [&](const Ghost& g) {
                return g.obstacle == obstacles_[at] && g.body == owners_[at];
            };
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

// After a sub-step of a body: its sleeping sheets whose plane has passed over the ball. Sub-steps are half a radius
// long at most, so one whose own surface passed is still nearer than that, and any other had room to spare.
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

// How much of a step the ball may make before it comes round to the side of a sleeping sheet with room to spare, so
// that the sheet must wake there. Along a straight line the distance to a sheet falls first and rises then, so only
// where the line crosses the sheet's plane can this happen with the ball going on to touch.
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
    if (static_cast<unsigned>(count_ - 1) < static_cast<unsigned>(kComfortableCandidates))  // some and not many
        return project_on_half_spaces(goal_m_, std::span(cuts_).first(static_cast<std::size_t>(count_)), radius_m_,
                                      basis_);
    if (count_ > 0) {
        spend(kRoundWork);
        return project_many(goal_m_, basis_);
    }
    basis_.count = 0;
    basis_.point_m = goal_m_;
    return true;
}

// On all walls, counting the work.
bool ProxySolver::project_many(const Vec3& goal_m, ProjectionBasis& basis) noexcept {
    const auto walls = std::span(cuts_).first(static_cast<std::size_t>(count_));
    int scans = 0;
    const bool solved = projection_detail::exchange(
        goal_m, count_, [this](int i) { return wall(i); },
        [&](const Vec3& point_m) {
            ++scans;
            return projection_detail::most_violated_of(walls, radius_m_, point_m);
        },
        basis);
    spend(scans * (count_ / kCutsOfAWork + kExchangeWork));
    return solved;
}

// A ball that had to shrink grows while the space lets it: pushed out by its own cuts, never through another.
void ProxySolver::grow(const HapticScene& scene, double radius_m, double growth_m) noexcept {
    if (growth_m <= 0.0 || work_left_ <= 0 || step_.truncated) return;  // never into what is not known
    for (int i = 0; i < count_; ++i) {
        if (asleep(i)) continue;
        double distance = 0.0;
        keep_cut(i, support(scene, i, ball_m_, distance));
        spend(kSupportWork);
    }
    const double before = radius_m_;
    double growth = std::min(growth_m, radius_m - radius_m_);
    for (int round = 0; round < 8 && work_left_ > 0; ++round, growth *= 0.5) {
        radius_m_ = before + growth;
        ProjectionBasis grown;
        const bool fits = project_many(ball_m_, grown);
        // In a corner the ball is pushed out farther than it grows; the push, too, is no more than was asked for.
        if (fits && glm::dot(grown.point_m - ball_m_, grown.point_m - ball_m_) <= growth_m * growth_m * (1.0 + 1e-9)) {
            ball_m_ = grown.point_m;
            return;
        }
    }
    radius_m_ = before;
}

double ProxySolver::fraction_inside(const Vec3& step, int* met) const noexcept {
    double fraction = 1.0;
    for (int i = 0; i < count_; ++i) {
        const HalfSpace h = wall(i);
        const double towards = -glm::dot(h.normal, step);
        if (towards <= 0.0) continue;
        const double gap = std::max(0.0, glm::dot(h.normal, ball_m_) - h.offset_m);
        if (gap >= fraction * towards) continue;
        fraction = gap / towards;
        if (met) *met = i;
    }
    return fraction;
}

// Renews the cuts that hold the ball from where it is; true when one of them did not touch or has turned, so another
// round is due. Once per move a cut that does not touch is renewed from where the ball would go without it: sliding
// over a tessellated plane then takes one round per triangle instead of 5 to 20.
template <class Has>
bool ProxySolver::renew_holding_cuts(const HapticScene& scene) noexcept {
    std::array<Vec3, 3> ahead{goal_m_, goal_m_, goal_m_};
    const auto held = [this](int k) { return wall(basis_.index[static_cast<std::size_t>(k)]); };
    if (basis_.count == 2) {
        for (int a = 0; a < 2; ++a) {
            const HalfSpace other = held(1 - a);
            ahead[static_cast<std::size_t>(a)] +=
                other.normal * std::max(0.0, other.offset_m - glm::dot(other.normal, goal_m_));
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
            if (distance_ahead > 1e-12 &&
                glm::dot(further.normal, ball_m_) - further.offset_m >= radius_m_ - kProjectionTolerance_m)
                cut = further;
        }
        keep_cut<Has>(i, cut);
        const Vec3 turn = cut.normal - old_normal;
        stale = stale || apart || glm::dot(turn, turn) * glm::dot(pull, pull) > kTouching_m * kTouching_m;
    }
    return stale;
}

// Round the edge of a solid in one go: when one solid alone holds the ball and the goal lies within the ball's reach
// outside it, or below a smooth part of it, the nearest place is known. Two straight pieces lead there, the first in
// the cut at the ball, the second in the cut at the goal. Without it an edge pressed 4.5 mm deep by a 5 mm ball takes
// 45 rounds.
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
    // A goal inside the solid may be nearer to another face than the one the ball would roll to, unless no edge lies
    // between.
    const auto own = [&](const Vec3& normal) {
        return body == kStill ? normal : track_of(body).frame.turned_back(normal);
    };
    if (at_goal <= 1e-12 && !shape_at(scene, i).smooth_between(obstacle, own(ball_cut.normal), own(goal_cut.normal)))
        return false;
    const Vec3 end = goal_m_ + goal_cut.normal * (radius_m_ - at_goal);
    ProjectionBasis bend;
    const std::array<HalfSpace, 2> both{HalfSpace{ball_cut.normal, ball_cut.offset_m + radius_m_},
                                        HalfSpace{goal_cut.normal, goal_cut.offset_m + radius_m_}};
    if (!project_on_half_spaces(
            0.5 * (ball_m_ + end), 2, [&](int k) { return both[static_cast<std::size_t>(k)]; }, bend))
        return false;
    const Vec3 middle = bend.point_m;
    if (glm::length(middle - ball_m_) + glm::length(end - middle) > way_left_m) return false;
    for (int j = 0; j < count_; ++j) {
        if (j == i) continue;
        const HalfSpace h = wall(j);
        if (glm::dot(h.normal, middle) < h.offset_m - kProjectionTolerance_m ||
            glm::dot(h.normal, end) < h.offset_m - kProjectionTolerance_m)
            return false;
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
    was_free_ = step_.count == 0;
    step_.begin();
    looks_ = 0;
    work_left_ = kMostWork;
    most_rounds_ = std::clamp(request.most_rounds, 1, kMaxIterations);
    if (scene_ != &scene || generation_ != scene.generation) {
        // The same world with something added or removed: the ball is where it was, and what kept it from its goal may
        // be gone.
        scene_ = &scene;
        generation_ = scene.generation;
        if (placed_) hurry_ = kHurryMoves;
        place(scene, request, placed_ ? world_m() - scene.origin_m : goal_local, radius);
    } else if (!placed_) {
        place(scene, request, goal_local, radius);
    }
    ++moves_;
    radius_m_ = std::min(radius_m_, radius);
    if (ghost_count_ > 0) release_ghosts(scene, goal_local, radius, request.ghost_exit_m);
    if (Has::kBodies && body_count_ > 0) {
        all_far_in_ = nullptr;
        watch_bodies(scene, request, radius);
        const std::uint64_t number = request.bodies ? request.bodies->number : 0;
        if (tracked_count_ == 0) bodies_number_ = number, bodies_behind_ = false;
        else if (bodies_behind_ || number != bodies_number_) advance_bodies(scene, request, radius);
    }
    carrier_ = kStill;
    step_.ghosted = ghost_count_ > 0;

    // Everything the ball can meet on this move lies within its path's length and its radius. Where that is more than
    // fits, the move is made in stages, each as far as the candidates are known.
    double way_left = request.path_cap_m;
    if (hurry_ > 0) {
        way_left = std::max(way_left, glm::length(goal_local - local_m()) / hurry_--);
        far_short_ = far_short_ || way_left > request.path_cap_m;
    }
    const double margin = std::max(request.margin_m, 2.0 * way_left);
    path_cap_m_ = way_left;
    rubs_from_ = 0;
    path_size_ = 0;
    const bool looks = request.most_rounds > 0;
    if (looks && known_around<Has>(ball_m_) < way_left + radius) gather(scene, radius + margin, radius + way_left);
    goal_m_ = goal_local - anchor_m_;
    if (Has::kOneSided && one_sided_count_ > 0) turn_sheets(scene);
    if (looks && radius_m_ < radius && !bodies_unknown_) grow(scene, radius, request.growth_m);
    path_[0] = ball_m_;
    path_size_ = 1;
    step_.converged = false;
    int stages_left = looks ? kMaxStages : 0;
    while (step_.iterations < most_rounds_) {
        ++step_.iterations;
        if (Has::kBodies && tracked_count_ > kFewBodies && !tracks_all_)
            spend(static_cast<int>(tracked_count_) * kTurnWork);
        bool solved = project();
        Vec3 way = basis_.point_m - ball_m_;
        if (!solved) way *= fraction_inside(way);
        if (Has::kOneSided && one_sided_count_ > 0) {
            spend(2 * one_sided_count_ * kTurnWork);
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
            if (way_left > 0.0 && stages_left-- > 0 && looks_ < kMostLooks && work_left_ > 0) {
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
    rounds_left_ = looks ? most_rounds_ - step_.iterations : 0;
    return step_;
}

// Where the ball, so far free, first touches something on the hand's own straight way: the solver's path leads straight
// to the resting place and touches only there, and what lies before the first touch is no way along a surface. Each cut
// that is met without touching is renewed from there.
template <class Has>
void ProxySolver::touch_down(const HapticScene& scene) noexcept {
    ball_m_ = path_[0];
    double way_left = path_cap_m_;
    while (rounds_left_ > 0 && work_left_ > 0) {
        --rounds_left_;
        Vec3 way = goal_m_ - ball_m_;
        if (const double length = glm::length(way); length > way_left) way *= way_left / length;
        int met = -1;
        const double fraction = fraction_inside(way, &met);
        ball_m_ += way * fraction;
        way_left -= glm::length(way) * fraction;
        if (met < 0) break;
        double distance = 0.0;
        keep_cut<Has>(met, support<Has>(scene, met, ball_m_, distance));
        if (distance - radius_m_ <= kTouching_m) break;
    }
    path_[1] = ball_m_;
    path_size_ = 2;
    rubs_from_ = 1;
}

// Renews every cut that the ball stands behind, as cuts that were renewed further along may be, and tells the surfaces
// that the ball touches where it is.
template <class Has>
int ProxySolver::touched(const HapticScene& scene, std::array<HalfSpace, kMostTouched>& surfaces) noexcept {
    int count = 0;
    for (int i = 0; i < count_; ++i) {
        const HalfSpace h = wall(i);
        const double slack = glm::dot(h.normal, ball_m_) - h.offset_m;
        const bool behind = slack < -0.1 * kProjectionTolerance_m;
        if (!behind && (slack > kTouching_m || count >= kMostTouched)) continue;
        double distance = 0.0;
        const HalfSpace cut = support<Has>(scene, i, ball_m_, distance);
        if (behind) keep_cut<Has>(i, cut);
        if (distance - radius_m_ <= kTouching_m && count < kMostTouched)
            surfaces[static_cast<std::size_t>(count++)] = {cut.normal, cut.offset_m + radius_m_};
    }
    return count;
}

// The surface that the ball hangs a little above, as where its path bridged a round one: it goes straight down to it. A
// hair above or touching must make no difference.
template <class Has>
int ProxySolver::hangs_over(const HapticScene& scene, const Vec3& goal_m, HalfSpace& surface) noexcept {
    double least = kHangs * radius_m_;
    int count = 0;
    for (int i = 0; i < count_; ++i) {
        const HalfSpace h = wall(i);
        if (glm::dot(h.normal, ball_m_) - h.offset_m >= least) continue;
        double distance = 0.0;
        const HalfSpace cut = support<Has>(scene, i, ball_m_, distance);
        if (distance - radius_m_ >= least || glm::dot(cut.normal, goal_m) >= cut.offset_m + radius_m_) continue;
        keep_cut<Has>(i, cut);
        least = distance - radius_m_;
        surface = {cut.normal, cut.offset_m + radius_m_};
        count = 1;
    }
    return count;
}

// Rounds towards a goal like those of move(), as far as candidates are known; nothing is gathered.
template <class Has>
void ProxySolver::draw(const HapticScene& scene) noexcept {
    ++moves_;
    while (rounds_left_ > 0 && work_left_ > 0) {
        --rounds_left_;
        bool solved = project();
        Vec3 way = basis_.point_m - ball_m_;
        if (!solved) way *= fraction_inside(way);
        if (Has::kOneSided && one_sided_count_ > 0) {
            if (const double fraction = fraction_to_waking(scene, way); fraction < 1.0) {
                way *= fraction;
                solved = false;
            }
        }
        const double length = glm::length(way), known = std::max(0.0, known_around<Has>(ball_m_) - radius_m_);
        const bool short_of = length > known;
        ball_m_ = short_of ? ball_m_ + way * (known / length) : solved ? basis_.point_m : ball_m_ + way;
        path_[static_cast<std::size_t>(path_size_++)] = ball_m_;
        if (short_of) return;
        if (Has::kOneSided && one_sided_count_ > 0 && turn_sheets(scene)) continue;
        if (basis_.count == 0 || !renew_holding_cuts<Has>(scene)) return;
    }
}

// Friction where the ball stands: by the press against what it touches there, not against what it would meet further
// along, and none in the air. The ball stays where it lags less behind than that friction holds, or goes on until it
// lags as much: to where surfaces would let it rest if the hand were drawn back by the lag.
template <class Has>
void ProxySolver::rub(const HapticScene& scene, double share) noexcept {
    const ProjectionBasis rest = basis_;
    const Vec3 goal = goal_m_;
    Vec3 lag = ball_m_ - rest.point_m;
    std::array<HalfSpace, kMostTouched> surfaces;
    for (int round = 0; round < kMostRubs && rounds_left_ > 0 && work_left_ > 0; ++round) {
        int count = touched<Has>(scene, surfaces);
        const bool hangs = count == 0;
        if (hangs) count = hangs_over<Has>(scene, goal, surfaces[0]);
        if (count > 0) {
            ProjectionBasis here;
            project_on_half_spaces(
                goal, count, [&](int i) { return surfaces[static_cast<std::size_t>(i)]; }, here);
            lag = ball_m_ - here.point_m;
            if (hangs) lag -= surfaces[0].normal * glm::dot(lag, surfaces[0].normal);
            const double reach = share * glm::length(here.point_m - goal), length = glm::length(lag);
            if (!hangs && length <= reach + kTouching_m) break;
            if (length > reach) lag *= reach / length;
        }
        goal_m_ = goal + lag;
        draw<Has>(scene);
    }
    goal_m_ = goal;
    basis_ = rest;
}

template <class Has>
void ProxySolver::hold_back(const HapticScene& scene, double reach_m) noexcept {
    const Vec3 target = basis_.point_m;
    const double reach2 = reach_m * reach_m;
    const auto beyond = [&](const Vec3& p) { return glm::dot(p - target, p - target) - reach2; };
    const auto off_a_hold = [&] {
        for (int k = 0; k < basis_.count; ++k) {
            const HalfSpace h = wall(basis_.index[static_cast<std::size_t>(k)]);
            if (glm::dot(h.normal, ball_m_) - h.offset_m > kTouching_m) return true;
        }
        return false;
    };
    bool rubs = rounds_left_ > 0;
    // Where not all of that way is known, as after a gathering that was cut short or lay further along, the path that
    // the ball went is.
    const auto knows_the_way = [&] {
        return known_around<Has>(path_[0]) - radius_m_ >= std::min(path_cap_m_, glm::length(goal_m_ - path_[0]));
    };
    if (was_free_ && rubs && path_size_ > 1 && knows_the_way()) {
        touch_down<Has>(scene);
    } else {
        if (beyond(ball_m_) >= 0.0) return;
        const bool bent = path_size_ > 2;  // pieces of such a path bridge round surfaces
        while (path_size_ > 1) {
            const Vec3 from = path_[static_cast<std::size_t>(path_size_ - 2)];
            const double outside = beyond(from);
            if (outside >= 0.0) {
                const Vec3 way = path_[static_cast<std::size_t>(path_size_ - 1)] - from;
                const double a = glm::dot(way, way), b = glm::dot(way, from - target);
                if (a > 0.0)
                    ball_m_ =
                        from + way * std::clamp((-b - std::sqrt(std::max(0.0, b * b - a * outside))) / a, 0.0, 1.0);
                path_[static_cast<std::size_t>(path_size_ - 1)] = ball_m_;
                break;
            }
            ball_m_ = from;
            --path_size_;
        }
        rubs = rubs && (bent || off_a_hold());
    }
    const double press_m = glm::length(target - goal_m_);
    if (rubs && press_m > 0.0) rub<Has>(scene, reach_m / press_m);
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
