// Tests the effect of a typed line while a list is open, in a session on a virtual clock.
#include "app/core/session/carried_lines.h"

#include "app/core/session/headless_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "worlds/base/typist.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace carried_lines_test {

class CarriedLinesInTheHouse : public testing::Test {
protected:
    void SetUp() override {
        speak_to(ActsBy::Lines);
        const auto house = read_world(test::bundled_world("house.map"));
        ASSERT_TRUE(house);
        session_.app().apply(WorldEntered{make_ready(std::make_shared<const Scene>(*house))}, 0.0);
        type({});
    }
    void TearDown() override { speak_to(ActsBy::WindowKeys); }
    // Types a line, and returns what the session says until the line has been carried out. An empty line only waits.
    std::string type(const std::string& line) {
        const std::size_t before = speech_.lines().size();
        if (!line.empty()) session_.type(line);
        for (int quiet_ms = 0; quiet_ms < 500 && session_.now_s() < 120.0; ++quiet_ms) {
            session_.advance();
            if (!session_.lines().done() || !session_.app().idle()) quiet_ms = 0;
        }
        std::string said;
        for (std::size_t i = before; i < speech_.lines().size(); ++i) said += speech_.lines()[i].utterance.text + "\n";
        return said;
    }
    bool list_is_open() { return session_.app().dialogue().is_open(); }

    RecordingAudio audio_;
    RecordingSpeech speech_;
    HeadlessSession session_{Settings{}, HandFacts{}, audio_, speech_};
};

TEST_F(CarriedLinesInTheHouse, are_commands_if_the_open_list_has_no_use_for_them) {
    for (const char* list : {"menu", "find", "routes", "find piano", "describe"}) {
        type(list);
        ASSERT_TRUE(list_is_open()) << list;
        const std::string said = type("left 1");
        EXPECT_EQ(said.find("list"), std::string::npos) << list << ": " << said;
        EXPECT_NE(said.find("orth"), std::string::npos) << list << ": " << said;
        EXPECT_FALSE(list_is_open()) << list;
        type("right 1");
        // A whole sentence has the same effect as the word of a command.
        type(list);
        EXPECT_NE(type("turn left three times").find("West"), std::string::npos) << list;
        EXPECT_FALSE(list_is_open()) << list;
        type("right 3");
    }
}

TEST_F(CarriedLinesInTheHouse, close_the_open_list_in_german_by_its_word_or_by_another_command) {
    const test::InLanguage german("de");
    for (const char* list : {"menü", "finden", "hallo"}) {
        type(list);
        ASSERT_TRUE(list_is_open()) << list;
        const std::string refused = type("bananen");
        EXPECT_NE(refused.find("„abbrechen“ verlässt sie"), std::string::npos) << list << ": " << refused;
        EXPECT_NE(type("abbrechen").find("Geschlossen"), std::string::npos) << list;
        EXPECT_FALSE(list_is_open()) << list;
        type(list);
        EXPECT_NE(type("wie viele Stockwerke gibt es").find("Es gibt 2 Stockwerke."), std::string::npos) << list;
        EXPECT_FALSE(list_is_open()) << list;
    }
}

TEST_F(CarriedLinesInTheHouse, choose_from_the_open_list_before_they_count_as_commands) {
    EXPECT_NE(type("describe").find("Which room to describe."), std::string::npos);
    EXPECT_NE(type("kitchen").find("Kitchen: 4.5 by 3 metres"), std::string::npos);
    type("menu");
    EXPECT_NE(type("down").find("2 of "), std::string::npos);
    EXPECT_NE(type("list").find("1: "), std::string::npos);
    EXPECT_NE(type("around").find("Behind: "), std::string::npos) << "only asks";
    EXPECT_NE(type("bananas").find("\"bananas\" is not in this list."), std::string::npos);
    EXPECT_TRUE(list_is_open());
    EXPECT_NE(type("escape").find("Closed"), std::string::npos);
}

TEST_F(CarriedLinesInTheHouse, choose_by_name_without_a_word_of_the_lists_that_are_searched) {
    for (const auto& [line, answer] :
         {std::pair("route to clock", "Follow the beacon to Grandfather clock"),
          std::pair("routes kitchen", "To Kitchen"),
          std::pair("route to the grandfather clock", "Follow the beacon to Grandfather clock"),
          std::pair("find piano", "Piano"), std::pair("find bedroom", "To Bedroom"),
          std::pair("describe the kitchen", "Kitchen: 4.5 by 3 metres"), std::pair("where is the piano", "Piano: ")}) {
        const std::string said = type(line);
        EXPECT_TRUE(said.starts_with(answer)) << line << ": " << said;
        EXPECT_EQ(list_is_open(), std::string_view(line) == "find piano") << line;
    }
}

TEST_F(CarriedLinesInTheHouse, open_no_list_that_the_person_did_not_request) {
    for (const auto& [line, answer] :
         {std::pair("where is the unicorn", "Nothing called \"unicorn\" was found. Type find to hear what there is."),
          std::pair("how do i get to the moon", "Nothing called \"moon\" was found. Type routes to hear"),
          std::pair("describe attic", "Nothing called \"attic\" was found. Type describe to hear")}) {
        EXPECT_NE(type(line).find(answer), std::string::npos) << line;
        EXPECT_FALSE(list_is_open()) << line;
    }
    const test::InLanguage german("de");
    EXPECT_NE(type("wo ist das einhorn").find("„einhorn“ wurde nicht gefunden."), std::string::npos);
    EXPECT_FALSE(list_is_open());
}

}  // namespace carried_lines_test
}  // namespace handrail
