#include "haptic/render/soft_patch.h"

#include <algorithm>
#include <cmath>

#include "haptic/render/effects.h"
#include "haptic/render/haptic_scene.h"
#include "haptic/render/tick_assert.h"
#include "haptic/render/tick_math.h"

namespace handrail::render {
namespace {

constexpr double kShear = 0.5;  // c, the coupling to each neighbouring cell
// Least radius of the footprint, in cells. With fewer, the sum over the cells no longer approximates the integral.
constexpr double kLeastFootprintCells = 3.0;
constexpr double kBack_hand_m = 1e-6;  // distance from its rest position at which a cell has recovered

}  // namespace

bool is_sound(const SoftPatch& patch) {
    const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
    return is_finite(patch.corner_m) && is_finite(patch.u) && is_finite(patch.v) &&
           std::abs(glm::dot(patch.u, patch.u) - 1.0) < 1e-9 && std::abs(glm::dot(patch.v, patch.v) - 1.0) < 1e-9 &&
           std::abs(glm::dot(patch.u, patch.v)) < 1e-9 && within(patch.size_u_m, 1e-3, 1e4) &&
           within(patch.size_v_m, 1e-3, 1e4) && within(patch.depth_m, 1e-4, 1e3) &&
           within(patch.stiffness_fraction, 0.02, 0.6) && within(patch.recovery_s, 0.02, 60.0) &&
           within(patch.yield_n, 0.1, 4.0);
}

void lay_grids(std::vector<SoftPatch>& patches) {
    std::uint32_t next = 0;
    for (SoftPatch& patch : patches) {
        const double most = std::min<double>(kMostCellsAlongSide * kMostCellsAlongSide,
                                             kMostSoftCells / static_cast<double>(patches.size()));
        const double cell = std::max(std::sqrt(patch.size_u_m * patch.size_v_m / most),
                                     std::max(patch.size_u_m, patch.size_v_m) / most);
        const auto count = [&](double size_m) {
            return static_cast<std::uint32_t>(std::max(1.0, std::floor(size_m / cell * (1.0 + 1e-12))));
        };
        patch.cells_u = count(patch.size_u_m);
        patch.cells_v = count(patch.size_v_m);
        patch.first_cell = next;
        next += patch.cells_u * patch.cells_v;
        patch.part.clear();
        if (patch.outline_m.size() < 3) continue;
        bool whole = true;
        for (std::uint32_t iv = 0; iv < patch.cells_v; ++iv)
            for (std::uint32_t iu = 0; iu < patch.cells_u; ++iu) {
                const Vec3 centre = patch.corner_m + patch.u * ((iu + 0.5) * patch.size_u_m / patch.cells_u) +
                                    patch.v * ((iv + 0.5) * patch.size_v_m / patch.cells_v);
                bool left = false, right = false;
                for (std::size_t k = 0; k < patch.outline_m.size(); ++k) {
                    const Vec3& from = patch.outline_m[k];
                    const Vec3& to = patch.outline_m[(k + 1) % patch.outline_m.size()];
                    (glm::dot(glm::cross(to - from, centre - from), patch.normal()) < 0.0 ? right : left) = true;
                }
                patch.part.push_back(left && right ? 0 : 1);
                whole = whole && !(left && right);
            }
        if (whole) patch.part.clear();
    }
}

SoftState::SoftState() : set_m_(kMostSoftCells, 0.0), load_(kMostSoftCells, 0.0) {}

void SoftState::clear() noexcept {
    std::fill(set_m_.begin(), set_m_.end(), 0.0);
    awake_.fill(false);
}

Vec3 SoftState::press(const SoftPatch& patch, bool& awake, const HandMotion& hand, const Vec3& proxy_m, double radius_m,
                      bool& pressed) noexcept {
    tick_assert(patch.cells_u > 0 && patch.cells_v > 0 && radius_m > 0.0 && hand.dt_s >= 0.0 && hand.scale > 0.0);
    const Vec3 normal = patch.normal();
    const Vec3 from_corner = hand.goal_m - patch.corner_m;
    const double at_u = glm::dot(from_corner, patch.u), at_v = glm::dot(from_corner, patch.v),
                 height = glm::dot(from_corner, normal);
    const double step_u = patch.size_u_m / patch.cells_u, step_v = patch.size_v_m / patch.cells_v;
    const double footprint = std::max(radius_m, kLeastFootprintCells * std::max(step_u, step_v));
    const double deep = radius_m - height;  // e, in world metres like all lengths here
    // If the proxy is behind or below the hard floor, the patch gives no force. The proxy cannot get there through the
    // floor, only around it.
    const double above_floor = glm::dot(proxy_m - patch.corner_m, normal) + patch.depth_m;
    const double front = smooth_step(1.0 + above_floor / radius_m);
    const bool near = deep > 0.0 && front > 0.0 && at_u > -footprint && at_u < patch.size_u_m + footprint &&
                      at_v > -footprint && at_v < patch.size_v_m + footprint;
    if (!near && !awake) return Vec3(0.0);

    double* const set = set_m_.data() + patch.first_cell;
    const std::uint32_t nu = patch.cells_u, nv = patch.cells_v;
    const std::uint32_t cells = nu * nv;
    const auto absent = [&](std::uint32_t i) { return !patch.part.empty() && patch.part[i] == 0; };
    const double stiffness = patch.stiffness_fraction * hand.stiffest_n_per_m;

    // The range of cells under the footprint, along one axis.
    struct Range {
        std::uint32_t first, end;
    };
    const auto range = [&](double at, double step, std::uint32_t count) {
        const double low = std::clamp((at - footprint) / step - 0.5, 0.0, static_cast<double>(count));
        const double high = std::clamp((at + footprint) / step + 0.5, 0.0, static_cast<double>(count));
        return Range{static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high)};
    };
    const Range ru = near ? range(at_u, step_u, nu) : Range{0, 0}, rv = near ? range(at_v, step_v, nv) : Range{0, 0};
    const auto weight_of = [&](std::uint32_t iu, std::uint32_t iv, double& du, double& dv) {
        du = (iu + 0.5) * step_u - at_u;
        dv = (iv + 0.5) * step_v - at_v;
        return std::max(0.0, 1.0 - (du * du + dv * dv) / (footprint * footprint));  // the square of this root is g
    };

