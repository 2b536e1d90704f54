// The voice that the person has set up for their desktop: speech-dispatcher, with its own voice, rate and pitch. It
// plays the sound itself. libspeechd waits for the server's answers, with a faulty sound set-up for ever. It is
// therefore called only on a separate thread, and a watchdog in tick() cuts a connection that does not answer. All
// functions return at once.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "audio-cues/sinks/voice.h"

namespace handrail::sinks {

// Owned and called by the audio thread.
class SpeechdSpeech final : public Voice {
public:
    // After a call without an answer for this long, the server counts as gone.
    static constexpr double kStalled_s = 1.0;
    static constexpr double kFirstRetry_s = 1.0;  // after a loss; doubled with every failure
    static constexpr double kSlowestRetry_s = 30.0;

    // If the person names a server (SPEECHD_ADDRESS), only that one is used. Otherwise it uses the default one, and
    // starts it if it does not run. Reads the environment, so call it before other threads change the environment.
    explicit SpeechdSpeech(const settings::Settings::Speech& settings);
    // Waits at most half a second for the server. A thread that still waits then is left behind and ends when it can.
    ~SpeechdSpeech() override;
    SpeechdSpeech(const SpeechdSpeech&) = delete;
    SpeechdSpeech& operator=(const SpeechdSpeech&) = delete;

    settings::SpeechThrough through() const override { return settings::SpeechThrough::SpeechDispatcher; }
    VoiceState state() const override;
    void want(bool wanted) override;

    void say(const cues::Utterance& utterance) override;
    void stop() override;
    bool speaking() const override;
    std::optional<std::string> news() override;
    void tick(double now_s) override;
    void set_speech(const settings::Settings::Speech& settings) override;

private:
    struct Shared;
    struct Worker;
    static void work(const std::shared_ptr<Shared>& shared);

    std::shared_ptr<Shared> shared_;
    std::thread thread_;
    std::uint64_t watched_call_ = 0;  // the unanswered call that tick() saw last, and when it first saw it
    double watched_since_s_ = 0.0;
    double now_s_ = 0.0;
    double speaks_until_s_ = 0.0;  // limit for a server that never reports the end
};

}  // namespace handrail::sinks
