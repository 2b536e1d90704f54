// Defines the two interfaces between the code that decides what is heard and the code that plays it. One thread, the
// audio thread, owns both sinks.
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

// Importance of speech: a class interrupts all classes after it in this list, and none before it. SpeechOrder applies
// these rules for every voice. A sink itself always speaks a line at once.
enum class SpeechClass : std::uint8_t {
    Alarm,  // A fault of a device or of the program. It interrupts everything, and only the stop keys end it.
    // A danger or obstacle at the feet: a drop, stairs, a closed door, a blocked step. It interrupts like an alarm.
    Warning,
    Answer,  // reply to a key
    // Important news that the person did not request, such as the room that they enter or the next part of a route.
    Guidance,
    Contact,  // name of the thing that the person touches or bumps into; the newest replaces older ones
    Ambient,  // hints; dropped as soon as anything else is spoken
};

// The topic of a line, if it determines what happens when the line is cut off or a newer line of this topic comes.
enum class SpeechTopic : std::uint8_t {
    None,
    // The person's place. The newest line replaces older ones, and the session composes it again if it was cut off.
    Place,
    Summary,  // summary of a route that begins; the session composes it again if it was cut off
    Leg,      // next part of a route; treated like Place
    Lesson,   // task of a lesson; treated like Summary
    Praise,   // feedback of a lesson on the step that the person made; treated like Summary
    Heading,  // the direction that the person faces; the newest line replaces older ones
    Steps,    // number of steps that the person walked; any other line may delay it, and it expires
    Arrival,  // the person has arrived at a thing; treated like Place
};

// A set of topics, as bits.
struct SpeechTopics {
    std::uint32_t bits = 0;

    void add(SpeechTopic topic) { bits |= 1U << static_cast<unsigned>(topic); }
    void remove(SpeechTopic topic) { bits &= ~(1U << static_cast<unsigned>(topic)); }
    bool has(SpeechTopic topic) const { return (bits >> static_cast<unsigned>(topic) & 1U) != 0; }
    bool any() const { return bits != 0; }
};

struct Utterance {
    std::string text;  // text to speak: one line of valid UTF-8 without control characters (see speakable())
    SpeechClass speech_class = SpeechClass::Answer;
    double loudness = 1.0;                  // 0 to 1; text sinks ignore it
    SpeechTopic topic = SpeechTopic::None;  // lets code that counts what the person heard find the topic of the text
    // Direction from which the voice comes, to the right of straight ahead; nothing: the middle.
    std::optional<double> right_rad = {};
};

class SpeechSink {
public:
    virtual ~SpeechSink() = default;
    // Starts to speak and returns at once; an utterance that is still being spoken ends.
    virtual void say(const Utterance& utterance) = 0;
    virtual void write(const Utterance& /*utterance*/) {
    }  // tells sinks that store text of a line that will not be spoken, because its time has passed
    virtual void stop() = 0;  // stops speaking at once
    // True from say() until the last sample; always false for sinks that only write text.
    virtual bool speaking() const = 0;
    virtual void tick(double /*now_s*/) {}  // does housekeeping; called about every 5 ms
    virtual void set_speech(const settings::Settings::Speech& /*settings*/) {
    }  // sets rate and voice from the next utterance on
    // Returns a message about the sink itself, suitable for speech ("There is no voice ..."). Returns each message
    // once.
    virtual std::optional<std::string> news() { return std::nullopt; }
    // Returns the name of the current voice as part of a sentence: "the speech server", "text alone". Empty until a
    // voice is chosen.
    virtual std::string who() const { return phrase("voice.text_alone"); }
};

