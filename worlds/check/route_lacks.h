// Explains why a place cannot be reached on foot: what the best route would lack for the walker, if it lacks only one
// thing. Pure functions; any thread may call them.
#pragma once

#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail::check {

enum class Lack : std::uint8_t {
    Nothing,   // none of the kinds below is a sufficient explanation: walls, or several lacks together, are the reason
    Headroom,  // there are only has_m of free height above the soles, and the body needs its height
    Step,      // there is a step of has_m, and the body can climb less
    Width,     // there is a passage has_m wide, and the body needs twice its radius
    Things,    // things are in the way; route_lacks never returns this kind
};
std::string_view word_of(Lack lack);  // returns the value for "select" in texts: "headroom"

struct RouteLacks {
    Lack lack = Lack::Nothing;
    double has_m = 0.0, needs_m = 0.0;
    Vec3 at_m{0.0};  // where the best route lacks most, at the height of the soles
};

// Explains why no route leads from `from_m` to `places_m` in the walkable space of this scene. The best route is the
// one whose worst place is best: most headroom, lowest step, or greatest width. The best route must be passable for a
// body that is at least half as tall, or has a fifth of the radius, or climbs up to 0.6 m more. If several kinds are an
// explanation, the first one in `kinds` is returned. Makes a trial space of the scene for each kind, and before these
// an additional one if there are several kinds. After a stop request, it returns what it has found by then. Source: the
// widest-path problem, Pollack, 1960.
std::vector<RouteLacks> route_lacks(const Scene& scene, const navigation::WalkSpace& space, const Vec3& from_m,
                                    std::span<const Vec3> places_m, std::span<const Lack> kinds,
                                    const std::stop_token& stop = {});

// Like route_lacks for one place and for routes that stay within a box, for example on one flight of stairs. The cost
// depends on the content of the box.
RouteLacks route_lacks_within(const Scene& scene, const navigation::WalkSpace& space, const Vec3& from_m,
                              const Vec3& place_m, const Aabb& box_m, std::span<const Lack> kinds);

}  // namespace handrail::check
