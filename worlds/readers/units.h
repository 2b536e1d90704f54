// What one unit of a file is long, where the file does not say. Any thread.
#pragma once

#include <optional>
#include <string_view>

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr double kWidestWorld_m = 2000.0, kNarrowestWorld_m = 2.0;
inline constexpr double kHighestMesh_m = 100.0;

// "mm", "cm", "m", "in" or "inch", "ft" or "feet", or a positive number of metres. Nothing: none of these.
std::optional<double> unit_named(std::string_view word);

// Adds a first warning to the report if the world is over 2 km or under 2 m wide, or a mesh over 100 m high: its width
// as it was read, and in other units.
void ask_about_unit(Scene& scene);
// Adds a first warning to the report if a mesh seems to lie on its side: it is thin from south to north, and most of
// its flat area faces there. Formats without a stated axis are often written with y upwards.
void ask_about_axes(Scene& scene);

}  // namespace handrail
