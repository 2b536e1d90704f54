#include "app/terminal/line_editor.h"
#include "tests/support/names.h"

#include <gmock/gmock.h>

namespace handrail {
namespace line_editor_test {

using testing::ElementsAre;
using testing::IsEmpty;

// Returns the terminal's last line after the output `written`.
std::string shown(const std::string& written) {
    std::string line;
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (written[i] == '\n') {
            line.clear();
        } else if (written[i] == '\b') {
            while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0U) == 0x80U) line.pop_back();
            if (!line.empty()) line.pop_back();
            i += 2;  // the editor also writes a blank over the character and a second step back
        } else {
            line += written[i];
        }
    }
    return line;
}

struct Typed {
    LineEditor editor;
    std::string written;
    std::vector<std::string> lines;
    bool left = false;

    explicit Typed(std::string_view prompt = ":") : written(editor.open(prompt)) {}
    Typed& put(std::string_view bytes) {
        KeyDecoder decoder;
        auto inputs = decoder.take(bytes);
        for (TerminalInput& input : decoder.time_out()) inputs.push_back(std::move(input));
        for (const TerminalInput& input : inputs) {
            LineEditor::Reply reply = editor.take(input);
            written += reply.echo;
            left = left || reply.left;
            for (std::string& line : reply.lines) lines.push_back(std::move(line));
        }
        return *this;
    }
};

TEST(LineEditor, displays_typed_text_and_returns_the_line_on_enter) {
    Typed typed;
    typed.put("forward 3");
    EXPECT_EQ(shown(typed.written), ":forward 3");
    EXPECT_THAT(typed.lines, IsEmpty());
    typed.put("\r");
    EXPECT_THAT(typed.lines, ElementsAre("forward 3"));
    EXPECT_EQ(shown(typed.written), "");
    EXPECT_FALSE(typed.editor.is_open());
}

TEST(LineEditor, deletes_whole_characters_and_the_whole_line) {
    Typed typed;
    typed.put("tür\x7f\x7f");
    EXPECT_EQ(shown(typed.written), ":t");
    typed.put("\x7f\x7f\x7f");
    EXPECT_EQ(shown(typed.written), ":") << "not beyond its begin";
    typed.put("wohin\x15wo\r");
    EXPECT_THAT(typed.lines, ElementsAre("wo"));
}

TEST(LineEditor, is_closed_by_escape_and_ignores_other_keys) {
    Typed typed;
    typed.put("where\x1b");
    EXPECT_TRUE(typed.left);
    EXPECT_FALSE(typed.editor.is_open());
    EXPECT_THAT(typed.lines, IsEmpty());
    Typed other;
    EXPECT_FALSE(other.editor.take({"Up", {}, false}).taken);
    EXPECT_FALSE(other.editor.take({"F12", {}, false}).taken);
    EXPECT_TRUE(other.editor.is_open());
}

TEST(LineEditor, accepts_each_line_of_a_pasted_text) {
    Typed typed;
    typed.put("\x1b[200~forward 3\r\nwhere\nri\x1b[201~");
    EXPECT_THAT(typed.lines, ElementsAre("forward 3", "where"));
    EXPECT_TRUE(typed.editor.is_open());
    typed.put("ght\r");
    EXPECT_THAT(typed.lines, ElementsAre("forward 3", "where", "right"));
    Typed whole;
    whole.put("\x1b[200~where\n\x1b[201~");
    EXPECT_FALSE(whole.editor.is_open());
}

TEST(LineEditor, truncates_an_endless_line_and_displays_only_a_part) {
    Typed typed;
    typed.put(std::string(100'000, 'a'));
    typed.put("\r");
    ASSERT_EQ(typed.lines.size(), 1U);
    EXPECT_EQ(typed.lines.front().size(), LineEditor::kLongest);
    Typed strange;
    strange.put(
        "\x1b[200~a\x07\x9b"
        "b\x1b[201~\r");
    EXPECT_EQ(strange.written.find('\x07'), std::string::npos) << "nothing that a terminal would obey";
}

}  // namespace line_editor_test
}  // namespace handrail
