// Finds the point of an intersection of half-spaces that is nearest to a goal. This is a quadratic programme in three
// variables with at most three active constraints, solved exactly by dual basis exchange. The renderer uses it to move
// the proxy and to find the closest point of a convex brush. Pure functions without allocation or exceptions; any
// thread. Cost: a few scans of all half-spaces, with 4 multiplications each. The program uses double precision
// everywhere; the scalar type is a parameter only so that a test can compare with single precision. Source of the
// scheme: Sharir & Welzl, A combinatorial bound for linear programming and related problems, STACS 1992 (LP-type
// problems).
#pragma once

#include <array>
#include <cstring>
#include <span>

#include "worlds/base/vec.h"

namespace handrail {

// A half-space: the points p with dot(normal, p) >= offset_m. The normal has length 1.
template <class Real>
struct BasicHalfSpace {
    glm::vec<3, Real> normal{0, 0, 1};
    Real offset_m = 0;
};
using HalfSpace = BasicHalfSpace<double>;

// A point violates a half-space if it is outside the half-space by more than this. The limit is far below anything that
// a hand feels, and far above rounding errors within 1 km of the local origin.
inline constexpr double kProjectionTolerance_m = 1e-10;
template <class Real>
inline constexpr Real kProjectionToleranceOf = static_cast<Real>(kProjectionTolerance_m);
template <>
inline constexpr float kProjectionToleranceOf<float> = 1e-7F;

// The result of a projection, which is also the warm start of the next one: the half-spaces whose borders the point is
// on, and a multiplier for each.
template <class Real>
struct BasicProjectionBasis {
    int count = 0;
    std::array<int, 3> index{};
    // Multipliers of the half-spaces, >= 0; point - goal == sum of multiplier * normal.
    std::array<Real, 3> multiplier_m{};
    glm::vec<3, Real> point_m{0};
};
using ProjectionBasis = BasicProjectionBasis<double>;

namespace projection_detail {

template <class Real>
struct Member {
    glm::vec<3, Real> normal;
    Real offset_m;  // offset relative to the goal
    int index;
};

// Finds the optimum for `count` half-spaces (1 to 4), of which the last is certainly active. Returns false if no subset
// of at most three members is a solution. Duplicates, opposite walls (pairs) and triples of nearly coplanar normals
// have no usable solution and are skipped. Triples are skipped only at a far smaller determinant than pairs. The
// reason: in a crevice of half a degree, a proxy that slides from one triangle of a wall to the next touches three
// half-spaces whose determinant is 1e-9. If solve() skipped them, the proxy would stop although these three constrain
// it (test: random grooves).
template <class Real>
bool solve(const std::array<Member<Real>, 4>& members, int count, const glm::vec<3, Real>& goal_m,
           BasicProjectionBasis<Real>& out) noexcept {
    using V = glm::vec<3, Real>;
    constexpr Real kSingularPair = static_cast<Real>(1e-12), kThinTriple = static_cast<Real>(1e-12);
    constexpr Real kSingularTriple = sizeof(Real) > 4 ? static_cast<Real>(1e-20) : kThinTriple;
    const int last = count - 1;
    const Member<Real>& m = members[static_cast<std::size_t>(last)];
    const auto feasible = [&](const V& d, int a, int b) {
        for (int k = 0; k < last; ++k) {
            if (k == a || k == b) continue;
            const Member<Real>& other = members[static_cast<std::size_t>(k)];
            if (glm::dot(other.normal, d) - other.offset_m < -2 * kProjectionToleranceOf<Real>) return false;
        }
        return true;
    };
    if (m.offset_m >= 0) {
        const V d = m.normal * m.offset_m;
        if (feasible(d, -1, -1)) {
            out.count = 1;
            out.index[0] = m.index;
            out.multiplier_m[0] = m.offset_m;
            out.point_m = goal_m + d;
            return true;
        }
    }
    for (int j = 0; j < last; ++j) {
        const Member<Real>& p = members[static_cast<std::size_t>(j)];
        const V along = glm::cross(m.normal, p.normal);
        const Real det = glm::dot(along, along);
        if (det < kSingularPair) continue;
        const Real c = glm::dot(m.normal, p.normal);
        const Real lm = (m.offset_m - c * p.offset_m) / det;
        const Real lp = (p.offset_m - c * m.offset_m) / det;
        if (lm < 0 || lp < 0) continue;
        const V d = m.normal * lm + p.normal * lp;
        if (!feasible(d, j, -1)) continue;
        out.count = 2;
        out.index = {m.index, p.index, 0};
        out.multiplier_m = {lm, lp, 0};
        out.point_m = goal_m + d;
        return true;
    }
    for (int j = 0; j < last; ++j) {
        for (int k = j + 1; k < last; ++k) {
            const Member<Real>& p = members[static_cast<std::size_t>(j)];
            const Member<Real>& q = members[static_cast<std::size_t>(k)];
            const V pq = glm::cross(p.normal, q.normal);
            const V qm = glm::cross(q.normal, m.normal);
            const V mp = glm::cross(m.normal, p.normal);
            const Real det = glm::dot(m.normal, pq);
            if (det * det < kSingularTriple) continue;
            const auto meeting = [&](Real of_m, Real of_p, Real of_q) {
                return (pq * of_m + qm * of_p + mp * of_q) / det;
            };
            V d = meeting(m.offset_m, p.offset_m, q.offset_m);
            // A triple with a small determinant loses digits, so the remaining error is solved for once more and added.
            if (det * det < kThinTriple)
                d += meeting(m.offset_m - glm::dot(m.normal, d), p.offset_m - glm::dot(p.normal, d),
                             q.offset_m - glm::dot(q.normal, d));
            const Real lm = glm::dot(d, pq) / det;
            const Real lp = glm::dot(d, qm) / det;
            const Real lq = glm::dot(d, mp) / det;
            if (lm < 0 || lp < 0 || lq < 0 || !feasible(d, j, k)) continue;
            out.count = 3;
            out.index = {m.index, p.index, q.index};
            out.multiplier_m = {lm, lp, lq};
            out.point_m = goal_m + d;
            return true;
        }
    }
    return false;
}

// Returns the index of the half-space that the point violates most, if it does so by more than the tolerance. If two
// are equally violated, returns the first. Returns -1 if none is violated.
template <class Real, class HalfSpaceAt>
int most_violated_of(int count, const HalfSpaceAt& at, const glm::vec<3, Real>& point_m) noexcept {
    Real worst = -kProjectionToleranceOf<Real>;
    int entering = -1;
    for (int i = 0; i < count; ++i) {
        const BasicHalfSpace<Real> h = at(i);
        const Real slack = glm::dot(h.normal, point_m) - h.offset_m;
        if (slack < worst) {
            worst = slack;
            entering = i;
        }
    }
    return entering;
}

// Like most_violated_of above, with a bit-identical result, for half-spaces in an array whose offsets are each
// increased by grown_m. It processes four half-spaces at a time, which takes half the instructions.
inline int most_violated_of(std::span<const HalfSpace> all, double grown_m, const Vec3& point_m) noexcept {
    using Two = double __attribute__((vector_size(16)));
    static_assert(sizeof(HalfSpace) == 4 * sizeof(double));
    const auto slacks = [&](const HalfSpace& a, const HalfSpace& b) noexcept {
        Two a_xy, a_zo, b_xy, b_zo;
        std::memcpy(&a_xy, &a.normal.x, sizeof(Two));
        std::memcpy(&a_zo, &a.normal.z, sizeof(Two));
        std::memcpy(&b_xy, &b.normal.x, sizeof(Two));
        std::memcpy(&b_zo, &b.normal.z, sizeof(Two));
        const Two x = __builtin_shufflevector(a_xy, b_xy, 0, 2), y = __builtin_shufflevector(a_xy, b_xy, 1, 3);
        const Two z = __builtin_shufflevector(a_zo, b_zo, 0, 2), offset = __builtin_shufflevector(a_zo, b_zo, 1, 3);
        return x * point_m.x + y * point_m.y + z * point_m.z - (offset + grown_m);
    };
    double worst = -kProjectionTolerance_m;
    int entering = -1;
    const auto look = [&](std::size_t i, double slack) noexcept {
        if (!(slack < worst)) return;
        worst = slack;
        entering = static_cast<int>(i);
    };
    std::size_t i = 0;
    for (; i + 4 <= all.size(); i += 4) {
        const Two first = slacks(all[i], all[i + 1]), second = slacks(all[i + 2], all[i + 3]);
        const Two least = first < second ? first : second;
        if (!(least[0] < worst || least[1] < worst)) continue;
        look(i, first[0]);
        look(i + 1, first[1]);
        look(i + 2, second[0]);
        look(i + 3, second[1]);
    }
    for (; i < all.size(); ++i) look(i, glm::dot(all[i].normal, point_m) - (all[i].offset_m + grown_m));
    return entering;
}

template <class Real, class HalfSpaceAt, class MostViolated>
bool exchange(const glm::vec<3, Real>& goal_m, int count, const HalfSpaceAt& at, const MostViolated& most_violated,
              BasicProjectionBasis<Real>& basis) noexcept {
    constexpr int kMaxExchanges = 40;  // an upper limit; |point - goal| rises with every exchange, so no basis repeats
    const int warm_count = basis.count;
    const std::array<int, 3> warm = basis.index;
    basis.count = 0;
    basis.point_m = goal_m;
    const auto enter = [&](int index) {
        std::array<Member<Real>, 4> members;
        int n = 0;
        for (int k = 0; k <= basis.count; ++k) {
            const int id = k < basis.count ? basis.index[static_cast<std::size_t>(k)] : index;
            const BasicHalfSpace<Real> h = at(id);
            members[static_cast<std::size_t>(n++)] = {h.normal, h.offset_m - glm::dot(h.normal, goal_m), id};
        }
        BasicProjectionBasis<Real> next;
        if (!solve(members, n, goal_m, next)) return false;
        basis = next;
        return true;
    };
    for (int round = 0; round < warm_count; ++round) {
        Real worst = -kProjectionToleranceOf<Real>;
        int entering = -1;
        for (int k = 0; k < warm_count; ++k) {
            const int id = warm[static_cast<std::size_t>(k)];
            if (id >= count) continue;
            const BasicHalfSpace<Real> h = at(id);
            const Real slack = glm::dot(h.normal, basis.point_m) - h.offset_m;
            if (slack < worst) {
                worst = slack;
                entering = id;
            }
        }
        if (entering < 0) break;
        if (!enter(entering)) {
            basis.count = 0;
            basis.point_m = goal_m;
            break;
        }
    }
    for (int round = 0; round < kMaxExchanges; ++round) {
        const int entering = most_violated(basis.point_m);
        if (entering < 0) return true;
        if (!enter(entering)) return false;
    }
    return false;
}

}  // namespace projection_detail

// Fills `basis` with the point nearest to goal_m that satisfies at(0) ... at(count - 1). The indices of the previous
// call are the warm start; set basis.count = 0 for a cold start. Returns false if the intersection is empty or too thin
// to decide. The basis then holds the best point found, which satisfies only its own members. Choose a local origin
// near the points, because rounding errors grow with the coordinates.
template <class Real, class HalfSpaceAt>
bool project_on_half_spaces(const glm::vec<3, Real>& goal_m, int count, const HalfSpaceAt& at,
                            BasicProjectionBasis<Real>& basis) noexcept {
    return projection_detail::exchange(
        goal_m, count, at,
        [&](const glm::vec<3, Real>& point) { return projection_detail::most_violated_of(count, at, point); }, basis);
}

// Like project_on_half_spaces above, for half-spaces in an array, each moved along its normal by grown_m.
inline bool project_on_half_spaces(const Vec3& goal_m, std::span<const HalfSpace> all, double grown_m,
                                   ProjectionBasis& basis) noexcept {
    const auto at = [&](int i) noexcept {
        return HalfSpace{all[static_cast<std::size_t>(i)].normal, all[static_cast<std::size_t>(i)].offset_m + grown_m};
    };
    return projection_detail::exchange(
        goal_m, static_cast<int>(all.size()), at,
        [&](const Vec3& point) { return projection_detail::most_violated_of(all, grown_m, point); }, basis);
}

}  // namespace handrail
