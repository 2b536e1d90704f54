#include "worlds/readers/spoken_text.h"

#include <algorithm>
#include <cctype>

#include "worlds/base/text.h"

namespace handrail::readers {
namespace {

constexpr std::size_t kMostBytes = 1000;  // greatest length of a text, about one minute of speech

void add_latin1(std::string& text, unsigned char c) {
    if (c < 0x80) {
        text += static_cast<char>(c);
        return;
    }
    text += static_cast<char>(0xC0 | (c >> 6));
    text += static_cast<char>(0x80 | (c & 0x3F));
}

}  // namespace

std::string spoken_text(std::string_view raw) {
    std::string_view cut = raw.substr(0, kMostBytes);
    if (cut.size() < raw.size())
        while (!cut.empty() && (static_cast<unsigned char>(raw[cut.size()]) & 0xC0) == 0x80) cut.remove_suffix(1);
    const bool utf8 = is_utf8(cut);
    std::string text;
    const auto blank = [&] {
        if (!text.empty() && text.back() != ' ') text += ' ';
    };
    for (std::size_t i = 0; i < cut.size(); ++i) {
        const auto c = static_cast<unsigned char>(cut[i]);
        if (c == '\\' && i + 1 < cut.size() && cut[i + 1] == 'n') {
            while (!text.empty() && text.back() == ' ') text.pop_back();
            if (const auto last = static_cast<unsigned char>(text.empty() ? '.' : text.back());
                last >= 0x80 || std::isalnum(last))
                text += ',';
            blank();
            ++i;
        } else if (c <= ' ' || c == 0x7F || (!utf8 && c >= 0x80 && c < 0xA0)) {
            blank();
        } else if (utf8) {
            text += static_cast<char>(c);
        } else {
            add_latin1(text, c);
        }
    }
    while (!text.empty() && (text.back() == ' ' || text.back() == ',')) text.pop_back();
    return text;
}

std::string words_of_name(std::string_view name) {
    std::string text = spoken_text(name);
    if (const std::size_t slash = text.find_last_of("/\\"); slash != std::string::npos) text.erase(0, slash + 1);
    if (const std::size_t dot = text.rfind('.'); dot != std::string::npos && dot > 0 && text.size() - dot <= 5)
        text.erase(dot);
    std::replace(text.begin(), text.end(), '_', ' ');
    std::replace(text.begin(), text.end(), '-', ' ');
    return spoken_text(text);
}

}  // namespace handrail::readers
