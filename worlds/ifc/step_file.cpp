#include "worlds/ifc/step_file.h"

#include <algorithm>
#include <charconv>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::ifc {
namespace {

bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }
bool is_name(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

// Returns the number of characters after \S\ that belong to it. An apostrophe after \S\ is a shifted character (a
// section sign), which some programs double. But if a comma or a bracket follows, the apostrophe ends the text, as in a
// path that was not escaped.
int shifted_length(std::string_view after) {
    if (!after.starts_with('\'')) return after.empty() ? 0 : 1;
    const auto ends_text = [&](std::size_t from) {
        const std::size_t next = after.find_first_not_of(" \t\r\n", from);
        return next == std::string_view::npos || after[next] == ',' || after[next] == ')';
    };
    if (ends_text(1)) return 0;
    return after.starts_with("''") && !ends_text(2) ? 2 : 1;
}

// Reads the bytes one after the other and counts lines.
class Cursor {
public:
    explicit Cursor(std::string_view bytes) : bytes_(bytes) {}

    bool at_end() const { return at_ >= bytes_.size(); }
    char peek() const { return at_end() ? '\0' : bytes_[at_]; }
    std::size_t place() const { return at_; }
    int line() const { return line_; }
    void step() {
        if (bytes_[at_] == '\n') ++line_;
        ++at_;
    }
    // Skips blanks and comments. Returns false if a comment never ends.
    bool skip_blanks() {
        while (!at_end()) {
            if (is_blank(bytes_[at_])) {
                step();
            } else if (bytes_.substr(at_, 2) == "/*") {
                const std::size_t end = bytes_.find("*/", at_ + 2);
                if (end == std::string_view::npos) return false;
                while (at_ < end + 2) step();
            } else {
                break;
            }
        }
        return true;
    }
    std::string_view name() {
        const std::size_t begin = at_;
        while (!at_end() && is_name(bytes_[at_])) ++at_;
        return bytes_.substr(begin, at_ - begin);
    }
    // Skips a text, from its opening apostrophe past its closing one. Returns false if it never ends.
    bool skip_text() {
        step();
        for (; !at_end(); step()) {
            if (bytes_.substr(at_, 2) == "\\\\") {
                step();
            } else if (bytes_.substr(at_, 3) == "\\S\\") {
                for (int left = 2 + shifted_length(bytes_.substr(at_ + 3)); left > 0; --left) step();
            } else if (bytes_[at_] == '\'') {
                step();
                if (peek() != '\'') return true;
            }
        }
        return false;
    }
    // Moves past the next semicolon that is outside texts and comments. Sets `text` to everything before that
    // semicolon. Returns false if the file ends first.
    bool statement(std::string_view& text) {
        const std::size_t begin = at_;
        while (!at_end()) {
            const char c = bytes_[at_];
            if (c == '\'') {
                if (!skip_text()) return false;
                continue;
            } else if (c == '/' && bytes_.substr(at_, 2) == "/*") {
                if (!skip_blanks()) return false;
                continue;
            } else if (c == ';') {
                text = bytes_.substr(begin, at_ - begin);
                step();
                return true;
            }
            step();
        }
        return false;
    }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
    int line_ = 1;
};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

// Splits "NAME(...)" into name and values. For "(A(...)B(...))", the name is empty.
bool split_record(std::string_view text, std::string_view& name, std::string_view& values) {
    text = trimmed(text);
    Cursor cursor(text);
    name = cursor.name();
    cursor.skip_blanks();
    if (cursor.peek() != '(' || text.back() != ')') return false;
    values = text.substr(cursor.place() + 1, text.size() - cursor.place() - 2);
    return true;
}

// Parses commas and brackets into values. It uses an explicit stack instead of recursion.
class ValueParser {
public:
    explicit ValueParser(std::string_view text) : text_(text), cursor_(text) {}

    std::vector<StepValue> all() {
        std::vector<StepValue> top;
        open_.push_back({&top, false});
        while (cursor_.skip_blanks() && !cursor_.at_end()) {
            const char c = cursor_.peek();
            if (c == ',') cursor_.step();
            else if (c == '(') {
                if (!open_list({}, false)) break;
            } else if (c == ')') {
                if (!close_list()) break;
            } else if (!single()) break;
        }
        while (open_.size() > 1 && close_list()) {
        }
        return top;
    }

private:
    struct Open {
        std::vector<StepValue>* into = nullptr;
        bool typed = false;  // true if the brackets belong to a typed value and not to a list
    };

    bool open_list(std::string_view type, bool typed) {
        cursor_.step();
        if (open_.size() > StepFile::kDeepest) return false;
        StepValue list;
        list.kind = StepValue::Kind::List;
        list.type = type;
        open_.back().into->push_back(std::move(list));
        open_.push_back({&open_.back().into->back().items, typed});
        return true;
    }
    bool close_list() {
        if (open_.size() < 2) return false;
        if (!cursor_.at_end()) cursor_.step();
        const bool typed = open_.back().typed;
        open_.pop_back();
        StepValue& list = open_.back().into->back();
        if (typed && list.items.size() == 1 && list.items.front().kind != StepValue::Kind::List) {
            StepValue within = std::move(list.items.front());
            within.type = list.type;
            list = std::move(within);
        }
        return true;
    }

    bool single() {
        StepValue value;
        const char c = cursor_.peek();
        const std::size_t begin = cursor_.place();
        const auto from_here = [&] { return text_.substr(begin, cursor_.place() - begin); };
        if (c == '$' || c == '*') {
            cursor_.step();
        } else if (c == '\'') {
            value.kind = StepValue::Kind::Text;
            if (!cursor_.skip_text()) return false;
            value.text = text_.substr(begin + 1, cursor_.place() - begin - 2);
        } else if (c == '.') {
            value.kind = StepValue::Kind::Word;
            cursor_.step();
            value.text = cursor_.name();
            if (cursor_.peek() != '.') return false;
            cursor_.step();
        } else if (c == '#') {
            value.kind = StepValue::Kind::Reference;
            cursor_.step();
            const std::string_view digits = cursor_.name();
            const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value.reference);
            if (error != std::errc{} || end != digits.data() + digits.size()) return false;
        } else if (c == '"') {  // skips binary values, which are not used
            cursor_.step();
            while (!cursor_.at_end() && cursor_.peek() != '"') cursor_.step();
            if (cursor_.at_end()) return false;
            cursor_.step();
        } else if (is_name(c) && !(c >= '0' && c <= '9') && c != '-') {
            const std::string_view type = cursor_.name();
            cursor_.skip_blanks();
            return cursor_.peek() == '(' && open_list(type, true);
        } else {
            value.kind = StepValue::Kind::Number;
            while (!cursor_.at_end() && (is_name(cursor_.peek()) || cursor_.peek() == '.' || cursor_.peek() == '+'))
                cursor_.step();
            std::string_view digits = from_here();
            const auto taken = take_number(digits);
            if (!taken || !taken->in_range || !digits.empty()) return false;
            value.number = taken->value;
        }
        open_.back().into->push_back(std::move(value));
        return true;
    }

    std::string_view text_;
    Cursor cursor_;
    std::vector<Open> open_;
};

