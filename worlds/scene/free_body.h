// Defines the objects of a world that are free to move: they can be pushed, lifted and dropped. Plain values of a
// Scene. haptic/compile/compile_dynamics makes rigid bodies of them, and app/core/bodies moves them.
#pragma once

#include <cstddef>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"
#include "worlds/scene/source_place.h"

namespace handrail {

// Describes one rigid body, which consists of all solids of `feature`.
struct FreeBody {
    // Greatest number of free bodies in a world; further ones in the file stay fixed.
    static constexpr std::size_t kMost = 2048;
    static constexpr double kLeast_kg = 0.01, kMost_kg = 10000.0;

    FeatureId feature = kNoFeature;
    double mass_kg = 1.0;  // mass of the body, from kLeast_kg to kMost_kg
    // Coefficients of friction while sliding and at rest, each from 0 to 2. Each is multiplied by the coefficient of
    // the other surface, which is 1 for a plain floor.
    double friction = 0.4, friction_static = 0.5;
    // The speed after an impact as a share of the speed before it, from 0 to 0.95. It is multiplied by the elasticity
    // of the other body.
    double elasticity = 0.2;
    // Rolling resistance: the distance ahead of the centre at which the floor's force acts, as a share of the body's
    // least half width.
    double rolling = 0.1;
    // A rubber string leads from the middle of the body to string_at_m. The farther it is stretched, the harder it
    // pulls. A stiffness of 0 means that there is no string.
    Vec3 string_at_m{0.0};
    double string_n_per_m = 0.0;
    bool by_density = false;  // true: the mass follows from the volume and the density
    SourcePlace source;

    static constexpr double kWalkersPush_n = 150.0;  // greatest force with which a walker pushes a body
    bool gives_way_to_walkers() const { return mass_kg * 9.81 * friction_static <= kWalkersPush_n; }
};

}  // namespace handrail
