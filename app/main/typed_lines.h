// Reads the lines that a person or a script types when there is no window. App thread. If a person types the word for
// the stop key at a terminal, the word acts on the thread of the LineWatch.
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
    // All arguments must outlive this object. The object reads standard input from its construction on. It carries out
    // the lines in `before` first.
    TypedLines(core::Session& app, WorldVisits& worlds, servo::ServoSwitches& switches,
               const std::vector<std::string>& before = {});

    // Call once a frame. If `wizard` is not null, it receives the input. If `hand_is_sought`, the session does not end
    // at the end of the lines, because a search for a hand is under way.
    void take(double now_s, wizard::WizardSession* wizard, bool hand_is_sought);
    // Returns true if the person left, or if all lines were carried out and the program awaits nothing else.
    bool closed() const { return closed_ || lines_.left(); }
    // Returns the lines that were read but not yet carried out, for the next session.
    std::vector<std::string> take_rest();

private:
    bool stops_at_once(std::string_view line);

    core::Session& app_;
    servo::ServoSwitches& switches_;
    const bool typed_;  // standard input is a terminal
    ProgramLines lines_;
    bool closed_ = false;
    terminal::LineWatch watch_;  // declared last, because its thread uses the other members
};

}  // namespace handrail::program
