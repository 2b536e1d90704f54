// The content of a braille display: three cells of heading, then as much of the message as fits. Pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::sinks {

// "N", "NE" and so on if the person faces one of the eight directions, otherwise whole degrees; at most three
// characters.
std::string heading_cells(double heading_rad);

class BrailleLine {
public:
    static constexpr std::size_t kHeadingCells = 3;
    static constexpr std::size_t kLeastForHeading = 12;  // narrower displays show only the message

    // Starts a new message at its first word. The heading changes in place.
    void show(std::string_view utf8);
    // Shows the current item of a list with its place: "Worlds 2/7". Panning past its ends shows the neighbouring
    // items, each with its place, without moving to them. before: what was said before the item, such as the list's
    // title when it opens.
    void show_list(std::string_view before, const std::vector<std::string>& items, std::size_t at);
    void set_heading(std::string cells) { heading_ = std::move(cells); }
    void set_width(std::size_t cells);
    // Pan by a display's width, never past either end; words stay whole if they fit. Returns false if there is nothing
    // more in that direction.
    bool pan_right();
    bool pan_left();
    void pan_home();

    // Exactly as many characters as the display has cells.
    std::u32string cells() const;

private:
    std::size_t message_cells() const { return width_ - (width_ >= kLeastForHeading ? kHeadingCells : 0); }
    // The end of the piece that begins at `from`: after the last whole word that fits.
    std::size_t end_of_piece(std::size_t from) const;

    void show_item(std::size_t item);

    std::u32string message_;
    std::vector<std::u32string> items_;  // items of a list; empty: a message is shown
    std::size_t at_ = 0, item_ = 0;      // the current item, and the item that is shown
    std::string heading_;
    std::size_t width_ = 0;
    std::size_t from_ = 0;  // start of the piece that is shown
};

}  // namespace handrail::sinks
