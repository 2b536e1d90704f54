// Draws the force on the hand as an arrow. App thread.
#pragma once

#include <imgui.h>

#include "app/window/palette.h"

namespace handrail::window {

// Forces below this are not drawn.
inline constexpr double kLeastDrawnForce_n = 0.05;

// Draws an arrow that begins at `from` in a direction, a unit vector on the screen. `unit_px` is a fifth of the height
// of the letters. For each newton, the arrow is as long as letters are high. It has a border in the colour of the
// ground. Returns the place of the tip.
ImVec2 draw_force(ImDrawList& list, ImVec2 from, ImVec2 direction, double newtons, float unit_px,
                  const Palette& palette);
// Writes the newtons next to the tip of such an arrow.
void write_force(ImDrawList& list, ImFont& font, ImVec2 tip, ImVec2 direction, double newtons, float unit_px,
                 const Palette& palette);

}  // namespace handrail::window
