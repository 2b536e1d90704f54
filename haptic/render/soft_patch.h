// Computes soft surfaces: a cushion that recovers, and clay that keeps a dent. A soft patch is a grid of cells over a
// flat face, above a hard floor that the obstacle underneath provides. Under the proxy each cell is a spring, weighted
// by its distance from the centre:
//
//   normal force  F = K sum_i k_i (e - s_i)+      e: depth of the proxy's lowest point below the untouched face
//   k_i = 3 D^2 / (pi R^2) g_i,  g_i = (1 - (d_i / R)^2)^2, d_i the distance from cell i to below the proxy,
//   D the size of the cells, R the footprint's radius
//
// On an untouched patch this gives F = K e (Winkler's foundation, its pressure summed over the footprint). As for every
// force, lengths are divided by the scale. Along the face the force is the slope of the same energy, so the proxy can
// slide into a dent. R is the proxy's radius, but at least three cells. s_i is the depth that cell i keeps after the
// proxy has left it:
//
//   elastic:  tau s_i' = g_i (e - s_i)+ - s_i + c sum_j (s_j - s_i)       recovers with the time constant tau
//   plastic:  s_i grows as far as needed to keep  g_i (e - s_i)+ + c sum_j (s_j - s_i) <= F_yield / K,  never shrinks,
//   at most the patch's depth
//
// In both, j runs over the four neighbours (the shear layer of Pasternak's foundation) and c = 0.5. Both laws descend
// the stored energy, so the patch only ever takes energy. Sources: Winkler 1867; Pasternak 1954; Kerr, Elastic and
// viscoelastic foundation models, J. Appl. Mech. 31(3), 1964.
//
// TouchState owns SoftState, which allocates only when it is created; one thread. A tick costs about 10 ns for each
// cell of patches that are touched or still recovering, at most 100 us, and nothing if there are none.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"

namespace handrail::render {

struct HapticScene;
struct HandMotion;

struct SoftPatch {
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    Vec3 corner_m{0.0};                       // corner of the untouched face, in the world
    Vec3 u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};  // unit vectors along its sides; u x v points out of the face
    double size_u_m = 0.0, size_v_m = 0.0;    // lengths of the sides along u and v, in the world
    double depth_m = 0.0;                     // distance from the face down to the hard floor, in the world
    double stiffness_fraction = 0.2;          // K as a fraction of the device's rated stiffness, 0.02 to 0.6
    bool plastic = false;
    double recovery_s = 0.5;      // tau, for an elastic patch; 0.02 to 60
    double yield_n = 1.0;         // F_yield, for a plastic patch; 0.1 to 4
    std::vector<Vec3> outline_m;  // corners of the convex face, in either direction; empty: the whole rectangle

    // The members below are computed when the scene is built. `part` has one element for each cell, u running fastest:
    // 1 if the cell is in the face. Empty: all cells are.
    std::vector<std::uint8_t> part;
    std::uint32_t cells_u = 0, cells_v = 0, first_cell = 0;

    Vec3 normal() const noexcept { return glm::cross(u, v); }
};

// Returns true if the patch is valid: every number is finite and within the ranges above.
bool is_sound(const SoftPatch& patch);

constexpr std::uint32_t kMostSoftCells = 4096;  // greatest number of cells of all patches of a scene together
constexpr std::uint32_t kMostSoftPatches = 64;
constexpr std::uint32_t kMostCellsAlongSide = 32;
// Distributes the cells among the patches, as nearly square as possible, and fills in the computed members.
void lay_grids(std::vector<SoftPatch>& patches);

class SoftState {
public:
    SoftState();

    // Restores every patch to its untouched state. Needed only when the hand enters another world, because a dent stays
    // while the hand is elsewhere.
    void clear() noexcept;
    // Returns the force on the hand, in world axes. `proxy_m` is the centre of the proxy in the world. Stiffness
    // fractions are relative to hand.stiffest_n_per_m. `pressed` receives the feature of a patch that pushes back.
    Vec3 force_n(const HapticScene& scene, const HandMotion& hand, const Vec3& proxy_m, double radius_m,
                 const SoftPatch*& pressed) noexcept;

private:
    Vec3 press(const SoftPatch& patch, bool& awake, const HandMotion& hand, const Vec3& proxy_m, double radius_m,
               bool& pressed) noexcept;

    std::vector<double> set_m_;                   // s of the cells of all patches, in world metres
    std::vector<double> load_;                    // g of each cell of the current patch
    std::array<bool, kMostSoftPatches> awake_{};  // for each patch: true if one of its cells has not recovered yet
    std::uint32_t world_ = 0;                     // number of the world to which the dents belong
    std::size_t patches_ = 0;
};

}  // namespace handrail::render
