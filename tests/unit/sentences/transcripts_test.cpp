// Ten typical sessions by text alone, as docs/transcripts.md shows them: played anew, and held equal to what stands
// there. With HANDRAIL_WRITE_TRANSCRIPTS set the document is written anew instead.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/sentences/sentence_rules.h"
#include "tests/unit/sentences/text_session.h"

namespace handrail {
namespace transcripts_test {

struct Script {
    const char* title;
    const char* about;
    const char* world;
    const char* language;
    bool first_start;
    std::vector<const char*> lines;
};

const std::vector<Script>& scripts() {
    static const std::vector<Script> kScripts{
        {"The first minutes",
         "The first start, from the welcome to the first corner and back to the door.",
         "first_room.map",
         "en",
         true,
         {"", "forward 6", "left 4", "forward 3", "right 8", "forward 7", "home", "list", "explore freely", "where"}},
        {"Where am I",
         "Questions about the place, each short first and longer when asked again.",
         "house.map",
         "en",
         false,
         {"where", "where", "heading", "around", "ahead", "look", "look", "exits", "coordinates", "repeat"}},
        {"Walking, and what is in the way",
         "Steps are counted, and what ends them is told each time.",
         "house.map",
         "en",
         false,
         {"forward 3", "forward 11", "forward", "left 2", "forward 5", "back 2", "use", "home"}},
        {"Along a wall",
         "Trailing says where it goes, names what it meets, and waits before stairs.",
         "house.map",
         "en",
         false,
         {"trail-right 4", "trail-on", "trail-on", "trail-on", "trail-back", "square", "retrace 30"}},
        {"From thing to thing",
         "Leaps to the nearest things, with the doors of the room among them, and back.",
         "house.map",
         "en",
         false,
         {"exits", "leap-next", "leap-next", "leap-next", "leap-last", "leap-last", "undo", "where"}},
        {"Lost, and found again",
         "Turned to the nearest wall, with the way back; then rooms and house from afar.",
         "house.map",
         "en",
         false,
         {"where", "right 2", "forward 4", "left 5", "lost", "describe living room", "describe kitchen", "overview"}},
        {"Marks and finding",
         "A mark of one's own, the list of all that has a name, and what is told of one thing.",
         "house.map",
         "en",
         false,
         {"forward 2", "mark", "my place", "find grandfather clock", "where it is", "marks", "escape", "home",
          "find my place", "where it is"}},
        {"Lists and help",
         "Every list works alike: numbers, names, and words for the keys.",
         "house.map",
         "en",
         false,
         {"menu", "list", "down", "down", "escape", "help", "search", "wall", "escape", "hallo", "forward 2000"}},
        {"A school from afar",
         "A large building before one walks in it.",
         "school.map",
         "en",
         false,
         {"overview", "describe library", "exits", "leap-next", "where"}},
        {"Auf Deutsch",
         "The same words of one's own language: a session in German.",
         "house.map",
         "de",
         false,
         {"wo", "vorwärts 3", "links 2", "ausgänge", "verlaufen", "beschreibe küche", "überblick", "zurück 2"}},
    };
    return kScripts;
}

std::string told(const std::vector<std::string>& said) {
    std::string text;
    for (const std::string& line : said) text += "- Handrail says: " + line + "\n";
    return said.empty() ? "- Handrail says nothing.\n" : text;
}

std::string play(const Script& script) {
    const test::InLanguage spoken(script.language);
    test::TextSession session(test::our_world(script.world), script.first_start);
    std::string text =
        std::string("## ") + script.title + "\n\n" + script.about + " World: `" + script.world + "`.\n\n";
    text += told(session.greeting());
    for (const char* line : script.lines) {
        text += *line == '\0' ? "- You press Enter on an empty line.\n" : "- You type `" + std::string(line) + "`.\n";
        text += told(session.type(line));
    }
    return text;
}

std::string document() {
    std::string text =
        "# Ten sessions as examples\n\n"
        "These sessions were played by lines of words, without a device, a window or sound. Each is a list: what was "
        "typed, and what was said then.\n"
        "A test plays them anew and holds them against this page (`unit_sentences`, with `HANDRAIL_WRITE_TRANSCRIPTS` "
        "set it writes the page).\n";
    for (const Script& script : scripts()) text += "\n" + play(script);
    return text;
}

TEST(Transcripts, of_ten_typical_sessions_are_as_the_document_shows_them) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the document is the same under a sanitizer";
    ASSERT_EQ(scripts().size(), 10U);
    const std::filesystem::path file = test::project_root() / "docs" / "transcripts.md";
    const std::string played = document();
    if (const char* write = std::getenv("HANDRAIL_WRITE_TRANSCRIPTS"); write && *write) {
        std::ofstream(file) << played;
        GTEST_SKIP() << "written to " << file;
    }
    std::ifstream stream(file);
    const std::string shown((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_EQ(played, shown) << "HANDRAIL_WRITE_TRANSCRIPTS=1 writes the document anew; read what has changed";
}

TEST(Transcripts, keep_the_rules_of_what_is_said) {
    for (const Script& script : scripts()) {
        const std::string played = play(script);
        const std::string begin = "- Handrail says: ";
        for (std::size_t at = played.find(begin); at != std::string::npos; at = played.find(begin, at + 1)) {
            const std::size_t from = at + begin.size();
            const std::string said = played.substr(from, played.find('\n', from) - from);
            for (const std::string& fault : test::faults_of(said, script.language))
                ADD_FAILURE() << script.title << ": " << fault << "\n  " << said;
        }
    }
}

}  // namespace transcripts_test
}  // namespace handrail
