// The voice the person has set up for their desktop: speech-dispatcher, with its own voice, rate and pitch. It plays
// the sound itself. libspeechd waits for answers of the server, and with a bad sound set-up for ever; so it is called
// on a thread of its own only, and a watchdog in tick() cuts a connection that does not answer. Everything here returns
// at once.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "audio-cues/sinks/voice.h"

namespace handrail {

// Owned and called by the audio thread.
class SpeechdSpeech final : public Voice {
public:
    static constexpr double kStalled_s = 1.0;     // a call without an answer for this long: the server counts as gone
    static constexpr double kFirstRetry_s = 1.0;  // after a loss; doubled with every failure
    static constexpr double kSlowestRetry_s = 30.0;

    // Where the person names a server (SPEECHD_ADDRESS) only that one is used; else the default one, which is started
    // where it does not run. Reads the environment: before other threads change it.
    explicit SpeechdSpeech(const Settings::Speech& settings);
    // Waits at most half a second for the server; a thread that is still waiting then is left to end by itself.
    ~SpeechdSpeech() override;
    SpeechdSpeech(const SpeechdSpeech&) = delete;
    SpeechdSpeech& operator=(const SpeechdSpeech&) = delete;

    SpeechThrough through() const override { return SpeechThrough::SpeechDispatcher; }
    VoiceState state() const override;
    void want(bool wanted) override;

    void say(const Utterance& utterance) override;
    void stop() override;
    bool speaking() const override;
    std::optional<std::string> news() override;
    void tick(double now_s) override;
    void set_speech(const Settings::Speech& settings) override;

private:
    struct Shared;
    struct Worker;
    static void work(const std::shared_ptr<Shared>& shared);

    std::shared_ptr<Shared> shared_;
    std::thread thread_;
    std::uint64_t watched_call_ = 0;  // the unanswered call that tick() saw last, and when first
    double watched_since_s_ = 0.0;
    double now_s_ = 0.0;
    double speaks_until_s_ = 0.0;  // a server that never says it has ended is not waited for
};

}  // namespace handrail
