// Speaks with the voice that the person has set up for their desktop: speech-dispatcher, with the voice, rate and pitch
// of the person's own settings. The server plays the sound itself. libspeechd waits for the server's answers, and with
// a faulty sound set-up it waits for ever. It is therefore called only on a separate thread, and tick() cuts a
// connection that does not answer. All functions return at once.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "audio-cues/sinks/voice.h"

namespace handrail::sinks {

// The audio thread owns a SpeechdSpeech and calls its functions.
class SpeechdSpeech final : public Voice {
public:
    // Time without an answer to a call after which the server is treated as gone.
    static constexpr double kStalled_s = 1.0;
    static constexpr double kFirstRetry_s = 1.0;  // time until the first retry after a loss; doubled after each failure
    static constexpr double kSlowestRetry_s = 30.0;

    // If the person names a server (SPEECHD_ADDRESS), only that server is used. Otherwise the default server is used,
    // and started if it does not run. The constructor reads the environment, so create the object before other threads
    // change the environment.
    explicit SpeechdSpeech(const settings::Settings::Speech& settings);
    // Waits at most half a second for the thread. If the thread is still waiting for the server after that, it is left
    // behind and ends when it can.
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
    std::uint64_t watched_call_ = 0;  // the unanswered call that tick() saw last, and the time when tick() first saw it
    double watched_since_s_ = 0.0;
    double now_s_ = 0.0;
    double speaks_until_s_ = 0.0;  // latest end of the utterance, in case the server never reports it
};

}  // namespace handrail::sinks