bool looks_like_utf16(std::string_view bytes) {
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF") ||
           bytes.starts_with(std::string_view("I\0S\0", 4)) || bytes.starts_with(std::string_view("\0I\0S", 4));
}

}  // namespace

Result<StepFile> StepFile::read(std::string_view bytes, const std::string& file_name, const std::stop_token& stop) {
    StepFile file;
    file.file_name_ = file_name;
    if (bytes.starts_with("version https://git-lfs")) return fail(phrase("reader.lfs_pointer"), file_name);
    if (looks_like_utf16(bytes)) return fail(phrase("ifc.utf16"), file_name);
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    Cursor cursor(bytes);
    cursor.skip_blanks();
    std::string_view text;
    if (!bytes.substr(cursor.place()).starts_with("ISO-10303-21") || !cursor.statement(text))
        return fail(phrase("ifc.no_step"), file_name);
    const auto cut = [&] {
        return fail(phrase("ifc.cut_short", {{"instances", file.instances_.size()}}), file_name, cursor.line());
    };
    bool in_data = false, ended = false;
    while (cursor.skip_blanks() && !cursor.at_end()) {
        if ((file.instances_.size() & 0xfff) == 0 && stop.stop_requested())
            return fail(phrase("files.stopped"), file_name);
        const int line = cursor.line();
        if (cursor.peek() == '#') {
            StepInstance instance;
            instance.line = line;
            cursor.step();
            const std::string_view digits = cursor.name();
            const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), instance.id);
            cursor.skip_blanks();
            if (cursor.at_end()) return cut();
            const bool numbered = error == std::errc{} && end == digits.data() + digits.size() && cursor.peek() == '=';
            if (numbered) cursor.step();
            if (!cursor.statement(text)) return cut();
            if (!numbered || !split_record(text, instance.name, instance.values))
                return fail(phrase("ifc.damaged"), file_name, line);
            if (!file.place_of_.emplace(instance.id, static_cast<std::uint32_t>(file.instances_.size())).second)
                return fail(phrase("ifc.twice", {{"id", instance.id}}), file_name, line);
            file.instances_.push_back(instance);
            continue;
        }
        if (!cursor.statement(text)) return cut();
        text = trimmed(text);
        if (text == "END-ISO-10303-21") {
            ended = true;
            break;
        }
        if (text == "DATA" || text.starts_with("DATA(")) in_data = true;
        std::string_view name, values;
        if (!split_record(text, name, values)) {
            if (text != "HEADER" && text != "DATA" && text != "ENDSEC")
                return fail(phrase("ifc.damaged"), file_name, line);
            continue;
        }
        if (name != "FILE_SCHEMA") continue;
        const std::vector<StepValue> schema = ValueParser(values).all();
        if (!schema.empty() && !schema[0].items.empty()) {
            file.schema_ = decoded(schema[0].items[0].text);
            std::transform(file.schema_.begin(), file.schema_.end(), file.schema_.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
        }
    }
    if (!ended || !in_data) return cut();
    return file;
}

const StepInstance* StepFile::find(std::uint64_t id) const {
    const auto found = place_of_.find(id);
    return found == place_of_.end() ? nullptr : &instances_[found->second];
}

std::vector<StepValue> StepFile::values_of(const StepInstance& instance) const {
    contract_pre(find(instance.id));
    return ValueParser(instance.values).all();
}

}  // namespace handrail::ifc
