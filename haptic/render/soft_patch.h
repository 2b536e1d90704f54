// Surfaces that give way: a cushion that comes back, clay that keeps a dent. A soft patch is a grid of cells over a
// flat face, above a hard floor that the obstacle underneath provides. Under the ball each cell is a spring, weighted
// by how central it lies:
//
//   normal force  F = K sum_i k_i (e - s_i)+      e: how deep the ball's lowest point lies under the untouched face
//   k_i = 3 D^2 / (pi R^2) g_i,  g_i = (1 - (d_i / R)^2)^2, d_i the way from cell i to below the ball, D the cells'
//   size, R the footprint's radius
//
// so that on an untouched patch F = K e, lengths over the scale as for every force (Winkler's foundation, its pressure
// gathered over the footprint), and along the face the slope of the same energy, which lets the ball slide into a dent.
// R is the ball's radius, at least three cells. s_i is how deep cell i stays when the ball has gone:
//
//   elastic:  tau s_i' = g_i (e - s_i)+ - s_i + c sum_j (s_j - s_i)       comes back with the time constant tau
//   plastic:  s_i grows as far as needed to keep  g_i (e - s_i)+ + c sum_j (s_j - s_i) <= F_yield / K,  never shrinks,
//   at most the patch's depth
//
// with j over the four neighbours (the shear layer of Pasternak's foundation) and c = 0.5. Both are flows down the
// stored energy, so the patch only ever takes energy. Sources: Winkler 1867; Pasternak 1954; Kerr, Elastic and
// viscoelastic foundation models, J. Appl. Mech. 31(3), 1964. SoftState is owned by TouchState, one thread; allocates
// when created; a tick costs about 10 ns for each cell of patches that are touched or still coming back, at most 100
// us, and nothing when there are none.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"

namespace handrail {

struct HapticScene;
struct HandMotion;

struct SoftPatch {
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    Vec3 corner_m{0.0};                       // of the untouched face, world
    Vec3 u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};  // unit, along its sides; u x v looks out of it
    double size_u_m = 0.0, size_v_m = 0.0;    // world
    double depth_m = 0.0;                     // down to the hard floor, world
    double stiffness_fraction = 0.2;          // K as a fraction of the device's rated stiffness, 0.02 to 0.6
    bool plastic = false;
    double recovery_s = 0.5;      // tau of an elastic one, 0.02 to 60
    double yield_n = 1.0;         // of a plastic one, 0.1 to 4
    std::vector<Vec3> outline_m;  // convex corners of the face, either way round; empty: the whole rectangle

    // Worked out when the scene is built.
    std::vector<std::uint8_t> part;  // per cell, u running fastest: 1 where the face is; empty: everywhere
    std::uint32_t cells_u = 0, cells_v = 0, first_cell = 0;

    Vec3 normal() const noexcept { return glm::cross(u, v); }
};

// True when every number is finite and in the ranges above.
bool is_sound(const SoftPatch& patch);

constexpr std::uint32_t kMostSoftCells = 4096;  // of all patches of a scene
constexpr std::uint32_t kMostSoftPatches = 64;
constexpr std::uint32_t kMostCellsAlongSide = 32;
// Shares the cells among the patches, square ones as far as that goes; fills in what is worked out.
void lay_grids(std::vector<SoftPatch>& patches);

class SoftState {
public:
    SoftState();

    // Every patch as new. Only another world needs that: a dent stays while the hand is elsewhere.
    void clear() noexcept;
    // On the hand, world axes. ball_m: centre of the ball, world. Fractions are of hand.stiffest_n_per_m. `pressed`: a
    // patch that pushes back.
    Vec3 force_n(const HapticScene& scene, const HandMotion& hand, const Vec3& ball_m, double radius_m,
                 const SoftPatch*& pressed) noexcept;

private:
    Vec3 press(const SoftPatch& patch, bool& awake, const HandMotion& hand, const Vec3& ball_m, double radius_m,
               bool& pressed) noexcept;

    std::vector<double> set_m_;                   // s, of all patches, world metres
    std::vector<double> load_;                    // g of the patch at work
    std::array<bool, kMostSoftPatches> awake_{};  // something in it has not come back yet
    std::uint32_t world_ = 0;                     // of the scene that the dents belong to
    std::size_t patches_ = 0;
};

}  // namespace handrail
