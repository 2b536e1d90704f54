// Reads the keys of a terminal, which act at once like the keys of the window, and words that the person types after a
// colon. A terminal never reports that a key was released, so each key is treated as a tap. A held key repeats, and
// then acts again only after the action that it began has ended. App thread; the stop key acts on the thread of
// terminal::TerminalKeys.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "app/main/key_acts.h"
#include "app/main/program_lines.h"
#include "app/terminal/line_editor.h"
#include "app/terminal/raw_terminal.h"
#include "app/terminal/terminal_keys.h"
#include "haptic/servo/servo_switches.h"
#include "worlds/base/clock.h"

namespace handrail::program {

class TypedKeys {
public:
    // Returns null if standard input or output is no terminal, or if the terminal supports no keys (TERM=dumb), as in
    // editors. All arguments must outlive the object. Its destructor restores the terminal.
    static std::unique_ptr<TypedKeys> open(core::Session& app, WorldVisits& worlds, servo::ServoSwitches& switches,
                                           Clock& clock);

    // Call once a frame. If `wizard` is not null, it receives the input.
    void take(double now_s, wizard::WizardSession* wizard);
    // Returns true if the person left, or if the terminal was closed.
    bool closed() const { return closed_ || acts_.closed() || lines_.left(); }

private:
    TypedKeys(std::unique_ptr<terminal::RawTerminal> terminal, core::Session& app, WorldVisits& worlds,
              servo::ServoSwitches& switches, Clock& clock);
    void take_input(const terminal::TimedInput& came, wizard::WizardSession* wizard, double now_s);
    bool take_into_line(const terminal::TerminalInput& input, wizard::WizardSession* wizard, double now_s);
    void take_key(const terminal::TimedInput& came, wizard::WizardSession* wizard, double now_s);
    bool question_open(const wizard::WizardSession* wizard) const { return !wizard && app_.dialogue().typing(); }

    core::Session& app_;
    KeyActs acts_;
    ProgramLines lines_;
    terminal::LineEditor editor_;
    bool answers_ = false;  // true if the open line is the answer to a question of the session
    std::string last_key_;
    double last_key_s_ = 0.0;
    bool closed_ = false;
    std::unique_ptr<terminal::RawTerminal> terminal_;
    terminal::TerminalKeys keys_;  // declared last, because its thread uses the switches
};

}  // namespace handrail::program
