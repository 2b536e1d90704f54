// Things of a world that are free to move: they can be pushed, lifted and dropped. Plain values of a Scene.
// haptic/compile/compile_dynamics makes rigid bodies of them, and app/core/bodies moves them.
#pragma once

#include <cstddef>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"
#include "worlds/scene/source_place.h"

namespace handrail {

// All solids of `feature` together are one rigid body.
struct FreeBody {
    static constexpr std::size_t kMost = 2048;  // in one world; further ones in the file stay where they are
    static constexpr double kLeast_kg = 0.01, kMost_kg = 10000.0;

    FeatureId feature = kNoFeature;
    double mass_kg = 1.0;  // kLeast_kg to kMost_kg
    // Coefficients while sliding and at rest, 0 to 2. Each is multiplied by that of the other surface; a plain floor
    // has 1.
    double friction = 0.4, friction_static = 0.5;
    // Speed after an impact as a share of the speed before, 0 to 0.95; multiplied by that of the other body.
    double elasticity = 0.2;
    // Rolling resistance: how far the floor's force acts ahead of the centre, as a share of the least half width.
    double rolling = 0.1;
    // A rubber string from the body's middle to a place; the longer it is, the harder it pulls. 0: no string.
    Vec3 string_at_m{0.0};
    double string_n_per_m = 0.0;
    bool by_density = false;  // true: the mass follows from volume and density
    SourcePlace source;

    static constexpr double kWalkersPush_n = 150.0;  // the greatest force with which a walker pushes
    bool gives_way_to_walkers() const { return mass_kg * 9.81 * friction_static <= kWalkersPush_n; }
};

}  // namespace handrail
