// Checks whether a hand can distinguish the materials of a world. Pure functions over a Scene, called on the loading
// thread. People notice differences of compliance from 15 % and of force from 10 % (Bergmann Tiest & Kappers). So
// materials that are meant to differ must differ by at least twice as much: by 30 % in stiffness, by 50 % in friction,
// or in texture. Different sounds are ignored, because a material may be touched without sound.
#pragma once

#include <string>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

// Least ratio of the stiffnesses of two materials that a hand can distinguish.
inline constexpr double kStiffnessApart = 1.3;
// Least ratio of the frictions of two materials that a hand can distinguish.
inline constexpr double kFrictionApart = 1.5;
inline constexpr double kPeriodApart = 1.3;  // least ratio of the periods of two textures that a hand can distinguish
inline constexpr std::size_t kMostMaterialsInView = 5;
// Width of a view: the part of the world that a device with 15 cm of workspace covers at the room scale.
inline constexpr double kView_m = 9.0;

// The properties of a surface that a hand feels. The values combine the map's keys with those of the library.
struct Finish {
    std::string name;
    double stiffness_fraction = 0.8;
    double friction_mu = 0.3;
    TextureWave wave;
    const HeightPicture* picture = nullptr;
};
Finish finish_of(const Material& material);
Finish finish_of(const MaterialSpec& spec);

bool are_distinguishable(const Finish& a, const Finish& b);

// Two named materials of a world that a hand cannot distinguish. The sentence says what to change.
struct AlikeMaterials {
    std::string one, other;
    std::string sentence;
};
// Returns each pair of alike materials once. Only named materials that a hand can reach are compared.
std::vector<AlikeMaterials> alike_materials(const Scene& scene);

struct LintReport {
    std::vector<std::string> problems;  // sentences about pairs that a hand cannot distinguish, with what to change
    std::vector<std::string> warnings;  // sentences about places with too many materials and about stick-slip friction
};
// Returns a sentence about the view with the most materials, if it contains more than kMostMaterialsInView named ones;
// else empty.
std::string crowded_view(const Scene& scene);
// Checks whether a hand can distinguish the named materials that it can reach in this world.
LintReport lint_materials(const Scene& scene);

}  // namespace handrail
