#include "haptic/render/proxy_parts.h"

#include <algorithm>
#include <cmath>

#include "haptic/render/tick_assert.h"

namespace handrail::render {

using namespace proxy_parts;

void ProxySolver::reset() noexcept {
    placed_ = false;
    all_far_in_ = nullptr;
    basis_.count = 0;
    known_m_ = -1.0;
    dense_m_ = kFarthestLook_m;
    ghosts_.clear();
    gatherings_ = 0;
    carrier_ = kStill;
    hurry_ = 0;
    gathers_on_ = tracks_.unknown = tracks_.behind = crowded_ = false;
}

ClosestPoint ProxySolver::closest_of_body(const HapticScene& scene, std::uint32_t obstacle, std::uint16_t body,
                                          const Vec3& local_m) const noexcept {
    const HapticScene& shape = *scene.bodies[body].shape;
    const PlacedFrame& frame = tracks_.of(body).frame;
    ClosestPoint found = shape.closest(obstacle, frame.to_own(local_m) - shape.origin_m);
    found.point_m = frame.to_world(found.point_m + shape.origin_m);
    found.normal = frame.turned(found.normal);
    found.distance_m *= frame.scale;
    return found;
}

Vec3 ProxySolver::to_own(const HapticScene& scene, const Hold& hold, const Vec3& world_m) const noexcept {
    const Vec3 local = world_m - scene.origin_m;
    return hold.body == kStill ? local
                               : tracks_.of(hold.body).frame.to_own(local) - scene.bodies[hold.body].shape->origin_m;
}

// Starts the proxy at a place. Solids that contain the place become ghosts. Any other obstacle nearer than the radius
// makes the proxy shrink.
void ProxySolver::place(const HapticScene& scene, const Request& request, const Vec3& local_m,
                        double radius_m) noexcept {
    placed_ = true;
    all_far_in_ = nullptr;
    basis_.count = 0;
    known_m_ = -1.0;
    ghosts_.clear();
    cuts_.clear();
    gathers_on_ = tracks_.unknown = false;
    carrier_ = kStill;
    scene_origin_m_ = scene.origin_m;
    anchor_m_ = local_m;
    proxy_m_ = Vec3(0.0);
    radius_m_ = radius_m;
    take_bodies(scene, request, radius_m);
    place_in(scene, kStill, radius_m);
    for (const std::uint16_t b : tracks_.ids()) place_in(scene, b, radius_m);
}

// Makes a ghost solid again as soon as the whole proxy is outside the ghost, wherever the goal is. A proxy that has
// been outside must never enter. The hand feels no knock, because a proxy that already rests nearest to its goal stays
// there when the new cut is added.
void ProxySolver::release_ghosts(const HapticScene& scene) noexcept {
    for (int i = ghosts_.count() - 1; i >= 0; --i) {
        const OwnedObstacle ghost = ghosts_[i];
        const ClosestPoint nearest = ghost.body == kStill
                                         ? scene.closest(ghost.obstacle, local_m())
                                         : closest_of_body(scene, ghost.obstacle, ghost.body, local_m());
        if (nearest.distance_m < radius_m_) continue;
        ghosts_.remove(i);
        known_m_ = -1.0;
        gathers_on_ = tracks_.unknown = false;
    }
}

bool ProxySolver::project() noexcept {
    spend(kRoundWork);
    // True if there is at least one candidate, but no more than kComfortableCandidates.
    if (static_cast<unsigned>(cuts_.count - 1) < static_cast<unsigned>(kComfortableCandidates))
        return project_on_half_spaces(goal_m_, cuts_.in_use(), radius_m_, basis_);
    if (cuts_.count > 0) return project_many(goal_m_, basis_);
    basis_.count = 0;
    basis_.point_m = goal_m_;
    return true;
}

// Projects a goal on the walls of all candidates and counts the work.
bool ProxySolver::project_many(const Vec3& goal_m, ProjectionBasis& basis) noexcept {
    const auto walls = cuts_.in_use();
    int scans = 0;
    const bool solved = projection_detail::exchange(
        goal_m, cuts_.count, [this](int i) { return wall(i); },
        [&](const Vec3& point_m) {
            ++scans;
            return projection_detail::most_violated_of(walls, radius_m_, point_m);
        },
        basis);
    spend(scans * (cuts_.count / kCutsOfAWork + kExchangeWork));
    return solved;
}

// Lets a proxy that had to shrink grow again while there is room. The cuts at the proxy push it away from their
// obstacles as it grows, and it never goes through another obstacle.
void ProxySolver::grow(const HapticScene& scene, double radius_m, double growth_m) noexcept {
    if (growth_m <= 0.0 || work_.left <= 0 || step_.truncated) return;  // the proxy never grows into unknown space
    for (int i = 0; i < cuts_.count; ++i) {
        if (cuts_.asleep(i)) continue;
        double distance = 0.0;
        keep_cut(i, support(scene, i, proxy_m_, distance));
        spend(kSupportWork);
    }
    const double before = radius_m_;
    double growth = std::min(growth_m, radius_m - radius_m_);
    for (int round = 0; round < 8 && work_.left > 0; ++round, growth *= 0.5) {
        radius_m_ = before + growth;
        ProjectionBasis grown;
        const bool fits = project_many(proxy_m_, grown);
        // In a corner the proxy is pushed farther than it grows. The push, too, must be no longer than `growth_m`.
        if (fits &&
            glm::dot(grown.point_m - proxy_m_, grown.point_m - proxy_m_) <= growth_m * growth_m * (1.0 + 1e-9)) {
            proxy_m_ = grown.point_m;
            return;
        }
    }
    radius_m_ = before;
}

double ProxySolver::fraction_inside(const Vec3& step, int* met) const noexcept {
    double fraction = 1.0;
    for (int i = 0; i < cuts_.count; ++i) {
        const HalfSpace h = wall(i);
        const double towards = -glm::dot(h.normal, step);
        if (towards <= 0.0) continue;
        const double gap = std::max(0.0, glm::dot(h.normal, proxy_m_) - h.offset_m);
        if (gap >= fraction * towards) continue;
        fraction = gap / towards;
        if (met) *met = i;
    }
    return fraction;
}

// Renews the cuts that hold the proxy, from the proxy's place. Returns true if another round is due, because a cut did
// not touch its obstacle or has turned. A cut that does not touch its obstacle is renewed, once in each move, from the
// place to which the proxy would go without that cut. Sliding over a tessellated plane then takes one round for each
// triangle instead of 5 to 20.
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
    spend(kHoldWork * basis_.count * basis_.count);
    const Vec3 pull = goal_m_ - proxy_m_;
    bool stale = false;
    for (int a = 0; a < basis_.count; ++a) {
        const int i = basis_.index[static_cast<std::size_t>(a)];
        const Vec3 old_normal = cuts_.planes[static_cast<std::size_t>(i)].normal;
        double distance = 0.0;
        HalfSpace cut = support<Has>(scene, i, proxy_m_, distance);
        const bool apart = distance - radius_m_ > kTouching_m;
        if (apart && cuts_.looked_ahead[static_cast<std::size_t>(i)] != moves_) {
            cuts_.looked_ahead[static_cast<std::size_t>(i)] = moves_;
            double distance_ahead = 0.0;
            const HalfSpace further = support<Has>(scene, i, ahead[static_cast<std::size_t>(a)], distance_ahead);
            if (distance_ahead > 1e-12 &&
                glm::dot(further.normal, proxy_m_) - further.offset_m >= radius_m_ - kProjectionTolerance_m)
                cut = further;
        }
        keep_cut<Has>(i, cut);
        const Vec3 turn = cut.normal - old_normal;
        stale = stale || apart || glm::dot(turn, turn) * glm::dot(pull, pull) > kTouching_m * kTouching_m;
    }
    return stale;
}

