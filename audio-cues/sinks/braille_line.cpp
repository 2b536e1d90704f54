#include "audio-cues/sinks/braille_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "worlds/base/language.h"

namespace handrail::sinks {
namespace {

// The text is valid UTF-8 (see Utterance), so only the lead bytes are examined.
std::u32string code_points(std::string_view utf8) {
    std::u32string text;
    for (const char c : utf8) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) text += static_cast<char32_t>(byte);
        else if (byte < 0xC0 && !text.empty()) text.back() = (text.back() << 6) | (byte & 0x3FU);
        else if (byte >= 0xC0)
            text += static_cast<char32_t>(byte < 0xE0 ? byte & 0x1FU : byte < 0xF0 ? byte & 0x0FU : byte & 0x07U);
    }
    return text;
}

}  // namespace

std::string heading_cells(double heading_rad) {
    constexpr std::array<const char*, 8> kNames{"braille.n", "braille.ne", "braille.e", "braille.se",
                                                "braille.s", "braille.sw", "braille.w", "braille.nw"};
    const double turned = std::fmod(heading_rad * 180.0 / std::numbers::pi, 360.0);
    const int degrees = static_cast<int>(std::lround(turned < 0.0 ? turned + 360.0 : turned)) % 360;
    if (degrees % 45 == 0) return phrase(kNames[static_cast<std::size_t>(degrees / 45)]);
    return std::to_string(degrees);
}

void BrailleLine::show(std::string_view utf8) {
    message_ = code_points(utf8);
    items_.clear();
    from_ = 0;
}

void BrailleLine::show_list(std::string_view before, const std::vector<std::string>& items, std::size_t at) {
    show(before);
    if (at >= items.size()) return;
    for (std::size_t i = 0; i < items.size(); ++i)
        items_.push_back(code_points((i == at ? std::string(before) : std::string()) + items[i] + " " +
                                     std::to_string(i + 1) + "/" + std::to_string(items.size())));
    at_ = at;
    show_item(at);
}

void BrailleLine::show_item(std::size_t item) {
    item_ = item;
    message_ = items_[item];
    from_ = 0;
}

void BrailleLine::pan_home() {
    if (!items_.empty()) show_item(at_);
    from_ = 0;
}

void BrailleLine::set_width(std::size_t cells) {
    if (cells != width_) from_ = 0;
    width_ = cells;
}

std::size_t BrailleLine::end_of_piece(std::size_t from) const {
    const std::size_t room = message_cells();
    if (message_.size() - from <= room) return message_.size();
    const std::size_t blank = message_.rfind(U' ', from + room);
    return blank == std::u32string::npos || blank <= from ? from + room : blank + 1;
}

bool BrailleLine::pan_right() {
    if (message_cells() == 0) return false;
    const std::size_t end = end_of_piece(from_);
    if (end >= message_.size()) {
        if (items_.empty() || item_ + 1 >= items_.size()) return false;
        show_item(item_ + 1);
        return true;
    }
    from_ = end;
    return true;
}

bool BrailleLine::pan_left() {
    if (message_cells() == 0) return false;
    if (from_ == 0) {
        if (items_.empty() || item_ == 0) return false;
        show_item(item_ - 1);
        for (std::size_t next = end_of_piece(0); next < message_.size(); next = end_of_piece(next)) from_ = next;
        return true;
    }
    // Pieces are laid out from the beginning of the text. The previous piece is therefore the last piece that ends at
    // or before from_.
    std::size_t before = 0;
    for (std::size_t next = end_of_piece(0); next < from_; next = end_of_piece(next)) before = next;
    from_ = before;
    return true;
}

std::u32string BrailleLine::cells() const {
    std::u32string line;
    if (width_ == 0) return line;
    if (width_ >= kLeastForHeading) {
        for (const char c : heading_.substr(0, kHeadingCells)) line += static_cast<char32_t>(c);
        line.resize(kHeadingCells, U' ');
    }
    line += message_.substr(from_, std::min(end_of_piece(from_) - from_, message_cells()));
    line.resize(width_, U' ');
    return line;
}

}  // namespace handrail::sinks
