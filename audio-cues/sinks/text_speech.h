// Writes speech as text, which is always on. It writes one UTF-8 line per announcement, with "say: " or "alert: " in
// front and no cursor movement, so that screen readers on a console, braille displays, pipes and logs can use it. One
// thread (the audio thread).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "audio-cues/plan/sinks.h"

namespace handrail::sinks {

// Writes each line at once, unbuffered, to a file descriptor that the caller keeps open (standard output: 1). Never
// waits and never raises SIGPIPE. If the reader of the output is slow, the sink keeps up to kMostBacklog bytes for
// later ticks and drops further lines. If the reader has gone, the sink writes nothing more.
class TextSpeech final : public cues::SpeechSink {
public:
    static constexpr std::size_t kMostBacklog = 64 * 1024;

    explicit TextSpeech(int file_descriptor) : fd_(file_descriptor) {}
    ~TextSpeech() override;  // waits at most 0.2 s for a slow reader
    TextSpeech(const TextSpeech&) = delete;
    TextSpeech& operator=(const TextSpeech&) = delete;

    void say(const cues::Utterance& utterance) override { write(utterance); }
    void write(const cues::Utterance& utterance) override;
    void stop() override {}
    bool speaking() const override { return false; }
    void tick(double now_s) override;

    bool reader_left() const { return reader_left_; }

private:
    void drain(int timeout_ms);

    int fd_;
    bool reader_left_ = false;
    std::string backlog_;
};

// Passes everything to several sinks, in order.
class TeeSpeech final : public cues::SpeechSink {
public:
    explicit TeeSpeech(std::vector<std::unique_ptr<cues::SpeechSink>> sinks) : sinks_(std::move(sinks)) {}

    void say(const cues::Utterance& utterance) override;
    void write(const cues::Utterance& utterance) override;
    void stop() override;
    bool speaking() const override;  // true if any of the sinks speaks
    void tick(double now_s) override;
    void set_speech(const settings::Settings::Speech& settings) override;
    std::optional<std::string> news() override;

private:
    std::vector<std::unique_ptr<cues::SpeechSink>> sinks_;
};

}  // namespace handrail::sinks
