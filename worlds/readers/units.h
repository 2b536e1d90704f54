// What one unit of a file is long, where the file does not say. Any thread.
#pragma once

#include <optional>
#include <string_view>

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr double kWidestWorld_m = 2000.0, kNarrowestWorld_m = 2.0;

// "mm", "cm", "m", "in" or "inch", "ft" or "feet", or a positive number of metres. Nothing: none of these.
std::optional<double> unit_named(std::string_view word);

// Adds a first warning to the report where the world would be over 2 km or under 2 m wide: how wide it is, and how wide
// in other units.
void ask_about_unit(Scene& scene);

}  // namespace handrail
