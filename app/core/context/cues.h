// Everything that a session has to say and to play, in order. The owner of the session takes it after each tick and
// passes it on to speech and sound. App thread only.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/world/walker_state.h"
#include "audio-cues/plan/cue_planner.h"

namespace handrail::core {

// A sound that is played once at this place.
cues::CueRequest sound_at(cues::SoundKind kind, const Vec3& place_m, double now_s);

class Cues {
public:
    // body: its ears are the place of sounds that have no place themselves.
    explicit Cues(const WalkerState& body) : body_(body) {}

    void say(std::string text, cues::SpeechClass speech_class, double now_s);
    // A line about this topic, with the class that belongs to it. anew: it was cut, so that it was said before does not
    // matter. place_m: what it is about, if it is about a place.
    struct Telling {
        bool anew = false;
        bool answers = false;  // a key, or what somebody has waited for: said at every verbosity
        std::optional<Vec3> place_m = {};
    };
    void tell(cues::SpeechTopic topic, std::string text, double now_s, const Telling& how);
    // What a foot must know at once: drops, stairs, what is shut or blocks. Said each time.
    void warn(std::string text, double now_s) { say(std::move(text), cues::SpeechClass::Warning, now_s); }
    // A response to what the person asked or did.
    void answer(std::string text, double now_s) { say(std::move(text), cues::SpeechClass::Answer, now_s); }
    void play(cues::SoundKind kind, double now_s) { cue(sound_at(kind, body_.ears_m(), now_s)); }
    void play_at(cues::SoundKind kind, const Vec3& place_m, double now_s) { cue(sound_at(kind, place_m, now_s)); }
    // A key was pressed: what is being said ends, but for alarms and warnings.
    void quiet(double now_s);
    void cue(cues::CueRequest request) { waiting.push_back(std::move(request)); }
    std::vector<cues::CueRequest> take() { return std::exchange(waiting, {}); }

    std::vector<cues::CueRequest> waiting;  // not taken yet

private:
    const WalkerState& body_;
};

}  // namespace handrail::core
