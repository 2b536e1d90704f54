// The person's own screen reader as a voice. It reads what it finds in the accessible objects of the window, so the
// words only pass through here: ReaderVoice puts them into a ReaderChannel on the audio thread, and whoever owns the
// objects takes them out on a thread of its own.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "audio-cues/sinks/voice.h"

namespace handrail {

// Holds one message, the newest: what was not taken before the next came is not read. An alarm is replaced by an alarm
// only. Any thread; each call holds a mutex for microseconds.
class ReaderChannel {
public:
    // The voice's side.
    void want(bool wanted);
    VoiceState state() const;
    void say(const Utterance& utterance);
    void stop();

    // The objects' side.
    bool wanted() const;
    void set_state(VoiceState state);
    std::optional<std::string> take();
    // Called on the thread that changes something, with no lock held but this object's own; an empty function ends
    // that.
    void on_change(std::function<void()> call);

private:
    void changed();

    mutable std::mutex mutex_;  // guards all below
    bool wanted_ = false;
    VoiceState state_ = VoiceState::Gone;
    std::optional<Utterance> waiting_;
    std::mutex call_mutex_;  // guards call_
    std::function<void()> call_;
};

// Owned and called by the audio thread.
class ReaderVoice final : public Voice {
public:
    // The window must have the keyboard for a moment before the reader hears of it.
    static constexpr double kPatience_s = 3.0;
    // A screen reader does not tell when it has ended, so that is guessed: letters at a brisk rate. Too short would
    // only let it keep a queue of its own.
    static constexpr double kStart_s = 0.3;
    static constexpr double kLetter_s = 0.045;

    explicit ReaderVoice(std::shared_ptr<ReaderChannel> channel) : channel_(std::move(channel)) {}
    ~ReaderVoice() override { channel_->want(false); }
    ReaderVoice(const ReaderVoice&) = delete;
    ReaderVoice& operator=(const ReaderVoice&) = delete;

    SpeechThrough through() const override { return SpeechThrough::ScreenReader; }
    VoiceState state() const override { return channel_->state(); }
    void want(bool wanted) override { channel_->want(wanted); }
    double patience_s() const override { return kPatience_s; }

    void say(const Utterance& utterance) override;
    // Takes back what has not been read yet. What is being read stops by the key that asked for silence: the reader
    // hears of every key first.
    void stop() override;
    bool speaking() const override { return now_s_ < speaks_until_s_; }
    void tick(double now_s) override { now_s_ = now_s; }

private:
    std::shared_ptr<ReaderChannel> channel_;
    double now_s_ = 0.0;
    double speaks_until_s_ = 0.0;
};

}  // namespace handrail
