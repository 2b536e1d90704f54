// Why nobody comes to a place on foot: what the best way there would lack for the body that walks, where that is one
// thing alone. Pure functions; any thread.
#pragma once

#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail {

enum class Lack : std::uint8_t {
    Nothing,   // no lack of the kinds below is alone what keeps a body away: walls do, or several lacks
    Headroom,  // has_m above the soles, where the body's height is needed
    Step,      // a step of has_m, where the body's step is the most
    Width,     // a passage of has_m, where twice the body's radius is needed
    Things,    // what stands about; found by others
};
std::string_view word_of(Lack lack);  // a select word of texts: "headroom"

struct WayLacks {
    Lack lack = Lack::Nothing;
    double has_m = 0.0, needs_m = 0.0;
    Vec3 at_m{0.0};  // where on the best way the lack is greatest, at the soles
};

// For each place that no way leads to from `from_m` in the space of this scene. The best way is that whose worst place
// is best: with most headroom, the least step, the most width; a body at least half as tall, of a fifth of the radius
// or more, or that climbs up to 0.6 m more must come through. Of several kinds the first of `kinds` is told. Makes a
// trial space of the scene for each kind, and another first where there are several; stopped, it tells what it has by
// then. Source: the widest-path problem, Pollack, 1960.
std::vector<WayLacks> way_lacks(const Scene& scene, const WalkSpace& space, const Vec3& from_m,
                                std::span<const Vec3> places_m, std::span<const Lack> kinds,
                                const std::stop_token& stop = {});

// The same for one place, of the ways that stay in a box, such as those on one flight of stairs. Costs what is in it.
WayLacks way_lacks_within(const Scene& scene, const WalkSpace& space, const Vec3& from_m, const Vec3& place_m,
                          const Aabb& box_m, std::span<const Lack> kinds);

}  // namespace handrail
