#include "haptic/render/proxy_parts.h"

#include <algorithm>

namespace handrail::render {

using namespace proxy_parts;

namespace {

// Tolerances for the side of a sheet that the proxy is on. A sheet falls asleep if the proxy's centre is more than
// kSleeps_m behind it, and may wake if the centre is less than kWakes_m behind it. The values differ so that a proxy
// that rests at the border does not switch back and forth.
constexpr double kSleeps_m = 1e-9;
constexpr double kWakes_m = 1e-10;

}  // namespace

double ProxySolver::in_front_m(const HapticScene& scene, int candidate, const PlacedFrame& frame,
                               const Vec3& at_m) const noexcept {
    const auto i = static_cast<std::size_t>(candidate);
    const Vec3 local = anchor_m_ + at_m;
    if (cuts_.owners[i] == kStill) return scene.in_front_m(cuts_.obstacles[i], local);
    const HapticScene& shape = *scene.bodies[cuts_.owners[i]].shape;
    return shape.in_front_m(cuts_.obstacles[i], frame.to_own(local) - shape.origin_m) * frame.scale;
}

// Wakes one-sided sheets, or puts them to sleep. A sheet acts while the proxy is on its touchable side, but only after
// the proxy has been there without touching it. A proxy that comes through from behind is thus not pushed out. Returns
// true if a sheet woke or fell asleep.
bool ProxySolver::turn_sheets(const HapticScene& scene) noexcept {
    bool turned = false;
    for (int i = 0; i < cuts_.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (cuts_.sheets[at] == ProxyCuts::Sheet::No) continue;
        const bool sleeps = cuts_.sheets[at] == ProxyCuts::Sheet::Asleep;
        const double in_front = in_front_m(scene, i, proxy_m_);
        if (sleeps ? in_front < -kWakes_m : in_front >= -kSleeps_m) continue;
        if (sleeps) {
            double distance = 0.0;
            const HalfSpace cut = support(scene, i, proxy_m_, distance);
            if (distance < radius_m_ - kSleeps_m && !cuts_.was_awake(at)) continue;
            keep_cut(i, cut);
        } else {
            keep_cut(i, {cuts_.planes[at].normal, ProxyCuts::kNoCut_m});
        }
        cuts_.sheets[at] = sleeps ? ProxyCuts::Sheet::Awake : ProxyCuts::Sheet::Asleep;
        turned = true;
    }
    return turned;
}

// Wakes the sleeping sheets of a body whose planes have passed over the proxy; called after a sub-step of the body. A
// sub-step is at most half a radius long. So if the sheet itself passed over the proxy, the sheet is still nearer than
// half a radius. If it is farther away, only its plane passed, and the sheet may wake.
void ProxySolver::turn_sheets_of(const HapticScene& scene, std::uint16_t body, const PlacedFrame& before) noexcept {
    for (int i = 0; i < cuts_.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (cuts_.owners[at] != body || cuts_.sheets[at] != ProxyCuts::Sheet::Asleep) continue;
        if (in_front_m(scene, i, before, proxy_m_) >= -kWakes_m || in_front_m(scene, i, proxy_m_) < -kWakes_m) continue;
        double distance = 0.0;
        const HalfSpace cut = support(scene, i, proxy_m_, distance);
        if (distance <= 0.5 * radius_m_) continue;
        keep_cut(i, cut);
        cuts_.sheets[at] = ProxyCuts::Sheet::Awake;
    }
}

// Returns the fraction of a step after which the proxy reaches the front of a sleeping sheet without touching it, so
// that the sheet must wake there. Along a straight line the distance to a sheet first falls and then rises. So the
// sheet must wake only if the line crosses the sheet's plane and the proxy touches the sheet further along.
double ProxySolver::fraction_to_waking(const HapticScene& scene, const Vec3& step) const noexcept {
    double fraction = 1.0;
    for (int i = 0; i < cuts_.count; ++i) {
        if (cuts_.sheets[static_cast<std::size_t>(i)] != ProxyCuts::Sheet::Asleep) continue;
        const double before = in_front_m(scene, i, proxy_m_);
        if (before >= -kWakes_m) continue;
        const double after = in_front_m(scene, i, proxy_m_ + step);
        if (after <= 0.0) continue;
        const double crossing = before / (before - after);
        if (crossing >= fraction) continue;
        double distance = 0.0;
        support(scene, i, proxy_m_ + step * crossing, distance);
        if (distance >= radius_m_ - kSleeps_m) fraction = crossing;
    }
    return fraction;
}

}  // namespace handrail::render
