// Starts a program of ours as a person's shell would: a home of its own, no display, no screen reader, its words on
// standard output.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace handrail::test {

struct ProgramRun {
    int exit_status = -1;  // 128 + signal number when a signal ended it
    std::string out, err;
    bool timed_out = false;  // it was killed after the time allowed
};

struct ProgramCall {
    std::string program;  // its path
    std::vector<std::string> arguments;
    std::string input;                               // fed to standard input, then closed
    bool close_input = true;                         // false: standard input stays open until the program ends
    std::map<std::string, std::string> environment;  // set on top; an empty value removes
    int signal_when_said = 0;                        // sent once `signal_after` stands in the output
    std::string signal_after;
    double allowed_s = 600.0;  // for a busy machine; only a program that hangs takes that long
    bool first_start =
        false;           // true: of somebody who never started the program before, and is led through the first minutes
    bool voice = false;  // true: the program's own voice speaks too, into no sound device, which takes as long as it
                         // takes to say
};

// What a program of ours sees when nothing is there: no display, no screen reader, no speech server, a null sound
// device, this home, where the first minutes are over and, unless `voice`, text alone speaks, since a voice that nobody
// hears makes every test wait for its words (a settings file says so).
std::map<std::string, std::string> bare_environment(const std::string& home, bool voice = false);

// Sound goes to a null device (ALSOFT_DRIVERS=null) and HOME is a fresh folder unless the call says otherwise.
ProgramRun run_program(const ProgramCall& call);

}  // namespace handrail::test
