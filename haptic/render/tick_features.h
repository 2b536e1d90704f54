// What a tick may have to look at beyond still solids, sheets felt from both sides, friction, damping, the passivity
// guard and the drag of liquids. Tick and solver are compiled twice from one source, for scenes that contain none of it
// and for those that contain any, and chosen once per tick: what a scene does not contain costs nothing. Inside, a
// stage says `Has::kBodies && ...`; rare work, such as gathering, is compiled once. Both are right for every scene that
// has nothing of what was left out.
#pragma once

namespace handrail {

struct PlainFeatures {
    static constexpr bool kBodies = false;    // things that move
    static constexpr bool kOneSided = false;  // sheets felt from one side only
    static constexpr bool kFields = false;    // textures and shading
    static constexpr bool kMedia = false;     // effects, soft patches, liquids with buoyancy or a film
};

struct AllFeatures {
    static constexpr bool kBodies = true, kOneSided = true, kFields = true, kMedia = true;
};

}  // namespace handrail
