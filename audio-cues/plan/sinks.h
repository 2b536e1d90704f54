// The two interfaces between deciding what is heard and playing it. One thread owns both sinks (the audio thread).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "settings/settings.h"
#include "worlds/base/language.h"
#include "worlds/base/vec.h"
#include "worlds/scene/material.h"

namespace handrail::cues {

// Who may interrupt whom: a class cuts everything after it in this list, never anything before it. SpeechOrder keeps
// these rules for every voice; a sink that is told to say something always says it at once.
enum class SpeechClass : std::uint8_t {
    Alarm,     // of a device or of the program itself: cuts all, and only the stop keys end it
    Warning,   // what a foot must know at once: a drop, stairs, something shut, a step that was blocked; as an alarm
    Answer,    // reply to a key
    Guidance,  // what comes unasked and matters: the room you come into, the next leg of a route
    Contact,   // name of what is touched or bumped into: newest replaces older
    Ambient,   // hints: dropped when anything else speaks
};

// What a line is about, if that decides what becomes of it when it is cut or a newer one comes.
enum class SpeechTopic : std::uint8_t {
    None,
    Place,    // where you are: the newest replaces older ones; made anew if it was cut
    Summary,  // of a route that begins: made anew if it was cut
    Leg,      // of a route: as Place
    Lesson,   // what a lesson wants: as Summary
    Praise,   // what a lesson says of the step that was done: as Summary
    Heading,  // which way you face: the newest replaces older ones
    Steps,    // how many steps you went: yields to everything and expires
};

// Several topics, as bits.
struct SpeechTopics {
    std::uint32_t bits = 0;

    void add(SpeechTopic topic) { bits |= 1U << static_cast<unsigned>(topic); }
    void remove(SpeechTopic topic) { bits &= ~(1U << static_cast<unsigned>(topic)); }
    bool has(SpeechTopic topic) const { return (bits >> static_cast<unsigned>(topic) & 1U) != 0; }
    bool any() const { return bits != 0; }
};

struct Utterance {
    std::string text;  // one line of valid UTF-8 without control characters (see speakable)
    SpeechClass speech_class = SpeechClass::Answer;
    double loudness = 1.0;                  // 0 to 1; text sinks take no notice
    SpeechTopic topic = SpeechTopic::None;  // for who counts what was heard
    std::optional<double> right_rad = {};   // the voice comes from there, to the right of ahead; none: from the middle
};

class SpeechSink {
public:
    virtual ~SpeechSink() = default;
    virtual void say(const Utterance& utterance) = 0;  // returns at once; cuts the current utterance and starts
    virtual void write(const Utterance& /*utterance*/) {
    }                         // text that is no longer voiced, because its turn has passed; for sinks that store text
    virtual void stop() = 0;  // silences at once
    virtual bool speaking() const = 0;      // from say() until the last sample; text alone takes no time
    virtual void tick(double /*now_s*/) {}  // housekeeping, about every 5 ms
    virtual void set_speech(const settings::Settings::Speech& /*settings*/) {
    }  // rate and voice, from the next utterance on
    // A message about the sink itself, suitable for speech ("There is no voice ..."). Each is returned once.
    virtual std::optional<std::string> news() { return std::nullopt; }
    // The name of the current voice inside a sentence: "the speech server", "text alone". Empty while it is not
    // decided.
    virtual std::string who() const { return phrase("voice.text_alone"); }
};

enum class SoundKind : std::uint8_t {
    Contact,  // the hand meets a surface
    Slide,    // loop while the hand slides
    Footstep,
    Bump,      // the walker meets a wall
    WallTone,  // loop, soft, at the side of the nearest wall
    Splash,
    DoorMoves,  // a door, lift or button starts to move
    DoorShuts,
    Bell,  // at one side, to find out which ear is which
    // Signs along a route, each at its place.
    Corner,
    Opening,   // a gap in the wall along which the person walks
    DropNear,  // one beat of the warning before an edge
    StairsUp,
    StairsDown,
    DoorNear,  // a door is ahead
    Falls,     // an object of a game falls into a hole
    Knock,     // a covered hole, hollow
    Border,    // a rolled object meets the border of the game, dull
    // Sounds that help to find things, each at its place, one at a time.
    Mark,
    Landmark,
    Clue,
    Beacon,       // the beacon is to the side
    BeaconAhead,  // the beacon is straight ahead
    BeaconBehind,
    // The world's own sounds: loops that stay at their places, used for a map's sounds and particles.
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
    HiddenClock,  // for the hunt for a hidden clock; unlike any clock of a world
    Shimmer,      // any other sound
    // Earcons: heard in the middle of the head, whatever their position.
    Denied,
    ForcesOn,
    ForcesOff,
    TurnTick,
    FrameSwitch,
    Arrived,
    Rim,      // the workspace begins to scroll
    RimBack,  // the workspace has stopped scrolling
    Grab,
    LetGo,
    Click,       // the wall to the desk gave way, or a control was pressed
    GuideStart,  // guidance of the hand begins
    GuideStop,   // guidance of the hand has ended
    Warmer,      // faster the nearer the person is to what they look for
    Colder,      // played instead if the person moved away from it
    Alarm,
    Beep,
};
inline constexpr int kSoundKinds = static_cast<int>(SoundKind::Beep) + 1;
inline bool is_earcon(SoundKind kind) noexcept { return kind >= SoundKind::Denied; }
inline bool is_beacon(SoundKind kind) noexcept { return kind >= SoundKind::Beacon && kind <= SoundKind::BeaconBehind; }
inline bool is_world_sound(SoundKind kind) noexcept { return kind >= SoundKind::Hum && kind <= SoundKind::Shimmer; }

// A sound at a place. A loop keeps sounding under its kind and source until set_loop gives it loudness 0.
struct SoundCue {
    SoundKind kind = SoundKind::Contact;
    SoundClass material = SoundClass::Generic;
    Vec3 position_m{0.0};       // world
    double loudness = 1.0;      // range 0 to 1
    double pitch = 1.0;         // factor
    double event_time_s = 0.0;  // time of the event that it announces; latency is counted from here
    double pulses_per_s = 0.0;  // for loops: number of swells per second; 0: steady
    double muffled_db = 0.0;    // loss in doors and walls on the way, in addition to distance; high tones lose more
    std::uint32_t source = 0;   // distinguishes loops of one kind; for Slide it is the hand
};

struct Listener {
    Vec3 ears_m{0.0};
    double heading_rad = 0.0;
    double reverberation_s = 0.0;  // of the surrounding room: time until the sound has fallen by 60 dB; 0: open air
};

class AudioSink {
public:
    virtual ~AudioSink() = default;
    virtual void play(const SoundCue& cue) = 0;
    virtual void set_loop(const SoundCue& cue) = 0;  // one loop per kind and source; loudness 0 fades it out
    virtual void set_listener(const Listener& listener) = 0;
    virtual void set_sound(const settings::Settings::Sound& /*settings*/) {
    }  // balance, mono, reverberation and second cues, from now on; CuePlanner applies the volumes
    virtual void set_speaking(bool /*speaking*/) {
    }  // tells whether a voice speaks that this sink does not play: sounds get quieter for it too
    virtual void stop_all() = 0;          // silences every sound but speech, at once and without a click
    virtual void tick(double now_s) = 0;  // housekeeping, about every 5 ms
    // True if the device runs dry again and again, so that it needs more periods.
    virtual bool drops_out() const { return false; }
    // A message about the sink itself, suitable for speech ("The sound device was lost ..."). Each is returned once.
    virtual std::optional<std::string> news() { return std::nullopt; }
};

}  // namespace handrail::cues
