#include "app/main/plain_output.h"

#include <string_view>

#include "worlds/base/text.h"

namespace handrail::program {
namespace {

// Returns true if the bytes may be the beginning of a direction control. The UTF-8 of every direction control begins
// with one of these byte sequences.
bool may_become_one(std::string_view bytes) {
    return bytes == "\xd8" || bytes == "\xe2" || bytes == "\xe2\x80" || bytes == "\xe2\x81";
}

bool steers(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f;
}

}  // namespace

int PlainOutput::overflow(int byte) {
    if (std::char_traits<char>::eq_int_type(byte, std::char_traits<char>::eof()))
        return std::char_traits<char>::not_eof(byte);
    const char c = std::char_traits<char>::to_char_type(byte);
    held_ += c;
    if (begins_with_direction_control(held_)) {
        held_.clear();
    } else if (!may_become_one(held_)) {
        held_.pop_back();
        let_go();
        if (!steers(c)) held_ += c;
        if (!may_become_one(held_)) let_go();
    }
    return to_ ? byte : std::char_traits<char>::eof();
}

int PlainOutput::sync() {
    let_go();
    to_.flush();
    return to_ ? 0 : -1;
}

void PlainOutput::let_go() {
    to_ << held_;
    held_.clear();
}

}  // namespace handrail::program
