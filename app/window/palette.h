// Defines the colours of the window, one set for each value of the setting display.colours. Two faces that can be next
// to each other on the plan differ by a contrast of 3:1, or one of them has an outline that has this contrast to both.
// Text has a contrast of at least 7:1. A test computes all of this. Pure functions.
#pragma once

#include <array>
#include <cstdint>

#include "settings/settings.h"

namespace handrail::window {

using Rgb = std::array<std::uint8_t, 3>;

struct Palette {
    Rgb ground, text;                       // of texts, lists, labels and everything that has no other colour
    Rgb outside, inside;                    // ground of the plan outside and inside the building
    Rgb wall;                               // filled
    Rgb object, object_outline;             // high things
    Rgb low, liquid;                        // outlines of low things; hatching
    Rgb door, door_outline, mover_outline;  // doors and movers have the same filling
    Rgb room_outline;
    Rgb path, route, hand_path;  // lines; each also has a pattern or width of its own
    Rgb beacon, mark, walker;
    Rgb hand, touching;  // the proxy while it is free, and while it touches something
    Rgb force;
    bool bare = false;  // the first-person view shows only outlines and stripes
};

const Palette& palette_of(settings::ColourSet colours);

// Returns the contrast of two colours, 1 to 21, as the Web Content Accessibility Guidelines 2.2 define it.
double contrast(const Rgb& a, const Rgb& b);

}  // namespace handrail::window
