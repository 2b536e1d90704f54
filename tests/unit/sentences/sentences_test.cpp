// Runs every command in five worlds and two languages, and checks each resulting sentence against the rules.
#include <fmt/ranges.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "app/core/dialogue/brief_words.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/sentences/sentence_rules.h"
#include "worlds/base/typist.h"

namespace handrail {
namespace sentences_test {

using test::AppSession;
using test::faults_of;

TEST(SentenceRules, detect_each_fault_and_accept_correct_sentences) {
    const auto fails = [](const char* text, const char* language = "en") { return !faults_of(text, language).empty(); };
    for (const char* good :
         {"Kitchen, facing north. Door to hall: 3 steps, half left.", "Up to 4 things.", "An edge. A one-way door.",
          "1 exit: door to corridor, south wall.", "12.5 metres by 3 metres.", "Shift+4, 2 of 9", "Table, 4 of them"})
        EXPECT_FALSE(fails(good)) << good << ": " << faults_of(good, "en").front();
    for (const char* bad :
         {"Door (open)", "Edge to step down from to garden", "the the door", "edge from to garden", "2 3 steps",
          "Steps, 3, 4 metres", "Value {name}", "Twice..", "Wrong ,comma", " begins", "a edge", "an door", "1 steps",
          "rooms.exit", "nan metres", "-0.0 metres", "to at once", "the of", "snake_case"})
        EXPECT_TRUE(fails(bad)) << bad;
    EXPECT_TRUE(fails("1 Schritte", "de"));
    EXPECT_TRUE(fails("von zu Hause", "de"));
    EXPECT_TRUE(fails("die Tür der der", "de"));
    EXPECT_FALSE(fails("Tür zum Flur: 1 Schritt, halb links.", "de"));
}

// Returns true for commands after which the test cannot query the world any more, or whose lists change the language of
// the announcements.
bool stays_out(Command command) {
    return command == Command::Leave || command == Command::Calibrate || command == Command::Language ||
           command == Command::FirstMinutes || command == Command::Learners;
}

class Talk {
public:
    Talk(std::shared_ptr<const Scene> scene, const std::string& language) : language_(language) {
        s_.app.apply(WorldEntered{make_ready(std::move(scene))}, 0.0);
        s_.run(0.2);
        look("entering");
        s_.request(Command::Exits);
        look("exits");
    }
    void everything() {
        for (int round = 0; round < 2; ++round) {
            for (const CommandInfo& row : command_table()) {
                if (stays_out(row.command)) continue;
                s_.app.apply(CommandDown{row.command}, s_.now);
                s_.run(0.25);
                s_.app.apply(CommandUp{row.command}, s_.now);
                // The command may have begun something that continues, so the test waits only for a limited time.
                for (int i = 0; i < 8 && !s_.app.idle(); ++i) s_.run(0.25);
                look(std::string(row.word));
                // The second request switches input help off. Otherwise input help would explain the following keys
                // instead of carrying them out.
                if (row.command == Command::InputHelp) s_.request(row.command);
                go_through_list(std::string(row.word), round);
                s_.app.requests() = {};
            }
            to_room(round);
        }
    }
    std::size_t sentences() const { return sentences_; }
    // Maps each faulty text to a description of its faults.
    const std::map<std::string, std::string>& faulty() const { return faulty_; }

private:
    void look(const std::string& after) {
        for (const std::string& text : std::exchange(s_.said, {})) {
            ++sentences_;
            const std::vector<std::string> faults = faults_of(text, language_);
            if (!faults.empty()) faulty_.emplace(text, after + ": " + fmt::format("{}", fmt::join(faults, "; ")));
        }
    }
    // Goes down the list, chooses one entry, and leaves the list. The loops are limited, because an entry may open
    // another list.
    void go_through_list(const std::string& word, int round) {
        constexpr int kMostItems = 12, kMostLists = 6;
        for (int i = 0; i < kMostItems && s_.app.dialogue().is_open(); ++i) {
            key("Down");
            look(word + ", down");
        }
        if (round == 1) key("Home");
        key("Right");
        look(word + ", right");
        if (s_.app.dialogue().is_open() && !leaves_here()) key("Enter");
        s_.run(0.3);
        look(word + ", chosen");
        for (int i = 0; i < kMostLists && s_.app.dialogue().is_open(); ++i) {
            key("Escape");
            look(word + ", left");
        }
        EXPECT_FALSE(s_.app.dialogue().is_open()) << word;
    }
    // Returns true if choosing an entry of this list could end the session, change the language or read another world.
    bool leaves_here() const {
        const std::string title = s_.app.dialogue().view().title;
        return title == phrase("menu.worlds") || title == phrase("language.menu") || title == phrase("menu.title");
    }
    void key(const char* name) {
        if (!s_.app.dialogue().is_open()) return;
        s_.app.apply(KeyTapped{name}, s_.now);
        s_.run(0.05);
    }
    // Puts the walker in the middle of another room.
    void to_room(int which) {
        const auto rooms = s_.app.view({}).rooms;
        if (!rooms || rooms->empty()) return;
        const DrawnRoom& room = (*rooms)[(rooms->size() / 2 + static_cast<std::size_t>(which)) % rooms->size()];
        s_.app.apply(Placed{room.middle_m, 0.4}, s_.now);
        s_.run(0.5);
        look("placed");
    }

    std::string language_;
    AppSession s_;
    std::size_t sentences_ = 0;
    std::map<std::string, std::string> faulty_;
};

class Sentences : public testing::TestWithParam<const char*> {};

TEST_P(Sentences, of_every_command_keep_the_rules_in_every_language) {
    const std::string name = GetParam();
    const bool ours = name == "house.map" || name == "school.map";
    const std::filesystem::path source(test::project_root());
    const auto path = ours                        ? source / "worlds" / "maps" / name
                      : name == "small_house.ifc" ? source / "tests" / "unit" / "ifc" / "worlds" / name
                                                  : test::real_world(name).value_or(std::filesystem::path());
    if (path.empty()) GTEST_SKIP() << test::needs_real_world(name);
    if (test::kSanitizerScale < 1.0 && name != "house.map") GTEST_SKIP() << "words are the same under a sanitizer";
    for (const LanguageName& language : bundled_languages())
        for (const ActsBy who : {ActsBy::WindowKeys, ActsBy::Lines}) {
            // The keys and words in the texts do not depend on the world. So the large worlds do not repeat the test
            // for typed lines.
            if (name != "house.map" && name != "small_house.ifc" && who == ActsBy::Lines) continue;
            const test::InLanguage spoken(language.code);
            speak_to(who);
            Talk talk(test::world_once(path), language.code);
            talk.everything();
            speak_to(ActsBy::WindowKeys);
            for (const auto& [text, what] : talk.faulty())
                ADD_FAILURE() << language.code << " " << what << "\n  " << text;
            EXPECT_GT(talk.sentences(), 150U);
            std::cout << name << ", " << language.code << ": " << talk.sentences() << " texts\n";
        }
}

INSTANTIATE_TEST_SUITE_P(Worlds, Sentences,
                         testing::Values("house.map", "school.map", "agdm01.map", "quake-start.map", "small_house.ifc"),
                         [](const auto& test) {
                             std::string name(test.param);
                             name = name.substr(0, name.find('.'));
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace sentences_test
}  // namespace handrail
