// Text for pages and pictures: HTML and SVG. Pure; any thread.
#pragma once

#include <string>
#include <string_view>

namespace handrail {

// As the text of an element or an attribute in double quotes; control characters that XML 1.0 has no place for are left
// out.
inline std::string markup_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
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
