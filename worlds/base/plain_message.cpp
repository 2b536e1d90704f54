#include "worlds/base/plain_message.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cwctype>
#include <set>

#include "worlds/base/text.h"

namespace handrail {
namespace {

using Part = PlainMessage::Part;
using Kind = PlainMessage::Kind;
using Number = std::variant<std::int64_t, double>;

// A decimal number 0.DIGITS * 10^point. The digits neither begin nor end with a zero.
struct Decimal {
    std::string digits;
    int point = 0;
    bool minus = false;
};

void drop_zeros(Decimal& number) {
    const std::size_t zeros = std::min(number.digits.find_first_not_of('0'), number.digits.size());
    number.digits.erase(0, zeros);
    number.point -= static_cast<int>(zeros);
    while (!number.digits.empty() && number.digits.back() == '0') number.digits.pop_back();
    if (number.digits.empty()) number.point = 0;
}

// Uses the shortest decimal number that reads back as the same value, as ICU does.
Decimal decimal_of(const Number& value) {
    Decimal made;
    std::string text = std::visit([](auto number) { return fmt::format("{}", number); }, value);
    made.minus = text.front() == '-';
    if (made.minus) text.erase(0, 1);
    int exponent = 0;
    if (const std::size_t at = text.find('e'); at != std::string::npos) {
        exponent = std::atoi(text.c_str() + at + 1);
        text.resize(at);
    }
    const std::size_t dot = text.find('.');
    made.point = static_cast<int>(std::min(dot, text.size())) + exponent;
    if (dot != std::string::npos) text.erase(dot, 1);
    made.digits = std::move(text);
    drop_zeros(made);
    return made;
}

// Keeps this many digits, of which there may be none or fewer than none.
void round_to(Decimal& number, int kept) {
    if (kept >= static_cast<int>(number.digits.size())) return;
    bool up = false;
    if (kept >= 0) {
        const auto at = static_cast<std::size_t>(kept);
        const bool half = number.digits[at] == '5' && number.digits.size() == at + 1;
        up = half ? at > 0 && (number.digits[at - 1] - '0') % 2 == 1 : number.digits[at] >= '5';
    }
    number.digits.resize(static_cast<std::size_t>(std::max(kept, 0)));
    if (up) {
        while (!number.digits.empty() && number.digits.back() == '9') number.digits.pop_back();
        if (number.digits.empty()) {
            number.digits = "1";
            ++number.point;
        } else {
            ++number.digits.back();
        }
    }
    drop_zeros(number);
}

std::string number_text(const Number& value, const NumberFormat& format, bool german) {
    if (const auto* number = std::get_if<double>(&value)) {
        if (std::isnan(*number)) return "NaN";
        if (std::isinf(*number)) return *number < 0 ? "-∞" : "∞";
    }
    Decimal number = decimal_of(value);
    round_to(number, format.significant > 0 ? format.significant : number.point + format.most);
    const int digits = static_cast<int>(number.digits.size());
    std::string whole, fraction;
    for (int i = 0; i < number.point; ++i) whole += i < digits ? number.digits[static_cast<std::size_t>(i)] : '0';
    if (whole.empty()) whole = "0";
    if (digits > number.point) {
        fraction.append(static_cast<std::size_t>(std::max(-number.point, 0)), '0');
        fraction += number.digits.substr(static_cast<std::size_t>(std::max(number.point, 0)));
    }
    while (static_cast<int>(fraction.size()) < format.least) fraction += '0';
    if (format.grouped)
        for (int at = static_cast<int>(whole.size()) - 3; at > 0; at -= 3)
            whole.insert(static_cast<std::size_t>(at), german ? "." : ",");
    if (!fraction.empty()) whole += (german ? "," : ".") + fraction;
    return (number.minus ? "-" : "") + whole;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

// Reads decimals such as ".0#": each 0 is always written, each # only if it is not zero.
bool take_decimals(std::string_view marks, NumberFormat& format) {
    if (marks.find_first_not_of("0#") != std::string_view::npos) return false;
    format.least = static_cast<int>(std::count(marks.begin(), marks.end(), '0'));
    format.most = static_cast<int>(marks.size());
    return true;
}

bool take_skeleton_word(std::string_view word, NumberFormat& format) {
    if (word == "group-off") format.grouped = false;
    else if (word == "precision-integer") format.most = 0;
    else if (word.starts_with('.')) return take_decimals(word.substr(1), format);
    else if (word.starts_with('@') && word.find_first_not_of('#', 1) == std::string_view::npos)
        format.significant = static_cast<int>(word.size());
    else return false;
    return true;
}

std::optional<NumberFormat> number_format(std::string_view style) {
    NumberFormat format;
    style = trimmed(style);
    if (style.empty()) return format;
    if (style == "integer") {
        format.most = 0;
        return format;
    }
    if (style.starts_with("#0")) {
        format.grouped = false;
        format.most = 0;
        style.remove_prefix(2);
        if (style.empty()) return format;
        return style.front() == '.' && take_decimals(style.substr(1), format) ? std::optional(format) : std::nullopt;
    }
    if (!style.starts_with("::")) return std::nullopt;
    format.most = 6;  // the default of a skeleton
    for (style = trimmed(style.substr(2)); !style.empty(); style = trimmed(style)) {
        const std::size_t end = std::min(style.find(' '), style.size());
        if (!take_skeleton_word(style.substr(0, end), format)) return std::nullopt;
        style.remove_prefix(end);
    }
    return format;
}

// Reads a pattern. After the first fault it reads nothing more.
class PatternReader {
public:
    explicit PatternReader(std::string_view pattern) : pattern_(pattern) {}

    std::vector<Part> read() {
        std::vector<Part> parts = message(false, 0);
        if (!fault_ && at_ < pattern_.size()) fail("U_UNMATCHED_BRACES");
        return parts;
    }
    const char* fault() const { return fault_; }
    std::size_t at() const { return at_; }

private:
    void fail(const char* fault) {
        if (!fault_) fault_ = fault;
    }
    char here(std::size_t ahead = 0) const { return at_ + ahead < pattern_.size() ? pattern_[at_ + ahead] : '\0'; }
    bool take(char expected, const char* otherwise) {
        if (here() == expected && at_ < pattern_.size()) ++at_;
        else fail(at_ < pattern_.size() ? otherwise : "U_UNMATCHED_BRACES");
        return !fault_;
    }
    void skip_blanks() { at_ = std::min(pattern_.find_first_not_of(" \t\n\r", at_), pattern_.size()); }
    std::string word() {
        skip_blanks();
        const std::size_t end = std::min(pattern_.find_first_of(" \t\n\r,{}#'", at_), pattern_.size());
        std::string taken(pattern_.substr(at_, end - at_));
        at_ = end;
        skip_blanks();
        return taken;
    }

    // Takes the quote at this place. Two quotes stand for one. A quote before a character with a meaning begins a
    // quoted text, up to the next quote.
    void quote(bool plural, std::string& text) {
        ++at_;
        if (here() == '\'') {
            text += '\'';
            ++at_;
            return;
        }
        if (here() != '{' && here() != '}' && !(plural && here() == '#')) {
            text += '\'';
            return;
        }
        while (at_ < pattern_.size()) {
            const char c = pattern_[at_++];
            if (c == '\'' && here() != '\'') return;
            if (c == '\'') ++at_;
            text += c;
        }
    }

    std::vector<Part> message(bool plural, int depth) {
        std::vector<Part> parts;
        std::string text;
        const auto end_text = [&] {
            if (!text.empty()) parts.push_back({Kind::Text, std::move(text)});
            text.clear();
        };
        while (at_ < pattern_.size() && !fault_) {
            const char c = pattern_[at_];
            if (c == '}' && depth > 0) break;
            if (c == '\'') {
                quote(plural, text);
            } else if (c == '{') {
                end_text();
                ++at_;
                parts.push_back(argument(depth));
            } else if (c == '#' && plural) {
                end_text();
                ++at_;
                parts.push_back({Kind::Count, ""});
            } else {
                text += c;
                ++at_;
            }
        }
        end_text();
        return parts;
    }

    Part argument(int depth) {
        Part part{Kind::Value, word()};
        if (part.text.empty()) fail("U_PATTERN_SYNTAX_ERROR");
        if (!fault_ && here() == ',') {
            ++at_;
            const std::string type = word();
            if (type == "number") number(part);
            else if (type == "plural") choices(part, Kind::Plural, depth);
            else if (type == "selectordinal") choices(part, Kind::Ordinal, depth);
            else if (type == "select") choices(part, Kind::Select, depth);
            else fail("U_ILLEGAL_ARGUMENT_ERROR");
        }
        if (!fault_) take('}', "U_PATTERN_SYNTAX_ERROR");
        return part;
    }

    void number(Part& part) {
        part.kind = Kind::Number;
        if (here() != ',') return;
        const std::size_t end = std::min(pattern_.find('}', ++at_), pattern_.size());
        if (const auto format = number_format(pattern_.substr(at_, end - at_))) part.number = *format;
        else fail("U_ILLEGAL_ARGUMENT_ERROR");
        at_ = end;
    }

    void choices(Part& part, Kind kind, int depth) {
        part.kind = kind;
        if (!take(',', "U_PATTERN_SYNTAX_ERROR")) return;
        bool other = false;
        for (skip_blanks(); !fault_ && at_ < pattern_.size() && here() != '}'; skip_blanks()) {
            std::string key = word();
            if (key.empty()) fail("U_PATTERN_SYNTAX_ERROR");
            if (!take('{', "U_PATTERN_SYNTAX_ERROR")) return;
            other = other || key == "other";
            part.choices.emplace_back(std::move(key), message(kind != Kind::Select, depth + 1));
            take('}', "U_UNMATCHED_BRACES");
        }
        if (!other) fail("U_DEFAULT_KEYWORD_MISSING");
    }

    std::string_view pattern_;
    std::size_t at_ = 0;
    const char* fault_ = nullptr;
};

class Filler {
public:
    Filler(std::span<const TextValue> values, bool german) : values_(values), german_(german) {}

    // Adds the text of the parts. Returns false if a value has the wrong type. `counted` is the value of the plural
    // around the parts.
    bool add(const std::vector<Part>& parts, const Number* counted) {
        return std::all_of(parts.begin(), parts.end(), [&](const Part& part) { return add(part, counted); });
    }
    std::string take() { return std::move(made_); }

private:
    bool add(const Part& part, const Number* counted) {
        if (part.kind == Kind::Text) return made_ += part.text, true;
        if (part.kind == Kind::Count) return made_ += number_text(*counted, NumberFormat(), german_), true;
        const auto value =
            std::find_if(values_.begin(), values_.end(), [&](const TextValue& one) { return one.name == part.text; });
        if (value == values_.end()) return made_ += "{" + part.text + "}", true;
        if (const auto* text = std::get_if<std::string_view>(&value->value)) return add(part, *text, counted);
        Number number = 0.0;
        if (const auto* whole = std::get_if<std::int64_t>(&value->value)) number = *whole;
        else number = std::get<double>(value->value);
        return add(part, number);
    }
    bool add(const Part& part, std::string_view text, const Number* counted) {
        if (part.kind == Kind::Value) made_ += text;
        else if (part.kind == Kind::Select) return add(choice(part, text), counted);
        return part.kind == Kind::Value;
    }
    bool add(const Part& part, const Number& number) {
        if (part.kind == Kind::Select) return false;
        if (part.kind != Kind::Plural && part.kind != Kind::Ordinal)
            return made_ += number_text(number, part.number, german_), true;
        const double value = std::visit([](auto one) { return static_cast<double>(one); }, number);
        for (const auto& [key, parts] : part.choices)
            if (key.front() == '=' && std::atof(key.c_str() + 1) == value) return add(parts, &number);
        return add(choice(part, plural_form(part, number_text(number, counting_format(part), german_))), &number);
    }
    // Returns the plural form of a number by its digits, as the language's rules in Unicode's CLDR state.
    std::string_view plural_form(const Part& part, std::string_view written) const {
        if (written.starts_with('-')) written.remove_prefix(1);
        if (part.kind == Kind::Plural) return written == "1" ? "one" : "other";
        const bool fraction = written.find(german_ ? ',' : '.') != std::string_view::npos;
        const bool teens = written.size() > 1 && written[written.size() - 2] == '1';
        if (german_ || fraction || teens) return "other";
        const char last = written.back();
        return last == '1' ? "one" : last == '2' ? "two" : last == '3' ? "few" : "other";
    }
    // ICU chooses the plural form for the number as the form "other" writes it first: "1.0" is not one.
    static NumberFormat counting_format(const Part& part) {
        for (const Part& inner : choice(part, "other")) {
            if (inner.kind == Kind::Count) break;
            if (inner.kind == Kind::Number && inner.text == part.text) return inner.number;
        }
        return {};
    }
    static const std::vector<Part>& choice(const Part& part, std::string_view key) {
        const auto named = [&](std::string_view name) {
            return std::find_if(part.choices.begin(), part.choices.end(),
                                [&](const auto& one) { return one.first == name; });
        };
        const auto found = named(key);
        return found == part.choices.end() ? named("other")->second : found->second;
    }

    std::span<const TextValue> values_;
    bool german_;
    std::string made_;
};

void add_names(const std::vector<Part>& parts, std::set<std::string>& names) {
    for (const Part& part : parts) {
        if (part.kind != Kind::Text && part.kind != Kind::Count) names.insert(part.text);
        for (const auto& [key, inner] : part.choices) add_names(inner, names);
    }
}

}  // namespace

std::optional<std::string> PlainMessage::filled(std::span<const TextValue> values) const {
    Filler filler(values, german_);
    return filler.add(parts_, nullptr) ? std::optional(filler.take()) : std::nullopt;
}

std::vector<std::string> PlainMessage::names() const {
    std::set<std::string> found;
    add_names(parts_, found);
    return {found.begin(), found.end()};
}

std::unique_ptr<const Message> compile_plain_message(std::string_view pattern, const std::string& language,
                                                     MessageFault* fault) {
    PatternReader reader(pattern);
    std::vector<Part> parts = reader.read();
    if (!reader.fault()) return std::make_unique<const PlainMessage>(std::move(parts), language == "de");
    if (fault) *fault = {reader.fault(), static_cast<int>(reader.at())};
    return nullptr;
}

std::string plain_capitalised(std::string_view text) {
    const std::vector<std::string> first = characters_of(text.substr(0, 4));
    if (first.empty()) return std::string(text);
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(first.front()[at]); };
    const std::size_t size = first.front().size();
    char32_t letter = size == 1 ? byte(0) : byte(0) & (0xFFU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) letter = letter << 6 | (byte(i) & 0x3FU);
    const auto upper = static_cast<char32_t>(std::towupper(static_cast<std::wint_t>(letter)));
    if (upper == letter || (size == 1 && letter >= 0x80)) return std::string(text);
    std::string made;
    if (upper < 0x80) made += static_cast<char>(upper);
    else if (upper < 0x800) made += static_cast<char>(0xC0 | upper >> 6);
    else if (upper < 0x10000) made += static_cast<char>(0xE0 | upper >> 12);
    else made += static_cast<char>(0xF0 | upper >> 18);
    for (int shift = upper < 0x80 ? -6 : upper < 0x800 ? 0 : upper < 0x10000 ? 6 : 12; shift >= 0; shift -= 6)
        made += static_cast<char>(0x80 | (upper >> shift & 0x3F));
    return made + std::string(text.substr(size));
}

}  // namespace handrail
