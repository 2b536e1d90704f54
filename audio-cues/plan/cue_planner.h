// Decides what the person hears. CuePlanner debounces names, chooses sounds by material and force, and uses one voice
// at a time. It is pure logic over its inputs and a time, so scenarios replay it exactly. One thread uses it: the audio
// thread, or in scenarios the only thread.
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
    Say,       // Speaks `text` with `speech_class`. `repeatable` permits repetition within 5 s, for answers to keys.
    Footstep,  // plays a footstep on `material` at `position_m`
    // The walker's body touched `feature` at `position_m`. Plays a thud and speaks `text` as a warning. Within 5 s of
    // the same warning, `text` is not spoken again, but `written` goes to the text sinks each time.
    Bump,
    // Plays the wall tone at `position_m`. Its loudness depends on the distance to the wall, and loudness 0 ends it.
    WallTone,
    Interrupt,   // Any key was pressed: the voice stops, unless it is speaking an alarm or a warning.
    StopSpeech,  // The Control key was pressed: the voice stops, and all waiting lines are dropped.
    SilenceAll,  // F12 was pressed: voice and sounds stop. Loops stay off until the next step, bump or touch.
    Play,        // plays `sound` at `position_m`
    Repeat,      // repeats the last utterance
    // Speaks the last utterance, then the one before it and so on, at most kMostHistory, each with its number.
    HistoryBack,
    HistoryForward,
    // Speaks `text`, then plays `sound` of `material` even if that sound is switched off; a loop plays for 2.5 s.
    Demonstrate,
    // Plays the loop `sound` of `source` at `position_m`, with the loudness that its map states, muffled by
    // `muffled_db`. Loudness 0 ends the loop.
    WorldSound,
};

// A request of the app for a sound or speech. It reaches the audio thread through a queue.
struct CueRequest {
    CueRequestKind kind = CueRequestKind::Say;
    double time_s = 0.0;
    std::string text, written;
    SpeechClass speech_class = SpeechClass::Answer;
    SpeechTopic topic = SpeechTopic::None;
    bool repeatable = false;
    SoundKind sound = SoundKind::Beep;
    // Material of the sound; for a Bump, Generic stands for the material of `feature`.
    SoundClass material = SoundClass::Generic;
    FeatureId feature = kNoFeature;
    Vec3 position_m{0.0};
    bool placed = false;  // for Say: the text is about `position_m`, so the voice may come from there
    double loudness = 1.0;
    double pitch = 1.0;         // factor on the pitch, for Footstep and Play
    double muffled_db = 0.0;    // for WorldSound; see SoundCue
    double pulses_per_s = 0.0;  // for WorldSound; see SoundCue
    std::uint32_t source = 0;   // for WorldSound; see SoundCue
};

// A spoken line, for the window's large text and for tests. In lists, the newest line is last.
struct SpokenLine {
    double time_s = 0.0;
    std::string text;
    SpeechClass speech_class = SpeechClass::Answer;
    bool again = false;  // the line repeats a line of the history
};

struct CueInputs {
    double now_s = 0.0;
    std::span<const servo::ContactEvent> contacts;
    std::span<const CueRequest> requests;
    Listener listener;
};

// Returns the text for a thing that the person touches or bumps into. Its length depends on
// Settings::Speech::verbosity:
// - 0: ""
// - 1: "North wall"
// - 2: "North wall, plaster"; a door with the side of its handle
// - 3: also hinge and description
// - 4: also size
// The text is empty if the feature has no name. A second press of the same question key uses a level higher by two.
std::string describe_feature(const Scene& scene, FeatureId id, int verbosity);

