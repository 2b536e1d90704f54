// Divides the window: the pictures are at the top, then two lines about the hand and the task, then the last messages.
// So no text covers a picture. Pure functions; lengths are in pixels.
#pragma once

#include "app/core/context/view.h"
#include "app/window/plan.h"

namespace handrail::window {

struct PixelSize {
    int width = 0;
    int height = 0;

    bool operator==(const PixelSize&) const = default;
};

// Height of a line of the newest message as a fraction of the window's height, for people with low vision, if the text
// size is 1.
inline constexpr double kTextLinePart = 1.0 / 12.0;
// The pictures get at least this fraction of the window's height.
inline constexpr double kLeastPicturesPart = 0.35;

struct WindowLayout {
    PixelBox pictures;            // all of the pictures; an open list covers it
    PixelBox first_person, plan;  // empty: the window does not show this picture
    PixelBox status;              // two lines about the hand and the task
    PixelBox messages;
    float line_px = 0.0F;   // height of a line of the newest message and of lists
    float small_px = 0.0F;  // height of a line of older messages and of the status
};

// `text_size` is the setting display.text_size. With both pictures, they are next to each other in a wide window and
// one above the other in a high one.
WindowLayout lay_out_window(PixelSize size, core::Pictures pictures, double text_size);

inline bool is_empty(const PixelBox& box) { return box.max_px.x <= box.min_px.x || box.max_px.y <= box.min_px.y; }

}  // namespace handrail::window
