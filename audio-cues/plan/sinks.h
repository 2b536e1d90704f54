// The two seams between what should be heard and what makes it heard. One thread owns both sinks (the audio thread).
#pragma once

#include <cstdint>
#include <string>

#include "worlds/base/vec.h"
#include "worlds/scene/material.h"

namespace handrail {

// Who may interrupt whom: a class cuts itself short and everything after it in this list, never anything before it.
enum class SpeechClass : std::uint8_t {
    Alarm,    // safety: cuts all
    Answer,   // reply to a key
    Contact,  // name of what is touched or bumped into: newest replaces older
    Ambient,  // hints: dropped when anything else speaks
};

struct Utterance {
    std::string text;
    SpeechClass speech_class = SpeechClass::Answer;
};

class SpeechSink {
public:
    virtual ~SpeechSink() = default;
    virtual void say(const Utterance& utterance) = 0;   // returns at once; starts after interrupting what is running
    virtual void stop() = 0;                            // silence at once, queue dropped
    virtual bool speaking() const = 0;
};

enum class SoundKind : std::uint8_t {
    Contact,    // hand meets a surface
    Slide,      // loop while the hand slides
    Footstep,
    Bump,       // body meets a wall
    WallTone,   // loop, soft, at the side of the nearest wall
    Splash,
    Denied, ForcesOn, ForcesOff, TurnTick, FrameSwitch, Arrived, Alarm, Beep,
};

// A sound at a place. Loops keep sounding under their kind until set_loop gives them volume 0.
struct SoundCue {
    SoundKind kind = SoundKind::Contact;
    SoundClass material = SoundClass::Generic;
    Vec3 position_m{0.0};          // world
    double loudness = 1.0;         // 0 to 1
    double pitch = 1.0;            // factor
    double event_time_s = 0.0;     // when what it tells of happened; latency is counted from here
};

struct Listener {
    Vec3 ears_m{0.0};
    double heading_rad = 0.0;
};

class AudioSink {
public:
    virtual ~AudioSink() = default;
    virtual void play(const SoundCue& cue) = 0;
    virtual void set_loop(const SoundCue& cue) = 0;     // one loop per kind; loudness 0 fades it out
    virtual void set_listener(const Listener& listener) = 0;
    virtual void stop_all() = 0;                        // every sound but speech, at once, click-free
    virtual void tick(double now_s) = 0;                // housekeeping, about every 5 ms
};

}  // namespace handrail
