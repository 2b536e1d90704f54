// Decodes strings of STEP files, by ISO 10303-21, clause 6.4.3.
#include <array>
#include <cstdint>

#include "worlds/base/text.h"
#include "worlds/ifc/step_file.h"

namespace handrail::ifc {
namespace {

void add_utf8(std::string& to, std::uint32_t code) {
    if (code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) code = 0xfffd;
    const auto byte = [&](std::uint32_t b) { to += static_cast<char>(b); };
    if (code < 0x80) byte(code);
    else if (code < 0x800) byte(0xc0 | code >> 6), byte(0x80 | (code & 0x3f));
    else if (code < 0x10000) byte(0xe0 | code >> 12), byte(0x80 | (code >> 6 & 0x3f)), byte(0x80 | (code & 0x3f));
    else
        byte(0xf0 | code >> 18), byte(0x80 | (code >> 12 & 0x3f)), byte(0x80 | (code >> 6 & 0x3f)),
            byte(0x80 | (code & 0x3f));
}

int hex(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                  : -1;
}

// Parses exactly `digits` hexadecimal digits. Returns false if they are missing or invalid.
bool hex_number(std::string_view text, std::size_t digits, std::uint32_t& value) {
    if (text.size() < digits) return false;
    value = 0;
    for (const char c : text.substr(0, digits)) {
        if (hex(c) < 0) return false;
        value = value << 4 | static_cast<std::uint32_t>(hex(c));
    }
    return true;
}

// Returns the character for \S\ in a part of ISO 8859 that differs from Latin-1: Cyrillic (5), Greek (7), Hebrew (8),
// and six characters of Turkish (9). All other parts are read as Latin-1.
std::uint32_t of_page(char page, std::uint32_t code) {
    if (page == 'E' && code >= 0xa1 && code != 0xad) return code == 0xf0 ? 0x2116 : code == 0xfd ? 0xa7 : code + 0x360;
    if (page == 'G' && code >= 0xb4 && code != 0xb7 && code != 0xbb && code != 0xbd) return code + 0x2d0;
    if (page == 'H' && code >= 0xe0 && code <= 0xfa) return code + 0x4f0;
    if (page == 'I') {
        constexpr std::array<std::array<std::uint32_t, 2>, 6> kTurkish{
            {{0xd0, 0x11e}, {0xdd, 0x130}, {0xde, 0x15e}, {0xf0, 0x11f}, {0xfd, 0x131}, {0xfe, 0x15f}}};
        for (const auto& [from, to] : kTurkish)
            if (code == from) return to;
    }
    return code;
}

}  // namespace

std::string decoded(std::string_view raw) {
    std::string text;
    const bool utf8 = is_utf8(raw);
    char page = 'A';
    for (std::size_t i = 0; i < raw.size();) {
        const std::string_view rest = raw.substr(i);
        std::uint32_t code = 0;
        if (rest.starts_with("''")) {
            text += '\'';
            i += 2;
        } else if (rest.starts_with("\\X2\\") || rest.starts_with("\\X4\\")) {
            const std::size_t digits = rest[2] == '2' ? 4 : 8;
            i += 4;
            for (std::uint32_t high = 0; hex_number(raw.substr(i), digits, code); i += digits) {
                if (digits == 4 && code >= 0xd800 && code < 0xdc00) {  // a surrogate pair of UTF-16
                    high = code;
                    continue;
                }
                if (high != 0 && code >= 0xdc00 && code < 0xe000)
                    code = 0x10000 + ((high - 0xd800) << 10) + (code - 0xdc00);
                high = 0;
                add_utf8(text, code);
            }
            if (raw.substr(i).starts_with("\\X0\\")) i += 4;
        } else if (rest.starts_with("\\X\\") && hex_number(rest.substr(3), 2, code)) {
            add_utf8(text, code);
            i += 5;
        } else if (rest.starts_with("\\S\\") && rest.size() > 3) {
            add_utf8(text, of_page(page, 0x80 | (static_cast<unsigned char>(rest[3]) & 0x7fU)));
            i += rest.substr(3).starts_with("''") ? 5 : 4;  // Some programs double the apostrophe after \S\ too.
        } else if (rest.size() >= 4 && rest.starts_with("\\P") && rest[3] == '\\') {
            page = rest[2];
            i += 4;
        } else if (rest.starts_with("\\\\")) {
            text += '\\';
            i += 2;
        } else if (const auto byte = static_cast<unsigned char>(rest[0]); byte >= 0x80 && !utf8) {
            add_utf8(text, byte);
            ++i;
        } else {
            text += rest[0];
            ++i;
        }
    }
    return text;
}

}  // namespace handrail::ifc
