// Queues everything that a session wants to say and play. After each tick, the owner of the session removes the
// requests and passes them to speech and sound. Use the queue on the app thread only.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/world/walker_state.h"
#include "audio-cues/plan/cue_planner.h"

namespace handrail::core {

// Returns a request to play a sound once at `place_m`.
cues::CueRequest sound_at(cues::SoundKind kind, const Vec3& place_m, double now_s);

class Cues {
public:
    // Sounds without a place are played at the ears of `avatar`, which must outlive this object.
    explicit Cues(const WalkerState& avatar) : avatar_(avatar) {}

    void say(std::string text, cues::SpeechClass speech_class, double now_s);
    // Options of announce(), which says a line about a topic. The topic determines the speech class. `anew`: the line
    // was cut off before, so it may be repeated. `place_m`: the place that the line is about, if any.
    struct AnnounceOptions {
        bool anew = false;
        // True: the person pressed a key for this line or was waiting for it, so it is said at every verbosity.
        bool answers = false;
        std::optional<Vec3> place_m = {};
    };
    void announce(cues::SpeechTopic topic, std::string text, double now_s, const AnnounceOptions& how);
    // Says a warning that a walking person needs at once: a drop, stairs, or something that is shut or blocks the path.
    // It is said each time, even if it was said shortly before.
    void warn(std::string text, double now_s) { say(std::move(text), cues::SpeechClass::Warning, now_s); }
    // Says the response to what the person requested or did.
    void answer(std::string text, double now_s) { say(std::move(text), cues::SpeechClass::Answer, now_s); }
    void play(cues::SoundKind kind, double now_s) { cue(sound_at(kind, avatar_.ears_m(), now_s)); }
    void play_at(cues::SoundKind kind, const Vec3& place_m, double now_s) { cue(sound_at(kind, place_m, now_s)); }
    // Stops the present speech, except alarms and warnings. Call it when a key is pressed.
    void quiet(double now_s);
    void cue(cues::CueRequest request) { waiting.push_back(std::move(request)); }
    std::vector<cues::CueRequest> take() { return std::exchange(waiting, {}); }

    // Returns the last leg of a route that was announced.
    const std::string& last_leg() const { return last_leg_; }

    std::vector<cues::CueRequest> waiting;  // requests that the owner has not removed yet

private:
    const WalkerState& avatar_;
    std::string last_leg_;
};

}  // namespace handrail::core
