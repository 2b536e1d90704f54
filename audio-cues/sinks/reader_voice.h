// Makes the person's own screen reader a voice. The reader reads the text in the window's accessible objects, so this
// code only passes text on. ReaderVoice puts the text into a ReaderChannel on the audio thread. The owner of the
// accessible objects takes it out on its own thread.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "audio-cues/sinks/voice.h"

namespace handrail::sinks {

// Contains only the newest message, so a message that was not taken before the next one came is never read. An alarm is
// replaced only by another alarm. Any thread; each call holds a mutex for microseconds.
class ReaderChannel {
public:
    // Functions for ReaderVoice.
    void want(bool wanted);
    VoiceState state() const;
    void say(const cues::Utterance& utterance);
    void stop();

    // Functions for the owner of the accessible objects.
    bool wanted() const;
    void set_state(VoiceState state);
    std::optional<std::string> take();
    // Sets a function that is called when the state of the channel changes, on the thread that changed it. During the
    // call, only call_mutex_ is locked. An empty function removes the old one.
    void on_change(std::function<void()> call);

private:
    void changed();

    mutable std::mutex mutex_;  // protects all members below
    bool wanted_ = false;
    VoiceState state_ = VoiceState::Unavailable;
    std::optional<cues::Utterance> waiting_;
    std::mutex call_mutex_;  // protects call_
    std::function<void()> call_;
};

// The audio thread owns and calls it.
class ReaderVoice final : public Voice {
public:
    // How long the first text waits for the reader, which notices the window only after the window has had the keyboard
    // focus for a moment.
    static constexpr double kPatience_s = 3.0;
    // Start time and time per letter at a brisk rate. A screen reader does not report when it has finished, so the
    // duration is estimated from the number of letters. If the estimate is too short, the reader only queues the next
    // text itself.
    static constexpr double kStart_s = 0.3;
    static constexpr double kLetter_s = 0.045;

    explicit ReaderVoice(std::shared_ptr<ReaderChannel> channel) : channel_(std::move(channel)) {}
    ~ReaderVoice() override { channel_->want(false); }
    ReaderVoice(const ReaderVoice&) = delete;
    ReaderVoice& operator=(const ReaderVoice&) = delete;

    settings::SpeechThrough through() const override { return settings::SpeechThrough::ScreenReader; }
    VoiceState state() const override { return channel_->state(); }
    void want(bool wanted) override { channel_->want(wanted); }
    double patience_s() const override { return kPatience_s; }

    void say(const cues::Utterance& utterance) override;
    // Withdraws the text that has not been read yet. The key with which the person requests silence also stops the
    // reading itself, because the reader receives every key first.
    void stop() override;
    bool speaking() const override { return now_s_ < speaks_until_s_; }
    void tick(double now_s) override { now_s_ = now_s; }

private:
    std::shared_ptr<ReaderChannel> channel_;
    double now_s_ = 0.0;
    double speaks_until_s_ = 0.0;
};

}  // namespace handrail::sinks
