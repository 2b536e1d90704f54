// What a moving thing would meet, and who rides on it. It compares one thing with a walker or with another thing, and
// ignores the rest of the world. Pure functions of plain shapes; any thread. Cost: the solids of these things.
#pragma once

#include <memory>

#include "app/core/world/walker_world.h"
#include "worlds/geometry/placement.h"

namespace handrail::core {

// True if a walker there and the thing there overlap. It is exact, as for walking, if the thing is rotated about the
// upright axis; otherwise it uses the box of each solid.
bool meets_body(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
                const WalkerShape& body);

// True if two things overlap by more than kMeetingDepth_m. A pair of solids that only a plane through two edges could
// separate counts as overlapping.
inline constexpr double kMeetingDepth_m = 1e-3;
bool things_meet(const Scene& a, const Placement& a_at, const Scene& b, const Placement& b_at);

// How a walker stands on a thing: not at all, only with its rim, or with its centre.
enum class Riding : std::uint8_t { Not, ByRim, ByMiddle };
Riding riding(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
              const WalkerShape& body);

// Where a point of a thing is after the thing has moved.
Vec3 carried(const Vec3& point_m, const Placement& from, const Placement& to);

// The level shift for a walker that stands on a thing with its centre, so that it stands on it wholly. Zero if it does
// already, or is wider than the thing.
Vec3 onto_thing(const Aabb& thing_m, const Vec3& feet_m, double radius_m);

}  // namespace handrail::core