// Rolls round the edge of a solid in one step. The step is possible if a single solid holds the proxy and the goal is
// either outside that solid, within the proxy's radius, or below a smooth part of it. Then the final place of the proxy
// is known. A path of two straight pieces leads there, the first in the cut at the proxy, the second in the cut at the
// goal. Without this step, an edge pressed 4.5 mm deep by a 5 mm proxy takes 45 rounds.
bool ProxySolver::arc_step(const HapticScene& scene, double way_left_m) noexcept {
    if (basis_.count != 1 || cuts_.one_sided > 0) return false;
    const int i = basis_.index[0];
    const std::uint32_t obstacle = cuts_.obstacles[static_cast<std::size_t>(i)];
    const std::uint16_t body = cuts_.owners[static_cast<std::size_t>(i)];
    if (!shape_at(scene, i).solid(obstacle)) return false;
    double at_goal = 0.0, at_proxy = 0.0;
    const HalfSpace goal_cut = support(scene, i, goal_m_, at_goal);
    if (!(at_goal < radius_m_)) return false;
    const HalfSpace proxy_cut = support(scene, i, proxy_m_, at_proxy);
    const double turn = glm::dot(proxy_cut.normal, goal_cut.normal);
    if (!(turn > 0.5 && turn < 1.0 - 1e-14)) return false;
    // A goal inside the solid may be nearer to another face than to the one to which the proxy would roll, unless the
    // two faces are one smooth surface.
    const auto own = [&](const Vec3& normal) {
        return body == kStill ? normal : tracks_.of(body).frame.turned_back(normal);
    };
    if (at_goal <= 1e-12 && !shape_at(scene, i).smooth_between(obstacle, own(proxy_cut.normal), own(goal_cut.normal)))
        return false;
    const Vec3 end = goal_m_ + goal_cut.normal * (radius_m_ - at_goal);
    ProjectionBasis bend;
    const std::array<HalfSpace, 2> both{HalfSpace{proxy_cut.normal, proxy_cut.offset_m + radius_m_},
                                        HalfSpace{goal_cut.normal, goal_cut.offset_m + radius_m_}};
    if (!project_on_half_spaces(
            0.5 * (proxy_m_ + end), 2, [&](int k) { return both[static_cast<std::size_t>(k)]; }, bend))
        return false;
    const Vec3 middle = bend.point_m;
    if (glm::length(middle - proxy_m_) + glm::length(end - middle) > way_left_m) return false;
    for (int j = 0; j < cuts_.count; ++j) {
        if (j == i) continue;
        const HalfSpace h = wall(j);
        if (glm::dot(h.normal, middle) < h.offset_m - kProjectionTolerance_m ||
            glm::dot(h.normal, end) < h.offset_m - kProjectionTolerance_m)
            return false;
    }
    keep_cut(i, goal_cut);
    path_.add(middle);
    path_.add(end);
    proxy_m_ = end;
    basis_.multiplier_m[0] = radius_m_ - at_goal;
    basis_.point_m = end;
    return true;
}

