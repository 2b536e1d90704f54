// A private BRLTTY for the test, with a socket as its display. The test can read the displayed text and press the
// display's keys. For tests on one thread.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "tests/support/child_process.h"
#include "tests/support/names.h"

namespace handrail::test {

class BrailleServer {
public:
    static constexpr int kCells = 40;

    // Why BRLTTY cannot run here; empty: it can.
    static std::string why_not();
    // Runs in `folder`, with its display. running() is false if one of the two does not start.
    explicit BrailleServer(const std::filesystem::path& folder);
    ~BrailleServer();
    BrailleServer(const BrailleServer&) = delete;
    BrailleServer& operator=(const BrailleServer&) = delete;

    Environment environment() const;  // makes a client connect to this server
    bool running() const { return process_ && process_->running() && display_ >= 0; }
    void kill();         // kills the server and its display
    bool start_again();  // to be called after kill()
    bool unplug_display_and_plug_in_another();

    // The text on the display, without trailing blanks.
    std::string shown();
    bool shows(const std::string& words);          // within a minute
    void press(const std::string& command) const;  // BRLTTY's name of the command: "FWINRT", "ROUTE 7"
    std::string everything() const;

private:
    bool connect_display();

    std::filesystem::path folder_;
    int port_ = 0;  // BrlAPI's port, relative to its base
    std::unique_ptr<ChildProcess> process_;
    int display_ = -1;
    std::string received_, shown_;
};

}  // namespace handrail::test
