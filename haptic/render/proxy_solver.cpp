#include "haptic/render/proxy_solver.h"

#include <algorithm>
#include <cmath>

namespace handrail {
namespace {

constexpr double kTouching_m = 1e-8;     // a cut that is this near to its obstacle touches it
constexpr double kFarthestLook_m = 4.0;  // free-space bounds beyond this save nothing more
// Free-space distance is only needed as a lower bound L with kLoose * distance <= L: an exact answer has no useful worst case (in the middle
// of a round room everything is equally near), this one visits a few nodes.
constexpr double kLoose = 0.7;

bool nearer(double distance_a, std::uint32_t a, double distance_b, std::uint32_t b) noexcept {
    return distance_a != distance_b ? distance_a < distance_b : a < b;
}

}  // namespace

ProxySolver::ProxySolver()
    : cuts_(kMaxCandidates), obstacles_(kMaxCandidates), looked_ahead_(kMaxCandidates), nearest_(kMaxCandidates + 1), ghosts_(kMaxGhosts) {}

void ProxySolver::reset() noexcept {
    placed_ = false;
    basis_.count = 0;
    known_m_ = -1.0;
    ghost_count_ = 0;
    gatherings_ = 0;
}

bool ProxySolver::is_ghost(std::uint32_t obstacle) const noexcept {
    return std::find(ghosts_.begin(), ghosts_.begin() + ghost_count_, obstacle) != ghosts_.begin() + ghost_count_;
}

HalfSpace ProxySolver::support(const HapticScene& scene, int candidate, const Vec3& at, double& distance_m) const noexcept {
    const ClosestPoint closest = scene.closest(obstacles_[static_cast<std::size_t>(candidate)], anchor_m_ + at);
    distance_m = closest.distance_m;
    return {closest.normal, glm::dot(closest.normal, closest.point_m - anchor_m_)};
}

// Starts the ball at a place: solids around it become ghosts, anything else nearer than the radius shrinks the ball.
void ProxySolver::place(const HapticScene& scene, const Vec3& local_m, double radius_m) noexcept {
    placed_ = true;
    basis_.count = 0;
    known_m_ = -1.0;
    ghost_count_ = 0;
    scene_origin_m_ = scene.origin_m;
    anchor_m_ = local_m;
    ball_m_ = Vec3(0.0);
    radius_m_ = radius_m;
    scene.obstacle_bvh.within(local_m, radius_m, [&](std::uint32_t item, double&) {
        const double distance = scene.closest(item, local_m).distance_m;
        if (scene.solid(item) && distance <= 0.0) {
            if (ghost_count_ < kMaxGhosts) ghosts_[static_cast<std::size_t>(ghost_count_++)] = item;
        } else {
            radius_m_ = std::min(radius_m_, std::max(distance, kSmallestRadius_m));
        }
    });
}

void ProxySolver::release_ghosts(const HapticScene& scene, const Vec3& goal_local_m, double radius_m, double exit_m) noexcept {
    for (int i = ghost_count_ - 1; i >= 0; --i) {
        const std::uint32_t ghost = ghosts_[static_cast<std::size_t>(i)];
        if (scene.closest(ghost, goal_local_m).distance_m <= radius_m + exit_m || scene.closest(ghost, local_m()).distance_m < radius_m) continue;
        ghosts_[static_cast<std::size_t>(i)] = ghosts_[static_cast<std::size_t>(--ghost_count_)];
        known_m_ = -1.0;
    }
}

// The `most` nearest obstacles within reach into nearest_, as a heap with the farthest on top; false when there were more.
bool ProxySolver::gather_nearest(const HapticScene& scene, const Vec3& at, double reach_m, std::size_t most) noexcept {
    nearest_count_ = 0;
    bool complete = true;
    const auto less = [](const Candidate& a, const Candidate& b) { return nearer(a.distance_m, a.obstacle, b.distance_m, b.obstacle); };
    scene.obstacle_bvh.within(at, reach_m, [&](std::uint32_t item, double& reach) {
        if (ghost_count_ > 0 && is_ghost(item)) return;
        const ClosestPoint closest = scene.closest(item, at);
        if (closest.distance_m > reach) return;
        nearest_[nearest_count_++] = {item, closest.distance_m, {closest.normal, glm::dot(closest.normal, closest.point_m - at)}};
        std::push_heap(nearest_.begin(), nearest_.begin() + static_cast<std::ptrdiff_t>(nearest_count_), less);
        if (nearest_count_ <= most) return;
        std::pop_heap(nearest_.begin(), nearest_.begin() + static_cast<std::ptrdiff_t>(nearest_count_), less);
        --nearest_count_;
        complete = false;
        reach = nearest_[0].distance_m;
    });
    return complete;
}

// Makes every obstacle within reach_m of the ball a candidate, with a fresh cut; where that is too many, as far as the nearest go.
void ProxySolver::gather(const HapticScene& scene, double reach_m, double needed_m) noexcept {
    ++gatherings_;
    const Vec3 at = local_m();
    known_m_ = reach_m;
    if (!gather_nearest(scene, at, reach_m, kComfortableCandidates)) {
        known_m_ = nearest_[0].distance_m;
        if (known_m_ < needed_m) {
            const bool complete = gather_nearest(scene, at, reach_m, kMaxCandidates);
            known_m_ = complete ? reach_m : nearest_[0].distance_m;
            step_.truncated = step_.truncated || known_m_ < needed_m;
        }
    }
    for (int i = 0; i < path_size_; ++i) path_[static_cast<std::size_t>(i)] -= ball_m_;
    anchor_m_ = at;
    ball_m_ = Vec3(0.0);
    basis_.count = 0;
    count_ = static_cast<int>(nearest_count_);
    for (std::size_t i = 0; i < nearest_count_; ++i) {
        cuts_[i] = nearest_[i].cut;
        obstacles_[i] = nearest_[i].obstacle;
        looked_ahead_[i] = 0;
    }
    if (count_ > 0) return;
    double best = std::max(kFarthestLook_m, 2.0 * reach_m);
    scene.obstacle_bvh.within(at, kLoose * best, [&](std::uint32_t item, double& reach) {
        if (ghost_count_ > 0 && is_ghost(item)) return;
        best = std::min(best, scene.closest(item, at).distance_m);
        reach = std::min(reach, kLoose * best);
    });
    known_m_ = std::max(reach_m, kLoose * best);
}

bool ProxySolver::project() noexcept {
    return project_on_half_spaces(
        goal_m_, count_, [this](int i) { return wall(i); }, basis_);
}

// A ball that had to shrink grows while the space lets it: pushed out by its own cuts, never through another.
void ProxySolver::grow(const HapticScene& scene, double radius_m, double growth_m) noexcept {
    if (radius_m_ >= radius_m) {
        radius_m_ = radius_m;
        return;
    }
    if (growth_m <= 0.0) return;
    for (int i = 0; i < count_; ++i) {
        double distance = 0.0;
        cuts_[static_cast<std::size_t>(i)] = support(scene, i, ball_m_, distance);
    }
    const double before = radius_m_;
    radius_m_ = std::min(radius_m, radius_m_ + growth_m);
    ProjectionBasis grown;
    if (project_on_half_spaces(
            ball_m_, count_, [this](int i) { return wall(i); }, grown)) {
        ball_m_ = grown.point_m;
    } else {
        radius_m_ = before;
    }
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
        HalfSpace& cut = cuts_[static_cast<std::size_t>(i)];
        const Vec3 old_normal = cut.normal;
        double distance = 0.0;
        cut = support(scene, i, ball_m_, distance);
        const bool apart = distance - radius_m_ > kTouching_m;
        if (apart && looked_ahead_[static_cast<std::size_t>(i)] != moves_) {
            looked_ahead_[static_cast<std::size_t>(i)] = moves_;
            double distance_ahead = 0.0;
            const HalfSpace further = support(scene, i, ahead[static_cast<std::size_t>(a)], distance_ahead);
            if (distance_ahead > 1e-12 && glm::dot(further.normal, ball_m_) - further.offset_m >= radius_m_ - kProjectionTolerance_m) cut = further;
        }
        const Vec3 turn = cut.normal - old_normal;
        stale = stale || apart || glm::dot(turn, turn) * glm::dot(pull, pull) > kTouching_m * kTouching_m;
    }
    return stale;
}

