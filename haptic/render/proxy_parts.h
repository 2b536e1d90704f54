// What the parts of ProxySolver share: proxy_solver.cpp makes a move and its rounds, proxy_gather.cpp finds candidates,
// proxy_bodies.cpp follows what moves, proxy_sheets.cpp turns sheets of one side, proxy_friction.cpp walks back from
// where a move ends. Included by these five alone; the same thread and rules as proxy_solver.h.
#pragma once

#include "haptic/render/proxy_solver.h"
#include "haptic/render/tick_assert.h"

namespace handrail::proxy_parts {

inline constexpr double kTouching_m = 1e-8;     // a cut that is this near to its obstacle touches it
inline constexpr double kFarthestLook_m = 4.0;  // free-space bounds beyond this save nothing more

// What the parts of a move take, in units of seven instructions, about a nanosecond on a processor of 2020 when nothing
// is in its caches' way: from what callgrind counts in the worst places (tests/bench/compare.sh, worst), where a unit
// came to 5 to 9 instructions. Only their sum against kMostWork matters.
inline constexpr int kLookWork = 50;     // a node or an obstacle looked at while gathering
inline constexpr int kPlaneWork = 12;    // a plane of a solid, besides that
inline constexpr int kSupportWork = 60;  // a cut renewed
inline constexpr int kRoundWork = 100;   // projecting, besides looking through the candidates
inline constexpr int kHoldWork = 50;     // renewing what holds, times the square of how many hold
inline constexpr int kScanWork = 2;      // a cut looked at
inline constexpr int kDropWork = 6;      // a candidate, when some of all are dropped
inline constexpr int kGlanceWork = 30;   // a body looked at, to see whether it must be followed
inline constexpr int kKnownWork = 12;    // how much is known around a body that is followed
inline constexpr int kCarryWork = 25;    // a body that is followed, in each sub-step
inline constexpr int kCutsOfAWork =
    2;  // so many candidates a projection looks through in one, four at a time: about a nanosecond each
inline constexpr int kExchangeWork = 30;       // of a projection, besides that
inline constexpr int kSubStepWork = 300;       // of bodies, besides their candidates
inline constexpr int kTurnWork = 20;           // a cut of a moving body turned
inline constexpr std::size_t kFewBodies = 16;  // so many need not be counted

inline constexpr int kHurryMoves = 8;  // moves in which the ball reaches a goal that only a vanished thing kept it from

}  // namespace handrail::proxy_parts

namespace handrail {

template <class Has>
HalfSpace ProxySolver::support(const HapticScene& scene, int candidate, const Vec3& at,
                               double& distance_m) const noexcept {
    const auto i = static_cast<std::size_t>(candidate);
    const ClosestPoint found = !Has::kBodies || cuts_.owners[i] == kStill
                                   ? scene.closest(cuts_.obstacles[i], anchor_m_ + at)
                                   : closest_of_body(scene, cuts_.obstacles[i], cuts_.owners[i], anchor_m_ + at);
    distance_m = found.distance_m;
    return {found.normal, glm::dot(found.normal, found.point_m - anchor_m_)};
}

// A body's cut is kept in the body's frame too, where it stays valid however the body moves.
template <class Has>
void ProxySolver::keep_cut(int candidate, const HalfSpace& cut) noexcept {
    tick_assert(candidate >= 0 && candidate < cuts_.count);
    const auto i = static_cast<std::size_t>(candidate);
    cuts_.planes[i] = cut;
    if (!Has::kBodies || cuts_.owners[i] == kStill) return;
    const PlacedFrame& frame = tracks_.of(cuts_.owners[i]).frame;
    cuts_.own_planes[i] = {frame.turned_back(cut.normal),
                           (cut.offset_m + glm::dot(cut.normal, anchor_m_ - frame.position_m)) / frame.scale};
}

template <class Leaves>
void ProxySolver::drop_candidates_of(const Leaves& leaves) noexcept {
    spend(cuts_.count * proxy_parts::kDropWork);
    cuts_.drop_of(leaves);
    basis_.count = 0;
}

}  // namespace handrail
