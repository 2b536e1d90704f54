// Sinks for scenarios and tests in virtual time. They store the sounds and lines that a person would have heard, as far
// as that is known without samples, and make no sound. One thread. The tests of OpenALSink measure the samples.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audio-cues/plan/sinks.h"

namespace handrail::sinks {

// A sound, with the time at which it would start.
struct HeardSound {
    cues::SoundCue cue;
    double time_s = 0.0;     // time of its first sample in the output
    double latency_s = 0.0;  // time_s - cue.event_time_s
};

// Stores sounds with their start times. A sound starts at the beginning of the first mixing period after play(). A
// period has 256 samples at 48 kHz, as in OpenALSink.
class RecordingAudio final : public cues::AudioSink {
public:
    static constexpr double kPeriod_s = 256.0 / 48000.0;

    void play(const cues::SoundCue& cue) override;
    void set_loop(const cues::SoundCue& cue) override;
    void set_listener(const cues::Listener& listener) override { listener_ = listener; }
    void stop_all() override;
    void tick(double now_s) override { now_s_ = now_s; }

    const std::vector<HeardSound>& sounds() const { return sounds_; }  // one-shots, in the order of play()
    const std::vector<HeardSound>& loop_changes() const {
        return changes_;
    }  // one entry for each call that changed the loudness, pitch, place or material of a loop
    std::optional<cues::SoundCue> loop(
        cues::SoundKind kind,
        std::uint32_t source = 0) const;               // returns the loop of this kind and source that sounds now
    std::vector<cues::SoundCue> world_sounds() const;  // returns the world's loops that sound now
    const std::vector<double>& silences_s() const { return silences_s_; }  // times of the stop_all() calls
    const cues::Listener& listener() const { return listener_; }

private:
    HeardSound heard(const cues::SoundCue& cue) const;

    double now_s_ = 0.0;
    cues::Listener listener_;
    std::vector<HeardSound> sounds_, changes_;
    std::map<std::pair<cues::SoundKind, std::uint32_t>, cues::SoundCue> loops_;  // the loops that sound now
    std::vector<double> silences_s_;
};

// An utterance, with the times at which a voice would speak it.
struct HeardSpeech {
    cues::Utterance utterance;
    double time_s = 0.0;
    double end_s = 0.0;  // time when it was finished or cut off
    bool cut = false;    // cut off by stop() or by another utterance
    bool voiced = true;  // false: only written, because its time had passed
};

// By default, speech takes no time. With a rate, each utterance lasts as long as a voice at that rate would take (0.1 s
// plus its words).
class RecordingSpeech final : public cues::SpeechSink {
public:
    explicit RecordingSpeech(double words_per_minute = 0.0) : words_per_minute_(words_per_minute) {}

    void say(const cues::Utterance& utterance) override;
    void write(const cues::Utterance& utterance) override;
    void stop() override;
    bool speaking() const override;
    void tick(double now_s) override { now_s_ = now_s; }

    const std::vector<HeardSpeech>& lines() const { return lines_; }
    const std::vector<double>& stops_s() const { return stops_s_; }  // times of the stop() calls

private:
    void cut();

    double words_per_minute_;
    double now_s_ = 0.0;
    std::vector<HeardSpeech> lines_;
    std::optional<std::size_t> voiced_;  // index of the last line that was spoken
    std::vector<double> stops_s_;
};

}  // namespace handrail::sinks
