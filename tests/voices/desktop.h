// Runs a private desktop of a blind person for the test, isolated from the desktop of the machine. It has a session
// bus, an X server, a speech server that records what it receives, and the screen reader Orca, which speaks through
// that server.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/virtual_display.h"
#include "tests/voices/speech_server.h"

namespace handrail::test {

class Desktop {
public:
    // Returns why the desktop cannot run on this machine; empty if it can. Either a package is missing, or a sanitizer
    // is active. Under a sanitizer, the tests would also judge the time and memory of foreign libraries.
    static std::string why_not();
    // Starts everything except Orca in `folder`. If a part does not start, running() returns false.
    explicit Desktop(const std::filesystem::path& folder, int word_ms = 1);
    ~Desktop();
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    bool running() const { return display && speech && speech->running(); }
    // Starts Orca and waits until Orca says that it is on. `braille` is the environment of a display that Orca uses.
    bool start_orca(const Environment& braille = {});
    void kill_orca() { orca_->kill(); }
    void end_session() { bus_->kill(); }  // ends the bus and everything that was started through it

    // Returns the variables that connect a program to this desktop. If `speech_server` is false, the program finds no
    // speech server.
    Environment environment(bool speech_server) const;
    // Gives the program's window the keyboard focus as soon as the window exists.
    bool focus_window() const;
    bool press(const std::string& keys) const { return display->xdotool("key " + keys); }
    // Returns the program's accessible objects as any screen reader finds them, one on each line, such as `list item
    // "North wall" selected focused`. Two more blanks indent the children of an object.
    std::string objects() const;
    // Runs a Python program with pyatspi, which walks the program's objects as any screen reader does. Returns what it
    // prints.
    std::string query_objects(const std::string& python) const;
    std::string everything() const;  // text for messages of failing tests

    std::unique_ptr<VirtualDisplay> display;
    std::unique_ptr<SpeechServer> speech;

private:
    Environment session() const;
    std::string without_other_orcas() const;

    std::filesystem::path folder_;
    std::unique_ptr<ChildProcess> bus_, orca_;
};

}  // namespace handrail::test
