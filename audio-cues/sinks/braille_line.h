// What stands on a braille display: three cells of heading, then the message, a display's width of it at a time. Pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace handrail {

// "N", "NE" ... where one faces one of the eight directions, else whole degrees; at most three characters.
std::string heading_cells(double heading_rad);

class BrailleLine {
public:
    static constexpr std::size_t kHeadingCells = 3;
    static constexpr std::size_t kLeastForHeading = 12;  // narrower displays are all message

    // A new message begins at its first word; the heading changes in place.
    void show(std::string_view utf8);
    void set_heading(std::string cells) { heading_ = std::move(cells); }
    void set_width(std::size_t cells);
    // By a display's width, never past either end; words stay whole where they fit. False where there is nothing more that way.
    bool pan_right();
    bool pan_left();
    void pan_home() { from_ = 0; }

    // Exactly as many characters as there are cells.
    std::u32string cells() const;

private:
    std::size_t message_cells() const { return width_ - (width_ >= kLeastForHeading ? kHeadingCells : 0); }
    // Where the piece that begins at `from` ends: after the last whole word that fits.
    std::size_t end_of_piece(std::size_t from) const;

    std::u32string message_;
    std::string heading_;
    std::size_t width_ = 0;
    std::size_t from_ = 0;  // of the piece that is shown
};

}  // namespace handrail
