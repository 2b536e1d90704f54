// Makes exact shapes, in code or for a reader: box, sphere, cylinder, cone and capsule. They may be moved, turned and
// scaled. The hand feels a round shape exactly. Drawing, walking and covering use a flat-faced solid that encloses the
// shape and is wider by at most 4 % (sphere and capsule) or 1 % (cylinder and cone). Pure functions; any thread may
// call them.
#pragma once

#include <array>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/geometry/placement.h"
#include "worlds/scene/scene.h"

namespace handrail {

enum class PrimitiveKind : std::uint8_t { Box, Sphere, Cylinder, Cone, Capsule };
// The names of the kinds, indexed by PrimitiveKind.
inline constexpr std::array<std::string_view, 5> kPrimitiveNames{"box", "sphere", "cylinder", "cone", "capsule"};

struct Primitive {
    PrimitiveKind kind = PrimitiveKind::Box;
    // The size of the shape in its own frame, centred on the frame's origin. A sphere has equal sizes. A cylinder, cone
    // or capsule stands along z, and its x and y sizes are equal. The cone's tip is at the top. The capsule's length
    // includes its round ends.
    Vec3 size_m{1.0};
    Vec3 stretch{1.0};  // factor for each axis; the kind of shape must stay the same
    Placement at;
};

// Makes the solid, with one material and without names. Fails with a sentence if a size is not positive or not finite,
// or if stretching changes the kind of shape.
Result<Solid> make_solid(const Primitive& primitive, MaterialId material = kDefaultMaterial);

// Returns the distance from the point to the surface of the shape, negative inside. Returns infinity for a shape that
// is not round (std::monostate).
double signed_distance(const RoundShape& round, const Vec3& point_m) noexcept;

}  // namespace handrail
