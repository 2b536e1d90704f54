#include "app/wizard/wizard.h"

#include <set>

#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/wizard/wizard_rig.h"

namespace handrail::test {
namespace wizard_test {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kTwoMinutes_s = 120.0;

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

// Checks that the lines contain each of the `wanted` texts, in this order.
void expect_in_order(const std::vector<std::string>& lines, std::initializer_list<const char*> wanted) {
    auto from = lines.begin();
    for (const char* words : wanted) {
        from = std::find_if(from, lines.end(),
                            [&](const std::string& line) { return line.find(words) != std::string::npos; });
        ASSERT_NE(from, lines.end()) << "\"" << words << "\" was not said in its place:\n" << joined(lines);
        ++from;
    }
}

TEST(WizardFromStartToEnd, with_a_simulated_touch_takes_a_brisk_person_less_than_two_minutes) {
    HeldSimulated held;
    WizardRig rig("", &held);
    BriskPerson person(rig, &held);
    const double begun_s = rig.now_s();
    ASSERT_TRUE(person.answer_all(300.0)) << joined(rig.said());
    std::printf("a brisk person with a simulated Touch: %.1f s\n", rig.now_s() - begun_s);
    EXPECT_LT(rig.now_s() - begun_s, kTwoMinutes_s);
    expect_in_order(rig.said(), {"bell on your left",
                                 "Is the bell on your right now",
                                 "looking for a touch device",
                                 "The simulated Touch is ready",
                                 "Take the grip",
                                 "Good.",
                                 "Push the grip in",
                                 "Good.",
                                 "Which hand",
                                 "Left hand.",
                                 "I will press",
                                 "You felt it at 0.",
                                 "Now you will feel a wall",
                                 "Normal, 2.5 newtons",
                                 "with more than 2.5 newtons",
                                 "as far as is comfortable",
                                 "Your hand reaches",
                                 "Your reach covers",
                                 "Your step is",
                                 "65 centimetres",
                                 "The set-up is complete."});
    const DeviceProfile profile = rig.profile();
    EXPECT_NEAR(profile.gentlest_n.value(), 0.4, 0.1);
    EXPECT_EQ(profile.ceiling_n, 2.5);
    EXPECT_EQ(profile.hand, HoldingHand::Left);
    EXPECT_NEAR(profile.width_m.value(), 1.4 * 0.075, 0.01);
    EXPECT_NEAR(profile.depth_m.value(), 1.3 * 0.075, 0.01);
    // The person moved the hand from 0.6 radii ahead to 0.7 radii behind, so the middle is 0.05 radii behind. The
    // wizard places 5 of 8 parts of the depth ahead of the body and 3 behind.
    EXPECT_NEAR(profile.offset_ahead_m.value(), (0.125 * 1.3 + 0.05) * 0.075, 0.003);
    EXPECT_EQ(profile.scale, 60.0);
    EXPECT_EQ(rig.store.values().walk.step_length_m, 0.65);
    EXPECT_LE(rig.largest_force_n, 2.5 + 1e-9);
    EXPECT_GT(rig.largest_force_n, 2.0) << "the wall was felt at what was chosen";
    rig.run(0.2);
    EXPECT_EQ(rig.force_n(), 0.0) << "nothing pushes when it is over";
}

TEST(WizardFromStartToEnd, with_a_falcon_starts_and_homes_it_with_spoken_instructions) {
    VirtualClock clock;
    HeldFalcon held(clock);
    WizardRig rig("", &held, &clock);
    BriskPerson person(rig, &held);
    const double begun_s = rig.now_s();
    ASSERT_TRUE(person.answer_all(300.0)) << joined(rig.said());
    std::printf("a brisk person with a Falcon: %.1f s\n", rig.now_s() - begun_s);
    EXPECT_LT(rig.now_s() - begun_s, kTwoMinutes_s);
    expect_in_order(rig.said(), {"looking for a touch device", "needs waking, in up to three attempts. Attempt 1",
                                 "Attempt 2", "The Falcon is ready.", "Pull it all the way towards you.", "Good.",
                                 "Push the grip in", "Good.", "Left hand.", "You felt it at 0.",
                                 "with more than 2.5 newtons", "Your hand reaches", "The set-up is complete."});
    EXPECT_GE(rig.clicks(), 3) << "one for each leg that found its zero";
    EXPECT_EQ(held.emulator.frames_before_homed_with_force, 0U);
    EXPECT_LE(held.emulator.largest_force_n, 2.5 + 0.05);
    EXPECT_EQ(rig.profile().hand, HoldingHand::Left);
    EXPECT_NEAR(rig.profile().gentlest_n.value(), 0.4, 0.1);
    EXPECT_TRUE(rig.store.values().profiles.contains("falcon a9001"));
}

TEST(WizardFromStartToEnd, with_no_device_says_so_and_does_the_remaining_parts) {
    WizardRig rig;
    BriskPerson person(rig, nullptr);
    const double begun_s = rig.now_s();
    ASSERT_TRUE(person.answer_all(300.0)) << joined(rig.said());
    std::printf("a brisk person without a device: %.1f s\n", rig.now_s() - begun_s);
    expect_in_order(rig.said(), {"bell on your left", "Is the bell on your right now",
                                 "There is no touch device. Everything works with keyboard and sound", "Your step is",
                                 "The set-up is complete."});
    EXPECT_FALSE(rig.has_said("Take the grip"));
    EXPECT_EQ(rig.store.values().walk.step_length_m, 0.65);
    EXPECT_TRUE(rig.store.values().profiles.empty());
}

TEST(WizardFromStartToEnd, can_be_driven_by_lines_of_a_script) {
    HeldSimulated held;
    WizardRig rig("", &held);
    for (const char* line : {"left",
                             "",
                             "hand-back 15",
                             "hand-forward 30",
                             "hand-left 12",
                             "wait 9",
                             "button",
                             "up",
                             "hand-back 20",
                             "hand-forward 20",
                             "wait 2",
                             "",
                             "hand-right 30",
                             "hand-left 30",
                             "hand-forward 30",
                             "hand-back 30",
                             "",
                             "",
                             "down",
                             "",
                             "0.75"})
        rig.session.type(line);
    rig.session.end_of_lines();
    ASSERT_TRUE(rig.run_until(
        [&] {
            held.command.target_m = rig.session.simulated_hand().target_m;
            held.command.buttons = rig.session.simulated_hand().buttons;
            held.hand->command.publish(held.command);
            return rig.wizard().finished();
        },
        120.0));
    rig.run(5.0);
    EXPECT_TRUE(rig.has_said("The set-up is complete.")) << joined(rig.said());
    EXPECT_EQ(rig.profile().hand, HoldingHand::Left);
    EXPECT_EQ(rig.profile().ceiling_n, 2.5);
    EXPECT_GT(rig.profile().gentlest_n.value(), 0.2);
    EXPECT_GT(rig.profile().width_m.value(), 0.1);
    EXPECT_EQ(rig.store.values().walk.step_length_m, 0.75);
    EXPECT_FALSE(rig.store.values().workspace.rim) << "one \"down\" switched it off";
}

TEST(Wizard, waits_without_a_time_limit_and_repeats_the_question_on_space) {
    WizardRig rig("step");
    rig.run(3600.0);
    EXPECT_FALSE(rig.wizard().finished());
    const std::string question(rig.wizard().question());
    ASSERT_THAT(rig.said(), ElementsAre(question));
    rig.key("Space");
    rig.run(0.1);
    EXPECT_THAT(rig.said(), ElementsAre(question, question));
}

TEST(Wizard, corrects_swapped_headphones_at_once) {
    WizardRig rig("headphones");
    const auto side_of_last_bell = [&] {
        double side = 0.0;
        for (const HeardSound& sound : rig.audio.sounds())
            if (sound.cue.kind == SoundKind::Bell) side = sound.cue.position_m.x;
        return side;
    };
    rig.run(0.1);
    EXPECT_LT(side_of_last_bell(), 0.0);
    rig.key("Right");
    rig.run(0.1);
    EXPECT_TRUE(rig.store.values().sound.swap_sides);
    EXPECT_TRUE(rig.question_begins("Are you wearing headphones?")) << "asked once more";
    rig.key("Left");
    rig.run(0.1);
    EXPECT_GT(side_of_last_bell(), 0.0);
    rig.key("Enter");
    rig.run(0.1);
    EXPECT_TRUE(rig.wizard().finished());
}

TEST(Wizard, skips_the_question_about_ears_without_sound) {
    WizardRig rig("headphones,step");
    rig.sense.audible = false;
    rig.run(0.1);
    EXPECT_TRUE(rig.has_said("There is no sound device"));
    EXPECT_TRUE(rig.question_begins("Your step is"));
}

TEST(Wizard, on_escape_explains_and_removes_the_force_and_ends_on_a_second_press) {
    HeldSimulated held;
    WizardRig rig("gentlest,step", &held);
    ASSERT_TRUE(rig.run_until([&] { return rig.question_begins("Move the grip a little. Then I will press"); }));
    held.aim({0.0, 0.0, 0.01});
    ASSERT_TRUE(rig.run_until([&] { return rig.force_n() > 0.3; })) << joined(rig.said());
    rig.key("Escape");
    rig.run(0.15);
    EXPECT_EQ(rig.force_n(), 0.0);
    EXPECT_TRUE(
        rig.has_said("It never presses with more than one newton. Press Enter to go on, or Escape again to leave"));
    rig.key("Enter");
    EXPECT_TRUE(rig.run_until([&] { return rig.force_n() > 0.3; })) << "the same question begins again";
    rig.key("Escape");
    rig.key("Escape");
    rig.run(0.15);
    EXPECT_TRUE(rig.wizard().finished());
    EXPECT_EQ(rig.force_n(), 0.0);
    EXPECT_TRUE(rig.store.values().profiles.empty());
}

TEST(Wizard, removes_all_force_at_once_on_the_stop_key) {
    HeldSimulated held;
    WizardRig rig("gentlest", &held);
    ASSERT_TRUE(rig.run_until([&] { return rig.question_begins("Move the grip a little"); }));
    held.aim({0.0, 0.0, 0.01});
    ASSERT_TRUE(rig.run_until([&] { return rig.force_n() > 0.3; }));
    rig.key("F12");
    rig.run(0.003);  // long enough for the tick that receives the key, and for the device's own delay
    EXPECT_EQ(rig.force_n(), 0.0);
    rig.run(1.0);
    EXPECT_EQ(rig.force_n(), 0.0);
    EXPECT_FALSE(rig.audio.silences_s().empty());
    rig.key("Enter");
    EXPECT_TRUE(rig.run_until([&] { return rig.force_n() > 0.1; }));
}

TEST(Wizard, presses_in_small_steps_of_at_most_one_newton_and_releases_if_nobody_answers) {
    HeldSimulated held;
    WizardRig rig("gentlest", &held);
    ASSERT_TRUE(rig.run_until([&] { return rig.question_begins("Move the grip a little"); }));
    rig.run(10.0);
    EXPECT_EQ(rig.largest_force_n, 0.0) << "no force before a hand has moved";
    held.aim({0.0, 0.0, 0.01});
    ASSERT_TRUE(rig.run_until([&] { return rig.has_said(" and then let go"); }, 30.0));
    EXPECT_LE(rig.largest_force_n, Wizard::kGentlestMost_n + 1e-12);
    EXPECT_GT(rig.largest_force_n, 0.95);
    EXPECT_LT(rig.largest_step_n, 0.02);
    rig.run(0.5);
    EXPECT_EQ(rig.force_n(), 0.0);
    rig.key("Enter");
    rig.run(0.1);
    EXPECT_EQ(rig.profile().gentlest_n, Wizard::kGentlestMost_n);
}

TEST(Wizard, keeps_the_default_if_answered_before_anything_can_be_felt) {
    HeldSimulated held;
    WizardRig rig("gentlest", &held);
    ASSERT_TRUE(rig.run_until([&] { return rig.question_begins("Move the grip a little"); }));
    rig.key("Enter");
    rig.run(0.1);
    EXPECT_EQ(rig.profile().gentlest_n, 0.3);
}

TEST(Wizard, chooses_the_ceiling_in_three_steps_or_finely_and_raises_limits_in_its_way) {
    HeldSimulated held;
    WizardRig rig("strongest", &held);
    ASSERT_TRUE(rig.run_until([&] { return rig.question_begins("Now you will feel a wall"); }));
    EXPECT_THAT(std::string(rig.wizard().question()), HasSubstr("Force: light, 1.2 newtons"));
    for (const char* key : {"Up", "Up", "Up", "Left", "Left"}) {
        rig.key(key);
        rig.run(0.05);
    }
    EXPECT_TRUE(rig.has_said("Full, 3.3 newtons."));
    EXPECT_TRUE(rig.has_said("3.1 newtons."));
    rig.key("Enter");
    rig.run(0.1);
    EXPECT_EQ(rig.profile().ceiling_n, 3.1);
    EXPECT_EQ(rig.store.values().haptic.ceiling, ForceCeiling::Full);
}

TEST(Wizard, goes_back_one_question_on_backspace_and_on_up_if_up_changes_nothing) {
    WizardRig rig("headphones,step");
    rig.run(0.1);
    rig.key("Backspace");
    rig.run(0.1);
    EXPECT_TRUE(rig.has_said("This is the first question."));
    rig.key("Enter");
    rig.run(0.1);
    EXPECT_TRUE(rig.question_begins("Is the bell on your right now"));
    rig.key("Up");
    rig.run(0.1);
    EXPECT_TRUE(rig.question_begins("Are you wearing headphones?"));
    rig.key("Enter");
    rig.key("Enter");
    rig.run(0.1);
    ASSERT_TRUE(rig.question_begins("Your step is 70"));
    rig.key("Up");
    rig.run(0.1);
    EXPECT_TRUE(rig.question_begins("Your step is 75"));
    rig.key("Backspace");
    rig.run(0.1);
    EXPECT_TRUE(rig.question_begins("Is the bell on your right now"));
}

TEST(Wizard, accepts_a_step_in_metres_centimetres_or_as_ten_steps_and_refuses_invalid_ones) {
    for (const auto& [typed, length_m] :
         {std::pair{"0.65", 0.65}, {"65", 0.65}, {"6.5", 0.65}, {"1.5", 1.5}, {"15", 1.5}, {"20", 0.2}}) {
        WizardRig rig("step");
        rig.session.type(typed);
        rig.run(0.2);
        EXPECT_TRUE(rig.wizard().finished()) << typed;
        EXPECT_EQ(rig.store.values().walk.step_length_m, length_m) << typed;
    }
    for (const char* typed : {"0.1", "1.8", "151", "1e9", "-3", "0"}) {
        WizardRig rig("step");
        rig.session.type(typed);
        rig.run(0.2);
        EXPECT_FALSE(rig.wizard().finished()) << typed;
        EXPECT_TRUE(rig.has_said("and " + std::string(typed) + " is not.")) << typed;
        EXPECT_EQ(rig.store.values().walk.step_length_m, 0.7);
    }
}

TEST(Wizard, continues_without_an_unplugged_device_and_without_its_force) {
    HeldSimulated held;
    WizardRig rig("gentlest,strongest,step", &held);
    ASSERT_TRUE(rig.run_until([&] { return rig.question_begins("Move the grip a little"); }));
    held.aim({0.0, 0.0, 0.01});
    ASSERT_TRUE(rig.run_until([&] { return rig.force_n() > 0.2; }));
    DeviceTrouble unplugged;
    unplugged.unplugged = true;
    held.hand->trouble.publish(unplugged);
    rig.run(0.1);
    EXPECT_TRUE(rig.question_begins("Your step is"));
    EXPECT_EQ(rig.force_n(), 0.0);
    EXPECT_TRUE(
        rig.run_until([&] { return rig.has_said("The touch device was unplugged. I will go on without it."); }, 10.0))
        << "after the alarm";
}

// Enter and the force key must both confirm, because the messages of some faults name the force key.
TEST(Wizard, announces_a_latched_fault_which_enter_or_the_force_key_confirms) {
    for (const char* key : {"Enter", "F"}) {
        SCOPED_TRACE(key);
        HeldSimulated held;
        WizardRig rig("gentlest", &held);
        ASSERT_TRUE(rig.run_until([&] { return rig.question_begins("Move the grip a little"); }));
        held.aim({0.0, 0.0, 0.01});
        ASSERT_TRUE(rig.run_until([&] { return rig.force_n() > 0.2; }));
        DeviceTrouble trouble;
        trouble.not_a_number_samples = 5;
        held.hand->trouble.publish(trouble);
        rig.run(0.3);
        EXPECT_EQ(rig.force_n(), 0.0);
        EXPECT_TRUE(rig.has_said("The touch device sent impossible positions."));
        EXPECT_TRUE(rig.run_until([&] { return rig.has_said("Press Enter to go on, or Escape to leave."); }, 15.0))
            << "after the alarm";
        rig.key(key);
        held.aim({0.0, 0.0, -0.01});
        EXPECT_TRUE(rig.run_until([&] { return rig.force_n() > 0.2; })) << joined(rig.said());
    }
}

TEST(Wizard, does_only_the_requested_parts_and_homes_only_an_unhomed_device) {
    HeldSimulated held;
    WizardRig rig("reach,hand", &held);
    ASSERT_TRUE(rig.run_until([&] { return rig.wizard().waits_for_person() && !rig.wizard().question().empty(); }));
    EXPECT_TRUE(rig.question_begins("Which hand"));
    rig.key("Enter");
    rig.run(0.1);
    EXPECT_TRUE(rig.question_begins("Move the grip as far"));
    EXPECT_EQ(rig.profile().hand, HoldingHand::Right);
    VirtualClock clock;
    HeldFalcon falcon(clock);
    WizardRig homing("hand", &falcon, &clock);
    ASSERT_TRUE(homing.run_until([&] { return homing.wizard().waits_for_person(); }));
    EXPECT_TRUE(homing.question_begins("Rest your arm"));
    homing.key("Enter");
    homing.run(0.1);
    EXPECT_TRUE(homing.has_said("Not yet: the device does not know its position. Legs ready so far: 0 of 3."));
}

TEST(WizardWords, are_recognised_as_names_of_parts_or_get_the_nearest_suggestion) {
    EXPECT_EQ(parse_wizard_parts("")->size(), wizard_parts().size());
    EXPECT_THAT(*parse_wizard_parts("reach,Headphones,reach"), ElementsAre(WizardPart::Headphones, WizardPart::Reach));
    const auto wrong = parse_wizard_parts("headphone");
    ASSERT_FALSE(wrong);
    EXPECT_THAT(wrong.error().sentence(), HasSubstr("the nearest name is headphones"));
    for (const char* line : {"lft", "hand-left x", "hand-left 0", "hand-left 1e9", "wait -1", "up nan"})
        EXPECT_FALSE(parse_wizard_line(line)) << line;
    EXPECT_THAT(parse_wizard_line("lft").error().sentence(), HasSubstr("Did you mean \"left\"?"));
    EXPECT_EQ(parse_wizard_line("  \r")->events.size(), 1U);
    EXPECT_EQ(parse_wizard_line("70")->events.size(), 2U);
    EXPECT_NEAR(parse_wizard_line("HAND-left 4")->hand_by_m.x, -0.02, 1e-12);
}

TEST(WizardWords, explain_every_part_in_every_language_and_nothing_else) {
    std::set<std::string> wanted;
    for (const WizardPartInfo& part : wizard_parts()) wanted.insert("wizard_part." + std::string(part.word));
    for (const LanguageName& language : bundled_languages()) {
        std::set<std::string> found;
        for (const auto& [key, pattern] : bundled_texts(language.code))
            if (key.starts_with("wizard_part.")) found.insert(key);
        EXPECT_EQ(found, wanted) << language.code;
    }
}

TEST(WizardWords, are_spoken_and_typed_in_german_or_in_english_as_before) {
    const InLanguage german("de");
    WizardRig rig("step");
    rig.session.type("hoch");
    rig.session.type("leave");
    rig.run(1.0);
    EXPECT_TRUE(rig.has_said("Zentimeter lang. Enter behält das"));
    EXPECT_TRUE(rig.has_said("Hier geht es um die Länge eines Schritts"));
    EXPECT_EQ(parse_wizard_line("lnks").error().message,
              "Die Antwort „lnks“ gibt es hier nicht. War „links“ gemeint? „hilfe“ nennt alle.");
    EXPECT_EQ(parse_wizard_line("verlassen")->events, parse_wizard_line("leave")->events);
    EXPECT_EQ(parse_wizard_line("zurueck")->events, parse_wizard_line("back")->events);
    EXPECT_EQ(parse_wizard_line("halt")->events, parse_wizard_line("stop")->events);
    EXPECT_EQ(parse_wizard_line("kraft")->events, parse_wizard_line("forces")->events);
    EXPECT_EQ(parse_wizard_line("hand-vor 2")->hand_by_m, parse_wizard_line("hand-forward 2")->hand_by_m);
    EXPECT_TRUE(parse_wizard_line("hilfe")->help);
    EXPECT_EQ(parse_wizard_line("schluss")->events.size(), 2U);
}

// The program must understand the words that the German texts ask a person to type.
TEST(WizardWords, that_german_texts_mention_are_understood) {
    const InLanguage german("de");
    int seen = 0;
    for (const auto& [key, text] : bundled_texts("de")) {
        if (!key.ends_with("_typed") || !key.starts_with("wizard.")) continue;
        for (std::size_t at = text.find("„"); at != std::string::npos; at = text.find("„", at + 1)) {
            const std::size_t begin = at + std::string_view("„").size();
            const std::string word = text.substr(begin, text.find("“", begin) - begin);
            EXPECT_TRUE(parse_wizard_line(word)) << key << ": " << word;
            ++seen;
        }
    }
    EXPECT_GT(seen, 12);
    for (const char* word : {"nochmal", "links", "rechts", "hoch", "runter", "zurück", "verlassen", "halt"}) {
        EXPECT_TRUE(parse_wizard_line(word)) << word;
        EXPECT_NE(phrase("wizard.help_typed").find(word), std::string::npos) << word;
    }
}

TEST(WizardWords, end_with_the_input_and_keep_what_was_set) {
    WizardRig rig("headphones,step");
    rig.session.type("right");
    rig.session.type("what");
    rig.session.end_of_lines();
    rig.run(0.5);
    EXPECT_TRUE(rig.wizard().finished());
    EXPECT_TRUE(rig.has_said("\"what\" is not an answer to this question."));
    EXPECT_TRUE(rig.has_said("What you have set is kept."));
    EXPECT_TRUE(rig.store.values().sound.swap_sides);
}

}  // namespace wizard_test
}  // namespace handrail::test