// Round the edge of a solid in one go: when one solid alone holds the ball and the goal lies within the ball's reach outside it, the nearest
// place is known. Two straight pieces lead there, the first in the cut at the ball, the second in the cut at the goal. Without it an edge
// pressed 4.5 mm deep by a 5 mm ball takes 45 rounds.
bool ProxySolver::arc_step(const HapticScene& scene, double way_left_m) noexcept {
    if (basis_.count != 1) return false;
    const int i = basis_.index[0];
    if (!scene.solid(obstacles_[static_cast<std::size_t>(i)])) return false;
    double at_goal = 0.0, at_ball = 0.0;
    const HalfSpace goal_cut = support(scene, i, goal_m_, at_goal);
    if (!(at_goal > 1e-12 && at_goal < radius_m_)) return false;
    const HalfSpace ball_cut = support(scene, i, ball_m_, at_ball);
    const double turn = glm::dot(ball_cut.normal, goal_cut.normal);
    if (!(turn > 0.5 && turn < 1.0 - 1e-14)) return false;
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
    cuts_[static_cast<std::size_t>(i)] = goal_cut;
    path_[static_cast<std::size_t>(path_size_++)] = middle;
    path_[static_cast<std::size_t>(path_size_++)] = end;
    ball_m_ = end;
    basis_.multiplier_m[0] = radius_m_ - at_goal;
    basis_.point_m = end;
    return true;
}