enum class SoundKind : std::uint8_t {
    Contact,  // the hand meets a surface
    Slide,    // a loop that sounds while the hand slides along a surface
    Footstep,
    Bump,      // the walker meets a wall
    WallTone,  // a soft loop from the direction of the nearest wall
    Splash,
    DoorMoves,  // a door, lift or button starts to move
    DoorShuts,
    Bell,  // sounds at one side, so that the person can find out which ear is which
    // Sounds along a route. Each comes from its place.
    Corner,
    Opening,   // a gap in the wall along which the person walks
    DropNear,  // one beat of the warning before an edge
    StairsUp,
    StairsDown,
    DoorNear,  // announces that a door is ahead
    Falls,     // an object of a game falls into a hole
    Knock,     // a hollow sound which tells that the hole is covered
    Border,    // a dull sound: a rolled object meets the border of the game
    // Sounds that help to find things. Each comes from its place, one at a time.
    Mark,
    Landmark,
    Clue,
    Beacon,       // the beacon is at the side of the person
    BeaconAhead,  // the beacon is straight ahead
    BeaconBehind,
    // The world's own sounds: loops at fixed places, used for the sounds and particles of a map.
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
    HiddenClock,  // a hidden clock that the person must find; sounds unlike any clock of a world
    Shimmer,      // used for all other sounds of a map
    // Earcons. They sound in the middle of the head, whatever their position.
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
    Click,       // the wall to the desk let the hand through, or the person pressed a control
    GuideStart,  // guidance of the hand begins
    GuideStop,   // guidance of the hand has ended
    Warmer,      // repeats faster the nearer the person is to the thing that they look for
    Colder,      // played instead of Warmer if the person moved away from that thing
    Alarm,
    Beep,
};
inline constexpr int kSoundKinds = static_cast<int>(SoundKind::Beep) + 1;
inline bool is_earcon(SoundKind kind) noexcept { return kind >= SoundKind::Denied; }
inline bool is_beacon(SoundKind kind) noexcept { return kind >= SoundKind::Beacon && kind <= SoundKind::BeaconBehind; }
inline bool is_world_sound(SoundKind kind) noexcept { return kind >= SoundKind::Hum && kind <= SoundKind::Shimmer; }

// A sound at a place. A loop, identified by kind and source, sounds until set_loop() gives it loudness 0.
struct SoundCue {
    SoundKind kind = SoundKind::Contact;
    SoundClass material = SoundClass::Generic;
    Vec3 position_m{0.0};       // position in the world
    double loudness = 1.0;      // 0 to 1
    double pitch = 1.0;         // factor on the pitch
    double event_time_s = 0.0;  // time of the event that the sound announces; latency is measured from here
    double pulses_per_s = 0.0;  // for loops: number of swells per second; 0: steady
    // Loss in decibels through the doors and walls between sound and listener, in addition to the loss by distance.
    // High tones lose more.
    double muffled_db = 0.0;
    std::uint32_t source = 0;  // distinguishes loops of one kind; for Slide it is the number of the hand
};

struct Listener {
    Vec3 ears_m{0.0};
    double heading_rad = 0.0;
    // Reverberation time of the surrounding room, which is the time in which a sound falls by 60 dB; 0: open air.
    double reverberation_s = 0.0;
};

class AudioSink {
public:
    virtual ~AudioSink() = default;
    virtual void play(const SoundCue& cue) = 0;
    // Sets one loop, identified by kind and source; loudness 0 fades it out.
    virtual void set_loop(const SoundCue& cue) = 0;
    virtual void set_listener(const Listener& listener) = 0;
    virtual void set_sound(const settings::Settings::Sound& /*settings*/) {
    }  // Sets balance, mono, reverberation and second cues from now on. CuePlanner applies the volumes.
    virtual void set_speaking(bool /*speaking*/) {
    }  // Says whether a voice is speaking, even if another program plays it. The sink then makes its sounds quieter.
    virtual void stop_all() = 0;          // ends every sound except speech, at once and without a click
    virtual void tick(double now_s) = 0;  // does housekeeping; called about every 5 ms
    // Returns true if the device runs out of samples again and again, so that it needs more periods of buffer.
    virtual bool drops_out() const { return false; }
    // Returns a message about the sink itself, suitable for speech ("The sound device was lost ..."). Returns each
    // message once.
    virtual std::optional<std::string> news() { return std::nullopt; }
};

}  // namespace handrail::cues
