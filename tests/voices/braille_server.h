// A BRLTTY of the test's own with a display that is only a socket: what stands on it can be read, and its keys pressed.
// For tests on one thread.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "tests/support/child_process.h"

namespace handrail::test {

class BrailleServer {
public:
    static constexpr int kCells = 40;

    // Why it cannot be had here; empty: it can.
    static std::string why_not();
    // In `folder`, with its display; running() is false when one of them does not start.
    explicit BrailleServer(const std::filesystem::path& folder);
    ~BrailleServer();
    BrailleServer(const BrailleServer&) = delete;
    BrailleServer& operator=(const BrailleServer&) = delete;

    Environment environment() const;  // leads a client here
    bool running() const { return process_ && process_->running() && display_ >= 0; }
    void kill();         // the server, and its display with it
    bool start_again();  // after kill()
    bool unplug_display_and_plug_in_another();

    // What stands on the display now, without blanks at its end.
    std::string shown();
    bool shows(const std::string& words);          // within a minute
    void press(const std::string& command) const;  // BRLTTY's name of it: "FWINRT", "ROUTE 7"
    std::string everything() const;

private:
    bool connect_display();

    std::filesystem::path folder_;
    int port_ = 0;  // BrlAPI's, above its base
    std::unique_ptr<ChildProcess> process_;
    int display_ = -1;
    std::string received_, shown_;
};

}  // namespace handrail::test
