// Everything that a session has to say and to play, in order. The owner of the session takes it after each tick and
// passes it on to speech and sound. App thread only.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/core/world/body_state.h"
#include "audio-cues/plan/cue_planner.h"

namespace handrail {

// A sound that is played once at this place.
CueRequest sound_at(SoundKind kind, const Vec3& place_m, double now_s);

class Cues {
public:
    // body: its ears are the place of sounds that have no place themselves.
    explicit Cues(const BodyState& body) : body_(body) {}

    void say(std::string text, SpeechClass speech_class, double now_s);
    // Hazards for the feet: drops, stairs, and what is shut or blocks. Never suppressed as a repetition.
    void warn(std::string text, double now_s) { say(std::move(text), SpeechClass::Warning, now_s); }
    // A response to what the person asked or did.
    void answer(std::string text, double now_s) { say(std::move(text), SpeechClass::Answer, now_s); }
    void play(SoundKind kind, double now_s) { cue(sound_at(kind, body_.ears_m(), now_s)); }
    void play_at(SoundKind kind, const Vec3& place_m, double now_s) { cue(sound_at(kind, place_m, now_s)); }
    // A key was pressed: current speech stops, except a warning that has just begun.
    void quiet(double now_s);
    void cue(CueRequest request) { waiting.push_back(std::move(request)); }
    std::vector<CueRequest> take() { return std::exchange(waiting, {}); }

    std::vector<CueRequest> waiting;  // not taken yet

private:
    const BodyState& body_;
};

}  // namespace handrail
