// What a person or a script types line by line, where there is no window. App thread; the word for the stop key, typed
// at a terminal, acts on the line watch's own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/main/program_lines.h"
#include "app/terminal/line_watch.h"
#include "haptic/servo/servo_switches.h"

namespace handrail {

class TypedLines {
public:
    // All outlive this object. Reads standard input from its construction on; `before` comes before that.
    TypedLines(Session& app, WorldVisits& worlds, ServoSwitches& switches, const std::vector<std::string>& before = {});

    // Once a frame. To the wizard, where there is one. While a hand is sought the end of the lines does not end the
    // session.
    void take(double now_s, WizardSession* wizard, bool hand_is_sought);
    // The person left, or there are no more lines and nothing to wait for.
    bool closed() const { return closed_ || lines_.left(); }
    // What was read and is not done yet, for whoever reads on.
    std::vector<std::string> take_rest();

private:
    bool stops_at_once(std::string_view line);

    Session& app_;
    ServoSwitches& switches_;
    const bool typed_;  // at a terminal
    ProgramLines lines_;
    bool closed_ = false;
    LineWatch watch_;  // last: its thread uses the others
};

}  // namespace handrail
