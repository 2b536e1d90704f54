// Draws text in large letters for people with low vision: the last messages, two lines about the hand and the task, and
// the open list or question. The chosen item is inverted and has a pointer, so that people need not rely on its
// colour. Draws into an ImGui draw list; no state. App thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/dialogue.h"
#include "app/window/palette.h"
#include "app/window/window_layout.h"

struct ImDrawList;
struct ImFont;
struct ImVec2;

namespace handrail::window {

// Splits `text` into lines that are no wider than `wrap_px` if letters are `line_px` high. Splits at blanks and at line
// feeds. The lines are views into `text`.
std::vector<std::string_view> wrapped_lines(ImFont& font, float line_px, const std::string& text, float wrap_px);

// The range of visible items of a list.
struct ListWindow {
    std::size_t first = 0, count = 0;
};
// Returns the visible items. `lines` contains the height of each item in lines, at least 1. The item `at` is always
// visible, and so are its neighbours if there is space. If the whole list fits, returns all items. Pure function: the
// result does not depend on an earlier current item.
ListWindow list_window(std::span<const std::size_t> lines, std::size_t at, std::size_t room_lines);

// A line of text with its height in pixels.
struct TextLine {
    std::string text;
    float high_px = 0.0F;
};
// Returns the lines of the last messages (`messages` has the oldest first), the newest message first, which fit into a
// box of this size. The newest message is in large letters if it then needs at most two lines, otherwise in small ones.
// Older messages are in small letters and get at least one line each while there is space. Three dots show that the end
// of a message is left out.
std::vector<TextLine> message_lines(ImFont& font, const std::vector<std::string>& messages, const WindowLayout& layout);
void draw_messages(ImDrawList& list, ImFont& font, const std::vector<std::string>& messages, const WindowLayout& layout,
                   const Palette& palette);
// Returns the height of letters at which the text fits into this width: `small_px`, or down to 0.6 of it.
float status_px(ImFont& font, const std::string& text, float wide_px, float small_px);
// Draws each text on one line of the status, in smaller letters if it is long.
void draw_status(ImDrawList& list, ImFont& font, std::span<const std::string> texts, const WindowLayout& layout,
                 const Palette& palette);

// Draws the open list or question, so that it covers the box. Title and position ("2/7") are at the top. Arrows show
// that there are more items beyond either end. A question also shows the typed text, or only the end of that text if it
// is long.
void draw_dialogue(ImDrawList& list, ImFont& font, const core::DialogueView& dialogue, ImVec2 min_px, ImVec2 max_px,
                   float line_px, const Palette& palette);

}  // namespace handrail::window
