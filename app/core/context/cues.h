// Everything that a session has to say and to play, in the order in which it came up. Whoever carries it to ears takes
// it after each tick. App thread only.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/core/world/body_state.h"
#include "audio-cues/plan/cue_planner.h"

namespace handrail {

// A sound that is played once, there.
CueRequest sound_at(SoundKind kind, const Vec3& place_m, double now_s);

class Cues {
public:
    // body: whose ears hear what has no place of its own.
    explicit Cues(const BodyState& body) : body_(body) {}

    void say(std::string text, SpeechClass speech_class, double now_s);
    // What a foot must know at once: drops, stairs, what is shut or blocks. Said each time.
    void warn(std::string text, double now_s) { say(std::move(text), SpeechClass::Warning, now_s); }
    // To what the person asked or did.
    void answer(std::string text, double now_s) { say(std::move(text), SpeechClass::Answer, now_s); }
    void play(SoundKind kind, double now_s) { cue(sound_at(kind, body_.ears_m(), now_s)); }
    void play_at(SoundKind kind, const Vec3& place_m, double now_s) { cue(sound_at(kind, place_m, now_s)); }
    // A key was pressed: what is being said ends, but for a warning that has just begun.
    void quiet(double now_s);
    void cue(CueRequest request) { waiting.push_back(std::move(request)); }
    std::vector<CueRequest> take() { return std::exchange(waiting, {}); }

    std::vector<CueRequest> waiting;  // to be taken

private:
    const BodyState& body_;
};

}  // namespace handrail
