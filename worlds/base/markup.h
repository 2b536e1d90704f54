// Escapes text for HTML pages and SVG pictures. Pure functions; any thread may call them.
#pragma once

#include <string>
#include <string_view>

#include "worlds/base/text.h"

namespace handrail {

// Escapes text for use in an element or in an attribute in double quotes. Removes control characters that XML 1.0
// forbids. Also removes direction controls, which would reverse the text that follows them on the page.
inline std::string markup_text(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        if (begins_with_direction_control(text)) {
            text.remove_prefix(static_cast<unsigned char>(text.front()) == 0xd8 ? 2 : 3);
            continue;
        }
        const char c = text.front();
        text.remove_prefix(1);
        const auto byte = static_cast<unsigned char>(c);
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else if (c == '"') out += "&quot;";
        else if (byte >= 0x20 || c == '\n' || c == '\t') out += c;
    }
    return out;
}

}  // namespace handrail
