// Starts one of our programs as a person's shell would. It has its own home folder, no display and no screen reader,
// and its words go to standard output.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

struct ProgramRun {
    int exit_status = -1;  // 128 + signal number if a signal ended it
    std::string out, err;
    bool timed_out = false;  // killed after the allowed time
};

struct ProgramCall {
    std::string program;  // its path
    std::vector<std::string> arguments;
    std::string input;        // written to standard input, which is then closed
    bool close_input = true;  // false: standard input stays open until the program ends
    // Set on top of the bare environment; an empty value removes a variable.
    std::map<std::string, std::string> environment;
    int signal_when_said = 0;  // sent once the output contains `signal_after`
    std::string signal_after;
    double allowed_s = 600.0;  // long enough for a busy machine; only a program that hangs takes that long
    bool first_start =
        false;  // True: for a person who has never started the program and is led through the first minutes.
    // True: the program's own voice speaks too, without a sound device. Each sentence takes as long as it takes to say.
    bool voice = false;
};

// The environment of a program that has no display, no screen reader, no speech server and a null sound device. A
// settings file in `home` says that the first minutes are over. Unless `voice` is set, it also says that only text
// speaks, since a voice that nobody hears makes every test wait for its words.
std::map<std::string, std::string> bare_environment(const std::string& home, bool voice = false);

// Sound goes to a null device (ALSOFT_DRIVERS=null), and HOME is a fresh folder unless the call sets it.
ProgramRun run_program(const ProgramCall& call);

}  // namespace handrail::test