const ProxySolver::Step& ProxySolver::move(const HapticScene& scene, const Request& request) noexcept {
    const double radius = std::max(request.radius_m, kSmallestRadius_m);
    const Vec3 goal_local = request.goal_m - scene.origin_m;
    if (scene_ != &scene || generation_ != scene.generation) {
        scene_ = &scene;
        generation_ = scene.generation;
        place(scene, placed_ ? world_m() - scene.origin_m : goal_local, radius);
    } else if (!placed_) {
        place(scene, goal_local, radius);
    }
    ++moves_;
    step_ = Step{};
    radius_m_ = std::min(radius_m_, radius);
    if (ghost_count_ > 0) release_ghosts(scene, goal_local, radius, request.ghost_exit_m);
    step_.ghosted = ghost_count_ > 0;

    // Everything the ball can meet on this move lies within its path's length and its radius. Where that is more than fits, the move is made in
    // stages, each as far as the candidates are known.
    const double margin = std::max(request.margin_m, 2.0 * request.path_cap_m);
    double way_left = request.path_cap_m;
    path_size_ = 0;
    const bool looks = request.most_rounds > 0;
    if (looks && glm::length(ball_m_) + way_left + radius > known_m_) gather(scene, radius + margin, radius + way_left);
    goal_m_ = goal_local - anchor_m_;
    if (looks) grow(scene, radius, request.growth_m);
    path_[0] = ball_m_;
    path_size_ = 1;
    step_.converged = false;
    const int most_rounds = std::clamp(request.most_rounds, 1, kMaxIterations);
    int stages_left = looks ? kMaxStages : 0;
    while (step_.iterations < most_rounds) {
        ++step_.iterations;
        const bool solved = project();
        Vec3 way = basis_.point_m - ball_m_;
        if (!solved) way *= fraction_inside(way);
        const double length = glm::length(way);
        const double known_way = known_m_ - radius - glm::length(ball_m_);
        if (length > 0.0 && length > std::min(way_left, known_way)) {
            const double part = std::clamp(known_way, 0.0, way_left);
            ball_m_ += way * (part / length);
            path_[static_cast<std::size_t>(path_size_++)] = ball_m_;
            way_left -= part;
            if (way_left > 0.0 && stages_left-- > 0) {
                gather(scene, radius + margin, radius + way_left);
                goal_m_ = goal_local - anchor_m_;
                if (known_m_ > radius) continue;
            }
            step_.capped = true;
            break;
        }
        way_left -= length;
        ball_m_ = solved ? basis_.point_m : ball_m_ + way;
        path_[static_cast<std::size_t>(path_size_++)] = ball_m_;
        if (basis_.count == 0) {
            step_.converged = solved;
            break;
        }
        if (!looks) break;
        if (!renew_holding_cuts(scene)) {
            step_.converged = solved;
            break;
        }
        if (solved && arc_step(scene, std::min(way_left, known_m_ - radius - glm::length(ball_m_)))) {
            step_.converged = true;
            break;
        }
    }
    for (int k = 0; k < basis_.count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const auto i = static_cast<std::size_t>(basis_.index[at]);
        step_.holds[at] = {obstacles_[i], cuts_[i].normal, basis_.multiplier_m[at]};
    }
    step_.count = basis_.count;
    return step_;
}

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
        cuts_[static_cast<std::size_t>(i)] = support(scene, i, ball_m_, distance);
    }
}

}  // namespace handrail
