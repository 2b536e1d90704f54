// Starts one of Handrail's programs as a person's shell would. The program has its own home folder, no display and no
// screen reader, and its spoken text goes to standard output.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

struct ProgramRun {
    int exit_status = -1;  // exit status, or 128 + signal number if a signal ended the program
    std::string out, err;
    bool timed_out = false;  // true if the program was killed after `allowed_s`
};

struct ProgramCall {
    std::string program;  // path of the program
    std::vector<std::string> arguments;
    std::string input;        // text that is written to standard input, which is then closed
    bool close_input = true;  // false: standard input stays open until the program ends
    // Variables that are set in addition to the bare environment. An empty value removes a variable.
    std::map<std::string, std::string> environment;
    int signal_when_said = 0;  // signal that is sent once the output contains `signal_after`; 0: none
    std::string signal_after;
    // Longest running time. It is long enough for a busy machine; only a program that hangs reaches it.
    double allowed_s = 600.0;
    bool first_start =
        // True: the program runs as for a person who has never started it, with the introduction of the first minutes.
        false;
    // True: the program's own voice speaks too, without a sound device. Each sentence then takes as long as speaking
    // it.
    bool voice = false;
};

// Returns the environment of a program that has no display, no screen reader, no speech server and a null sound device.
// A settings file in `home` says that the introduction of the first minutes is done. Unless `voice` is set, the file
// also says that there is only text and no voice, since every test would wait for a voice that nobody hears.
std::map<std::string, std::string> bare_environment(const std::string& home, bool voice = false);

// Runs a program until it ends. Sound goes to a null device (ALSOFT_DRIVERS=null), and HOME is a new folder unless the
// call sets it.
ProgramRun run_program(const ProgramCall& call);

}  // namespace handrail::test
