#include "app/core/dialogue/dialogue.h"

#include <gmock/gmock.h>

#include "app/core/session/session.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "worlds/base/text.h"

namespace handrail {
namespace dialogue_test {

using testing::HasSubstr;
using testing::StartsWith;

struct Fruit {
    std::vector<std::size_t> chosen;
    int left = 0;
    Dialogue dialogue;

    ListSpec list(bool stays = false) {
        ListSpec spec;
        spec.title = "Fruit";
        spec.items = {{"Apple", {}}, {"Banana", "3", true}, {"Blueberry", {}}, {"Cherry", {}}};
        spec.chosen = [this](std::size_t i) { chosen.push_back(i); };
        spec.left = [this] { ++left; };
        spec.stays_open = stays;
        return spec;
    }
    std::string key(std::string_view name) { return dialogue.key(name, 0.0).words; }
};

TEST(Dialogue, steps_through_a_list_and_stops_at_its_ends) {
    Fruit f;
    EXPECT_EQ(f.dialogue.open(f.list()), "Fruit. Apple, 1 of 4");
    EXPECT_TRUE(f.dialogue.key("Up", 0.0).denied);
    EXPECT_EQ(f.key("Down"), "Banana, 3; 2 of 4");
    EXPECT_EQ(f.key("End"), "Cherry, 4 of 4");
    EXPECT_TRUE(f.dialogue.key("Down", 0.0).denied);
    EXPECT_EQ(f.key("Space"), "Cherry, 4 of 4");
    EXPECT_EQ(f.key("Home"), "Apple, 1 of 4");
    EXPECT_THAT(f.key("F1"), HasSubstr("Enter chooses"));
    EXPECT_TRUE(f.dialogue.key("W", 0.0).taken) << "no key reaches the world while a list is open";
    f.key("Enter");
    EXPECT_EQ(f.chosen, std::vector<std::size_t>{0});
    EXPECT_FALSE(f.dialogue.is_open());
    EXPECT_FALSE(f.dialogue.key("Down", 0.0).taken);
}

TEST(Dialogue, adds_no_full_stop_to_a_title_that_ends_its_sentence) {
    for (const std::string title : {"Which route?", "Put 3 places in order, starting with the first.", "Stop!"}) {
        Fruit f;
        ListSpec list = f.list();
        list.title = title;
        EXPECT_EQ(f.dialogue.open(std::move(list)), title + " Apple, 1 of 4");
        EXPECT_THAT(f.dialogue.line("list", 0.0).words, StartsWith(title + " 1: Apple."));
    }
}

TEST(Dialogue, finds_names_by_their_first_letters) {
    Fruit f;
    f.dialogue.open(f.list());
    EXPECT_EQ(f.dialogue.typed("b", 10.0).words, "Banana, 3; 2 of 4");
    EXPECT_EQ(f.dialogue.typed("b", 10.2).words, "Blueberry, 3 of 4") << "the same letter again goes on";
    EXPECT_EQ(f.dialogue.typed("B", 20.0).words, "Banana, 3; 2 of 4");
    EXPECT_EQ(f.dialogue.typed("l", 20.3).words, "Blueberry, 3 of 4") << "letters that follow are one word";
    EXPECT_TRUE(f.dialogue.typed("z", 30.0).denied);
    EXPECT_EQ(f.dialogue.key("Space", 40.0).words, "Blueberry, 3 of 4");
}

// A keyboard sends a blank first as a key and then as a character.
TEST(Dialogue, finds_names_of_several_words_as_the_person_types_them) {
    Dialogue dialogue;
    ListSpec doors;
    doors.title = "Doors";
    doors.items = {{"Lift door", {}}, {"Library", {}}, {"Library desk", {}}, {"Library door", {}}, {"Old shed", {}}};
    dialogue.open(doors);
    double now_s = 10.0;
    std::string said;
    for (const char letter : std::string("library door")) {
        now_s += 0.2;
        if (letter == ' ') dialogue.key("Space", now_s);
        said = dialogue.typed(std::string(1, letter), now_s).words;
    }
    EXPECT_EQ(said, "Library door, 4 of 5");
    EXPECT_EQ(dialogue.key("Space", now_s + 5.0).words, "Library door, 4 of 5") << "a pause ends the name";
    now_s += 10.0;
    for (const char* part : {"l", "i", "b", " ", "d", "o"}) said = dialogue.typed(part, now_s += 0.2).words;
    EXPECT_EQ(said, "Nothing begins with lib do.");
}

TEST(Dialogue, finds_an_item_by_its_typed_alternatives) {
    Dialogue dialogue;
    std::size_t chosen = 9;
    const auto open = [&] {
        ListSpec list{"Clock", {{"Beacon", ""}, {"Where it is", "3 steps"}}, 0, [&](std::size_t i) { chosen = i; }};
        list.items[1].also_typed = "where is it";
        dialogue.open(std::move(list));
    };
    for (const char* typed : {"where it is", "where is it", "Where is it?", "Where it"}) {
        open();
        EXPECT_TRUE(dialogue.has_use_for(typed)) << typed;
        chosen = 9;
        EXPECT_TRUE(dialogue.line(typed, 0.0).taken);
        EXPECT_EQ(chosen, 1U) << typed;
    }
    open();
    EXPECT_TRUE(dialogue.has_use_for("where is it?"));
    EXPECT_FALSE(dialogue.has_use_for("where is the kitchen"));
    EXPECT_EQ(dialogue.line("list", 0.0).words, "Clock. 1: Beacon. 2: Where it is, 3 steps.") << "it is not said";
}

TEST(Dialogue, changes_a_value_in_place) {
    Fruit f;
    ListSpec spec = f.list();
    int value = 3;
    spec.adjusted = [&](std::size_t item, int by) {
        EXPECT_EQ(item, 1U);
        return std::to_string(value += by);
    };
    f.dialogue.open(std::move(spec));
    EXPECT_TRUE(f.dialogue.key("Right", 0.0).denied) << "an apple has no value";
    f.key("Down");
    EXPECT_EQ(f.key("Right"), "4");
    EXPECT_EQ(f.key("Left"), "3");
    EXPECT_EQ(f.key("Left"), "2");
    EXPECT_EQ(f.dialogue.view().items[1].value, "2");
}

TEST(Dialogue, returns_to_the_outer_list_and_closes_all_lists_after_a_final_choice) {
    Fruit f;
    f.dialogue.open(f.list(true));
    f.key("Down");
    f.key("Enter");
    EXPECT_TRUE(f.dialogue.is_open());
    ListSpec upper = f.list();
    upper.title = "More";
    f.dialogue.open(upper);
    EXPECT_EQ(f.key("Escape"), "Fruit. Banana, 3; 2 of 4");
    EXPECT_EQ(f.left, 1);
    f.dialogue.open(upper);
    f.key("Enter");
    EXPECT_FALSE(f.dialogue.is_open());
    EXPECT_EQ(f.chosen, (std::vector<std::size_t>{1, 0}));
}

// A function that is called for a choice may open and close any lists, including the list that contains the chosen
// item.
TEST(Dialogue, can_be_changed_by_the_chosen_item) {
    Dialogue dialogue;
    ListSpec list;
    list.title = "Outer";
    list.items = {{"one", {}, true}, {"two", {}}};
    list.stays_open = true;
    list.chosen = [&](std::size_t) {
        for (int i = 0; i < 20; ++i)
            dialogue.open({.title = "Inner", .items = {{"a", {}}}, .chosen = [](std::size_t) {}});
    };
    list.adjusted = [&](std::size_t, int) {
        dialogue.close_all();
        return std::string("gone");
    };
    dialogue.open(list);
    dialogue.key("Enter", 0.0);
    EXPECT_EQ(dialogue.view().title, "Inner");
    for (int i = 0; i < 20; ++i) dialogue.key("Escape", 0.0);
    EXPECT_EQ(dialogue.view().title, "Outer");
    dialogue.key("Left", 0.0);
    EXPECT_FALSE(dialogue.is_open());
}

TEST(Dialogue, reports_an_empty_list_and_opens_nothing) {
    Dialogue dialogue;
    EXPECT_EQ(dialogue.open({.title = "Marks", .items = {}, .chosen = {}}), "Marks: the list is empty.");
    EXPECT_FALSE(dialogue.is_open());
}

TEST(Dialogue, accepts_text_in_any_script_and_deletes_whole_letters) {
    Dialogue dialogue;
    std::string typed;
    EXPECT_EQ(dialogue.request_text(
                  {.question = "Name?", .text = "", .done = [&](std::string text) { typed = std::move(text); }}),
              "Name? Escape cancels.");
    EXPECT_TRUE(dialogue.typing());
    EXPECT_TRUE(dialogue.key("Enter", 0.0).denied) << "nothing typed";
    for (const std::string& c : characters_of(" Kü洞𝄞x")) dialogue.typed(c, 0.0);
    EXPECT_EQ(dialogue.key("Backspace", 0.0).words, "x deleted");
    EXPECT_EQ(dialogue.key("Backspace", 0.0).words, "𝄞 deleted");
    EXPECT_EQ(dialogue.key("Up", 0.0).words, "Name?  Kü洞");
    EXPECT_TRUE(dialogue.typed("\xC3", 0.0).denied);
    for (int i = 0; i < 300; ++i) dialogue.typed("x", 0.0);
    EXPECT_EQ(dialogue.view().text.size(), kLongestTyped);
    dialogue.key("Enter", 0.0);
    EXPECT_THAT(typed, StartsWith("Kü洞x"));
    EXPECT_FALSE(dialogue.is_open());
}

TEST(Dialogue, works_with_typed_lines) {
    Fruit f;
    f.dialogue.open(f.list(true));
    EXPECT_EQ(f.dialogue.line("list", 0.0).words, "Fruit. 1: Apple. 2: Banana, 3. 3: Blueberry. 4: Cherry.");
    EXPECT_EQ(f.dialogue.line("down", 0.0).words, "Banana, 3; 2 of 4");
    f.dialogue.line("blue", 0.0);
    f.dialogue.line("4", 0.0);
    f.dialogue.line(" CHERRY ", 0.0);
    EXPECT_EQ(f.chosen, (std::vector<std::size_t>{2, 3, 3}));
    EXPECT_TRUE(f.dialogue.line("5", 0.0).denied);
    EXPECT_TRUE(f.dialogue.line("pear", 0.0).denied);
    std::string typed;
    f.dialogue.request_text(
        {.question = "Name?", .text = "old", .done = [&](std::string text) { typed = std::move(text); }});
    f.dialogue.line("the hall", 0.0);
    EXPECT_EQ(typed, "the hall");
    f.dialogue.line("escape", 0.0);
    EXPECT_FALSE(f.dialogue.is_open());
}

// In a list of the platforms of a station, "1" means platform 1, wherever it is in the list.
TEST(Dialogue, prefers_an_item_named_by_a_number_to_the_item_at_that_number) {
    Fruit f;
    ListSpec platforms = f.list(true);
    platforms.items = {{"Footway", {}}, {"2", {}}, {"1", {}}, {"Steps", {}}};
    f.dialogue.open(std::move(platforms));
    for (const char* typed : {"1", "2", "4"}) f.dialogue.line(typed, 0.0);
    EXPECT_EQ(f.chosen, (std::vector<std::size_t>{2, 1, 3}));
}

TEST(Dialogue, sets_the_quantity_of_an_item_directly) {
    Dialogue dialogue;
    ListSpec list;
    list.title = "Desk";
    list.items = {{"Volume", "80 percent", true, ItemNumber{0.8, 0.0, 1.0, 0.1}}, {"Pull", "off", true}};
    std::vector<double> put;
    list.put = [&](std::size_t item, double number) {
        put.push_back(number);
        return item == 0 ? std::string("30 percent") : std::string("wrong");
    };
    dialogue.open(std::move(list));
    const DialogueReply done = dialogue.act({ItemAct::Kind::Put, 0, "Volume", 0.3}, 0.0);
    EXPECT_TRUE(done.taken && !done.denied);
    EXPECT_EQ(done.words, "30 percent");
    EXPECT_EQ(dialogue.view().items[0].value, "30 percent");
    EXPECT_TRUE(dialogue.act({ItemAct::Kind::Put, 1, "Pull", 1.0}, 0.0).denied) << "no quantity";
    EXPECT_FALSE(dialogue.act({ItemAct::Kind::Put, 0, "Other", 1.0}, 0.0).taken) << "another list by now";
    EXPECT_EQ(put, std::vector<double>{0.3});
}

struct Open {
    explicit Open() : app(Settings{}, HandFacts{}) {
        test::SceneBuilder b;
        b.box({0, 0, -0.2}, {6, 4, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
        b.start({3, 0.5, 0}, 0.0);
        app.apply(WorldEntered{make_ready(b.share())}, 0.0);
    }
    std::vector<std::string> said() {
        std::vector<std::string> lines;
        for (const CueRequest& cue : app.take_cues())
            if (cue.kind == CueRequestKind::Say) lines.push_back(cue.text);
        return lines;
    }
    Session app;
};

TEST(SessionLists, contain_every_command_and_perform_it) {
    Open s;
    s.app.apply(CommandDown{Command::Menu}, 0.0);
    s.app.apply(CommandUp{Command::Menu}, 0.0);
    EXPECT_TRUE(s.app.apply(KeyTapped{"Enter"}, 0.0));  // opens the entry "what I can do"
    EXPECT_TRUE(s.app.apply(KeyTapped{"Enter"}, 0.0));  // shows all commands
    ASSERT_EQ(s.app.dialogue().view().items.size(), command_table().size());
    s.said();
    double now_s = 0.0;
    for (const char letter : std::string("say which")) {  // the command "which way you face"
        EXPECT_TRUE(s.app.apply(TextTyped{std::string(1, letter)}, now_s));
        now_s += 0.1;
    }
    EXPECT_TRUE(s.app.apply(KeyTapped{"Enter"}, now_s));
    EXPECT_FALSE(s.app.dialogue().is_open());
    EXPECT_THAT(s.said().back(), HasSubstr("Facing north"));
}

TEST(SessionLists, never_capture_the_keys_that_stop_force_sound_or_speech) {
    Open s;
    s.app.apply(CommandDown{Command::Menu}, 0.0);
    for (const char* key : {"F12", "Control", "Grave"}) EXPECT_FALSE(s.app.apply(KeyTapped{key}, 0.0)) << key;
    for (const char* key : {"Up", "F", "W", "F2"}) EXPECT_TRUE(s.app.apply(KeyTapped{key}, 0.0)) << key;
    EXPECT_FALSE(s.app.apply(LineTyped{"stop"}, 0.0));
    EXPECT_TRUE(s.app.apply(LineTyped{"forward"}, 0.0));
    s.app.apply(WorldEntered{make_ready(s.app.scene())}, 1.0);
    EXPECT_FALSE(s.app.dialogue().is_open()) << "in another world the list may mean nothing";
}

TEST(SessionLists, release_held_keys_when_they_open) {
    Open s;
    s.app.apply(CommandDown{Command::Forward}, 0.0);
    s.app.apply(CommandDown{Command::Menu}, 0.0);
    for (double now = 0.0; now < 1.0; now += 0.02) s.app.tick(now, ToolState{});
    EXPECT_NEAR(s.app.feet_m().y, 0.5, 0.05);
}

}  // namespace dialogue_test
}  // namespace handrail
