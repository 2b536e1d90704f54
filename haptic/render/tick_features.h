// Lists the features that only some scenes have. Every scene may have the plain ones: still solids, two-sided sheets,
// friction, damping, the passivity guard and the drag of liquids. Tick and solver are compiled twice from one source,
// once without the features below and once with all of them. Each tick uses the version that the scene needs, so a
// scene pays nothing for features that it lacks. In the code a stage says `Has::kBodies && ...`. Rare work, such as
// gathering, is compiled only once. Both versions are correct for every scene that has none of the features below.
#pragma once

namespace handrail::render {

struct PlainFeatures {
    static constexpr bool kBodies = false;    // moving bodies
    static constexpr bool kOneSided = false;  // sheets that are felt from one side only
    static constexpr bool kFields = false;    // textures and shading
    static constexpr bool kMedia = false;     // effects, soft patches, liquids with buoyancy or a film
};

struct AllFeatures {
    static constexpr bool kBodies = true, kOneSided = true, kFields = true, kMedia = true;
};

}  // namespace handrail::render
