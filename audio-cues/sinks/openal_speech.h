// Plays speech from the middle, or from the direction of the thing that the text is about. It reads samples from a
// VoiceChannel and queues them piece by piece. Audio thread only, with the context current.
#pragma once

#include <AL/al.h>

#include <array>
#include <memory>

#include "audio-cues/sinks/voice_channel.h"
#include "settings/settings.h"

namespace handrail::sinks {

class OpenALSpeech {
public:
    explicit OpenALSpeech(std::shared_ptr<VoiceChannel> channel) : channel_(std::move(channel)) {}

    void make();
    void stop();  // also drops the utterance that is still to come
    void drop();
    void update(double now_s, const settings::Settings::Sound& sound);
    bool playing() const { return channel_->playing(); }
    // ticket() identifies the current utterance. give_up() marks an utterance that was lost with its device as ended,
    // so that code waiting for its end continues.
    VoiceChannel::Ticket ticket() const { return speakers_[speaker_].ticket; }
    void give_up(VoiceChannel::Ticket spoken);

private:
    // Utterances alternate between two sources, so that an utterance that was cut off can fade out while the next one
    // begins.
    struct Speaker {
        ALuint source = 0;
        VoiceChannel::Ticket ticket = 0;
        bool active = false;
        bool ended = false;  // all samples of the utterance are queued
        bool ending = false;
        double stop_at_s = 0.0;
        double gain = 1.0;
    };

    static void delete_played(const Speaker& s);
    static void drop_speech(Speaker& s);
    static void place(const Speaker& s, std::optional<double> right_rad, const settings::Settings::Sound& sound);

    std::shared_ptr<VoiceChannel> channel_;
    std::array<Speaker, 2> speakers_{};
    std::size_t speaker_ = 0;  // index of the source that plays the current utterance
};

}  // namespace handrail::sinks