template <class Has>
const ProxySolver::Step& ProxySolver::move(const HapticScene& scene, const Request& request) noexcept {
    tick_assert(is_finite(request.goal_m) && request.path_cap_m >= 0.0 && request.margin_m >= 0.0);
    tick_assert(request.growth_m >= 0.0);
    const double radius = std::max(request.radius_m, kSmallestRadius_m);
    const Vec3 goal_local = request.goal_m - scene.origin_m;
    path_.was_free = step_.count == 0;
    step_.begin();
    work_.looks = 0;
    work_.left = kMostWork;
    work_.most_rounds = std::clamp(request.most_rounds, 1, kMaxIterations);
    if (scene_ != &scene || generation_ != scene.generation) {
        // The scene has changed, but is the same world with something added or removed. The proxy stays where it was,
        // and an obstacle between the proxy and its goal may have vanished.
        scene_ = &scene;
        generation_ = scene.generation;
        if (placed_) hurry_ = kHurryMoves;
        place(scene, request, placed_ ? world_m() - scene.origin_m : goal_local, radius);
    } else if (!placed_) {
        place(scene, request, goal_local, radius);
    }
    ++moves_;
    radius_m_ = std::min(radius_m_, radius);
    if (ghosts_.count() > 0) release_ghosts(scene);
    if (Has::kBodies && tracks_.bodies > 0) {
        all_far_in_ = nullptr;
        watch_bodies(scene, request, radius);
        const std::uint64_t number = request.bodies ? request.bodies->number : 0;
        if (tracks_.count == 0) tracks_.number = number, tracks_.behind = false;
        else if (tracks_.behind || number != tracks_.number) advance_bodies(scene, request, radius);
    }
    carrier_ = kStill;
    step_.ghosted = ghosts_.count() > 0;

    // The proxy can meet only obstacles within the path's length plus its radius. If these are too many, the move is
    // made in stages, each as far as the candidates are known.
    double way_left = request.path_cap_m;
    if (hurry_ > 0) {
        way_left = std::max(way_left, glm::length(goal_local - local_m()) / hurry_--);
        tracks_.far_short = tracks_.far_short || way_left > request.path_cap_m;
    }
    const double margin = std::max(request.margin_m, 2.0 * way_left);
    path_.longest_m = way_left;
    path_.rubs_from = 0;
    path_.size = 0;
    const bool looks = request.most_rounds > 0;
    if (looks && known_around<Has>(proxy_m_) < way_left + radius) gather(scene, radius + margin, radius + way_left);
    goal_m_ = goal_local - anchor_m_;
    if (Has::kOneSided && cuts_.one_sided > 0) turn_sheets(scene);
    if (looks && radius_m_ < radius && !tracks_.unknown) grow(scene, radius, request.growth_m);
    path_.begin(proxy_m_);
    step_.converged = false;
    int stages_left = looks ? kMaxStages : 0;
    while (step_.iterations < work_.most_rounds) {
        ++step_.iterations;
        bool solved = project();
        Vec3 way = basis_.point_m - proxy_m_;
        if (!solved) way *= fraction_inside(way);
        if (Has::kOneSided && cuts_.one_sided > 0) {
            spend(2 * cuts_.one_sided * kTurnWork);
            if (const double fraction = fraction_to_waking(scene, way); fraction < 1.0) {
                way *= fraction;
                solved = false;
            }
        }
        const double length = glm::length(way);
        const double known_way = known_around<Has>(proxy_m_) - radius;
        if (length > 0.0 && length > std::min(way_left, known_way)) {
            const double part = std::clamp(known_way, 0.0, way_left);
            proxy_m_ += way * (part / length);
            path_.add(proxy_m_);
            way_left -= part;
            if (way_left > 0.0 && stages_left-- > 0 && work_.looks < kMostLooks && work_.left > 0) {
                gather(scene, radius + margin, radius + way_left);
                goal_m_ = goal_local - anchor_m_;
                if (known_around<Has>(proxy_m_) > radius) continue;
            }
            step_.capped = true;
            break;
        }
        way_left -= length;
        proxy_m_ = solved ? basis_.point_m : proxy_m_ + way;
        path_.add(proxy_m_);
        if (Has::kOneSided && cuts_.one_sided > 0 && turn_sheets(scene)) continue;
        if (basis_.count == 0) {
            step_.converged = solved;
            break;
        }
        if (!looks) break;
        if (!renew_holding_cuts<Has>(scene)) {
            step_.converged = solved;
            break;
        }
        if (solved && arc_step(scene, std::min(way_left, known_around<Has>(proxy_m_) - radius))) {
            step_.converged = true;
            break;
        }
    }
    for (int k = 0; k < basis_.count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const auto i = static_cast<std::size_t>(basis_.index[at]);
        step_.holds[at] = {cuts_.obstacles[i], cuts_.owners[i], cuts_.planes[i].normal, basis_.multiplier_m[at]};
    }
    step_.count = basis_.count;
    tick_assert(step_.count >= 0 && step_.count <= 3 && step_.iterations <= kMaxIterations);
    tick_assert(is_finite(proxy_m_) && radius_m_ >= kSmallestRadius_m && radius_m_ <= radius);
    path_.rounds_left = looks ? work_.most_rounds - step_.iterations : 0;
    return step_;
}

template bool ProxySolver::renew_holding_cuts<PlainFeatures>(const HapticScene&) noexcept;
template bool ProxySolver::renew_holding_cuts<AllFeatures>(const HapticScene&) noexcept;
template const ProxySolver::Step& ProxySolver::move<PlainFeatures>(const HapticScene&, const Request&) noexcept;
template const ProxySolver::Step& ProxySolver::move<AllFeatures>(const HapticScene&, const Request&) noexcept;

}  // namespace handrail::render
