// Definitions that the parts of ProxySolver share: proxy_solver.cpp makes a move and its rounds, proxy_gather.cpp finds
// candidates, proxy_bodies.cpp follows moving bodies, proxy_sheets.cpp wakes one-sided sheets, proxy_friction.cpp moves
// the proxy back for friction. Only these five files include it; the thread and rules are those of proxy_solver.h.
#pragma once

#include "haptic/render/proxy_solver.h"
#include "haptic/render/tick_assert.h"

namespace handrail::render::proxy_parts {

// Greatest distance between a cut and its obstacle at which the cut touches the obstacle.
inline constexpr double kTouching_m = 1e-8;
inline constexpr double kFarthestLook_m = 4.0;  // greatest useful lower bound for the free distance

// Costs of the parts of a move, in units of seven instructions. A unit takes about a nanosecond on a processor of 2020
// if all data are in its caches. The costs come from callgrind counts in the worst places (tests/bench/compare.sh,
// worst), where a unit came to 5 to 9 instructions. Only their sum matters, which is compared with kMostWork.
inline constexpr int kLookWork = 50;     // visiting a node or an obstacle while gathering
inline constexpr int kPlaneWork = 12;    // each plane of a visited solid, in addition to kLookWork
inline constexpr int kSupportWork = 60;  // renewing a cut
inline constexpr int kRoundWork = 100;   // a projection, without scanning the candidates
inline constexpr int kHoldWork = 50;     // renewing the holding cuts, times the square of their number
inline constexpr int kScanWork = 2;      // examining a cut
inline constexpr int kDropWork = 6;      // dropping some candidates, for each existing candidate
inline constexpr int kGlanceWork = 30;   // examining a body and deciding whether it must be followed
inline constexpr int kKnownWork = 12;    // finding how much is known around a followed body
inline constexpr int kCarryWork = 25;    // moving a followed body along its path, in each sub-step
// Number of candidates that a projection scans for one unit. It scans four at a time, which takes about a nanosecond
// each.
inline constexpr int kCutsOfAWork = 2;
inline constexpr int kExchangeWork = 30;       // each scan of a projection, in addition to its candidates
inline constexpr int kSubStepWork = 300;       // a sub-step of bodies, without their candidates
inline constexpr int kTurnWork = 20;           // rotating a cut of a moving body
inline constexpr std::size_t kFewBodies = 16;  // for at most this many bodies, the work is not counted

// Number of moves in which the proxy hurries to its goal after the obstacle between them has vanished.
inline constexpr int kHurryMoves = 8;

}  // namespace handrail::render::proxy_parts

namespace handrail::render {

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

// Stores a renewed cut. A body's cut is also stored in the body's frame, where it stays valid however the body moves.
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

}  // namespace handrail::render
