// Text in large letters for people with low vision: lines that fit a width, and the list or question that is open, as
// white on black with the chosen item turned round to black on white behind a pointer, so that it is told by more than
// its colour. Draws into a list of ImGui's; no state. App thread.
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

namespace handrail {

// The lines of a text at this height that are no wider than wrap_px, broken at blanks and at \n; views into `text`.
std::vector<std::string_view> wrapped_lines(ImFont& font, float line_px, const std::string& text, float wrap_px);

// The items of a list that are in sight.
struct ListWindow {
    std::size_t first = 0, count = 0;
};
// lines: of each item, at least 1. The item `at` is always in sight, and its neighbours where there is room; a list
// that fits begins at its first item. Pure; for every item the window is the same wherever one came from.
ListWindow list_window(std::span<const std::size_t> lines, std::size_t at, std::size_t room_lines);

// Covers the box. The title and the place ("2/7") stand above, arrows tell that more lies beyond either end. A question
// shows what is typed, and its end where that is long.
void draw_dialogue(ImDrawList& list, ImFont& font, const DialogueView& dialogue, ImVec2 min_px, ImVec2 max_px,
                   float line_px);

}  // namespace handrail
