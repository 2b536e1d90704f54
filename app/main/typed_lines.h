// What a person or a script types line by line when there is no window. App thread; the word for the stop key, typed at
// a terminal, acts on the line watch's thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/main/program_lines.h"
#include "app/terminal/line_watch.h"
#include "haptic/servo/servo_switches.h"

namespace handrail::program {

class TypedLines {
public:
    // All of these outlive this object. It reads standard input from its construction on; the lines of `before` come
    // first.
    TypedLines(core::Session& app, WorldVisits& worlds, servo::ServoSwitches& switches,
               const std::vector<std::string>& before = {});

    // Call once a frame. Input goes to the wizard if it is not null. While a hand is searched for, the end of the lines
    // does not end the session.
    void take(double now_s, wizard::WizardSession* wizard, bool hand_is_sought);
    // True if the person left, or if there are no more lines and nothing is awaited.
    bool closed() const { return closed_ || lines_.left(); }
    // Lines that were read but not yet carried out, for the next reader.
    std::vector<std::string> take_rest();

private:
    bool stops_at_once(std::string_view line);

    core::Session& app_;
    servo::ServoSwitches& switches_;
    const bool typed_;  // standard input is a terminal
    ProgramLines lines_;
    bool closed_ = false;
    terminal::LineWatch watch_;  // last: its thread uses the others
};

}  // namespace handrail::program
