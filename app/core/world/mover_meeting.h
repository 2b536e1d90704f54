// Determines what a moving thing would meet, and who rides on it. These functions compare one thing with a walker or
// with another thing, and ignore the rest of the world. Pure functions of plain shapes, which any thread may call. The
// cost is proportional to the number of solids of these things.
#pragma once

#include <functional>
#include <memory>

#include "app/core/world/walker_world.h"
#include "worlds/geometry/placement.h"

namespace handrail::core {

// Returns true if a walker at `feet_m` overlaps the thing at `at`. The result is exact, as for walking, if the thing is
// rotated only about the upright axis. Otherwise, the function uses the bounding box of each solid.
bool meets_walker(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
                  const WalkerShape& body);

// Returns true if two things overlap by more than kMeetingDepth_m. Two solids may be apart although only a plane
// parallel to an edge of each of them could separate them. In that case, the function also returns true.
inline constexpr double kMeetingDepth_m = 1e-3;
bool things_meet(const Scene& a, const Placement& a_at, const Scene& b, const Placement& b_at);

// Returns true if two boxes overlap. Boxes that only touch do not overlap, as in clip.h: a walker that stands next to a
// lift, level with its floor, does not block it.
bool boxes_meet(const Aabb& a, const Aabb& b);

// How a walker stands on a thing: not at all, only with its rim, or with its centre.
enum class Riding : std::uint8_t { Not, ByRim, ByMiddle };
Riding riding(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
              const WalkerShape& body);

// Returns where a point of a thing is after the thing has moved from `from` to `to`.
Vec3 carried(const Vec3& point_m, const Placement& from, const Placement& to);

// For a walker that stands on a thing with its centre, returns the horizontal shift after which the walker stands on
// the thing completely. Returns zero if the walker already does, or if the walker is wider than the thing.
Vec3 onto_thing(const Aabb& thing_m, const Vec3& feet_m, double radius_m);

// Calls `fits` with the place of a walker who stands in the doorway of a lift, and then with places nearer and nearer
// to the middle of the cabin, until the result is true. Returns false if it is not for any place within a long step.
bool step_in(Vec3 feet_m, const Aabb& lift_m, const std::function<bool(const Vec3& to_m)>& fits);

}  // namespace handrail::core
