// The two seams between what should be heard and what makes it heard. One thread owns both sinks (the audio thread).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "settings/settings.h"
#include "worlds/base/language.h"
#include "worlds/base/vec.h"
#include "worlds/scene/material.h"

namespace handrail {

// Who may interrupt whom: a class cuts itself short and everything after it in this list, never anything before it.
// Alarms and warnings wait for others of their own, so that none is
// lost. CuePlanner keeps these rules; a sink that is told to say
// something always says it at once.
enum class SpeechClass : std::uint8_t {
    Alarm,    // of a device or of the program itself: cuts all
    Warning,  // what a foot must know at once: a drop, stairs, something shut, a step that was blocked
    Answer,   // reply to a key
    Contact,  // name of what is touched or bumped into: newest replaces older
    Ambient,  // hints: dropped when anything else speaks
};

struct Utterance {
    std::string text;  // one line of valid UTF-8 without control characters (see speakable)
    SpeechClass speech_class = SpeechClass::Answer;
    double loudness = 1.0;  // 0 to 1; text sinks take no notice
};

class SpeechSink {
public:
    virtual ~SpeechSink() = default;
    virtual void say(const Utterance& utterance) = 0;  // returns at once; starts after interrupting what is running
    virtual void write(const Utterance& /*utterance*/) {
    }                                   // text that is not voiced any more (its turn passed); for sinks that keep text
    virtual void stop() = 0;            // silence at once
    virtual bool speaking() const = 0;  // from the moment of say() until the last sample; text alone takes no time
    virtual void tick(double /*now_s*/) {}                            // housekeeping, about every 5 ms
    virtual void set_speech(const Settings::Speech& /*settings*/) {}  // rate and voice, from the next utterance on
    // A sentence about the sink itself, fit to be spoken ("There is no voice ..."); each is given once.
    virtual std::optional<std::string> news() { return std::nullopt; }
    // Who speaks, as it stands inside a sentence: "the speech server", "text alone". Empty while that is not decided.
    virtual std::string who() const { return phrase("voice.text_alone"); }
};

enum class SoundKind : std::uint8_t {
    Contact,  // hand meets a surface
    Slide,    // loop while the hand slides
    Footstep,
    Bump,      // body meets a wall
    WallTone,  // loop, soft, at the side of the nearest wall
    Splash,
    DoorMoves,  // a door, lift or button sets off
    DoorShuts,
    Bell,  // at one side, to find out which ear is which
    // Where the way leads, at the places they tell of.
    Corner,
    Opening,   // the wall that is trailed is interrupted
    DropNear,  // one beat of the warning before an edge
    StairsUp,
    StairsDown,
    DoorNear,  // a door is before you
    Falls,     // a thing of a game falls into a hole
    Knock,     // a hole is covered, hollow
    Border,    // what is rolled meets the border of the game, dull
    // What helps to find things, at their places, one sound a time.
    Mark,
    Landmark,
    Clue,
    Beacon,       // to the side
    BeaconAhead,  // straight ahead
    BeaconBehind,
    // Sounds of the world, loops that stay at their places: what a map's sounds and particles are heard as.
    Hum,
    Buzz,
    Drone,
    Drip,
    Wind,
    Swamp,
    Thunder,
    Stream,
    Fire,
    Clock,
    Fan,
    Rain,
    Birds,
    Tolling,
    Music,
    HiddenClock,  // of the hunt, like no clock of a world
    Shimmer,      // anything else
    // Earcons: heard in the middle of the head, wherever their position is.
    Denied,
    ForcesOn,
    ForcesOff,
    TurnTick,
    FrameSwitch,
    Arrived,
    Rim,      // the workspace begins to scroll
    RimBack,  // and has ended
    Grab,
    LetGo,
    Click,       // the wall of the desk gave way, a control was pressed
    GuideStart,  // the hand will be led
    GuideStop,   // it is not led any more
    Warmer,      // the faster, the nearer one is to what one looks for
    Colder,      // instead, when one has come farther from it
    Alarm,
    Beep,
};
inline constexpr int kSoundKinds = static_cast<int>(SoundKind::Beep) + 1;
inline bool is_earcon(SoundKind kind) noexcept { return kind >= SoundKind::Denied; }
inline bool is_beacon(SoundKind kind) noexcept { return kind >= SoundKind::Beacon && kind <= SoundKind::BeaconBehind; }
inline bool is_world_sound(SoundKind kind) noexcept { return kind >= SoundKind::Hum && kind <= SoundKind::Shimmer; }

// A sound at a place. Loops keep sounding under their kind and source until set_loop gives them volume 0.
struct SoundCue {
    SoundKind kind = SoundKind::Contact;
    SoundClass material = SoundClass::Generic;
    Vec3 position_m{0.0};       // world
    double loudness = 1.0;      // 0 to 1
    double pitch = 1.0;         // factor
    double event_time_s = 0.0;  // when what it tells of happened; latency is counted from here
    double pulses_per_s = 0.0;  // loops: swells that often; 0: steady
    double muffled_db = 0.0;    // lost in doors and walls on the way, on top of distance; high tones lose more
    std::uint32_t source = 0;   // which of several loops of one kind; of Slide, which hand
};

struct Listener {
    Vec3 ears_m{0.0};
    double heading_rad = 0.0;
    double reverberation_s = 0.0;  // of the room around, until 60 dB are gone; 0: open air
};

class AudioSink {
public:
    virtual ~AudioSink() = default;
    virtual void play(const SoundCue& cue) = 0;
    virtual void set_loop(const SoundCue& cue) = 0;  // one loop per kind and source; loudness 0 fades it out
    virtual void set_listener(const Listener& listener) = 0;
    virtual void set_sound(const Settings::Sound& /*settings*/) {
    }  // sides, mono, reverberation and second cues, from now on; volumes are CuePlanner's
    virtual void set_speaking(bool /*speaking*/) {
    }                                     // a voice speaks that is not the sink's own: sounds step back for it too
    virtual void stop_all() = 0;          // every sound but speech, at once, click-free
    virtual void tick(double now_s) = 0;  // housekeeping, about every 5 ms
    virtual bool drops_out() const { return false; }  // the device runs dry again and again: it wants more periods
    // A sentence about the sink itself, fit to be spoken ("The sound device was lost ..."); each is given once.
    virtual std::optional<std::string> news() { return std::nullopt; }
};

}  // namespace handrail
