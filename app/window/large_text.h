// Text in large letters for people with low vision: lines that fit a width, and the open list or question. They are
// white on black. The chosen item is inverted and has a pointer, so that more than its colour marks it. Draws into an
// ImGui draw list; no state. App thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/dialogue.h"

struct ImDrawList;
struct ImFont;
struct ImVec2;

namespace handrail::window {

// Splits a text of this height into lines no wider than wrap_px, at blanks and at line feeds. The lines are views into
// `text`.
std::vector<std::string_view> wrapped_lines(ImFont& font, float line_px, const std::string& text, float wrap_px);

// The visible items of a list.
struct ListWindow {
    std::size_t first = 0, count = 0;
};
// `lines` has the height of each item, at least 1. The item `at` is always visible, and so are its neighbours if there
// is room; a list that fits begins at its first item. Pure: the window depends only on the current item, not on the one
// before.
ListWindow list_window(std::span<const std::size_t> lines, std::size_t at, std::size_t room_lines);

// Covers the box. Title and place ("2/7") are at the top; arrows show that there is more beyond either end. A question
// shows the typed text, or the end of it if it is long.
void draw_dialogue(ImDrawList& list, ImFont& font, const core::DialogueView& dialogue, ImVec2 min_px, ImVec2 max_px,
                   float line_px);

}  // namespace handrail::window
