// The keys of a terminal, acting at once as those of the window do, and words typed behind a colon. A key of a terminal
// never goes up, so each is a tap; one that comes again and again, as a held key makes it, acts again only when what it
// began is over. App thread; the stop key acts on the terminal keys' own.
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

namespace handrail {

class TypedKeys {
public:
    // Null where standard input and output are no terminal, or one that knows no keys (TERM=dumb), as those of editors
    // are. All outlive this object; the terminal is given back when it ends.
    static std::unique_ptr<TypedKeys> open(Session& app, WorldVisits& worlds, ServoSwitches& switches, Clock& clock);

    // Once a frame. To the wizard, where there is one.
    void take(double now_s, WizardSession* wizard);
    // The person left, or the terminal has gone.
    bool closed() const { return closed_ || acts_.closed() || lines_.left(); }

private:
    TypedKeys(std::unique_ptr<RawTerminal> terminal, Session& app, WorldVisits& worlds, ServoSwitches& switches,
              Clock& clock);
    void take_input(const TimedInput& came, WizardSession* wizard, double now_s);
    bool take_into_line(const TerminalInput& input, WizardSession* wizard, double now_s);
    void take_key(const TimedInput& came, WizardSession* wizard, double now_s);
    bool asked(const WizardSession* wizard) const { return !wizard && app_.dialogue().typing(); }

    Session& app_;
    KeyActs acts_;
    ProgramLines lines_;
    LineEditor editor_;
    bool answers_ = false;  // the line that is open answers a question of the session
    std::string last_key_;
    double last_key_s_ = 0.0;
    bool closed_ = false;
    std::unique_ptr<RawTerminal> terminal_;
    TerminalKeys keys_;  // last: its thread uses the switches
};

}  // namespace handrail
