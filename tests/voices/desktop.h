// A blind person's desktop of the test's own, with nothing of the machine's in it: a session bus, an X server, a speech
// server that writes down what it is told, and the screen reader Orca, which speaks through that.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "tests/support/child_process.h"
#include "tests/support/virtual_display.h"
#include "tests/voices/speech_server.h"

namespace handrail::test {

class Desktop {
public:
    // Why it cannot be had here: a package that is missing, or a sanitizer, under which time and memory of foreign
    // libraries are not judged. Empty: it can.
    static std::string why_not();
    // In `folder`, without Orca; running() is false when a part does not start.
    explicit Desktop(const std::filesystem::path& folder, int word_ms = 1);
    ~Desktop();
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    bool running() const { return display && speech && speech->running(); }
    bool start_orca(
        const Environment& braille = {});  // until it says that it is on; braille: of a display it is to use
    void kill_orca() { orca_->kill(); }
    void end_session() { bus_->kill(); }  // the bus and all that was started through it

    // What leads a program here; without `speech_server` it finds none.
    Environment environment(bool speech_server) const;
    // Gives the program's window the keyboard once it is there.
    bool focus_window() const;
    bool press(const std::string& keys) const { return display->xdotool("key " + keys); }
    // The program's accessible objects as any reader finds them: a line each, children two blanks further in: `list
    // item "North wall" selected focused`.
    std::string objects() const;
    // What a Python program with pyatspi prints that walks the program's objects as any reader does.
    std::string ask_objects(const std::string& python) const;
    std::string everything() const;  // for messages of failing tests

    std::unique_ptr<VirtualDisplay> display;
    std::unique_ptr<SpeechServer> speech;

private:
    Environment session() const;
    std::string without_other_orcas() const;

    std::filesystem::path folder_;
    std::unique_ptr<ChildProcess> bus_, orca_;
};

}  // namespace handrail::test
