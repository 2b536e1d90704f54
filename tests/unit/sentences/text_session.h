// Simulates a person who only types lines and reads the announcements. Runs the whole session in virtual time, without
// a device and without sound. Each line waits until everything that the previous line began has ended, as in a
// line-based terminal.
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
    // If `first_start` is true, the session leads the person through the first minutes before it greets the person with
    // the world.
    explicit TextSession(std::shared_ptr<const Scene> world, bool first_start = false);
    ~TextSession();
    TextSession(const TextSession&) = delete;
    TextSession& operator=(const TextSession&) = delete;

    // Types a line. Returns the announcements until the session is quiet. If the line is no command, returns the answer
    // that the terminal would give. greeting() returns the announcements before the first line.
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
