// What stands on a braille display: three cells of heading, then the message, a display's width of it at a time. Pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace handrail {

// "N", "NE" ... where one faces one of the eight directions, else whole degrees; at most three characters.
std::string heading_cells(double heading_rad);

class BrailleLine {
public:
    static constexpr std::size_t kHeadingCells = 3;
    static constexpr std::size_t kLeastForHeading = 12;  // narrower displays are all message

    // A new message begins at its first word; the heading changes in place.
    void show(std::string_view utf8);
    // The item of a list one is at, with its place: "Worlds 2/7". Panning past its ends shows the items round it, each
    // with its place, without going there. before: what was said before the item, as the list's title when it opens.
    void show_list(std::string_view before, const std::vector<std::string>& items, std::size_t at);
    void set_heading(std::string cells) { heading_ = std::move(cells); }
    void set_width(std::size_t cells);
    // By a display's width, never past either end; words stay whole where they fit. False where there is nothing more
    // that way.
    bool pan_right();
    bool pan_left();
    void pan_home();

    // Exactly as many characters as there are cells.
    std::u32string cells() const;

private:
    std::size_t message_cells() const { return width_ - (width_ >= kLeastForHeading ? kHeadingCells : 0); }
    // Where the piece that begins at `from` ends: after the last whole word that fits.
    std::size_t end_of_piece(std::size_t from) const;

    void show_item(std::size_t item);

    std::u32string message_;
    std::vector<std::u32string> items_;  // of a list; empty: a message
    std::size_t at_ = 0, item_ = 0;      // where one is, and what is shown
    std::string heading_;
    std::size_t width_ = 0;
    std::size_t from_ = 0;  // of the piece that is shown
};

}  // namespace handrail
