// Converts units of length, and warns about files that do not state theirs. Any thread may call these functions.
#pragma once

#include <optional>
#include <string_view>

#include "worlds/scene/scene.h"

namespace handrail::readers {

inline constexpr double kWidestWorld_m = 2000.0, kNarrowestWorld_m = 2.0;
inline constexpr double kHighestMesh_m = 100.0;

// Returns the length in metres of a unit: "mm", "cm", "m", "in" or "inch", "ft" or "feet". A positive number is a
// length in metres. Empty for any other word.
std::optional<double> unit_named(std::string_view word);

// If the world is over 2 km or under 2 m wide, or a mesh is over 100 m high, inserts a warning at the front of the
// report. The warning states the width as read and in other units.
void question_unit(Scene& scene);
// If a mesh seems to lie on its side, inserts a warning at the front of the report. Such a mesh is thin from south to
// north, and most of its flat area faces in that direction. Formats without a stated axis are often written with y
// upwards, which causes this.
void question_axes(Scene& scene);

}  // namespace handrail::readers
