// Exact shapes, built in code or by a reader: box, sphere, cylinder, cone and capsule, which may be moved, turned and
// scaled. The hand feels a round shape exactly. Drawing, walking and covering use a flat-faced solid around it, wider
// by at most 4 % (sphere and capsule) or 1 % (cylinder and cone). Pure functions; any thread.
#pragma once

#include <array>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/geometry/placement.h"
#include "worlds/scene/scene.h"

namespace handrail {

enum class PrimitiveKind : std::uint8_t { Box, Sphere, Cylinder, Cone, Capsule };
// Indexed by PrimitiveKind.
inline constexpr std::array<std::string_view, 5> kPrimitiveNames{"box", "sphere", "cylinder", "cone", "capsule"};

struct Primitive {
    PrimitiveKind kind = PrimitiveKind::Box;
    // Its sides in its own frame, around the frame's origin. A sphere has equal sides. Cylinder, cone and capsule stand
    // along z and are as wide (x) as deep (y). The cone's tip is at the top; the capsule's length includes its round
    // ends.
    Vec3 size_m{1.0};
    Vec3 stretch{1.0};  // factor for each axis; it must not change the kind of shape
    Placement at;
};

// Makes the solid, with one material and without names. Fails with a sentence if a size is not positive or not finite,
// or if stretching changes the kind of shape.
Result<Solid> make_solid(const Primitive& primitive, MaterialId material = kDefaultMaterial);

// Negative inside; infinity if the Solid has no round shape.
double signed_distance(const RoundShape& round, const Vec3& point_m) noexcept;

}  // namespace handrail
