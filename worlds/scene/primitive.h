// Things of an exact shape, built in code or by a reader: box, sphere, cylinder, cone, capsule; moved, turned and
// scaled. A round one is felt as what it is; what is seen, walked into and covered is a solid of flat faces around it,
// at most 4 % wider (sphere and capsule) or 1 % (cylinder and cone). Pure functions; any thread.
#pragma once

#include <array>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/geometry/placement.h"
#include "worlds/scene/scene.h"

namespace handrail {

enum class PrimitiveKind : std::uint8_t { Box, Sphere, Cylinder, Cone, Capsule };
inline constexpr std::array<std::string_view, 5> kPrimitiveNames{"box", "sphere", "cylinder", "cone",
                                                                 "capsule"};  // indexed by PrimitiveKind

struct Primitive {
    PrimitiveKind kind = PrimitiveKind::Box;
    // Its sides in its own frame, around the frame's zero: a sphere's are equal; cylinder, cone and capsule stand along
    // z, as wide (x) as deep (y), the cone with its tip up, the capsule with its round ends within its length.
    Vec3 size_m{1.0};
    Vec3 stretch{1.0};  // factor per axis, as far as the shape allows it
    Placement at;
};

// The solid it makes, with one material and no names yet. Fails, with a sentence, for sizes that are not above zero or
// not finite, and for a shape that is stretched into another.
Result<Solid> make_solid(const Primitive& primitive, MaterialId material = kDefaultMaterial);

// Negative inside; for a Solid without a round shape infinity.
double signed_distance(const RoundShape& round, const Vec3& point_m) noexcept;

}  // namespace handrail
