// Things of a world that are free to move: what can be pushed, lifted and dropped. Plain values of a Scene.
// haptic/compile/compile_dynamics makes bodies of them, app/core/bodies moves them.
#pragma once

#include <cstddef>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"
#include "worlds/scene/source_place.h"

namespace handrail {

// All solids of that feature together are one rigid body.
struct FreeBody {
    static constexpr std::size_t kMost = 2048;  // in one world; what comes later in the file stays where it is
    static constexpr double kLeast_kg = 0.01, kMost_kg = 10000.0;

    FeatureId feature = kNoFeature;
    double mass_kg = 1.0;  // kLeast_kg to kMost_kg
    // Against what it slides on, sliding and at rest, 0 to 2; a plain floor has 1, and both are multiplied.
    double friction = 0.4, friction_static = 0.5;
    double elasticity = 0.2;  // share of the speed with which it comes back, 0 to 0.95; that of both is multiplied
    double rolling = 0.1;     // of its least half width: how far the push of the floor runs ahead of it as it rolls
    // A rubber string from its middle to a place, which pulls the harder the longer it is; 0: none.
    Vec3 string_at_m{0.0};
    double string_n_per_m = 0.0;
    bool by_density = false;  // the mass follows from volume and density
    SourcePlace source;

    static constexpr double kWalkersPush_n = 150.0;  // what somebody who walks pushes with, at most
    bool gives_way_to_walkers() const { return mass_kg * 9.81 * friction_static <= kWalkersPush_n; }
};

}  // namespace handrail
