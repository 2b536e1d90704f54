// Plays the six typical sessions that docs/transcripts.md shows, by text alone, and compares them with the page. If
// HANDRAIL_WRITE_TRANSCRIPTS is set, writes the page instead.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "tests/support/names.h"
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
         "Questions about the place. The first answer is short; ask again for more.",
         "house.map",
         "en",
         false,
         {"where", "where", "heading", "around", "ahead", "look", "look", "exits", "coordinates"}},
        {"Walking, along walls, and from thing to thing",
         "Steps are counted, and you hear what stops you. Trailing names what it meets and waits before stairs.",
         "house.map",
         "en",
         false,
         {"forward 3", "forward 11", "forward", "use", "home", "trail-right 4", "trail-on", "trail-back", "square",
          "retrace 30", "leap-next", "leap-next", "leap-last", "undo"}},
        {"Lost, and found again",
         "You are turned to the nearest wall and hear the route back. Then the rooms and the house are described.",
         "house.map",
         "en",
         false,
         {"right 2", "forward 4", "left 5", "lost", "describe living room", "overview"}},
        {"Marks, finding, and lists",
         "You set a mark and find it again. Every list works alike: by numbers, names, and words for the keys.",
         "house.map",
         "en",
         false,
         {"forward 2", "mark", "my place", "find grandfather clock", "where is it", "home", "find my place",
          "where it is", "menu", "down", "escape", "help", "search", "wall", "hallo"}},
        {"Auf Deutsch",
         "A session in German, with German words typed.",
         "house.map",
         "de",
         false,
         {"wo", "vorwärts 3", "links 2", "verlaufen", "beschreibe küche", "zurück 2"}},
    };
    return kScripts;
}

// A typed line and the announcements after it. The first turn of a session is its greeting and has no line.
struct Turn {
    const char* line = nullptr;
    std::vector<std::string> said;
};

std::vector<Turn> play(const Script& script) {
    const test::InLanguage spoken(script.language);
    test::TextSession session(test::our_world(script.world), script.first_start);
    std::vector<Turn> turns{{nullptr, session.greeting()}};
    for (const char* line : script.lines) turns.push_back({line, session.type(line)});
    return turns;
}

std::string shown(const Turn& turn) {
    std::string text = turn.line == nullptr ? "- At the start:"
                       : *turn.line == '\0' ? "- Enter, on an empty line:"
                                            : "- `" + std::string(turn.line) + "`:";
    for (const std::string& said : turn.said)
        text += " " + said + (std::string_view(".?!").find(said.back()) == std::string_view::npos ? "." : "");
    return text + (turn.said.empty() ? " nothing.\n" : "\n");
}

std::string document() {
    std::string text =
        "# Six sessions as examples\n\n"
        "In these sessions everything is typed, and there is no device, window or sound. Each item is what\n"
        "you type, then what Handrail says.\n";
    std::set<std::string> greetings;
    for (const Script& script : scripts()) {
        text += std::string("\n## ") + script.title + "\n\n" + script.about + " World: `" + script.world + "`.\n\n";
        for (const Turn& turn : play(script)) {
            const std::string lines = shown(turn);
            // A world always greets in the same words, so the page shows each greeting only once.
            if (turn.line != nullptr || greetings.insert(lines).second) text += lines;
        }
    }
    return text;
}

TEST(Transcripts, match_the_document) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the document is the same under a sanitizer";
    const std::filesystem::path file = test::project_root() / "docs" / "transcripts.md";
    const std::string played = document();
    if (const char* write = std::getenv("HANDRAIL_WRITE_TRANSCRIPTS"); write && *write) {
        std::ofstream(file) << played;
        GTEST_SKIP() << "written to " << file;
    }
    std::ifstream stream(file);
    const std::string page((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_EQ(played, page) << "HANDRAIL_WRITE_TRANSCRIPTS=1 writes the document again; read what has changed";
}

TEST(Transcripts, follow_the_rules_for_spoken_text) {
    for (const Script& script : scripts())
        for (const Turn& turn : play(script))
            for (const std::string& said : turn.said)
                for (const std::string& fault : test::faults_of(said, script.language))
                    ADD_FAILURE() << script.title << ": " << fault << "\n  " << said;
}

}  // namespace transcripts_test
}  // namespace handrail
