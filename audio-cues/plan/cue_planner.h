// Decides what is heard: debounces names, picks sounds by material and force, keeps one voice. Pure logic over its inputs and a
// time, so scenarios replay it exactly. One thread (the audio thread; in scenarios the only one).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "audio-cues/plan/sinks.h"
#include "haptic/servo/servo_tick.h"
#include "settings/settings.h"
#include "worlds/scene/scene.h"

namespace handrail {

enum class CueRequestKind : std::uint8_t {
    Say,          // text, speech_class; `repeatable` lifts the 5 s rule (answers to keys)
    Footstep,     // material, position
    Bump,         // body met `feature` at `position`
    WallTone,     // loudness by distance, at `position`; loudness 0: off
    StopSpeech,   // Control key
    SilenceAll,   // F12
    Play,         // sound kind at position
    Repeat,       // last utterance again
};

// What the app asks to be heard; sent through a queue to the audio thread.
struct CueRequest {
    CueRequestKind kind = CueRequestKind::Say;
    double time_s = 0.0;
    std::string text;
    SpeechClass speech_class = SpeechClass::Answer;
    bool repeatable = false;
    SoundKind sound = SoundKind::Beep;
    SoundClass material = SoundClass::Generic;
    FeatureId feature = kNoFeature;
    Vec3 position_m{0.0};
    double loudness = 1.0;
};

// Everything said, newest last, for the window's large text and for tests.
struct SpokenLine {
    double time_s = 0.0;
    std::string text;
    SpeechClass speech_class = SpeechClass::Answer;
};

struct CueInputs {
    double now_s = 0.0;
    std::span<const ContactEvent> contacts;
    std::span<const CueRequest> requests;
    Listener listener;
};

class CuePlanner {
public:
    explicit CuePlanner(Settings settings);
    void set_settings(const Settings& settings);
    void enter_world(std::shared_ptr<const Scene> scene);       // names and materials to speak of
    // Handles all inputs in order and drives the sinks.
    void tick(const CueInputs& inputs, AudioSink& audio, SpeechSink& speech);
    const std::vector<SpokenLine>& spoken() const { return spoken_; }   // at most the last 500 lines

private:
    std::vector<SpokenLine> spoken_;
    Settings settings_;
    std::shared_ptr<const Scene> scene_;
};

}  // namespace handrail
