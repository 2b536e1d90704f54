#include "app/terminal/key_decoder.h"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

#include "app/core/dialogue/command.h"
#include "app/core/dialogue/key_map.h"
#include "app/core/dialogue/key_sets.h"
#include "app/core/dialogue/terminal_sends.h"
#include "tests/support/names.h"
#include "worlds/base/typist.h"

namespace handrail {
namespace key_decoder_test {

using testing::ElementsAre;
using testing::IsEmpty;

TerminalInput key(std::string name, std::string text = {}) { return {std::move(name), std::move(text), false}; }
TerminalInput pasted(std::string text) { return {{}, std::move(text), true}; }

std::vector<TerminalInput> decoded(std::string_view bytes, const TerminalKeyboard& keyboard = {}) {
    KeyDecoder decoder(keyboard);
    std::vector<TerminalInput> all = decoder.take(bytes);
    for (TerminalInput& input : decoder.time_out()) all.push_back(std::move(input));
    return all;
}

struct Sequence {
    std::string bytes;
    std::string name;
};

// Returns every key of a PC keyboard with every modifier, as xterm and similar terminals send the keys.
std::vector<Sequence> xterm_sequences() {
    std::vector<Sequence> all;
    const char* kHeld[] = {"",         "Shift+",         "Alt+",         "Alt+Shift+",
                           "Control+", "Control+Shift+", "Control+Alt+", "Control+Alt+Shift+"};
    const std::pair<char, const char*> kLetters[] = {{'A', "Up"},  {'B', "Down"}, {'C', "Right"}, {'D', "Left"},
                                                     {'F', "End"}, {'H', "Home"}, {'P', "F1"},    {'Q', "F2"},
                                                     {'R', "F3"},  {'S', "F4"}};
    const std::pair<int, const char*> kNumbers[] = {{2, "Insert"}, {3, "Delete"}, {5, "PageUp"}, {6, "PageDown"},
                                                    {15, "F5"},    {17, "F6"},    {18, "F7"},    {19, "F8"},
                                                    {20, "F9"},    {21, "F10"},   {23, "F11"},   {24, "F12"}};
    for (int modifiers = 1; modifiers <= 8; ++modifiers) {
        const std::string held = kHeld[modifiers - 1], number = std::to_string(modifiers);
        for (const auto& [letter, name] : kLetters) all.push_back({"\x1b[1;" + number + letter, held + name});
        for (const auto& [code, name] : kNumbers)
            all.push_back({"\x1b[" + std::to_string(code) + ";" + number + "~", held + name});
    }
    for (const auto& [letter, name] : kLetters) {
        all.push_back({std::string("\x1bO") + letter, name});
        if (letter < 'P') all.push_back({std::string("\x1b[") + letter, name});
    }
    for (const auto& [code, name] : kNumbers) all.push_back({"\x1b[" + std::to_string(code) + "~", name});
    all.push_back({"\x1b[Z", "Shift+Tab"});
    return all;
}

std::vector<Sequence> other_sequences() {
    return {// sequences of the VT220 and the Linux console
            {"\x1b[1~", "Home"},
            {"\x1b[4~", "End"},
            {"\x1b[11~", "F1"},
            {"\x1b[12~", "F2"},
            {"\x1b[13~", "F3"},
            {"\x1b[14~", "F4"},
            {"\x1b[[A", "F1"},
            {"\x1b[[B", "F2"},
            {"\x1b[[C", "F3"},
            {"\x1b[[D", "F4"},
            {"\x1b[[E", "F5"},
            {"\x1b[25~", "Shift+F1"},
            {"\x1b[26~", "Shift+F2"},
            {"\x1b[28~", "Shift+F3"},
            {"\x1b[29~", "Shift+F4"},
            {"\x1b[31~", "Shift+F5"},
            {"\x1b[32~", "Shift+F6"},
            {"\x1b[33~", "Shift+F7"},
            {"\x1b[34~", "Shift+F8"},
            {"\x1b[G", "Keypad5"},
            {"\x1b[E", "Keypad5"},
            // Sequences of rxvt.
            {"\x1b[7~", "Home"},
            {"\x1b[8~", "End"},
            {"\x1b[a", "Shift+Up"},
            {"\x1b[b", "Shift+Down"},
            {"\x1b[c", "Shift+Right"},
            {"\x1b[d", "Shift+Left"},
            {"\x1bOa", "Control+Up"},
            {"\x1bOb", "Control+Down"},
            {"\x1bOc", "Control+Right"},
            {"\x1bOd", "Control+Left"},
            {"\x1b[7$", "Shift+Home"},
            {"\x1b[3^", "Control+Delete"},
            {"\x1b[8^", "Control+End"},
            {"\x1b[6^", "Control+PageDown"},
            {"\x1b[5@", "Control+Shift+PageUp"},
            {"\x1b[11^", "Control+F1"},
            {"\x1b\x1b[A", "Alt+Up"},
            {"\x1b\x1b[D", "Alt+Left"},
            {"\x1b\x1bOa", "Control+Alt+Up"},
            // Older sequences that contain only the modifier, and the keypad in application mode.
            {"\x1b[5A", "Control+Up"},
            {"\x1bO2D", "Shift+Left"},
            {"\x1bOM", "KeypadEnter"},
            {"\x1bOp", "Keypad0"},
            {"\x1bOy", "Keypad9"},
            {"\x1bOn", "KeypadDecimal"},
            {"\x1bOj", "KeypadMultiply"},
            // xterm's modifyOtherKeys, and the kitty protocol with key releases and single modifiers.
            {"\x1b[27;5;56~", "Control+8"},
            {"\x1b[56;5u", "Control+8"},
            {"\x1b[27u", "Escape"},
            {"\x1b[13;2u", "Shift+Enter"},
            {"\x1b[9;5u", "Control+Tab"},
            {"\x1b[57442;5u", "Control"},
            {"\x1b[1;5:1A", "Control+Up"},
            {"\x1b[1;5:2A", "Control+Up"},
            {"\x1b[32;5u", "Control+Space"},
            {"\x1b[110;6u", "Control+Shift+N"},
            // Control characters, and keys with Alt.
            {"\t", "Tab"},
            {"\r", "Enter"},
            {"\n", "Enter"},
            {"\x7f", "Backspace"},
            {"\x0e", "Control+N"},
            {"\x1bq", "Alt+Q"},
            {"\x1bQ", "Alt+Shift+Q"},
            {"\x1b\x0e", "Control+Alt+N"},
            {"\x1b\r", "Alt+Enter"},
            {"\x1b\x7f", "Alt+Backspace"},
            {"\x1b[", "Alt+LeftBracket"},
            {"\x1bO", "Alt+Shift+O"},
            {"\x1b", "Escape"}};
}

TEST(KeyDecoder, recognises_every_sequence_under_the_key_name_of_the_window) {
    for (const auto& sequences : {xterm_sequences(), other_sequences()})
        for (const Sequence& sequence : sequences)
            EXPECT_THAT(decoded(sequence.bytes), ElementsAre(key(sequence.name)))
                << testing::PrintToString(sequence.bytes);
    EXPECT_THAT(decoded(std::string(1, '\0')), ElementsAre(key("Control+Space")));
}

// The decoder must give the same result however the bytes are split on their way, unless a timeout passes between two
// pieces.
TEST(KeyDecoder, gives_the_same_result_for_bytes_cut_anywhere) {
    std::string all;
    std::vector<TerminalInput> expected;
    for (const auto& sequences : {xterm_sequences(), other_sequences()})
        for (const Sequence& sequence : sequences) {
            if (sequence.bytes == "\x1b" || sequence.bytes == "\x1b[" || sequence.bytes == "\x1bO") continue;
            for (std::size_t cut = 1; cut < sequence.bytes.size(); ++cut) {
                KeyDecoder decoder;
                EXPECT_THAT(decoder.take(sequence.bytes.substr(0, cut)), IsEmpty()) << sequence.name << " at " << cut;
                EXPECT_TRUE(decoder.waits());
                EXPECT_THAT(decoder.take(sequence.bytes.substr(cut)), ElementsAre(key(sequence.name)));
                EXPECT_FALSE(decoder.waits());
            }
            all += sequence.bytes;
            expected.push_back(key(sequence.name));
        }
    KeyDecoder decoder;
    std::vector<TerminalInput> one_by_one;
    for (const char byte : all)
        for (TerminalInput& input : decoder.take({&byte, 1})) one_by_one.push_back(std::move(input));
    EXPECT_EQ(one_by_one, expected);
    EXPECT_EQ(decoded(all), expected) << "all in one piece";
}

TEST(KeyDecoder, treats_an_escape_byte_as_a_key_if_nothing_follows) {
    KeyDecoder decoder;
    EXPECT_THAT(decoder.take("\x1b"), IsEmpty());
    EXPECT_TRUE(decoder.waits());
    EXPECT_THAT(decoder.time_out(), ElementsAre(key("Escape")));
    EXPECT_FALSE(decoder.waits());
    EXPECT_THAT(decoder.take("[A"), ElementsAre(key("LeftBracket", "["), key("Shift+A", "A")));
    EXPECT_THAT(decoded("\x1b\x1b"), ElementsAre(key("Escape"), key("Escape")));
    EXPECT_THAT(decoded("\x1b\x1b\x1b"), ElementsAre(key("Escape"), key("Escape"), key("Escape")));
}

TEST(KeyDecoder, skips_unknown_sequences_and_continues_after_them) {
    for (const char* unknown :
         {"\x1b[99~", "\x1b[1;1R", "\x1b[?1;2c", "\x1b[>0;276;0c", "\x1b[<0;3;4M", "\x1b[I", "\x1b[O", "\x1b[12;34x",
          "\x1bOz", "\x1b[[Z", "\x1b[57999u", "\x1b[1;5:3A", "\x1b\x1b[99~", "\x1b[?1;2$y", "\x1c", "\xff", "\xc3x"}) {
        const auto inputs = decoded(std::string(unknown) + "k");
        ASSERT_FALSE(inputs.empty()) << testing::PrintToString(unknown);
        EXPECT_EQ(inputs.back(), key("K", "k")) << testing::PrintToString(unknown);
        for (const TerminalInput& input : inputs) EXPECT_NE(input.key, "Escape") << testing::PrintToString(unknown);
    }
    // The first sequence never ends. The second one is cut off, and its end never arrives.
    EXPECT_EQ(decoded("\x1b[" + std::string(1000, '1') + "~k").back(), key("K", "k"));
    EXPECT_THAT(decoded("\x1b[1;"), IsEmpty());
}

TEST(KeyDecoder, turns_letters_digits_and_signs_into_keys_with_their_text) {
    EXPECT_THAT(decoded("aA1 -/`~"),
                ElementsAre(key("A", "a"), key("Shift+A", "A"), key("1", "1"), key("Space", " "), key("Minus", "-"),
                            key("Slash", "/"), key("Grave", "`"), key("Shift+Grave", "~")));
    EXPECT_THAT(decoded("^%("), ElementsAre(key("Shift+6", "^"), key("Shift+5", "%"), key("Shift+9", "(")));
    const TerminalKeyboard german = terminal_keyboard("de", "xterm-256color", '\x7f');
    EXPECT_THAT(decoded("&%)/§", german), ElementsAre(key("Shift+6", "&"), key("Shift+5", "%"), key("Shift+9", ")"),
                                                      key("Slash", "/"), key("Shift+3", "§")));
    EXPECT_THAT(decoded("äß€😀"), ElementsAre(key("", "ä"), key("", "ß"), key("", "€"), key("", "😀")));
    KeyDecoder cut;
    EXPECT_THAT(cut.take("\xe2\x82"), IsEmpty());
    EXPECT_THAT(cut.take("\xac"), ElementsAre(key("", "€")));
}

TEST(KeyDecoder, learns_from_the_terminal_which_code_its_backspace_sends) {
    EXPECT_THAT(decoded("\x08"), ElementsAre(key("Control+H")));
    EXPECT_THAT(decoded("\x08\x7f", terminal_keyboard("en", "xterm", '\x08')),
                ElementsAre(key("Backspace"), key("Backspace")));
    EXPECT_THAT(decoded("\x1b[25~", terminal_keyboard("en", "rxvt-unicode", '\x7f')), ElementsAre(key("Shift+F3")));
}

TEST(KeyDecoder, passes_pasted_text_on_as_text_rather_than_keys) {
    const std::string paste = "\x1b[200~forward 3\rtür\x1b[201~k";
    KeyDecoder whole;
    EXPECT_THAT(whole.take(paste), ElementsAre(pasted("forward 3\rtür"), key("K", "k")));
    for (std::size_t cut = 1; cut < paste.size(); ++cut) {
        KeyDecoder decoder;
        std::string text;
        std::vector<TerminalInput> keys;
        for (const std::string& part : {paste.substr(0, cut), paste.substr(cut)})
            for (const TerminalInput& input : decoder.take(part)) {
                if (input.pasted) text += input.text;
                else keys.push_back(input);
            }
        EXPECT_EQ(text, "forward 3\rtür") << cut;
        EXPECT_THAT(keys, ElementsAre(key("K", "k"))) << cut;
    }
    // If the end mark of a paste is lost, the next key must end the paste.
    EXPECT_THAT(decoded("\x1b[200~abc\x1b[Bk"), ElementsAre(pasted("abc"), key("Down"), key("K", "k")));
}

// At a terminal, help must name exactly those keys for which an escape sequence exists.
TEST(TerminalSends, exactly_the_keys_that_have_an_escape_sequence) {
    std::set<std::string> sent;
    const auto note = [&](const std::string& bytes) {
        const auto inputs = decoded(bytes);
        if (inputs.size() == 1) sent.insert(inputs.front().key);
    };
    for (int byte = 0; byte < 128; ++byte) {
        // The test skips these bytes, because they are signals, or Backspace on some terminals.
        if (byte == 3 || byte == 8 || byte == 26 || byte == 28) continue;
        note(std::string(1, static_cast<char>(byte)));
        note(std::string("\x1b") + static_cast<char>(byte));
    }
    for (const Sequence& sequence : xterm_sequences()) note(sequence.bytes);
    std::set<std::string> all_names;
    const auto add_names = [&](std::string_view names) {
        std::istringstream words{std::string(names)};
        for (std::string name; words >> name;) all_names.insert(name);
    };
    for (const CommandInfo& row : command_table()) add_names(row.key);
    for (const KeyboardHand hand : {KeyboardHand::Left, KeyboardHand::Right})
        for (const SetKeys& row : keys_for(hand)) add_names(row.keys);
    EXPECT_GT(all_names.size(), 120U);
    int cannot = 0;
    for (const std::string& name : all_names) {
        EXPECT_EQ(terminal_sends(name), sent.contains(name)) << name;
        cannot += !terminal_sends(name);
    }
    EXPECT_GT(cannot, 10) << "Control, Control+8 and others";
    EXPECT_TRUE(terminal_sends("alt+w"));
}

// The keys that Handrail suggests at a terminal must be keys that the terminal can send. If a command has no such key,
// Handrail must suggest the word of the command.
TEST(KeyMap, names_keys_that_a_terminal_can_send_and_otherwise_the_typed_command) {
    const std::map<std::string, std::string> changes{{"where", "Keypad5 F2"}};
    const KeyMap keys(changes);
    EXPECT_EQ(keys.keys_of(Command::StopSpeech), "Control");
    speak_to(ActsBy::TerminalKeys);
    EXPECT_EQ(keys.keys_of(Command::StopSpeech), "colon quiet");
    EXPECT_EQ(keys.keys_of(Command::WhereAmI), "F2");
    EXPECT_EQ(keys.keys_of(Command::LastPlace), "colon last-place");
    EXPECT_EQ(keys.keys_of(Command::Repeat), "Space or Q");
    speak_to(ActsBy::WindowKeys);
}

}  // namespace key_decoder_test
}  // namespace handrail
