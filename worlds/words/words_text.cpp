#include "worlds/words/words_text.h"

#include <algorithm>
#include <array>

#include "worlds/base/text.h"

namespace handrail::words {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; }

// Returns the text as UTF-8. Bytes that are not UTF-8 are read as Latin-1, because some Windows editors write umlauts
// so.
std::string as_utf8(std::string_view bytes) {
    if (is_utf8(bytes)) return std::string(bytes);
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            text += c;
        } else {
            text += static_cast<char>(0xC0 | byte >> 6);
            text += static_cast<char>(0x80 | (byte & 0x3F));
        }
    }
    return text;
}

// Returns the length of the quotation mark at this position; 0 if there is none.
std::size_t quotation_mark(std::string_view line, std::size_t at) {
    constexpr std::array<std::string_view, 6> kMarks{"\"", "„", "“", "”", "«", "»"};
    for (const std::string_view mark : kMarks)
        if (line.substr(at).starts_with(mark)) return mark.size();
    return 0;
}

class Cutter {
public:
    std::vector<WordSentence> cut(std::string_view text) {
        while (!text.empty()) {
            const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
            ++line_;
            read_line(text.substr(0, end));
            const bool two = text.substr(end).starts_with("\r\n");
            text.remove_prefix(std::min(end + (two ? 2 : 1), text.size()));
        }
        finish();
        return std::move(sentences_);
    }

private:
    void finish() {
        if (!now_.tokens.empty()) {
            sentences_.push_back(std::move(now_));
            paragraph_ = false;
        }
        now_ = {};
    }

    void add(WordToken::Kind kind, std::string_view text, double number = 0.0) {
        if (now_.tokens.empty()) {
            now_.line = line_;
            now_.first = first_;
            now_.paragraph = paragraph_;
        }
        first_ = false;
        now_.tokens.push_back({kind, std::string(text), folded(text), number});
    }

    void read_line(std::string_view line) {
        const std::size_t begin = std::min(
            static_cast<std::size_t>(std::find_if_not(line.begin(), line.end(), is_blank) - line.begin()), line.size());
        first_ = true;
        if (begin == line.size()) {
            finish();
            paragraph_ = true;
            return;
        }
        if (line[begin] == '#') return;
        for (std::size_t at = begin; at < line.size();) at = read_token(line, at);
        if (now_.tokens.empty() || now_.tokens.back().kind != WordToken::Kind::Comma) finish();
    }

    // Reads a token and returns the position after it.
    std::size_t read_token(std::string_view line, std::size_t at) {
        const char c = line[at];
        if (is_blank(c) || c == '(' || c == ')') return at + 1;
        const bool last = at + 1 == line.size() || is_blank(line[at + 1]);
        if (c == '.' || c == ';' || c == '!') {
            finish();
            return at + 1;
        }
        if (c == ',' || c == ':') {
            add(c == ',' ? WordToken::Kind::Comma : WordToken::Kind::Colon, line.substr(at, 1));
            return at + 1;
        }
        if (const std::size_t mark = quotation_mark(line, at)) {
            std::size_t end = at + mark;
            while (end < line.size() && quotation_mark(line, end) == 0) ++end;
            add(WordToken::Kind::Name, line.substr(at + mark, end - at - mark));
            return end == line.size() ? end : end + quotation_mark(line, end);
        }
        const bool sign = (c == '-' || c == '+') && !last && is_digit(line[at + 1]);
        if (is_digit(c) || sign) return read_number(line, at);
        // Reads a word. The multiplication sign in "4 × 3" is a word as well.
        std::size_t end = at;
        while (end < line.size() && !is_blank(line[end]) && line[end] != ',' && line[end] != ';' && line[end] != ':' &&
               line[end] != '(' && line[end] != ')' && line[end] != '!' && quotation_mark(line, end) == 0) {
            if (line[end] == '.' && (end + 1 == line.size() || is_blank(line[end + 1]))) break;
            ++end;
        }
        add(WordToken::Kind::Word, line.substr(at, end - at));
        return end;
    }

    std::size_t read_number(std::string_view line, std::size_t at) {
        std::size_t end = at + 1;
        while (end < line.size() && is_digit(line[end])) ++end;
        if (end + 1 < line.size() && (line[end] == '.' || line[end] == ',') && is_digit(line[end + 1])) {
            ++end;
            while (end < line.size() && is_digit(line[end])) ++end;
        }
        std::string digits(line.substr(at, end - at));
        std::replace(digits.begin(), digits.end(), ',', '.');
        if (digits.front() == '+') digits.erase(0, 1);
        double value = 0.0;
        if (digits.size() > 30 || !parse_finite(digits, value)) {
            add(WordToken::Kind::Word, line.substr(at, end - at));
            return end;
        }
        add(WordToken::Kind::Number, line.substr(at, end - at), value);
        // In "4x3", the sign between two numbers becomes a separate word.
        const std::size_t sign = end < line.size() && (line[end] == 'x' || line[end] == 'X') ? 1
                                 : line.substr(end).starts_with("×") ? std::string_view("×").size()
                                                                     : 0;
        if (sign > 0 && end + sign < line.size() && is_digit(line[end + sign])) {
            add(WordToken::Kind::Word, "x");
            return end + sign;
        }
        return end;
    }

    std::vector<WordSentence> sentences_;
    WordSentence now_;
    int line_ = 0;
    bool first_ = true, paragraph_ = true;
};

}  // namespace

std::string folded(std::string_view text) {
    std::string lower = lower_ascii(text);
    for (std::size_t i = 0; i + 1 < lower.size(); ++i) {
        if (lower[i] != '\xC3') continue;
        const auto next = static_cast<unsigned char>(lower[i + 1]);
        if (next >= 0x80 && next <= 0x9E && next != 0x97) lower[i + 1] = static_cast<char>(next + 0x20);
    }
    return lower;
}

std::vector<WordSentence> sentences_of(std::string_view bytes) {
    constexpr std::string_view kByteOrder = "\xEF\xBB\xBF";
    if (bytes.starts_with(kByteOrder)) bytes.remove_prefix(kByteOrder.size());
    return Cutter().cut(as_utf8(bytes));
}

}  // namespace handrail::words
