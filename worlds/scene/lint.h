// Checks whether a hand can tell a world's materials apart. Pure functions over a Scene; loading thread. Thresholds:
// people notice differences of compliance from 15 % and of force from 10 % (Bergmann Tiest & Kappers). So materials
// that are meant to differ must differ by twice that or more: 30 % in stiffness, 50 % in friction, or in texture. Sound
// does not replace this, because a material may be touched without sound.
#pragma once

#include <string>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr double kStiffnessApart = 1.3;  // least ratio
inline constexpr double kFrictionApart = 1.5;   // least ratio
inline constexpr double kPeriodApart = 1.3;     // least ratio of the periods of two textures
inline constexpr std::size_t kMostMaterialsInView = 5;
// Width of a view: what a device with 15 cm of workspace covers at the room scale.
inline constexpr double kView_m = 9.0;

// How a surface feels, after keys of the map and library values are combined.
struct Finish {
    std::string name;
    double stiffness_fraction = 0.8;
    double friction_mu = 0.3;
    TextureWave wave;
    const HeightPicture* picture = nullptr;
};
Finish finish_of(const Material& material);
Finish finish_of(const MaterialSpec& spec);

bool can_be_told_apart(const Finish& a, const Finish& b);

// Two named materials of a world that a hand cannot tell apart; the sentence says what to change.
struct AlikeMaterials {
    std::string one, other;
    std::string sentence;
};
// Each pair appears once. Considers only the named materials that a hand can reach.
std::vector<AlikeMaterials> alike_materials(const Scene& scene);

struct LintReport {
    std::vector<std::string> problems;  // pairs that cannot be told apart, and what to change
    std::vector<std::string> warnings;  // places with too many materials, and stick-slip friction
};
// A sentence about the fullest view if it contains more than kMostMaterialsInView named materials; else empty.
std::string crowded_view(const Scene& scene);
// Checks the named materials that a hand can reach in this world.
LintReport lint_materials(const Scene& scene);

}  // namespace handrail
