// Explains why a place cannot be reached on foot: what the best route would lack for the walker, if it is one thing
// only. Pure functions; any thread.
#pragma once

#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail::check {

enum class Lack : std::uint8_t {
    Nothing,   // none of the kinds below alone explains it: walls or several lacks are the reason
    Headroom,  // only has_m above the soles; the body needs its height
    Step,      // a step of has_m; the body can climb less
    Width,     // a passage of has_m; the body needs twice its radius
    Things,    // things are in the way; way_lacks does not find these
};
std::string_view word_of(Lack lack);  // the value for "select" in texts: "headroom"

struct WayLacks {
    Lack lack = Lack::Nothing;
    double has_m = 0.0, needs_m = 0.0;
    Vec3 at_m{0.0};  // where the lack on the best route is greatest, at the soles
};

// `places_m` are places that no route from `from_m` leads to in this scene's space. The best route is the one whose
// worst place is best: most headroom, lowest step, or greatest width. It must be passable for a body at least half as
// tall, or with a fifth of the radius, or that climbs up to 0.6 m more. If several kinds explain it, the first one in
// `kinds` is returned. Makes a trial space of the scene for each kind, and one more first if there are several kinds.
// If stopped, it returns what it has found by then. Source: the widest-path problem, Pollack, 1960.
std::vector<WayLacks> way_lacks(const Scene& scene, const navigation::WalkSpace& space, const Vec3& from_m,
                                std::span<const Vec3> places_m, std::span<const Lack> kinds,
                                const std::stop_token& stop = {});

// The same for one place, with routes that stay in a box, such as those on one flight of stairs. The cost depends on
// the content of the box.
WayLacks way_lacks_within(const Scene& scene, const navigation::WalkSpace& space, const Vec3& from_m,
                          const Vec3& place_m, const Aabb& box_m, std::span<const Lack> kinds);

}  // namespace handrail::check