// Plans speech and sounds.
//
// Speech: at verbosity 0 ("sounds only"), names, guidance, hints and warnings are silent in every sink. Alarms, answers
// and counts of steps are spoken at every verbosity, because a person who asks needs an answer. A text is not spoken
// twice within 5 s unless its request is `repeatable`. A name is spoken 40 ms after the touch. Only the newest name is
// spoken, so that in a corner the person hears one whole name and not parts of two. SpeechOrder decides when each line
// is spoken.
//
// Sounds: the loudness is the product of the volumes in Settings::Sound; alarms never fall below 0.2. Contact sounds
// may repeat within 5 s. Only a second contact with the same feature within 50 ms makes no new sound, because it is
// chatter of the same touch.
class CuePlanner {
public:
    explicit CuePlanner(settings::Settings settings);
    void set_settings(const settings::Settings& settings);
    // Enters a world: names and materials come from `scene` from now on. Also forgets what the hands touched.
    void enter_world(std::shared_ptr<const Scene> scene);
    // Replaces the scene by another version of the same world, after something was added, moved or removed. Names come
    // from the new `scene` from now on, and nothing is announced again.
    void follow_edit(std::shared_ptr<const Scene> scene);
    // With two hands, the announcement of a touch says which hand touches: "Left hand: door".
    void set_two_hands(bool two) { two_hands_ = two; }
    // Says whether the hand is simulated because there is no device. If it is, the planner announces no faults of the
    // force, because nobody feels that force.
    void set_hand_stands_in(bool stands_in) { hand_stands_in_ = stands_in; }
    // Handles all inputs in order, contacts first, and drives the sinks. This includes calling their tick().
    // `inputs.now_s` must never decrease.
    void tick(const CueInputs& inputs, AudioSink& audio, SpeechSink& speech);
    // Call it at the end. Passes all lines that are still waiting to `speech` as text, so that text sinks contain every
    // answer.
    void flush(double now_s, SpeechSink& speech);
    bool waiting() const { return order_.waiting(); }
    // See SpeechOrder::take_owed(). Call it after the tick for the same time.
    SpeechTopics take_owed(double now_s, const SpeechSink& speech) {
        return order_.take_owed(now_s, speech.speaking());
    }
    const std::vector<SpokenLine>& spoken() const { return spoken_; }  // the spoken lines, but only the last kMaxSpoken
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
    // Passes `line` to order_, unless its text has no speakable character or verbosity 0 forbids the line.
    void submit(SpeechLine line);
    void alarm(const std::string& text, double requested_s, bool repeatable, bool cuts = false);
    void answer(std::string text, double requested_s);
    void press(double now_s, SpeechSink& speech);  // a key was pressed: ends the line that is being spoken
    void write_unspoken(double now_s, SpeechSink& speech);
    // What one hand touches, and the state of its sounds.
    struct Hand {
        std::uint8_t number = 0;
        std::vector<FeatureId> touched;     // features that the hand touches now
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
    // If there are two hands, puts the name of the hand in front of the text: "Left hand: door".
    std::string whose(std::size_t hand, std::string text) const;
    void keep_world_sounds(AudioSink& audio);
    void demonstrate(double now_s, AudioSink& audio, const SpeechSink& speech);
    void end_demonstration(AudioSink& audio);
    void speak_waiting(double now_s, SpeechSink& speech);
    void step_history(bool back, double requested_s);
    // Returns false if the same text was spoken within the last 5 s.
    bool keep_line(const SpeechLine& line, double now_s);
    void say_now(const SpeechLine& line, double now_s, SpeechSink& speech);
    // Returns the direction of `place_m`, as an angle in radians to the right of straight ahead. Returns nothing if the
    // person does not want voices to come from a direction, or if the place is above or below the ears.
    std::optional<double> side_of(const Vec3& place_m) const;
    double volume_of(SoundKind kind) const;  // 0 if the sound is switched off
    void play(SoundCue cue, AudioSink& audio);
    void add_as_text(const SoundCue& cue);
    void warn(const CueRequest& request, double requested_s, double now_s, SpeechSink& speech);
    SoundClass sound_of(MaterialId material) const;

    settings::Settings settings_;
    std::shared_ptr<const Scene> scene_;

    std::vector<SpokenLine> spoken_;
    std::uint64_t spoken_in_all_ = 0;
    std::size_t back_ = 0;  // position in the history, counted from the newest line; 0: the person is not in it
    // Texts of the last 5 s, with the time at which each was spoken.
    std::unordered_map<std::string, double> said_at_s_;
    SpeechOrder order_;
    SpeechTopic last_topic_ = SpeechTopic::None;  // topic of the last line that was not a repetition
    Listener listener_;                           // listener of the current tick

    std::array<Hand, 2> hands_;  // [0]: the only hand or the right one, [1]: the left hand
    bool two_hands_ = false;
    bool hand_stands_in_ = false;
    bool wall_tone_on_ = false;
    // The app's requests, before the volume is applied. Only those whose volume is above 0 are audible.
    std::vector<SoundCue> world_sounds_;
    bool hushed_ = false;  // true after SilenceAll, until the next event
    bool left_foot_ = false;
    SoundWords sound_words_;
    std::vector<SoundCue> sounds_as_text_;  // sounds of the current tick that are also written as text
    struct Demonstration {
        SoundCue cue;
        bool playing = false;  // true while the demonstrated loop is playing
        double ends_s = 0.0;
    };
    std::optional<Demonstration> demonstration_;
};

}  // namespace handrail::cues
