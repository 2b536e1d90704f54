// What a moving thing would meet, and who rides on it: one thing beside a body or beside another thing, nothing else of
// the world. Pure functions of plain shapes; any thread. Cost: the solids of the things asked about.
#pragma once

#include <memory>

#include "app/core/world/body_world.h"
#include "worlds/geometry/placement.h"

namespace handrail {

// A body that stands there, and the thing there: exact, as walking has it (turned about the upright line; else with the
// box round each solid).
bool meets_body(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
                const BodyShape& body);

// Two things overlap by more than kMeetingDepth_m. A pair of solids that only a plane through two edges could part
// counts as overlapping.
inline constexpr double kMeetingDepth_m = 1e-3;
bool things_meet(const Scene& a, const Placement& a_at, const Scene& b, const Placement& b_at);

// How a body stands on a thing: not at all, with its rim only, or with its middle.
enum class Riding : std::uint8_t { Not, ByRim, ByMiddle };
Riding riding(const std::shared_ptr<const Scene>& model, const Placement& at, const Vec3& feet_m,
              const BodyShape& body);

// Where a point of a thing is after the thing has moved.
Vec3 carried(const Vec3& point_m, const Placement& from, const Placement& to);

// Level, from a body that stands on a thing by its middle to where it stands on it wholly; nothing where it does or is
// wider than the thing.
Vec3 onto_thing(const Aabb& thing_m, const Vec3& feet_m, double radius_m);

}  // namespace handrail
