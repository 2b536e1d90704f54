// The speech in the middle: what a VoiceChannel brings, queued piece by piece. The audio thread, with the context
// current.
#pragma once

#include <AL/al.h>

#include <array>
#include <memory>

#include "audio-cues/sinks/voice_channel.h"

namespace handrail {

class OpenALSpeech {
public:
    explicit OpenALSpeech(std::shared_ptr<VoiceChannel> channel) : channel_(std::move(channel)) {}

    void make();
    void stop();  // and what waits to be said
    void drop();
    void update(double now_s);
    bool playing() const { return channel_->playing(); }
    // What was being said is lost with its device: ends it, so that whoever waits for its end goes on.
    VoiceChannel::Ticket ticket() const { return speakers_[speaker_].ticket; }
    void give_up(VoiceChannel::Ticket spoken);

private:
    // Utterances alternate between two sources, so that a cut one can fade.
    struct Speaker {
        ALuint source = 0;
        VoiceChannel::Ticket ticket = 0;
        bool active = false;
        bool ended = false;  // all samples are queued
        bool ending = false;
        double stop_at_s = 0.0;
        double gain = 1.0;
    };

    static void delete_played(const Speaker& s);
    static void drop_speech(Speaker& s);

    std::shared_ptr<VoiceChannel> channel_;
    std::array<Speaker, 2> speakers_{};
    std::size_t speaker_ = 0;  // the one in use
};

}  // namespace handrail
