// What a moving thing would meet, and who rides on it. These functions compare one thing with a walker or with another
// thing, and ignore the rest of the world. Pure functions of plain shapes; any thread. Cost: proportional to the number
// of solids of these things.
#pragma once

#include <memory>

#include "app/core/world/walker_world.h"
#include "worlds/geometry/placement.h"

namespace handrail::core {

// True if a walker at `feet_m` overlaps the thing at `at`. The result is exact, as for walking, if the thing is rotated
// only about the upright axis. Otherwise, the bounding box of each solid is used.
bool meets_body(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
                const WalkerShape& body);

// True if two things overlap by more than kMeetingDepth_m. If only a plane parallel to an edge of each could separate
// two solids, they count as overlapping.
inline constexpr double kMeetingDepth_m = 1e-3;
bool things_meet(const Scene& a, const Placement& a_at, const Scene& b, const Placement& b_at);

// How a walker stands on a thing: not at all, only with its rim, or with its centre.
enum class Riding : std::uint8_t { Not, ByRim, ByMiddle };
Riding riding(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
              const WalkerShape& body);

// Returns where a point of a thing is after the thing has moved.
Vec3 carried(const Vec3& point_m, const Placement& from, const Placement& to);

// For a walker that stands on a thing with its centre, returns the horizontal shift after which it stands on the thing
// completely. Zero if it already does, or if it is wider than the thing.
Vec3 onto_thing(const Aabb& thing_m, const Vec3& feet_m, double radius_m);

}  // namespace handrail::core
