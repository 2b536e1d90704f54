// The features of a scene beyond the plain ones: still solids, two-sided sheets, friction, damping, the passivity guard
// and the drag of liquids. Tick and solver are compiled twice from one source, once for scenes with none of these
// features and once for scenes with any. The choice is made once per tick, so a scene pays nothing for features that it
// lacks. In the code a stage says `Has::kBodies && ...`; rare work, such as gathering, is compiled once. Both versions
// are correct for every scene that has none of the omitted features.
#pragma once

namespace handrail::render {

struct PlainFeatures {
    static constexpr bool kBodies = false;    // bodies that move
    static constexpr bool kOneSided = false;  // sheets that are felt from one side only
    static constexpr bool kFields = false;    // textures and shading
    static constexpr bool kMedia = false;     // effects, soft patches, liquids with buoyancy or a film
};

struct AllFeatures {
    static constexpr bool kBodies = true, kOneSided = true, kFields = true, kMedia = true;
};

}  // namespace handrail::render
