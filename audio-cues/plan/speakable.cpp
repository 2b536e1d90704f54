#include "audio-cues/plan/speakable.h"

#include <cstddef>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::cues {
namespace {

bool continues(unsigned char byte) { return (byte & 0xc0U) == 0x80U; }

// Returns the length of the well-formed UTF-8 sequence at the start of `text`, or 0 if there is none (Unicode standard,
// table 3-7).
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
    };
    const unsigned char b0 = byte(0), b1 = byte(1);
    if (b0 < 0x80) return 1;
    if (b0 >= 0xc2 && b0 <= 0xdf) return continues(b1) ? 2 : 0;
    if (b0 >= 0xe0 && b0 <= 0xef) {
        const bool too_long = b0 == 0xe0 && b1 < 0xa0;
        const bool surrogate = b0 == 0xed && b1 > 0x9f;
        return continues(b1) && continues(byte(2)) && !too_long && !surrogate ? 3 : 0;
    }
    if (b0 >= 0xf0 && b0 <= 0xf4) {
        const bool too_long = b0 == 0xf0 && b1 < 0x90;
        const bool too_high = b0 == 0xf4 && b1 > 0x8f;
        return continues(b1) && continues(byte(2)) && continues(byte(3)) && !too_long && !too_high ? 4 : 0;
    }
    return 0;
}

}  // namespace

std::string speakable(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    bool gap = false;
    while (!text.empty()) {
        const auto first = static_cast<unsigned char>(text.front());
        const std::size_t length = utf8_length(text);
        // C1 control characters are c2 80 to c2 9f in UTF-8, and 80 to 9f in Latin-1.
        const bool c1 = (length == 2 && first == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0) ||
                        (length == 0 && first < 0xa0);
        const bool separator = text.starts_with("\u2028") || text.starts_with("\u2029");
        if (begins_with_direction_control(text)) {
        } else if (first <= 0x20 || first == 0x7f || c1 || separator) {
            gap = !out.empty();
        } else {
            if (gap) out += ' ';
            gap = false;
            if (length > 0) out += text.substr(0, length);
            else {
                out += static_cast<char>(0xc0U | (first >> 6U));
                out += static_cast<char>(0x80U | (first & 0x3fU));
            }
        }
        text.remove_prefix(length > 0 ? length : 1);
    }
    return out;
}

std::string sentence_case(std::string_view text) { return capitalised(speakable(text)); }

}  // namespace handrail::cues
