// A speech-dispatcher of the test's own with the recording module as its only voice.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/child_process.h"

namespace handrail::test {

// What the recording module wrote down.
struct Recorded {
    double time_s = 0.0;  // std::chrono::steady_clock
    std::string event;    // "speak", "end" or "stop"
    std::string words;
};

class SpeechServer {
public:
    // In `folder`, with so many milliseconds for each word. Ask installed("speech-dispatcher") first.
    static std::unique_ptr<SpeechServer> start(const std::filesystem::path& folder, int word_ms);

    Environment environment() const;  // leads a client here
    bool running() const { return process_ && process_->running(); }
    void kill() { process_->kill(); }
    void freeze() const;  // it takes connections and answers nothing
    bool start_again();   // after kill()
    std::vector<Recorded> recorded() const;
    bool spoke(const std::string& words) const;  // some utterance holds these words
    std::string everything() const;              // for messages of failing tests

private:
    SpeechServer(std::filesystem::path folder, int word_ms) : folder_(std::move(folder)), word_ms_(word_ms) {}

    std::filesystem::path folder_;
    int word_ms_;
    std::unique_ptr<ChildProcess> process_;
};

}  // namespace handrail::test
