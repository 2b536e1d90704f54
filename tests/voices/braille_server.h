// Runs a private BRLTTY for the test, whose display is a socket. The test can read the displayed text and press the
// display's keys. Only one thread may use the object.
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

    // Returns why BRLTTY cannot run on this machine; empty if it can.
    static std::string why_not();
    // Starts BRLTTY and its display in `folder`. If BRLTTY or the display does not start, running() returns false.
    explicit BrailleServer(const std::filesystem::path& folder);
    ~BrailleServer();
    BrailleServer(const BrailleServer&) = delete;
    BrailleServer& operator=(const BrailleServer&) = delete;

    Environment environment() const;  // variables that make a client connect to this server
    bool running() const { return process_ && process_->running() && display_ >= 0; }
    void kill();         // kills the server and its display
    bool start_again();  // call this only after kill()
    bool unplug_display_and_plug_in_another();

    // Returns the text on the display, without trailing blanks.
    std::string shown();
    bool shows(const std::string& words);          // waits up to a minute until the display shows `words`
    void press(const std::string& command) const;  // `command` is a name of BRLTTY, such as "FWINRT" or "ROUTE 7"
    std::string everything() const;

private:
    bool connect_display();

    std::filesystem::path folder_;
    int port_ = 0;  // number of BrlAPI's server: its port minus kBrlApiPort
    std::unique_ptr<ChildProcess> process_;
    int display_ = -1;
    std::string received_, shown_;
};

}  // namespace handrail::test
