// Decides what is heard: debounces names, picks sounds by material and force, and keeps to one voice. Pure logic over
// its inputs and a time, so scenarios replay it exactly. One thread (the audio thread; in scenarios the only one).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "audio-cues/plan/sinks.h"
#include "audio-cues/plan/sound_words.h"
#include "audio-cues/plan/speech_order.h"
#include "haptic/servo/servo_tick.h"
#include "settings/settings.h"
#include "worlds/scene/scene.h"

namespace handrail::cues {

enum class CueRequestKind : std::uint8_t {
    Say,          // text, speech_class; `repeatable` lifts the 5 s rule (answers to keys)
    Footstep,     // material, position
    Bump,         // body met `feature` at `position`; thud, and `text` as a warning; within 5 s of the last time it is
                  // not said again but `written`, each time
    WallTone,     // loudness by distance, at `position`; loudness 0: off
    Interrupt,    // any key: the voice is silent, unless it says an alarm or a warning
    StopSpeech,   // Control key: the voice is silent and what waited to be said is dropped
    SilenceAll,   // F12: voice and sounds; loops stay off until the next step, bump or touch
    Play,         // sound kind at position
    Repeat,       // last utterance again
    HistoryBack,  // the last utterance, then the one before it and so on, at most kMostHistory; with its number
    HistoryForward,
    Demonstrate,  // says `text`, then plays `sound` of `material` even if it is switched off; a loop for 2.5 s
    // Plays loop `sound` of `source` at `position`, as loud as its map says, muffled by `muffled_db`. Loudness 0: ends
    // it.
    WorldSound,
};

// A request of the app for something to be heard; sent through a queue to the audio thread.
struct CueRequest {
    CueRequestKind kind = CueRequestKind::Say;
    double time_s = 0.0;
    std::string text, written;
    SpeechClass speech_class = SpeechClass::Answer;
    SpeechTopic topic = SpeechTopic::None;
    bool repeatable = false;
    SoundKind sound = SoundKind::Beep;
    SoundClass material = SoundClass::Generic;  // for a Bump, Generic means the material of `feature`
    FeatureId feature = kNoFeature;
    Vec3 position_m{0.0};
    bool placed = false;  // Say: the text is about `position_m`, and can come from there
    double loudness = 1.0;
    double pitch = 1.0;         // factor, for Footstep and Play
    double muffled_db = 0.0;    // as in SoundCue
    double pulses_per_s = 0.0;  // for WorldSound, as in SoundCue
    std::uint32_t source = 0;   // as in SoundCue
};

// A spoken line, for the window's large text and for tests; lists have the newest last.
struct SpokenLine {
    double time_s = 0.0;
    std::string text;
    SpeechClass speech_class = SpeechClass::Answer;
    bool again = false;  // repeats a line of the history
};

struct CueInputs {
    double now_s = 0.0;
    std::span<const servo::ContactEvent> contacts;
    std::span<const CueRequest> requests;
    Listener listener;
};

// The text for a thing that is touched or bumped into, by Settings::Speech::verbosity:
//   0 ""   1 "North wall"   2 "North wall, plaster", a door with the side of its handle   3 also hinge and description
//   4 also size.
// Empty if the feature has no name. A second press of the same question uses a level higher by two.
std::string describe_feature(const Scene& scene, FeatureId id, int verbosity);

// Speech. Names, guidance, hints and warnings are silent, in every sink, at verbosity 0 ("sounds only"); alarms,
// answers and counts of steps are said at every level, since a person who asks is owed an answer. A text is not said
// twice within 5 s unless its request is `repeatable`. A name is said 40 ms after the touch, the newest one only, so
// that a corner gives one name and not two halves. SpeechOrder decides what is said when.
//
// Sounds. Loudness is the product of Settings::Sound; alarms never fall below 0.2. Contact sounds do not follow the 5 s
// rule; only the same feature within 50 ms is chatter and is heard once.
class CuePlanner {
public:
    explicit CuePlanner(settings::Settings settings);
    void set_settings(const settings::Settings& settings);
    // The scene is the source of names and materials. Also forgets what the hand touched.
    void enter_world(std::shared_ptr<const Scene> scene);
    // The same world with something added, moved or removed. Names are looked up in it from now on, and nothing is said
    // again.
    void follow_edit(std::shared_ptr<const Scene> scene);
    // With two hands the announcement says which one touches: "Left hand: door".
    void set_two_hands(bool two) { two_hands_ = two; }
    // The hand is simulated, because there is no device. Faults of its force are silent, because nobody feels that
    // force.
    void set_hand_stands_in(bool stands_in) { hand_stands_in_ = stands_in; }
    // Handles all inputs in order, contacts first, and drives the sinks, including their tick(). `now_s` must never go
    // back.
    void tick(const CueInputs& inputs, AudioSink& audio, SpeechSink& speech);
    // Call it at the end: writes what still waits, so that text sinks contain every answer.
    void flush(double now_s, SpeechSink& speech);
    bool waiting() const { return order_.waiting(); }
    // As SpeechOrder::take_owed, after the tick of that time.
    SpeechTopics take_owed(double now_s, const SpeechSink& speech) {
        return order_.take_owed(now_s, speech.speaking());
    }
    const std::vector<SpokenLine>& spoken() const { return spoken_; }  // at most the last kMaxSpoken lines
    std::uint64_t spoken_in_all() const { return spoken_in_all_; }

