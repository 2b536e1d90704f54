// Converts the window's colours to those of ImGui. Only the files that draw with ImGui include it.
#pragma once

#include <imgui.h>

#include "app/window/palette.h"

namespace handrail::window {

inline ImU32 colour_of(const Rgb& rgb) { return IM_COL32(rgb[0], rgb[1], rgb[2], 255); }

}  // namespace handrail::window