    // 1. Updates the cells: the surface yields to the proxy at its current position.
    std::fill_n(load_.begin(), cells, 0.0);
    const double squeeze = std::min(deep, patch.depth_m);  // the hard floor carries the rest of the pressure
    for (std::uint32_t iv = rv.first; iv < rv.end; ++iv)
        for (std::uint32_t iu = ru.first; iu < ru.end; ++iu) {
            double du = 0.0, dv = 0.0;
            const double root = weight_of(iu, iv, du, dv);
            load_[iv * nu + iu] = root * root * front;
        }
    const double share = hand.dt_s / patch.recovery_s;
    const double yields = patch.yield_n / stiffness * hand.scale;
    double most = 0.0;
    for (std::uint32_t iv = 0; iv < nv; ++iv)
        for (std::uint32_t iu = 0; iu < nu; ++iu) {
            const std::uint32_t i = iv * nu + iu;
            if (absent(i)) continue;
            double neighbours = 0.0, links = 0.0;
            const auto link = [&](std::uint32_t j) {
                if (absent(j)) return;
                neighbours += set[j];
                links += 1.0;
            };
            if (iu > 0) link(i - 1);
            if (iu + 1 < nu) link(i + 1);
            if (iv > 0) link(i - nu);
            if (iv + 1 < nv) link(i + nu);
            const double g = squeeze > set[i] ? load_[i] : 0.0;
            double& s = set[i];
            if (patch.plastic) {
                const double drive = g * (squeeze - s) + kShear * (neighbours - links * s);
                if (drive > yields) s = std::min(s + (drive - yields) / (g + kShear * links), patch.depth_m);
            } else {
                // Implicit in the cell's new value, so a step of any length is stable.
                s = (s + share * (g * squeeze + kShear * neighbours)) / (1.0 + share * (g + 1.0 + kShear * links));
            }
            tick_assert(s >= 0.0 && s <= patch.depth_m * (1.0 + 1e-9));
            most = std::max(most, s);
        }
    awake = !patch.plastic && most > kBack_hand_m * hand.scale;
    if (!awake && !patch.plastic && !near) std::fill_n(set, cells, 0.0);
    if (!near) return Vec3(0.0);

    // 2. Computes the force: the slope of the stored energy, K sum k_i (e - s_i)^2 / 2.
    const double per_cell = 3.0 * step_u * step_v / (kPi * footprint * footprint);
    double up = 0.0, along_u = 0.0, along_v = 0.0;
    for (std::uint32_t iv = rv.first; iv < rv.end; ++iv)
        for (std::uint32_t iu = ru.first; iu < ru.end; ++iu) {
            const std::uint32_t i = iv * nu + iu;
            const double spring = deep - set[i];
            if (absent(i) || spring <= 0.0) continue;
            double du = 0.0, dv = 0.0;
            const double root = weight_of(iu, iv, du, dv);
            up += root * root * spring;
            const double slope = root * spring * spring;  // the slope is dg/du = 4 root du / R^2
            along_u += slope * du;
            along_v += slope * dv;
        }
    pressed = up > 0.0;
    const double sideways = -2.0 / (footprint * footprint);
    return (normal * up + (patch.u * along_u + patch.v * along_v) * sideways) *
           (stiffness * per_cell * front / hand.scale);
}

Vec3 SoftState::force_n(const HapticScene& scene, const HandMotion& hand, const Vec3& proxy_m, double radius_m,
                        const SoftPatch*& pressed) noexcept {
    if (scene.soft_patches.empty()) return Vec3(0.0);
    if (world_ != scene.world || patches_ != scene.soft_patches.size()) {
        world_ = scene.world;
        patches_ = scene.soft_patches.size();
        clear();
    }
    Vec3 sum(0.0);
    HandMotion local = hand;
    local.goal_m = hand.goal_m - scene.origin_m;
    for (std::size_t i = 0; i < patches_; ++i) {
        bool pushes = false;
        sum += press(scene.soft_patches[i], awake_[i], local, proxy_m - scene.origin_m, radius_m, pushes);
        if (pushes) pressed = &scene.soft_patches[i];
    }
    return sum;
}

}  // namespace handrail::render
