// Runs a private speech-dispatcher for the test. Its only voice is the recording module.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/child_process.h"
#include "tests/support/names.h"

namespace handrail::test {

// One event that the recording module wrote.
struct Recorded {
    double time_s = 0.0;  // time of std::chrono::steady_clock
    std::string event;    // "speak", "end" or "stop"
    std::string words;
};

class SpeechServer {
public:
    // Starts the server in `folder`. Each word takes `word_ms` milliseconds. Check installed("speech-dispatcher")
    // first.
    static std::unique_ptr<SpeechServer> start(const std::filesystem::path& folder, int word_ms);

    Environment environment() const;  // variables that make a client connect to this server
    bool running() const { return process_ && process_->running(); }
    void kill() { process_->kill(); }
    void freeze() const;  // afterwards the server accepts connections but does not answer
    bool start_again();   // call this only after kill()
    std::vector<Recorded> recorded() const;
    bool spoke(const std::string& words) const;  // returns true if an utterance contains these words
    std::string everything() const;              // text for messages of failing tests

private:
    SpeechServer(std::filesystem::path folder, int word_ms) : folder_(std::move(folder)), word_ms_(word_ms) {}

    std::filesystem::path folder_;
    int word_ms_;
    std::unique_ptr<ChildProcess> process_;
};

}  // namespace handrail::test
