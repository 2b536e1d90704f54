// Composes the content of a braille display: three cells of heading, then as much of the message as fits. Pure
// functions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::sinks {

// Returns "N", "NE" and so on if the person faces one of the eight directions, otherwise whole degrees. The text has at
// most three characters.
std::string heading_cells(double heading_rad);

class BrailleLine {
public:
    static constexpr std::size_t kHeadingCells = 3;
    static constexpr std::size_t kLeastForHeading = 12;  // least width of a display that also shows the heading

    // Shows a new message from its first word on. A later set_heading() changes only the heading cells.
    void show(std::string_view utf8);
    // Shows the current item of a list with its place: "Worlds 2/7". Panning past the ends of the item shows the
    // neighbouring items, each with its place, without selecting them. `before` is the text spoken before the item,
    // such as the list's title when the list opens.
    void show_list(std::string_view before, const std::vector<std::string>& items, std::size_t at);
    void set_heading(std::string cells) { heading_ = std::move(cells); }
    void set_width(std::size_t cells);
    // Pan by the width of the display, never past either end. Words that fit are not divided. pan_right() and
    // pan_left() return false if there is nothing more in that direction.
    bool pan_right();
    bool pan_left();
    void pan_home();

    // Returns exactly as many characters as the display has cells.
    std::u32string cells() const;

private:
    std::size_t message_cells() const { return width_ - (width_ >= kLeastForHeading ? kHeadingCells : 0); }
    // Returns the end of the piece that begins at `from`. The piece ends after the last whole word that fits.
    std::size_t end_of_piece(std::size_t from) const;

    void show_item(std::size_t item);

    std::u32string message_;
    std::vector<std::u32string> items_;  // items of the list; empty: a message is shown
    std::size_t at_ = 0, item_ = 0;      // the list's current item, and the item on the display
    std::string heading_;
    std::size_t width_ = 0;
    std::size_t from_ = 0;  // start of the piece on the display
};

}  // namespace handrail::sinks
