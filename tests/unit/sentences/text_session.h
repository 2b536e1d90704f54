// A person who only types lines and reads what is said: the whole session in virtual time, without a device and without
// sound. Each line is carried out when what the previous one began is over, as in a line-based terminal.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/core/session/headless_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"

namespace handrail::test {

class TextSession {
public:
    // first_start: the person is led through the first minutes before the world's greeting.
    explicit TextSession(std::shared_ptr<const Scene> world, bool first_start = false);
    ~TextSession();
    TextSession(const TextSession&) = delete;
    TextSession& operator=(const TextSession&) = delete;

    // Returns what is said about a line until all is quiet; greeting() is what was said before the first line. A word
    // that is no command is answered as the terminal answers it.
    std::vector<std::string> type(const std::string& line);
    const std::vector<std::string>& greeting() const { return greeting_; }
    const Session& app() { return session_.app(); }

private:
    void settle();
    std::vector<std::string> take();

    RecordingAudio audio_;
    RecordingSpeech speech_;
    HeadlessSession session_;
    std::size_t taken_ = 0;
    std::vector<std::string> greeting_;
};

}  // namespace handrail::test