    static constexpr std::size_t kMaxSpoken = 500;
    static constexpr std::size_t kMostHistory = 50;

private:
    struct RecentContact {
        FeatureId feature;
        double time_s = 0.0;
    };

    void on_contact(const servo::ContactEvent& event, AudioSink& audio);
    void on_request(const CueRequest& request, double now_s, AudioSink& audio, SpeechSink& speech);
    // Gives it to the order, unless nothing of it can be spoken, or verbosity 0 forbids it.
    void ask(SpeechLine line);
    void alarm(const std::string& text, double asked_s, bool repeatable, bool cuts = false);
    void answer(std::string text, double asked_s);
    void write_unspoken(double now_s, SpeechSink& speech);
    // What one hand touches and is heard of it.
    struct Hand {
        std::uint8_t number = 0;
        std::vector<FeatureId> touched;     // touched now
        std::vector<RecentContact> recent;  // contact sounds of the last 50 ms
        bool sliding = false;
        FeatureId slide_feature;
        double slide_s = 0.0;  // time of the last slide event
    };

    struct Naming {
        FeatureId feature;
        double time_s = 0.0, settle_s = 0.0, keep_s = 0.0;
        Vec3 at_m{0.0};
        bool by_hand = true;
    };
    void name_touched(std::size_t hand, const Naming& naming);
    void touch(Hand& hand, const servo::ContactEvent& event);
    static bool is_touched(const Hand& hand, FeatureId feature);
    void stop_slide(Hand& hand, AudioSink& audio);
    // "Left hand: door" where there are two.
    std::string whose(std::size_t hand, std::string text) const;
    void keep_world_sounds(AudioSink& audio);
    void demonstrate(double now_s, AudioSink& audio, const SpeechSink& speech);
    void end_demonstration(AudioSink& audio);
    void speak_waiting(double now_s, SpeechSink& speech);
    void step_history(bool back, double asked_s);
    bool keep_line(const SpeechLine& line, double now_s);  // false: said within 5 s
    void say_now(const SpeechLine& line, double now_s, SpeechSink& speech);
    // How far to the right of ahead it is, if the person wants voices to come from there.
    std::optional<double> side_of(const Vec3& place_m) const;
    double volume_of(SoundKind kind) const;  // 0 where it is switched off
    void play(SoundCue cue, AudioSink& audio);
    void tell_sound(const SoundCue& cue);
    void warn(const CueRequest& request, double asked_s, double now_s, SpeechSink& speech);
    SoundClass sound_of(MaterialId material) const;

    settings::Settings settings_;
    std::shared_ptr<const Scene> scene_;

    std::vector<SpokenLine> spoken_;
    std::uint64_t spoken_in_all_ = 0;
    std::size_t back_ = 0;                               // how far back in the history the person is; 0: not at all
    std::unordered_map<std::string, double> said_at_s_;  // texts of the last 5 s
    SpeechOrder order_;
    SpeechTopic last_topic_ = SpeechTopic::None;  // of the last line that was no repetition
    Listener listener_;                           // of this tick

    std::array<Hand, 2> hands_;  // [0]: the only or right hand, [1]: the left hand
    bool two_hands_ = false;
    bool hand_stands_in_ = false;
    bool wall_tone_on_ = false;
    std::vector<SoundCue> world_sounds_;  // as requested, before volume; only those with a volume above 0 sound
    bool hushed_ = false;                 // true after SilenceAll, until the next event
    bool left_foot_ = false;
    SoundWords sound_words_;
    std::vector<SoundCue> sounds_to_tell_;  // sounds of this tick that are also written
    struct Demonstration {
        SoundCue cue;
        bool playing = false;  // the loop is playing
        double ends_s = 0.0;
    };
    std::optional<Demonstration> demonstration_;
};

}  // namespace handrail::cues
