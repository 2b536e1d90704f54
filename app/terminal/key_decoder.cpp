#include "app/terminal/key_decoder.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "worlds/base/text.h"

namespace handrail::terminal {
namespace {

constexpr char kEscape = '\x1b';
constexpr std::string_view kPasteEnds = "\x1b[201~";
constexpr std::size_t kLongestSequence = 64;

// Modifier keys as bits. Key sequences contain one plus the sum of these bits.
enum Modifier : unsigned { kShift = 1, kAlt = 2, kControl = 4 };

struct Sign {
    std::string_view text;
    std::string_view key;
};

// Characters and the keys that type them on an English keyboard. TerminalKeyboard contains the characters on the digit
// keys.
constexpr Sign kSigns[] = {{" ", "Space"},
                           {"`", "Grave"},
                           {"-", "Minus"},
                           {"=", "Equal"},
                           {"[", "LeftBracket"},
                           {"]", "RightBracket"},
                           {"\\", "Backslash"},
                           {";", "Semicolon"},
                           {"'", "Apostrophe"},
                           {",", "Comma"},
                           {".", "Period"},
                           {"/", "Slash"},
                           {"~", "Shift+Grave"},
                           {"_", "Shift+Minus"},
                           {"+", "Shift+Equal"},
                           {"{", "Shift+LeftBracket"},
                           {"}", "Shift+RightBracket"},
                           {"|", "Shift+Backslash"},
                           {":", "Shift+Semicolon"},
                           {"\"", "Shift+Apostrophe"},
                           {"<", "Shift+Comma"},
                           {">", "Shift+Period"},
                           {"?", "Shift+Slash"}};

struct Numbered {
    unsigned number;
    std::string_view key;
};

// Keys that a terminal sends as CSI number ~. The numbers are those of VT220 and its successors, and of rxvt for Home
// and End.
constexpr Numbered kNumbered[] = {{1, "Home"},     {2, "Insert"}, {3, "Delete"}, {4, "End"},  {5, "PageUp"},
                                  {6, "PageDown"}, {7, "Home"},   {8, "End"},    {11, "F1"},  {12, "F2"},
                                  {13, "F3"},      {14, "F4"},    {15, "F5"},    {17, "F6"},  {18, "F7"},
                                  {19, "F8"},      {20, "F9"},    {21, "F10"},   {23, "F11"}, {24, "F12"}};

// The numbers after that of F12. They stand for function keys with Shift. On the Linux console, they begin with
// Shift+F1; on rxvt, with Shift+F3.
constexpr unsigned kShiftedFunctions[] = {25, 26, 28, 29, 31, 32, 33, 34};

struct Lettered {
    char letter;
    std::string_view key;
};

// Keys that a terminal sends as CSI letter, CSI 1 ; modifiers letter, or SS3 letter.
constexpr Lettered kLettered[] = {{'A', "Up"},      {'B', "Down"}, {'C', "Right"},   {'D', "Left"},
                                  {'E', "Keypad5"}, {'F', "End"},  {'G', "Keypad5"}, {'H', "Home"},
                                  {'P', "F1"},      {'Q', "F2"},   {'R', "F3"},      {'S', "F4"}};

// Keys that a keypad in application mode sends as SS3 letter.
constexpr Lettered kKeypad[] = {
    {'M', "KeypadEnter"},   {'X', "KeypadEqual"},  {'j', "KeypadMultiply"}, {'k', "KeypadAdd"}, {'m', "KeypadSubtract"},
    {'n', "KeypadDecimal"}, {'o', "KeypadDivide"}, {'p', "Keypad0"},        {'q', "Keypad1"},   {'r', "Keypad2"},
    {'s', "Keypad3"},       {'t', "Keypad4"},      {'u', "Keypad5"},        {'v', "Keypad6"},   {'w', "Keypad7"},
    {'x', "Keypad8"},       {'y', "Keypad9"}};

// Numbers that the kitty protocol uses for modifier keys that are pressed alone.
constexpr Numbered kLoneModifiers[] = {{57441, "Shift"}, {57442, "Control"}, {57443, "Alt"},
                                       {57447, "Shift"}, {57448, "Control"}, {57449, "Alt"}};

constexpr std::string_view kRxvtArrows = "abcd";
constexpr std::string_view kArrows[] = {"Up", "Down", "Right", "Left"};

template <class Rows>
std::string_view key_of(const Rows& rows, char letter) {
    for (const auto& row : rows)
        if (row.letter == letter) return row.key;
    return {};
}

template <class Rows>
std::string_view key_of(const Rows& rows, unsigned number) {
    for (const auto& row : rows)
        if (row.number == number) return row.key;
    return {};
}

// Returns the name of the key with the modifiers before it, in the order that the window uses. Does not repeat a
// modifier that `key` already contains.
std::string with_modifiers(std::string_view key, unsigned modifiers) {
    if (key.empty()) return {};
    constexpr std::string_view kShifted = "Shift+";
    if (key.starts_with(kShifted)) {
        modifiers |= kShift;
        key.remove_prefix(kShifted.size());
    }
    std::string name;
    if (modifiers & kControl) name += "Control+";
    if (modifiers & kAlt) name += "Alt+";
    if (modifiers & kShift) name += kShifted;
    return name.append(key);
}

std::size_t length_of_character(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return 2;
    if (first >= 0xE0 && first < 0xF0) return 3;
    if (first >= 0xF0 && first < 0xF5) return 4;
    return 0;
}

// Returns the numbers of a sequence, which semicolons separate. A missing number is 0. If a number has parts ("97:65"),
// returns the first part.
std::vector<unsigned> numbers_of(std::string_view text) {
    std::vector<unsigned> numbers;
    while (true) {
        const std::size_t end = std::min(text.find(';'), text.size());
        unsigned number = 0;
        std::from_chars(text.data(), text.data() + end, number);
        numbers.push_back(number);
        if (end == text.size()) return numbers;
        text.remove_prefix(end + 1);
    }
}

// Returns the kind of event, which is the number after the colon that follows the modifiers: 3 in "1;5:3". The kind 1,
// a press, is the default.
unsigned event_of(std::string_view parameters) {
    const std::size_t colon = parameters.find(':', std::min(parameters.find(';'), parameters.size()));
    unsigned event = 1;
    if (colon != std::string_view::npos)
        std::from_chars(parameters.data() + colon + 1, parameters.data() + parameters.size(), event);
    return event;
}

unsigned modifiers_of(const std::vector<unsigned>& numbers, std::size_t at) {
    return numbers.size() > at && numbers[at] > 0 ? (numbers[at] - 1) & (kShift | kAlt | kControl) : 0;
}

std::string_view sign_key(std::string_view text) {
    for (const Sign& sign : kSigns)
        if (sign.text == text) return sign.key;
    return {};
}

}  // namespace

TerminalKeyboard terminal_keyboard(std::string_view language, std::string_view terminal, char erase) {
    TerminalKeyboard keyboard;
    // The characters that are keys of their own, the slash and the equals sign, are empty here.
    if (language == "de") keyboard.shifted_digits = {"", "!", "\"", "§", "$", "%", "&", "", "(", ")"};
    keyboard.erase = erase;
    keyboard.rxvt_functions = terminal.starts_with("rxvt");
    return keyboard;
}

std::vector<TerminalInput> KeyDecoder::take(std::string_view bytes) {
    std::vector<TerminalInput> done;
    held_ += bytes;
    take_held(done, false);
    return done;
}

std::vector<TerminalInput> KeyDecoder::time_out() {
    std::vector<TerminalInput> done;
    if (waits()) take_held(done, true);
    return done;
}

void KeyDecoder::take_held(std::vector<TerminalInput>& done, bool nothing_follows) {
    while (!held_.empty()) {
        if (pasting_) {
            if (!paste_step(done)) return;
            continue;
        }
        Step next = step(held_, nothing_follows);
        if (next.bytes == 0) return;
        pasting_ = next.input.pasted;
        held_.erase(0, next.bytes);
        if (!pasting_ && next.input != TerminalInput{}) done.push_back(std::move(next.input));
    }
}

bool KeyDecoder::paste_step(std::vector<TerminalInput>& done) {
    const std::size_t escape = held_.find(kEscape);
    if (escape != 0) {
        // If the text ends in an incomplete UTF-8 character, keep its bytes until the remaining bytes arrive. Do not
        // wait if an Escape follows, because then they can no longer arrive.
        std::size_t end = std::min(escape, held_.size());
        for (std::size_t back = 1; escape == std::string::npos && back <= std::min<std::size_t>(3, end); ++back) {
            const auto byte = static_cast<unsigned char>(held_[end - back]);
            if (byte < 0x80) break;
            if (byte >= 0xC0 && length_of_character(byte) > back) end -= back;
            if (byte >= 0xC0) break;
        }
        if (end == 0) return false;
        done.push_back({{}, held_.substr(0, end), true});
        held_.erase(0, end);
        return true;
    }
    if (held_.starts_with(kPasteEnds)) {
        held_.erase(0, kPasteEnds.size());
        pasting_ = false;
        return true;
    }
    if (kPasteEnds.starts_with(held_)) return false;
    // Terminals remove Escape from pasted text, so this Escape begins a key, and the mark that ends the paste was lost.
    pasting_ = false;
    return true;
}

KeyDecoder::Step KeyDecoder::step(std::string_view bytes, bool nothing_follows) const {
    if (bytes[0] == kEscape) return escape_step(bytes, nothing_follows);
    Step character = character_step(bytes);
    if (character.bytes == 0 && nothing_follows) return {bytes.size(), {}};
    return character;
}

KeyDecoder::Step KeyDecoder::escape_step(std::string_view bytes, bool nothing_follows) const {
    Step alone{1, {"Escape", {}, false}};
    if (bytes.size() == 1) return nothing_follows ? alone : Step{};
    Step behind;
    if (bytes[1] == '[' || bytes[1] == 'O') {
        behind = control_step(bytes);
        if (behind.bytes > 0) return behind;
        if (!nothing_follows) return {};
        // If nothing follows these two bytes, the person pressed Alt with the second character. A longer sequence was
        // cut off, so skip it.
        if (bytes.size() > 2) return {bytes.size(), {}};
        return {2, {with_modifiers(bytes[1] == '[' ? "LeftBracket" : "O", bytes[1] == '[' ? kAlt : kAlt | kShift), {}}};
    }
    behind = step(bytes.substr(1), nothing_follows);
    if (behind.bytes == 0) return {};
    // Two Escapes with nothing after them are two presses of Escape, so return the first alone.
    if (behind.input.key == "Escape" || behind.input.pasted) return alone;
    if (behind.input.key.empty()) return {1 + behind.bytes, {}};
    std::string key = behind.input.key;
    unsigned modifiers = kAlt;
    if (key.starts_with("Control+")) {
        modifiers |= kControl;
        key.erase(0, std::string_view("Control+").size());
    }
    if (key.starts_with("Alt+")) key.erase(0, std::string_view("Alt+").size());
    return {1 + behind.bytes, {with_modifiers(key, modifiers), {}, false}};
}

KeyDecoder::Step KeyDecoder::named(std::size_t used, std::string_view key, unsigned modifiers) {
    return {used, {with_modifiers(key, modifiers), {}, false}};
}

// Decodes sequences that begin with ESC [ or ESC O.
KeyDecoder::Step KeyDecoder::control_step(std::string_view bytes) const {
    if (bytes.size() < 3) return {};
    // F1 to F5 of the Linux console begin with ESC [ [.
    if (bytes[1] == '[' && bytes[2] == '[') {
        if (bytes.size() < 4) return {};
        constexpr std::string_view kFunctions[] = {"F1", "F2", "F3", "F4", "F5"};
        return bytes[3] >= 'A' && bytes[3] <= 'E' ? named(4, kFunctions[bytes[3] - 'A'], 0) : Step{4, {}};
    }
    std::size_t end = 2;
    while (end < bytes.size() && bytes[end] >= 0x30 && bytes[end] <= 0x3F) ++end;
    const std::string_view parameters = bytes.substr(2, end - 2);
    const bool plain_number = !parameters.empty() && parameters.find_first_not_of("0123456789") == std::string::npos;
    // If a key is pressed with Shift, rxvt ends its sequence in $. Other terminals use $ only as an intermediate byte
    // before the final letter.
    const bool rxvt_shift = plain_number && end < bytes.size() && bytes[end] == '$';
    while (!rxvt_shift && end < bytes.size() && bytes[end] >= 0x20 && bytes[end] <= 0x2F) ++end;
    if (end >= kLongestSequence) return {end, {}};
    if (end == bytes.size()) return {};
    const char last = bytes[end];
    const std::size_t used = end + 1;
    // A byte that cannot be part of a sequence ends the sequence. The byte is then decoded separately.
    if (!rxvt_shift && (last < 0x40 || last > 0x7E)) return {end, {}};
    const std::vector<unsigned> numbers = numbers_of(parameters);
    unsigned modifiers = modifiers_of(numbers, 1);
    // For a key whose sequence ends in a letter, some terminals send the modifiers as the only number of the sequence.
    if (numbers.size() == 1 && !key_of(kLettered, last).empty()) modifiers = modifiers_of(numbers, 0);
    if (parameters.find_first_of("<=>?") != std::string_view::npos || event_of(parameters) == 3) return {used, {}};

    if (bytes[1] == 'O') {
        if (const std::size_t arrow = kRxvtArrows.find(last); arrow != std::string_view::npos)
            return named(used, kArrows[arrow], kControl);
        const std::string_view key = key_of(kLettered, last);
        return named(used, key.empty() ? key_of(kKeypad, last) : key, modifiers);
    }
    if (const std::size_t arrow = kRxvtArrows.find(last); arrow != std::string_view::npos && parameters.empty())
        return named(used, kArrows[arrow], kShift);
    if (last == 'Z') return named(used, "Tab", modifiers | kShift);
    if (last == 'u') return coded_step(used, numbers[0], modifiers);
    if (last == '~' && numbers.size() == 3 && numbers[0] == 27) return coded_step(used, numbers[2], modifiers);
    if (last == '~' || last == '^' || last == '@' || last == '$')
        return numbered_step(used, last, numbers[0], modifiers);
    return named(used, key_of(kLettered, last), modifiers);
}

// Decodes a key whose sequence contains `code`, the code of the key's character.
KeyDecoder::Step KeyDecoder::coded_step(std::size_t used, unsigned code, unsigned modifiers) const {
    if (const std::string_view alone = key_of(kLoneModifiers, code); !alone.empty()) return named(used, alone, 0);
    if (code == 27) return named(used, "Escape", modifiers);
    if (code > 0x7F || (code < 0x20 && code != '\t' && code != '\r')) return {used, {}};
    const char character = static_cast<char>(code);
    const Step typed = character_step({&character, 1});
    return {used,
            {with_modifiers(typed.input.key, modifiers), modifiers == 0 ? typed.input.text : std::string{}, false}};
}

// Decodes a key whose sequence contains `number`, the number of the key. `last` is the character that ends the
// sequence.
KeyDecoder::Step KeyDecoder::numbered_step(std::size_t used, char last, unsigned number, unsigned modifiers) const {
    unsigned held = modifiers;
    if (last == '^' || last == '@') held |= kControl;
    if (last == '$' || last == '@') held |= kShift;
    if (last == '~' && number == 200) return {used, {{}, {}, true}};
    if (const std::string_view key = key_of(kNumbered, number); !key.empty()) return named(used, key, held);
    for (std::size_t i = 0; i < std::size(kShiftedFunctions); ++i)
        if (number == kShiftedFunctions[i])
            return named(used, "F" + std::to_string(i + (keyboard_.rxvt_functions ? 3 : 1)), held | kShift);
    return {used, {}};
}

KeyDecoder::Step KeyDecoder::character_step(std::string_view bytes) const {
    const char first = bytes[0];
    if (first == keyboard_.erase || first == '\x7f') return {1, {"Backspace", {}, false}};
    switch (first) {
        case '\t':
            return {1, {"Tab", {}, false}};
        case '\r':
        case '\n':
            return {1, {"Enter", {}, false}};
        case '\0':
            return {1, {"Control+Space", {}, false}};
        default:
            break;
    }
    if (static_cast<unsigned char>(first) < 0x20) {
        if (first <= 26) return {1, {std::string("Control+") + static_cast<char>('A' + first - 1), {}, false}};
        return {1, {}};
    }
    const std::size_t length = length_of_character(static_cast<unsigned char>(first));
    if (length == 0) return {1, {}};
    const std::string_view text = bytes.substr(0, length);
    for (std::size_t i = 1; i < text.size(); ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) return {i, {}};
    if (text.size() < length) return {};
    if (!is_utf8(text)) return {length, {}};
    TerminalInput typed{{}, std::string(text), false};
    for (std::size_t digit = 0; digit < keyboard_.shifted_digits.size() && typed.key.empty(); ++digit)
        if (keyboard_.shifted_digits[digit] == text) typed.key = "Shift+" + std::to_string(digit);
    if (!typed.key.empty()) return {length, std::move(typed)};
    if (first >= 'a' && first <= 'z') typed.key = static_cast<char>(first - 'a' + 'A');
    else if (first >= 'A' && first <= 'Z') typed.key = std::string("Shift+") + first;
    else if (first >= '0' && first <= '9') typed.key = first;
    else typed.key = sign_key(text);
    return {length, std::move(typed)};
}

}  // namespace handrail::terminal
