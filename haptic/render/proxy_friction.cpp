#include "haptic/render/proxy_parts.h"

#include <algorithm>
#include <cmath>

#include "haptic/render/tick_assert.h"

namespace handrail::render {

using namespace proxy_parts;

namespace {

// Greatest number of rounds in which rub() examines the contacts. Flat surfaces need two rounds, round surfaces three.
constexpr int kMostRubs = 6;
// Gap, as a share of the proxy's radius, up to which the proxy hangs over a surface because its path has bridged a
// curve of that surface.
constexpr double kHangs = 0.1;

}  // namespace

// Moves the proxy to the first contact on the hand's straight path. Up to the contact the proxy moved freely, so
// friction must ignore that part. The solver's own path cannot be used, because it leads straight to the resting place
// and touches only there. If the proxy reaches a cut without touching the cut's obstacle, the cut is renewed from
// there.
template <class Has>
void ProxySolver::touch_down(const HapticScene& scene) noexcept {
    proxy_m_ = path_[0];
    double way_left = path_.longest_m;
    while (path_.rounds_left > 0 && work_.left > 0) {
        --path_.rounds_left;
        Vec3 way = goal_m_ - proxy_m_;
        if (const double length = glm::length(way); length > way_left) way *= way_left / length;
        int met = -1;
        const double fraction = fraction_inside(way, &met);
        proxy_m_ += way * fraction;
        way_left -= glm::length(way) * fraction;
        if (met < 0) break;
        double distance = 0.0;
        keep_cut<Has>(met, support<Has>(scene, met, proxy_m_, distance));
        if (distance - radius_m_ <= kTouching_m) break;
    }
    path_[1] = proxy_m_;
    path_.size = 2;
    path_.rubs_from = 1;
}

// Renews every cut whose plane the proxy is behind. This can happen to a cut that was last renewed from a place further
// along the path. Fills `surfaces` with the surfaces that the proxy touches at its place, and returns their number.
template <class Has>
int ProxySolver::touched(const HapticScene& scene, std::array<HalfSpace, kMostTouched>& surfaces) noexcept {
    int count = 0;
    for (int i = 0; i < cuts_.count; ++i) {
        const HalfSpace h = wall(i);
        const double slack = glm::dot(h.normal, proxy_m_) - h.offset_m;
        const bool behind = slack < -0.1 * kProjectionTolerance_m;
        if (!behind && (slack > kTouching_m || count >= kMostTouched)) continue;
        double distance = 0.0;
        const HalfSpace cut = support<Has>(scene, i, proxy_m_, distance);
        if (behind) keep_cut<Has>(i, cut);
        if (distance - radius_m_ <= kTouching_m && count < kMostTouched)
            surfaces[static_cast<std::size_t>(count++)] = {cut.normal, cut.offset_m + radius_m_};
    }
    return count;
}

// Finds the surface over which the proxy hangs at a small distance, for example where its path bridged a curve. The
// caller then moves the proxy straight down to it, so that hanging slightly above gives the same result as touching.
// Returns the number of such surfaces, 0 or 1.
template <class Has>
int ProxySolver::hangs_over(const HapticScene& scene, const Vec3& goal_m, HalfSpace& surface) noexcept {
    double least = kHangs * radius_m_;
    int count = 0;
    for (int i = 0; i < cuts_.count; ++i) {
        const HalfSpace h = wall(i);
        if (glm::dot(h.normal, proxy_m_) - h.offset_m >= least) continue;
        double distance = 0.0;
        const HalfSpace cut = support<Has>(scene, i, proxy_m_, distance);
        if (distance - radius_m_ >= least || glm::dot(cut.normal, goal_m) >= cut.offset_m + radius_m_) continue;
        keep_cut<Has>(i, cut);
        least = distance - radius_m_;
        surface = {cut.normal, cut.offset_m + radius_m_};
        count = 1;
    }
    return count;
}

// Moves the proxy towards goal_m_ by rounds like those of move(), as far as candidates are known. Gathers no
// candidates.
template <class Has>
void ProxySolver::draw(const HapticScene& scene) noexcept {
    ++moves_;
    while (path_.rounds_left > 0 && work_.left > 0) {
        --path_.rounds_left;
        bool solved = project();
        Vec3 way = basis_.point_m - proxy_m_;
        if (!solved) way *= fraction_inside(way);
        if (Has::kOneSided && cuts_.one_sided > 0) {
            if (const double fraction = fraction_to_waking(scene, way); fraction < 1.0) {
                way *= fraction;
                solved = false;
            }
        }
        const double length = glm::length(way), known = std::max(0.0, known_around<Has>(proxy_m_) - radius_m_);
        const bool short_of = length > known;
        proxy_m_ = short_of ? proxy_m_ + way * (known / length) : solved ? basis_.point_m : proxy_m_ + way;
        path_.add(proxy_m_);
        if (short_of) return;
        if (Has::kOneSided && cuts_.one_sided > 0 && turn_sheets(scene)) continue;
        if (basis_.count == 0 || !renew_holding_cuts<Has>(scene)) return;
    }
}

// Applies friction at the proxy's place. The friction depends on the press against the surfaces that the proxy touches
// there, not on those further along, and is zero in the air. The lag is the proxy's distance from where it would rest
// without friction. If friction can hold that lag, the proxy stays. Otherwise it continues until its lag is as much as
// friction can hold.
template <class Has>
void ProxySolver::rub(const HapticScene& scene, double share) noexcept {
    const ProjectionBasis rest = basis_;
    const Vec3 goal = goal_m_;
    Vec3 lag = proxy_m_ - rest.point_m;
    std::array<HalfSpace, kMostTouched> surfaces;
    for (int round = 0; round < kMostRubs && path_.rounds_left > 0 && work_.left > 0; ++round) {
        int count = touched<Has>(scene, surfaces);
        const bool hangs = count == 0;
        if (hangs) count = hangs_over<Has>(scene, goal, surfaces[0]);
        if (count > 0) {
            ProjectionBasis here;
            project_on_half_spaces(
                goal, count, [&](int i) { return surfaces[static_cast<std::size_t>(i)]; }, here);
            lag = proxy_m_ - here.point_m;
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
    tick_assert(reach_m >= 0.0 && step_.count > 0);
    const Vec3 target = basis_.point_m;
    const double reach2 = reach_m * reach_m;
    const auto beyond = [&](const Vec3& p) { return glm::dot(p - target, p - target) - reach2; };
    const auto off_a_hold = [&] {
        for (int k = 0; k < basis_.count; ++k) {
            const HalfSpace h = wall(basis_.index[static_cast<std::size_t>(k)]);
            if (glm::dot(h.normal, proxy_m_) - h.offset_m > kTouching_m) return true;
        }
        return false;
    };
    bool rubs = path_.rounds_left > 0;
    // If candidates on the hand's straight path are missing, because a gathering was cut short or was centred further
    // along, the proxy's actual path is used instead.
    const auto knows_the_way = [&] {
        return known_around<Has>(path_[0]) - radius_m_ >= std::min(path_.longest_m, glm::length(goal_m_ - path_[0]));
    };
    if (path_.was_free && rubs && path_.size > 1 && knows_the_way()) {
        touch_down<Has>(scene);
    } else {
        if (beyond(proxy_m_) >= 0.0) return;
        const bool bent = path_.size > 2;  // a bent path has straight pieces that cut across curved surfaces
        while (path_.size > 1) {
            const Vec3 from = path_[path_.size - 2];
            const double outside = beyond(from);
            if (outside >= 0.0) {
                const Vec3 way = path_[path_.size - 1] - from;
                const double a = glm::dot(way, way), b = glm::dot(way, from - target);
                if (a > 0.0)
                    proxy_m_ =
                        from + way * std::clamp((-b - std::sqrt(std::max(0.0, b * b - a * outside))) / a, 0.0, 1.0);
                path_[path_.size - 1] = proxy_m_;
                break;
            }
            proxy_m_ = from;
            --path_.size;
        }
        rubs = rubs && (bent || off_a_hold());
    }
    const double press_m = glm::length(target - goal_m_);
    if (rubs && press_m > 0.0) rub<Has>(scene, reach_m / press_m);
    // A cut that was renewed further along may exclude the place where the proxy stopped.
    for (int i = 0; i < cuts_.count; ++i) {
        const HalfSpace h = wall(i);
        if (glm::dot(h.normal, proxy_m_) >= h.offset_m - 0.1 * kProjectionTolerance_m) continue;
        double distance = 0.0;
        keep_cut<Has>(i, support<Has>(scene, i, proxy_m_, distance));
    }
}

template void ProxySolver::hold_back<PlainFeatures>(const HapticScene&, double) noexcept;
template void ProxySolver::hold_back<AllFeatures>(const HapticScene&, double) noexcept;

}  // namespace handrail::render
