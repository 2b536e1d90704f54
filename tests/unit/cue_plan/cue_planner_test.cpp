#include "audio-cues/plan/cue_planner.h"

#include "audio-cues/plan/sound_table.h"
#include "audio-cues/plan/speakable.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"

namespace handrail {
namespace cue_planner_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

enum : std::uint32_t { kNorth, kFloor, kDoor, kPool, kNameless };

Feature feature(FeatureKind kind, std::string name, MaterialId material, Vec3 min_m, Vec3 max_m) {
    Feature f;
    f.kind = kind;
    f.name = std::move(name);
    f.material = material;
    f.bounds_m = {min_m, max_m};
    return f;
}

// Returns a room of 6 by 4 metres with a plaster wall, a carpet floor, an oak door, a pool, and a feature without a
// name.
std::shared_ptr<const Scene> room() {
    auto scene = std::make_shared<Scene>();
    scene->materials.resize(4);
    scene->materials[1].name = "plaster";
    scene->materials[1].sound = SoundClass::Plaster;
    scene->materials[2].name = "carpet";
    scene->materials[2].sound = SoundClass::Carpet;
    scene->materials[3].name = "wood";
    scene->materials[3].sound = SoundClass::Wood;
    scene->features = {feature(FeatureKind::Wall, "north wall", 1, {0, 4, 0}, {6, 4.2, 2.6}),
                       feature(FeatureKind::Floor, "floor", 2, {0, 0, -0.2}, {6, 4, 0}),
                       feature(FeatureKind::Door, "door", 3, {2.5, -0.2, 0}, {3.5, 0, 2}),
                       feature(FeatureKind::Liquid, "pool", kDefaultMaterial, {1, 1, -1}, {2, 2, 0}),
                       feature(FeatureKind::Object, "", kDefaultMaterial, {0, 0, 0}, {1, 1, 1})};
    scene->features[kDoor].handle = "east";
    scene->features[kDoor].hinge = "west";
    scene->features[kDoor].message = "It leads to the yard.";
    return scene;
}

// A planner with recording sinks in virtual time. It ticks every 5 ms, as it does on the audio thread.
class CuePlannerTest : public ::testing::Test {
protected:
    explicit CuePlannerTest(double words_per_minute = 0.0) : speech(words_per_minute) { planner.enter_world(room()); }

    void set(const std::function<void(Settings&)>& change) {
        change(settings);
        planner.set_settings(settings);
    }
    void tick(std::vector<ContactEvent> contacts = {}, std::vector<CueRequest> requests = {}) {
        planner.tick({.now_s = now_s, .contacts = contacts, .requests = requests, .listener = {}}, audio, speech);
        now_s += 0.005;
    }
    void wait(double seconds) {
        for (const double end_s = now_s + seconds; now_s < end_s;) tick();
    }
    ContactEvent event(ContactEventKind kind, std::uint32_t id, double speed_m_per_s = 0.1) const {
        ContactEvent e;
        e.kind = kind;
        e.time_s = now_s;
        e.feature = FeatureId{id};
        if (id < room_->features.size()) e.material = room_->features[id].material;
        e.position_m = {1.0, 2.0, 3.0};
        e.speed_m_per_s = speed_m_per_s;
        return e;
    }
    void begin(std::uint32_t id) { tick({event(ContactEventKind::Begin, id)}); }
    void end(std::uint32_t id) { tick({event(ContactEventKind::End, id)}); }
    static CueRequest request(CueRequestKind kind) {
        CueRequest r;
        r.kind = kind;
        return r;
    }
    static CueRequest text(std::string words, SpeechClass speech_class = SpeechClass::Answer, bool repeatable = false) {
        CueRequest r;
        r.text = std::move(words);
        r.speech_class = speech_class;
        r.repeatable = repeatable;
        return r;
    }
    std::vector<std::string> said(bool voiced_only = false) const {
        std::vector<std::string> texts;
        for (const HeardSpeech& line : speech.lines())
            if (line.voiced || !voiced_only) texts.push_back(line.utterance.text);
        return texts;
    }
    std::vector<SoundKind> heard() const {
        std::vector<SoundKind> kinds;
        for (const HeardSound& sound : audio.sounds()) kinds.push_back(sound.cue.kind);
        return kinds;
    }

