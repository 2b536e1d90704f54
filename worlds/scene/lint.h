// Whether a hand can tell a world's materials apart. Pure functions over a Scene; loading thread.
// Thresholds: compliance differs noticeably from 15 % on and force from 10 % (Bergmann Tiest & Kappers), so what is
// meant to differ must differ by twice that or more: 30 % in stiffness, 50 % in friction, or in texture. Sound is no
// substitute: a texture or material may be met in silence.
#pragma once

#include <string>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr double kStiffnessApart = 1.3;  // ratio
inline constexpr double kFrictionApart = 1.5;   // ratio
inline constexpr double kPeriodApart = 1.3;     // ratio, of two textures
inline constexpr std::size_t kMostMaterialsInView = 5;
inline constexpr double kView_m = 9.0;  // across: what a device of 15 cm holds at the room scale

// What a hand feels of a surface, once keys and library are put together.
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

// Two named materials of a world that a hand cannot tell apart, and what to change, in a sentence.
struct AlikeMaterials {
    std::string one, other;
    std::string sentence;
};
// Each pair once, over the named materials that a hand can reach.
std::vector<AlikeMaterials> alike_materials(const Scene& scene);

struct LintReport {
    std::vector<std::string> problems;  // pairs that cannot be told apart, and what to change
    std::vector<std::string> warnings;  // places with too many materials, stick-slip
};
// A sentence where more than kMostMaterialsInView named materials lie within one view, about the fullest one; empty
// where none is so full.
std::string crowded_view(const Scene& scene);
// Over the named materials that a hand can reach in this world.
LintReport lint_materials(const Scene& scene);

}  // namespace handrail
