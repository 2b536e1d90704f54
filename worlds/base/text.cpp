#include "worlds/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace handrail {
namespace {

// Returns the length in bytes of the first character of `text`, or 0 if that character is not well-formed UTF-8.
std::size_t bytes_of_character(std::string_view text) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    const unsigned first = byte(0);
    const std::size_t extra = first < 0x80       ? 0
                              : first >> 5 == 6  ? 1
                              : first >> 4 == 14 ? 2
                              : first >> 3 == 30 ? 3
                                                 : text.size();
    if (extra >= text.size()) return 0;
    unsigned code = extra == 0 ? first : first & (0x3fU >> extra);
    for (std::size_t k = 1; k <= extra; ++k) {
        if (byte(k) >> 6 != 2) return 0;
        code = code << 6 | (byte(k) & 0x3fU);
    }
    constexpr unsigned kLeast[] = {0, 0x80, 0x800, 0x10000};
    if (code < kLeast[extra] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return 0;
    return extra + 1;
}

}  // namespace

std::string lower_ascii(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

std::string nearest_name(std::string_view word, std::span<const std::string> candidates, std::size_t most) {
    const std::string a = lower_ascii(word);
    std::size_t best = static_cast<std::size_t>(-1);
    const std::string* found = nullptr;
    std::vector<std::size_t> row;
    for (const std::string& candidate : candidates) {
        const std::string b = lower_ascii(candidate);
        row.resize(b.size() + 1);
        std::iota(row.begin(), row.end(), std::size_t{0});
        for (std::size_t i = 1; i <= a.size(); ++i) {
            std::size_t diagonal = row[0];
            row[0] = i;
            for (std::size_t j = 1; j <= b.size(); ++j) {
                const std::size_t above = row[j];
                row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U)});
                diagonal = above;
            }
        }
        if (row[b.size()] < best) {
            best = row[b.size()];
            found = &candidate;
        }
    }
    return found && best <= most ? *found : std::string{};
}

std::string nearest_key(std::string_view key, std::span<const std::string> keys) {
    const std::size_t dot = key.rfind('.');
    if (dot == std::string_view::npos) return nearest_name(key, keys);
    const std::string table = lower_ascii(key.substr(0, dot + 1));
    std::vector<std::string> same;
    for (const std::string& known : keys)
        if (known.starts_with(table) && known.find('.', table.size()) == std::string::npos) same.push_back(known);
    return same.empty() ? nearest_name(key, keys) : nearest_name(key, same);
}

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t bytes = bytes_of_character(text.substr(i));
        if (bytes == 0) return false;
        i += bytes;
    }
    return true;
}

bool begins_with_direction_control(std::string_view text) {
    const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0; };
    if (byte(0) == 0xd8) return byte(1) == 0x9c;  // U+061C is the only direction control with two bytes
    if (byte(0) != 0xe2) return false;
    if (byte(1) == 0x80) return byte(2) == 0x8e || byte(2) == 0x8f || (byte(2) >= 0xaa && byte(2) <= 0xae);
    return byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9;  // true for U+2066 to U+2069
}

std::string one_line(std::string_view text) {
    std::string line;
    line.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = std::max<std::size_t>(bytes_of_character(text), 1);
        const std::string_view character = text.substr(0, bytes);
        const auto first = static_cast<unsigned char>(character[0]),
                   second = static_cast<unsigned char>(bytes > 1 ? character[1] : 0);
        const bool separator = character == "\u2028" || character == "\u2029";
        if (begins_with_direction_control(character)) {
        } else if (first < 0x20 || first == 0x7f || (first == 0xc2 && second < 0xa0 && bytes == 2) || separator)
            line += ' ';
        else if (bytes == 1 && first >= 0x80) line += "\xEF\xBF\xBD";
        else line += character;
        text.remove_prefix(bytes);
    }
    return line;
}

std::vector<std::string> characters_of(std::string_view text) {
    std::vector<std::string> characters;
    for (const char byte : text) {
        if (!characters.empty() && (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U) characters.back() += byte;
        else characters.emplace_back(1, byte);
    }
    return characters;
}

std::optional<TakenNumber> take_number(std::string_view& text, bool exponent) {
    std::string_view digits = text;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    if (digits.size() < text.size() && digits.starts_with('-')) return std::nullopt;
    TakenNumber taken;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), taken.value,
                                              exponent ? std::chars_format::general : std::chars_format::fixed);
    if (error == std::errc::invalid_argument) return std::nullopt;
    const std::string_view number = digits.substr(0, static_cast<std::size_t>(end - digits.data()));
    if (error == std::errc::result_out_of_range) {
        const bool tiny = number.find("e-") != std::string_view::npos || number.find("E-") != std::string_view::npos;
        const double sign = number.starts_with('-') ? -1.0 : 1.0;
        taken = {tiny ? 0.0 : std::copysign(std::numeric_limits<double>::max(), sign), false};
    }
    text = digits.substr(number.size());
    return taken;
}

bool parse_finite(std::string_view text, double& value) {
    const auto taken = take_number(text);
    if (!taken || !taken->in_range || !text.empty() || !std::isfinite(taken->value)) return false;
    value = taken->value;
    return true;
}

}  // namespace handrail