    double now_s = 1.0;
    Settings settings;
    std::shared_ptr<const Scene> room_ = room();
    RecordingAudio audio;
    RecordingSpeech speech;
    CuePlanner planner{Settings{}};
};

// A planner whose voice takes as long as a real voice: 240 words a minute, so a word lasts 0.25 s.
class CuePlannerWithVoice : public CuePlannerTest {
protected:
    CuePlannerWithVoice() : CuePlannerTest(240.0) {}
};

TEST_F(CuePlannerTest, names_the_touched_thing_with_its_material_within_120_ms) {
    const double touched_s = now_s;
    begin(kNorth);
    wait(0.2);
    ASSERT_THAT(said(), ElementsAre("North wall, plaster"));
    EXPECT_LE(speech.lines()[0].time_s - touched_s, 0.120);
    EXPECT_EQ(speech.lines()[0].utterance.speech_class, SpeechClass::Contact);
}

// The listener is at the origin and faces north.
TEST_F(CuePlannerTest, gives_each_line_about_a_place_its_direction_if_the_setting_is_on) {
    const auto directions = [&] {
        const std::size_t from = speech.lines().size();
        begin(kNorth);  // at 1 m east and 2 m north
        wait(6.0);
        CueRequest bump = text("Blocked", SpeechClass::Warning);
        bump.kind = CueRequestKind::Bump;
        bump.position_m = {0.0, -1.0, 1.0};
        tick({}, {bump});
        wait(6.0);
        CueRequest leg = text("Turn left", SpeechClass::Guidance);
        leg.placed = true;
        leg.position_m = {-3.0, 0.0, 0.0};
        tick({}, {leg});
        wait(6.0);
        tick({}, {text("Hall")});
        wait(6.0);
        end(kNorth);
        std::vector<std::optional<double>> all;
        for (std::size_t i = from; i < speech.lines().size(); ++i) all.push_back(speech.lines()[i].utterance.right_rad);
        return all;
    };
    EXPECT_THAT(directions(), ElementsAre(std::nullopt, std::nullopt, std::nullopt, std::nullopt));
    set([](Settings& s) { s.speech.from_places = true; });
    const auto on = directions();
    ASSERT_EQ(on.size(), 4U);
    EXPECT_NEAR(on[0].value_or(9.0), std::atan2(1.0, 2.0), 1e-12);
    EXPECT_NEAR(std::abs(on[1].value_or(9.0)), kPi, 1e-12);
    EXPECT_NEAR(on[2].value_or(9.0), -0.5 * kPi, 1e-12);
    EXPECT_FALSE(on[3]) << "a line without a place comes from the middle";
}

TEST_F(CuePlannerTest, plays_the_materials_contact_sound_at_the_hand_within_15_ms) {
    const ContactEvent touch = event(ContactEventKind::Begin, kFloor);
    tick({touch});
    ASSERT_THAT(heard(), ElementsAre(SoundKind::Contact));
    const HeardSound& sound = audio.sounds()[0];
    EXPECT_EQ(sound.cue.material, SoundClass::Carpet);
    EXPECT_EQ(sound.cue.position_m, touch.position_m);
    EXPECT_EQ(sound.cue.event_time_s, touch.time_s);
    EXPECT_GE(sound.latency_s, 0.0);
    EXPECT_LE(sound.latency_s, 0.015);
}

TEST_F(CuePlannerTest, second_touch_within_5_s_is_a_knock_without_speech) {
    for (int touch = 0; touch < 5; ++touch) {  // the hand touches the wall at 0, 1, ... 4 s
        begin(kNorth);
        wait(0.5);
        end(kNorth);
        wait(0.495);
    }
    EXPECT_THAT(said(), ElementsAre("North wall, plaster"));
    EXPECT_EQ(heard().size(), 5U);
    wait(1.0);
    begin(kNorth);
    wait(0.1);
    EXPECT_THAT(said(), ElementsAre("North wall, plaster", "North wall, plaster"));
}

TEST_F(CuePlannerTest, nothing_is_spoken_twice_within_5_s) {
    std::uint64_t state = 7;
    const auto random = [&](std::uint64_t below) {
        return static_cast<std::uint32_t>((state = state * 6364136223846793005ULL + 1442695040888963407ULL) >> 33U) %
               below;
    };
    for (int i = 0; i < 4000; ++i) {
        const auto id = static_cast<std::uint32_t>(random(4));
        switch (random(6)) {
            case 0:
                begin(id);
                break;
            case 1:
                end(id);
                break;
            case 2:
                tick({event(ContactEventKind::Slide, id, 0.001 * static_cast<double>(random(300)))});
                break;
            case 3:
                tick({}, {text("Answer", SpeechClass::Answer)});
                break;
            case 4: {
                CueRequest bump = request(CueRequestKind::Bump);
                bump.feature = FeatureId{id};
                tick({}, {bump});
                break;
            }
            default:
                wait(0.05);
        }
    }
    std::map<std::string, double> last;
    for (const HeardSpeech& line : speech.lines()) {
        const auto found = last.find(line.utterance.text);
        if (found != last.end()) {
            ASSERT_GE(line.time_s - found->second, 5.0 - 1e-9) << line.utterance.text;
        }
        last[line.utterance.text] = line.time_s;
    }
    EXPECT_EQ(last.size(), 5U);  // the planner announced exactly the four names and the answer
}

TEST_F(CuePlannerTest, chatter_of_one_feature_within_50_ms_sounds_once) {
    for (int i = 0; i < 8; ++i) {  // the hand touches the wall every 5 ms
        begin(kNorth);
        tick({event(ContactEventKind::End, kNorth)});
        now_s -= 0.005;
    }
    EXPECT_EQ(heard().size(), 1U);
    wait(0.05);
    begin(kNorth);
    EXPECT_EQ(heard().size(), 2U);
}

TEST_F(CuePlannerTest, a_corner_gives_two_knocks_and_only_the_newest_name) {
    tick({event(ContactEventKind::Begin, kFloor), event(ContactEventKind::Begin, kNorth)});
    wait(0.2);
    EXPECT_THAT(heard(), ElementsAre(SoundKind::Contact, SoundKind::Contact));
    EXPECT_THAT(said(), ElementsAre("North wall, plaster"));
}

TEST_F(CuePlannerTest, hand_trembling_between_two_surfaces_still_hears_a_name_within_120_ms) {
    // The hand changes from one surface to the other every 5 ms for 120 ms.
    for (int i = 0; i < 24; ++i) begin(i % 2 == 0 ? kNorth : kFloor);
    EXPECT_THAT(said(), ::testing::Not(IsEmpty()));
}

TEST_F(CuePlannerTest, tap_shorter_than_the_settling_time_is_still_named) {
    begin(kNorth);
    end(kNorth);
    wait(0.2);
    EXPECT_THAT(said(), ElementsAre("North wall, plaster"));
}

TEST_F(CuePlannerTest, sliding_onto_another_thing_names_it_without_a_knock) {
    begin(kNorth);
    wait(0.1);
    tick({event(ContactEventKind::Slide, kDoor)});
    wait(0.1);
    EXPECT_THAT(said(), ElementsAre("North wall, plaster", "Door, wood, handle on the east side"));
    EXPECT_EQ(heard().size(), 1U);
}

TEST_F(CuePlannerTest, slide_loop_follows_speed_and_ends_with_the_slide) {
    begin(kNorth);
    tick({event(ContactEventKind::Slide, kNorth, 0.05)});
    const auto slow = audio.loop(SoundKind::Slide);
    tick({event(ContactEventKind::Slide, kNorth, 0.2)});
    const auto fast = audio.loop(SoundKind::Slide);
    ASSERT_TRUE(slow && fast);
    EXPECT_GT(fast->loudness, slow->loudness);
    EXPECT_GT(fast->pitch, slow->pitch);
    EXPECT_EQ(fast->material, SoundClass::Plaster);
    end(kNorth);
    EXPECT_FALSE(audio.loop(SoundKind::Slide));

    tick({event(ContactEventKind::Slide, kFloor, 0.2)});
    ASSERT_TRUE(audio.loop(SoundKind::Slide));
    wait(0.2);  // the hand rests and causes no more events
    EXPECT_FALSE(audio.loop(SoundKind::Slide));
    tick({event(ContactEventKind::Slide, kFloor, 0.001)});
    EXPECT_FALSE(audio.loop(SoundKind::Slide)) << "1 mm/s is inaudible";
}

TEST_F(CuePlannerTest, sliding_along_two_surfaces_at_once_gives_one_steady_loop) {
    tick({event(ContactEventKind::Begin, kNorth), event(ContactEventKind::Begin, kFloor)});
    for (int i = 0; i < 40; ++i) {
        tick({event(ContactEventKind::Slide, kNorth, 0.2), event(ContactEventKind::Slide, kFloor, 0.2)});
        ASSERT_TRUE(audio.loop(SoundKind::Slide));
        EXPECT_EQ(audio.loop(SoundKind::Slide)->material, SoundClass::Plaster);
    }
    end(kNorth);
    tick({event(ContactEventKind::Slide, kFloor, 0.2)});
    ASSERT_TRUE(audio.loop(SoundKind::Slide));
    EXPECT_EQ(audio.loop(SoundKind::Slide)->material, SoundClass::Carpet);
}

TEST_F(CuePlannerTest, a_harder_blow_is_louder) {
    tick({event(ContactEventKind::Begin, kNorth, 0.01)});
    wait(0.1);
    tick({event(ContactEventKind::Begin, kNorth, 0.3)});
    ASSERT_EQ(audio.sounds().size(), 2U);
    EXPECT_GT(audio.sounds()[0].cue.loudness, 0.0);
    EXPECT_GT(audio.sounds()[1].cue.loudness, 1.5 * audio.sounds()[0].cue.loudness);
}

TEST_F(CuePlannerTest, a_bump_names_the_obstacle_and_further_bumps_only_thud) {
    CueRequest bump = request(CueRequestKind::Bump);
    bump.feature = FeatureId{kNorth};
    for (int i = 0; i < 4; ++i) {
        tick({}, {bump});
        wait(1.0);
    }
    EXPECT_THAT(said(), ElementsAre("North wall, plaster"));
    EXPECT_THAT(heard(), ElementsAre(SoundKind::Bump, SoundKind::Bump, SoundKind::Bump, SoundKind::Bump));
    EXPECT_EQ(audio.sounds()[0].cue.material, SoundClass::Plaster);
}

TEST_F(CuePlannerTest, a_blocked_step_is_spoken_once_in_5_s_and_written_each_time) {
    CueRequest bump = request(CueRequestKind::Bump);
    bump.feature = FeatureId{kNorth};
    bump.text = "North wall, plaster";
    bump.written = "Blocked. North wall, plaster";
    for (int i = 0; i < 4; ++i) {
        tick({}, {bump});
        wait(1.0);
    }
    EXPECT_THAT(said(true), ElementsAre("North wall, plaster"));
    EXPECT_THAT(said(), ElementsAre(bump.text, bump.written, bump.written, bump.written));
    EXPECT_THAT(heard(), ElementsAre(SoundKind::Bump, SoundKind::Bump, SoundKind::Bump, SoundKind::Bump));
    EXPECT_EQ(speech.lines()[0].utterance.speech_class, SpeechClass::Warning);
    wait(5.0);
    tick({}, {bump});
    EXPECT_THAT(said(true), ElementsAre(bump.text, bump.text)) << "after five seconds anew";
    set([](Settings& s) { s.speech.verbosity = 0; });
    tick({}, {bump});
    EXPECT_EQ(speech.lines().size(), 5U) << "sounds alone";
}

TEST_F(CuePlannerWithVoice, a_warning_is_spoken_each_time_and_interrupts_an_answer) {
    tick({}, {text("You are in a long room with four doors and a window to the yard")});
    wait(0.3);
    for (int i = 0; i < 3; ++i) {
        tick({}, {text("Drop, 1 step ahead", SpeechClass::Warning)});
        wait(1.6);
    }
    EXPECT_TRUE(speech.lines()[0].cut);
    EXPECT_THAT(said(true), ElementsAre("You are in a long room with four doors and a window to the yard",
                                        "Drop, 1 step ahead", "Drop, 1 step ahead", "Drop, 1 step ahead"));
    for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(speech.lines()[i].cut);
}

TEST_F(CuePlannerWithVoice, warnings_wait_for_alarms_and_each_other_and_answers_wait_for_both) {
    tick({}, {text("Facing north"), text("Stairs up", SpeechClass::Warning), text("Drop", SpeechClass::Warning),
              text("The touch device was unplugged", SpeechClass::Alarm)});
    wait(6.0);
    EXPECT_THAT(said(true), ElementsAre("The touch device was unplugged", "Stairs up", "Drop", "Facing north"));
    for (const HeardSpeech& line : speech.lines()) EXPECT_FALSE(line.cut) << line.utterance.text;
}

TEST_F(CuePlannerTest, a_keyboard_driven_hand_causes_no_messages_about_force) {
    planner.set_hand_stands_in(true);
    ContactEvent fault = event(ContactEventKind::FaultRaised, kNoFeature.value);
    for (const Fault kind : {Fault::Stalled, Fault::LateLoop}) {
        fault.fault = kind;
        tick({fault});
        tick({event(ContactEventKind::FaultCleared, kNoFeature.value)});
        wait(1.0);
    }
    EXPECT_THAT(said(), IsEmpty());
    EXPECT_THAT(heard(), IsEmpty());
    planner.set_hand_stands_in(false);
    tick({fault});
    EXPECT_THAT(said(), ElementsAre(fault_sentence(Fault::LateLoop)));
}

TEST_F(CuePlannerTest, sounds_are_described_as_text_only_on_request) {
    CueRequest door = request(CueRequestKind::Play), clock = request(CueRequestKind::WorldSound);
    door.sound = SoundKind::DoorNear;
    door.position_m = {0.0, 2.0, 1.0};
    clock.sound = SoundKind::Clock;
    clock.position_m = {3.0, 0.0, 1.0};
    tick({}, {door, clock});
    EXPECT_THAT(said(), IsEmpty());
    set([](Settings& s) { s.sound.as_text = true; });
    tick({}, {door});
    EXPECT_THAT(said(), ElementsAre("Door near, ahead", "Clock, right"));
    tick({}, {door});
    wait(1.0);
    EXPECT_EQ(said().size(), 2U) << "a knock that beats is told again only after a while, a clock much later";
    wait(3.0);
    tick({}, {door});
    EXPECT_EQ(said().back(), "Door near, ahead");
    CueRequest step = request(CueRequestKind::Footstep);
    step.material = SoundClass::Carpet;
    tick({}, {step});
    tick({}, {step});
    EXPECT_EQ(said().back(), "Steps on carpet");
    EXPECT_EQ(said().size(), 4U) << "a floor is told where it changes";
    for (const std::string& line : said()) EXPECT_EQ(line.find_first_of("[](){}"), std::string::npos) << line;
    for (const HeardSpeech& line : speech.lines()) EXPECT_FALSE(line.voiced) << "read, not spoken";
    set([](Settings& s) { s.sound.ways = false; });
    wait(4.0);
    tick({}, {door});
    EXPECT_EQ(said().size(), 4U) << "what is switched off is not told either";
}

TEST_F(CuePlannerTest, footsteps_sound_like_the_floor_and_the_feet_differ) {
    CueRequest step = request(CueRequestKind::Footstep);
    step.material = SoundClass::Tile;
    step.position_m = {3.0, 0.5, 0.0};
    tick({}, {step});
    tick({}, {step});
    ASSERT_THAT(heard(), ElementsAre(SoundKind::Footstep, SoundKind::Footstep));
    EXPECT_EQ(audio.sounds()[0].cue.material, SoundClass::Tile);
    EXPECT_EQ(audio.sounds()[0].cue.position_m, step.position_m);
    EXPECT_NE(audio.sounds()[0].cue.pitch, audio.sounds()[1].cue.pitch);
    EXPECT_THAT(said(), IsEmpty());
}

TEST_F(CuePlannerTest, entering_a_liquid_splashes_and_names_it) {
    tick({event(ContactEventKind::EnterLiquid, kPool)});
    wait(0.1);
    tick({event(ContactEventKind::LeaveLiquid, kPool)});
    wait(0.1);
    EXPECT_THAT(said(), ElementsAre("Pool"));
    ASSERT_THAT(heard(), ElementsAre(SoundKind::Splash, SoundKind::Splash));
    EXPECT_GT(audio.sounds()[0].cue.loudness, audio.sounds()[1].cue.loudness);
}

TEST_F(CuePlannerTest, fault_sounds_and_speaks_as_an_alarm) {
    ContactEvent fault = event(ContactEventKind::FaultRaised, kNoFeature.value);
    fault.fault = Fault::Unplugged;
    tick({fault});
    ASSERT_EQ(speech.lines().size(), 1U);
    EXPECT_EQ(speech.lines()[0].utterance.text, fault_sentence(Fault::Unplugged));
    EXPECT_EQ(speech.lines()[0].utterance.speech_class, SpeechClass::Alarm);
    EXPECT_THAT(heard(), ElementsAre(SoundKind::Alarm));
}

// In this test, speech takes time. The warning that a device may push must interrupt earlier messages about that device
// instead of waiting for them to end.
TEST_F(CuePlannerWithVoice, a_warning_that_a_device_may_push_waits_for_no_other_alarm) {
    ContactEvent fault = event(ContactEventKind::FaultRaised, kNoFeature.value);
    fault.fault = Fault::DeviceSilent;
    tick({fault});
    fault.fault = Fault::TooHot;
    tick({fault});
    fault.fault = Fault::MayPush;
    tick({fault});
    EXPECT_EQ(speech.lines().back().utterance.text, fault_sentence(Fault::MayPush));
}

TEST_F(CuePlannerTest, a_fault_that_needs_the_person_is_announced_each_time_and_a_pause_raises_no_alarm) {
    ContactEvent fault = event(ContactEventKind::FaultRaised, kNoFeature.value);
    for (const auto& [kind, times] :
         {std::pair{Fault::LateLoop, 2U}, std::pair{Fault::Stalled, 1U}, std::pair{Fault::ButtonReleased, 1U}}) {
        wait(6.0);
        const std::size_t lines = speech.lines().size(), sounds = audio.sounds().size();
        fault.fault = kind;
        for (int i = 0; i < 2; ++i) {
            fault.time_s = now_s;
            tick({fault});
            wait(1.0);
        }
        EXPECT_EQ(speech.lines().size() - lines, times) << static_cast<int>(kind);
        ASSERT_EQ(audio.sounds().size() - sounds, 2U);
        EXPECT_EQ(audio.sounds().back().cue.kind, is_pause(kind) ? SoundKind::ForcesOff : SoundKind::Alarm);
    }
}

TEST_F(CuePlannerTest, alarms_never_fall_below_a_fifth_of_full_loudness) {
    set([](Settings& s) { s.sound.volume = 0.0; });
    ContactEvent fault = event(ContactEventKind::FaultRaised, kNoFeature.value);
    fault.fault = Fault::LateLoop;
    tick({fault, event(ContactEventKind::Begin, kNorth)});
    wait(0.1);
    ASSERT_THAT(heard(), ElementsAre(SoundKind::Alarm)) << "contact sounds follow the volume down to nothing";
    EXPECT_DOUBLE_EQ(audio.sounds()[0].cue.loudness, 0.2);
    ASSERT_EQ(speech.lines().size(), 2U);
    EXPECT_DOUBLE_EQ(speech.lines()[0].utterance.loudness, 0.2);
    EXPECT_DOUBLE_EQ(speech.lines()[1].utterance.loudness, 0.0);
}

TEST_F(CuePlannerTest, each_kind_of_sound_follows_its_own_volume) {
    set([](Settings& s) {
        s.sound.volume = 0.5;
        s.sound.contact_volume = 0.4;
        s.sound.footstep_volume = 0.2;
        s.sound.wall_tone_volume = 0.6;
    });
    CueRequest tone = request(CueRequestKind::WallTone);
    tone.loudness = 0.5;
    tick({event(ContactEventKind::Begin, kNorth, 1.0)},
         {request(CueRequestKind::Footstep), tone, request(CueRequestKind::Play)});
    ASSERT_THAT(heard(), ElementsAre(SoundKind::Contact, SoundKind::Footstep, SoundKind::Beep));
    EXPECT_DOUBLE_EQ(audio.sounds()[0].cue.loudness, 0.5 * 0.4);
    EXPECT_DOUBLE_EQ(audio.sounds()[1].cue.loudness, 0.5 * 0.2);
    EXPECT_DOUBLE_EQ(audio.sounds()[2].cue.loudness, 0.5);
    ASSERT_TRUE(audio.loop(SoundKind::WallTone));
    EXPECT_DOUBLE_EQ(audio.loop(SoundKind::WallTone)->loudness, 0.5 * 0.6 * 0.5);
}

TEST_F(CuePlannerTest, verbosity_0_leaves_only_sounds_answers_and_alarms) {
    set([](Settings& s) { s.speech.verbosity = 0; });
    CueRequest bump = request(CueRequestKind::Bump);
    bump.feature = FeatureId{kDoor};
    tick({event(ContactEventKind::Begin, kNorth)}, {bump, text("Try the door", SpeechClass::Ambient)});
    wait(0.2);
    EXPECT_THAT(said(), IsEmpty());
    EXPECT_THAT(heard(), ElementsAre(SoundKind::Contact, SoundKind::Bump));
    tick({}, {text("You face north"), text("The touch device is hot", SpeechClass::Alarm)});
    EXPECT_THAT(said(), ElementsAre("The touch device is hot", "You face north"));
}

TEST_F(CuePlannerTest, steps_back_and_forward_through_the_last_fifty_messages) {
    const auto press = [&](CueRequestKind kind) {
        now_s += 1.0;
        CueRequest r = request(kind);
        r.time_s = now_s;
        tick({}, {r});
        return planner.spoken().back().text;
    };
    EXPECT_EQ(press(CueRequestKind::HistoryBack), "Nothing has been said yet.");
    for (int i = 1; i <= 60; ++i) {
        CueRequest r = text(fmt::format("Message {}.", i));
        r.time_s = now_s += 1.0;
        tick({}, {r});
    }
    EXPECT_EQ(press(CueRequestKind::HistoryBack), "Message 60. 1 of 50.");
    EXPECT_EQ(press(CueRequestKind::HistoryBack), "Message 59. 2 of 50.");
    EXPECT_EQ(press(CueRequestKind::HistoryForward), "Message 60. 1 of 50.");
    EXPECT_EQ(press(CueRequestKind::HistoryForward), "That was the most recent message.");
    std::string last;
    for (int i = 2; i <= 50; ++i) last = press(CueRequestKind::HistoryBack);
    EXPECT_EQ(last, "Message 11. 50 of 50.");
    EXPECT_EQ(press(CueRequestKind::HistoryBack), "That was the oldest message kept.");
    EXPECT_EQ(press(CueRequestKind::HistoryForward), "Message 12. 49 of 50.");
    CueRequest fresh = text("Something new.");
    fresh.time_s = now_s += 1.0;
    tick({}, {fresh});
    EXPECT_EQ(press(CueRequestKind::HistoryBack), "Something new. 1 of 50.")
        << "what is new begins at the newest again";
}

TEST_F(CuePlannerTest, higher_verbosity_says_more) {
    const auto scene = room();
    const FeatureId door{kDoor}, wall{kNorth}, floor{kFloor};
    EXPECT_EQ(describe_feature(*scene, door, 0), "");
    EXPECT_EQ(describe_feature(*scene, door, 1), "Door");
    EXPECT_EQ(describe_feature(*scene, door, 2), "Door, wood, handle on the east side");
    EXPECT_EQ(describe_feature(*scene, door, 3),
              "Door, wood, handle on the east side, hinged on the west side. It leads to the yard.");
    EXPECT_EQ(describe_feature(*scene, door, 4),
              "Door, wood, handle on the east side, hinged on the west side. 1 metre wide, 2 metres high. It leads to "
              "the yard.");
    EXPECT_EQ(describe_feature(*scene, wall, 4), "North wall, plaster. 6 metres wide, 2.6 metres high.");
    Scene thin = *scene;
    Feature& rug = thin.features[wall.value];
    rug.kind = FeatureKind::Object;
    rug.bounds_m = {{0.0, 0.0, 0.0}, {2.0, 1.4, 0.02}};
    EXPECT_THAT(describe_feature(thin, wall, 4), testing::EndsWith(". 2 by 1.4 metres.")) << "no rug is 0 metres high";
    rug.bounds_m = {{0.0, 0.0, 1.0}, {0.6, 0.01, 1.9}};
    EXPECT_THAT(describe_feature(thin, wall, 4), testing::EndsWith(". 0.6 metres wide, 0.9 metres high."))
        << "no poster is 0 metres deep";
    EXPECT_EQ(describe_feature(*scene, floor, 4), "Floor, carpet. 6 by 4 metres.");
    EXPECT_EQ(describe_feature(*scene, FeatureId{kNameless}, 4), "");
    EXPECT_EQ(describe_feature(*scene, kNoFeature, 4), "");
}

TEST_F(CuePlannerTest, repeat_speaks_the_last_line_word_for_word_at_once) {
    tick({}, {request(CueRequestKind::Repeat)});
    tick({}, {text("You are at the door, facing north")});
    tick({}, {request(CueRequestKind::Repeat)});
    tick({}, {request(CueRequestKind::Repeat)});
    EXPECT_THAT(said(), ElementsAre("Nothing has been said yet.", "You are at the door, facing north",
                                    "You are at the door, facing north", "You are at the door, facing north"));
}

TEST_F(CuePlannerTest, repeatable_answers_are_not_held_back) {
    for (int i = 0; i < 3; ++i) tick({}, {text("Facing north", SpeechClass::Answer, true)});
    for (int i = 0; i < 3; ++i) tick({}, {text("Saved", SpeechClass::Answer, false)});
    EXPECT_THAT(said(), ElementsAre("Facing north", "Facing north", "Facing north", "Saved"));
}

TEST_F(CuePlannerTest, silence_stops_voice_sounds_and_loops_until_the_next_event) {
    CueRequest tone = request(CueRequestKind::WallTone);
    tick({event(ContactEventKind::Slide, kNorth, 0.2)}, {tone});
    ASSERT_TRUE(audio.loop(SoundKind::WallTone) && audio.loop(SoundKind::Slide));
    tick({}, {request(CueRequestKind::SilenceAll)});
    EXPECT_EQ(speech.stops_s().size(), 1U);
    EXPECT_EQ(audio.silences_s().size(), 1U);
    tick({event(ContactEventKind::Slide, kNorth, 0.2)}, {tone});
    wait(0.2);
    EXPECT_FALSE(audio.loop(SoundKind::WallTone));
    EXPECT_FALSE(audio.loop(SoundKind::Slide));
    EXPECT_THAT(said(), IsEmpty()) << "the name that was waiting is gone too";
    tick({}, {request(CueRequestKind::Footstep), tone});
    EXPECT_TRUE(audio.loop(SoundKind::WallTone));
}

TEST_F(CuePlannerTest, switching_the_wall_tone_off_silences_it) {
    tick({}, {request(CueRequestKind::WallTone)});
    ASSERT_TRUE(audio.loop(SoundKind::WallTone));
    set([](Settings& s) { s.sound.wall_tone = false; });
    tick();
    EXPECT_FALSE(audio.loop(SoundKind::WallTone));
    tick({}, {request(CueRequestKind::WallTone)});
    EXPECT_FALSE(audio.loop(SoundKind::WallTone));
}

TEST_F(CuePlannerTest, sounds_of_the_world_follow_volume_switch_and_silence_and_return) {
    CueRequest clock = request(CueRequestKind::WorldSound);
    clock.sound = SoundKind::Clock;
    clock.source = 4;
    clock.loudness = 0.5;
    clock.muffled_db = 14.0;
    clock.position_m = {1.0, 2.0, 3.0};
    tick({}, {clock});
    ASSERT_EQ(audio.world_sounds().size(), 1U);
    const SoundCue cue = *audio.loop(SoundKind::Clock, 4);
    EXPECT_DOUBLE_EQ(cue.loudness, 0.5 * Settings{}.sound.world_volume);
    EXPECT_EQ(cue.muffled_db, 14.0);
    EXPECT_EQ(cue.position_m, clock.position_m);
    CueRequest lamp = clock;
    lamp.source = 5;
    tick({}, {lamp});
    EXPECT_EQ(audio.world_sounds().size(), 2U) << "two sources of one kind are two loops";
    tick({}, {request(CueRequestKind::SilenceAll)});
    tick();
    EXPECT_TRUE(audio.world_sounds().empty());
    tick({}, {request(CueRequestKind::Footstep)});
    EXPECT_EQ(audio.world_sounds().size(), 2U) << "they had not stopped";
    set([](Settings& s) { s.sound.world = false; });
    tick();
    EXPECT_TRUE(audio.world_sounds().empty());
    set([](Settings& s) { s.sound.world = true; });
    lamp.loudness = 0.0;
    tick({}, {lamp});
    EXPECT_EQ(audio.world_sounds().size(), 1U);
}

TEST_F(CuePlannerTest, every_cue_but_an_alarm_can_be_switched_off) {
    set([](Settings& s) {
        Settings::Sound& sound = s.sound;
        for (bool* on :
             {&sound.contact,   &sound.slide,     &sound.splash, &sound.door,   &sound.footstep, &sound.bump,
              &sound.wall_tone, &sound.world,     &sound.denied, &sound.forces, &sound.turn,     &sound.frame,
              &sound.arrived,   &sound.workspace, &sound.desk,   &sound.corner, &sound.drop,     &sound.ways,
              &sound.marks,     &sound.beacon,    &sound.guide})
            *on = false;
    });
    for (const SoundInfo& row : sound_table()) {
        CueRequest cue = request(is_world_sound(row.kind) ? CueRequestKind::WorldSound : CueRequestKind::Play);
        cue.sound = row.kind;
        tick({}, {cue});
    }
    begin(kNorth);
    ContactEvent slide = event(ContactEventKind::Slide, kNorth);
    slide.speed_m_per_s = 0.2;
    tick({slide});
    EXPECT_THAT(heard(), ElementsAre(SoundKind::Bell, SoundKind::Alarm, SoundKind::Beep));
    EXPECT_TRUE(audio.loop_changes().empty());
}

TEST_F(CuePlannerWithVoice, the_sound_dictionary_speaks_the_name_first_and_then_plays_the_sound) {
    CueRequest shown = request(CueRequestKind::Demonstrate);
    shown.sound = SoundKind::Clock;
    shown.text = "Clock: a ticking clock.";
    set([](Settings& s) { s.sound.world = false; });
    tick({}, {shown});
    ASSERT_THAT(said(), ElementsAre("Clock: a ticking clock."));
    const double spoken_until_s = speech.lines()[0].end_s;
    EXPECT_TRUE(audio.world_sounds().empty());
    wait(spoken_until_s - now_s + 0.02);
    ASSERT_EQ(audio.world_sounds().size(), 1U) << "switched off or not";
    wait(2.0);
    EXPECT_EQ(audio.world_sounds().size(), 1U);
    wait(0.6);
    EXPECT_TRUE(audio.world_sounds().empty()) << "a loop ends by itself";
    // The key that stops speech must also end the loop immediately, and discard the sounds that wait to be played.
    tick({}, {shown});
    wait(1.5);
    EXPECT_EQ(audio.world_sounds().size(), 1U);
    tick({}, {request(CueRequestKind::StopSpeech)});
    EXPECT_TRUE(audio.world_sounds().empty());
    shown.sound = SoundKind::Arrived;
    tick({}, {shown});
    tick({}, {request(CueRequestKind::StopSpeech)});
    wait(5.0);
    EXPECT_THAT(heard(), IsEmpty());
}

TEST(SoundTable, dictionary_contains_every_sound_with_its_name_and_meaning) {
    const std::vector<DictionaryEntry> entries = sound_dictionary();
    for (const SoundInfo& row : sound_table()) {
        const auto known =
            std::count_if(entries.begin(), entries.end(), [&](const DictionaryEntry& e) { return e.kind == row.kind; });
        EXPECT_EQ(known, row.kind == SoundKind::Contact ? 18 : 1) << row.name;
    }
    for (const DictionaryEntry& entry : entries) {
        EXPECT_EQ(speakable(entry.text), entry.text);
        EXPECT_EQ(entry.text.back(), '.');
    }
}

TEST(SoundTable, keywords_of_maps_select_the_matching_sounds) {
    const std::pair<const char*, SoundKind> rows[]{{"ambient_comp_hum", SoundKind::Hum},
                                                   {"ambient_drip", SoundKind::Drip},
                                                   {"ambient_drone", SoundKind::Drone},
                                                   {"ambient_flouro_buzz", SoundKind::Buzz},
                                                   {"ambient_light_buzz", SoundKind::Buzz},
                                                   {"ambient_suck_wind", SoundKind::Wind},
                                                   {"ambient_swamp2", SoundKind::Swamp},
                                                   {"ambient_thunder", SoundKind::Thunder},
                                                   {"particle_fountain", SoundKind::Stream},
                                                   {"light_torch_small_walltorch", SoundKind::Fire},
                                                   {"Clock-Tick 2", SoundKind::Clock},
                                                   {"water/stream1.wav", SoundKind::Stream},
                                                   {"env_steam", SoundKind::Fan},
                                                   {"church bells", SoundKind::Tolling},
                                                   {"ambient", SoundKind::Shimmer},
                                                   {"", SoundKind::Shimmer},
                                                   {"\xff\xfe", SoundKind::Shimmer}};
    for (const auto& [word, kind] : rows) EXPECT_EQ(world_sound_of(word), kind) << word;
}

TEST(SoundTable, distance_never_makes_a_sound_louder_and_world_sounds_end_at_their_range) {
    for (const SoundInfo& row : sound_table()) {
        double last = 1.0;
        for (double d = 0.0; d < 60.0; d += 0.25) {
            const double gain = distance_gain(row.kind, d);
            EXPECT_LE(gain, last);
            last = gain;
        }
        if (is_world_sound(row.kind)) {
            EXPECT_EQ(last, 0.0);
        }
    }
    EXPECT_NEAR(distance_gain(SoundKind::Hum, 4.0), 0.5 * distance_gain(SoundKind::Hum, 2.0), 1e-12)
        << "half at twice the distance, as in the open";
}

TEST_F(CuePlannerTest, keeps_the_last_500_lines) {
    for (int i = 0; i < 620; ++i) tick({}, {text(fmt::format("Line {}", i))});
    ASSERT_EQ(planner.spoken().size(), 500U);
    EXPECT_EQ(planner.spoken().front().text, "Line 120");
    EXPECT_EQ(planner.spoken().back().text, "Line 619");
    EXPECT_EQ(planner.spoken_in_all(), 620U);
}

TEST_F(CuePlannerTest, speaks_no_name_for_unnamed_things_and_works_without_a_world) {
    begin(kNameless);
    begin(4711);  // the world has no feature with this number
    wait(0.1);
    CuePlanner empty{Settings{}};
    const std::vector<ContactEvent> touch{event(ContactEventKind::Begin, kNorth)};
    empty.tick({.now_s = now_s, .contacts = touch, .requests = {}, .listener = {}}, audio, speech);
    empty.tick({.now_s = now_s + 1.0, .contacts = {}, .requests = {}, .listener = {}}, audio, speech);
    EXPECT_THAT(said(), IsEmpty());
    EXPECT_EQ(heard().size(), 3U);
}

TEST_F(CuePlannerTest, text_of_a_map_reaches_the_sinks_as_one_clean_line) {
    tick({}, {text(" You need\nthe gold k\xe9y ")});
    EXPECT_THAT(said(), ElementsAre("You need the gold kéy"));
}

TEST_F(CuePlannerWithVoice, an_alarm_interrupts_an_answer_and_an_answer_waits_for_an_alarm) {
    tick({}, {text("You are in a long room with four doors")});
    wait(0.3);
    tick({}, {text("The touch device was unplugged", SpeechClass::Alarm)});
    tick({}, {text("Facing north")});
    EXPECT_TRUE(speech.lines()[0].cut);
    EXPECT_THAT(said(), ElementsAre("You are in a long room with four doors", "The touch device was unplugged"));
    wait(3.0);
    ASSERT_EQ(speech.lines().size(), 3U);
    EXPECT_FALSE(speech.lines()[1].cut);
    EXPECT_EQ(speech.lines()[2].utterance.text, "Facing north");
}

TEST_F(CuePlannerWithVoice, alarms_wait_for_each_other) {
    tick({}, {text("First alarm", SpeechClass::Alarm), text("Second alarm", SpeechClass::Alarm)});
    wait(3.0);
    ASSERT_THAT(said(), ElementsAre("First alarm", "Second alarm"));
    EXPECT_FALSE(speech.lines()[0].cut);
}

TEST_F(CuePlannerWithVoice, answer_to_another_key_comes_at_once_and_parts_of_one_reply_follow_each_other) {
    tick({}, {text("One"), text("Two")});
    wait(2.0);
    ASSERT_THAT(said(), ElementsAre("One", "Two"));
    EXPECT_FALSE(speech.lines()[0].cut);
    tick({}, {text("Three is a long answer"), text("Four")});
    wait(0.1);
    tick({}, {request(CueRequestKind::Interrupt), text("Five")});
    wait(1.0);
    EXPECT_THAT(said(true), ElementsAre("One", "Two", "Three is a long answer", "Five"));
    EXPECT_TRUE(speech.lines()[2].cut);
    EXPECT_THAT(said(), ElementsAre("One", "Two", "Three is a long answer", "Four", "Five"))
        << "what was not voiced is still written";
}

TEST_F(CuePlannerWithVoice, touch_never_interrupts_an_answer_and_waits_while_the_hand_stays) {
    tick({}, {text("You are at the door")});
    begin(kNorth);
    wait(0.5);
    EXPECT_THAT(said(), ElementsAre("You are at the door"));
    wait(1.5);
    ASSERT_THAT(said(), ElementsAre("You are at the door", "North wall, plaster"));
    EXPECT_FALSE(speech.lines()[0].cut);
}

TEST_F(CuePlannerWithVoice, a_name_is_dropped_if_the_hand_leaves_before_its_turn) {
    tick({}, {text("You are at the door of a very long and very wide room")});
    begin(kNorth);
    wait(0.2);
    end(kNorth);
    wait(6.0);
    EXPECT_THAT(said(), ElementsAre("You are at the door of a very long and very wide room"));
}

TEST_F(CuePlannerWithVoice, a_newer_name_interrupts_an_older_one) {
    begin(kNorth);
    wait(0.15);
    begin(kDoor);
    wait(0.15);
    ASSERT_THAT(said(), ElementsAre("North wall, plaster", "Door, wood, handle on the east side"));
    EXPECT_TRUE(speech.lines()[0].cut);
}

TEST_F(CuePlannerWithVoice, a_hint_is_dropped_when_anything_else_is_spoken) {
    tick({}, {text("You are at the door")});
    tick({}, {text("Time for a break", SpeechClass::Ambient)});
    wait(5.0);
    EXPECT_THAT(said(true), ElementsAre("You are at the door"));
    EXPECT_THAT(said(), ElementsAre("You are at the door", "Time for a break")) << "it can be read";
    wait(1.0);
    tick({}, {text("Time for another break", SpeechClass::Ambient)});
    EXPECT_THAT(said(true), ElementsAre("You are at the door", "Time for another break"));
}

TEST_F(CuePlannerWithVoice, the_stop_key_silences_the_voice_in_the_same_tick_and_keeps_sounds) {
    tick({}, {text("One is long enough to be cut"), text("Two")});
    tick({event(ContactEventKind::Slide, kNorth, 0.2)}, {request(CueRequestKind::StopSpeech)});
    EXPECT_FALSE(speech.speaking());
    wait(3.0);
    EXPECT_THAT(said(true), ElementsAre("One is long enough to be cut"));
    EXPECT_THAT(said(), ElementsAre("One is long enough to be cut", "Two")) << "still there to be read";
    EXPECT_TRUE(audio.silences_s().empty());
}

TEST_F(CuePlannerWithVoice, any_key_interrupts_an_answer_but_no_warning) {
    tick({}, {text("An answer that is long enough to be cut")});
    wait(0.3);
    tick({}, {request(CueRequestKind::Interrupt)});
    EXPECT_FALSE(speech.speaking());
    for (const SpeechClass warns : {SpeechClass::Warning, SpeechClass::Alarm}) {
        // The person presses a key before anybody can have understood the warning.
        tick({}, {text("Edge. Drop, two metres deep, and more words", warns)});
        wait(0.3);
        tick({}, {request(CueRequestKind::Interrupt), text("To the key")});
        EXPECT_TRUE(speech.speaking());
        EXPECT_EQ(said().back(), "Edge. Drop, two metres deep, and more words");
        wait(8.0);
        EXPECT_EQ(said().back(), "To the key") << "and then comes what the key asked for";
        wait(6.0);
        // A key must not interrupt a warning, however long the warning takes.
        tick({}, {text("A warning of so many words that it goes on for a while and then for some more", warns)});
        wait(3.0);
        tick({}, {request(CueRequestKind::Interrupt)});
        EXPECT_TRUE(speech.speaking());
        wait(8.0);
        // The key that silences everything must end even a warning immediately.
        tick({}, {text("One more warning", warns)});
        tick({}, {request(CueRequestKind::StopSpeech)});
        EXPECT_FALSE(speech.speaking());
        wait(8.0);
    }
}

TEST_F(CuePlannerWithVoice, a_key_does_not_drop_a_waiting_warning) {
    tick({}, {text("Stairs up, five steps", SpeechClass::Warning), text("Door is shut", SpeechClass::Warning)});
    tick({}, {request(CueRequestKind::Interrupt)});
    wait(10.0);
    EXPECT_THAT(said(true), ElementsAre("Stairs up, five steps", "Door is shut"));
}

TEST_F(CuePlannerWithVoice, flush_writes_every_waiting_answer) {
    tick({}, {text("One"), text("Two"), text("Three")});
    EXPECT_TRUE(planner.waiting());
    planner.flush(now_s, speech);
    EXPECT_FALSE(planner.waiting());
    EXPECT_THAT(said(), ElementsAre("One", "Two", "Three"));
}

TEST_F(CuePlannerTest, same_inputs_give_the_same_speech_and_sound) {
    const auto run = [&](RecordingAudio& a, RecordingSpeech& s) {
        CuePlanner p{Settings{}};
        p.enter_world(room());
        for (int i = 0; i < 400; ++i) {
            const auto kind = static_cast<ContactEventKind>(i * 7 % 3);
            std::vector<ContactEvent> events{event(kind, static_cast<std::uint32_t>(i * 5 % 4), 0.001 * i)};
            events[0].time_s = 0.005 * i;
            p.tick({.now_s = 0.005 * i, .contacts = events, .requests = {}, .listener = {}}, a, s);
        }
    };
    RecordingAudio audio2;
    RecordingSpeech speech2;
    run(audio, speech);
    run(audio2, speech2);
    ASSERT_EQ(speech.lines().size(), speech2.lines().size());
    ASSERT_GT(speech.lines().size(), 0U);
    for (std::size_t i = 0; i < speech.lines().size(); ++i)
        EXPECT_EQ(speech.lines()[i].utterance.text, speech2.lines()[i].utterance.text);
    ASSERT_EQ(audio.sounds().size(), audio2.sounds().size());
    for (std::size_t i = 0; i < audio.sounds().size(); ++i)
        EXPECT_EQ(audio.sounds()[i].cue.loudness, audio2.sounds()[i].cue.loudness);
    EXPECT_EQ(audio.loop_changes().size(), audio2.loop_changes().size());
}

TEST_F(CuePlannerTest, with_two_hands_names_the_touching_hand_and_separates_their_sounds) {
    planner.set_two_hands(true);
    const auto of_left = [&](ContactEvent e, const Vec3& at_m) {
        e.hand = 1;
        e.position_m = at_m;
        return e;
    };
    tick({event(ContactEventKind::Begin, kNorth), of_left(event(ContactEventKind::Begin, kDoor), {-2.0, 0.0, 1.0})});
    wait(0.1);
    EXPECT_THAT(said(),
                ElementsAre("Right hand: North wall, plaster", "Left hand: Door, wood, handle on the east side"));
    ASSERT_EQ(audio.sounds().size(), 2U);
    EXPECT_EQ(audio.sounds()[0].cue.position_m, Vec3(1.0, 2.0, 3.0));
    EXPECT_EQ(audio.sounds()[1].cue.position_m, Vec3(-2.0, 0.0, 1.0)) << "where that hand is";
    // Both hands slide; then the left hand stops.
    tick({event(ContactEventKind::Slide, kNorth), of_left(event(ContactEventKind::Slide, kDoor), {-2.0, 0.0, 1.0})});
    ASSERT_TRUE(audio.loop(SoundKind::Slide, 0) && audio.loop(SoundKind::Slide, 1));
    EXPECT_EQ(audio.loop(SoundKind::Slide, 0)->material, SoundClass::Plaster);
    EXPECT_EQ(audio.loop(SoundKind::Slide, 1)->material, SoundClass::Wood);
    tick({of_left(event(ContactEventKind::End, kDoor), {-2.0, 0.0, 1.0})});
    EXPECT_TRUE(audio.loop(SoundKind::Slide, 0));
    EXPECT_FALSE(audio.loop(SoundKind::Slide, 1));
    // The planner must announce the same object again if the other hand touches it.
    tick({of_left(event(ContactEventKind::Begin, kNorth), {-1.0, 4.0, 1.0})});
    wait(0.1);
    EXPECT_EQ(said().back(), "Left hand: North wall, plaster");
    ContactEvent gone = of_left(event(ContactEventKind::FaultRaised, kNorth), Vec3(0.0));
    gone.fault = Fault::Unplugged;
    tick({gone});
    EXPECT_EQ(said().back(), "Left hand: The touch device was unplugged. Everything else keeps working.");
}

}  // namespace cue_planner_test
}  // namespace handrail
