#include "app/main/typed_lines.h"

#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "app/core/dialogue/terminal_line.h"

namespace handrail::program {

TypedLines::TypedLines(core::Session& app, WorldVisits& worlds, servo::ServoSwitches& switches,
                       const std::vector<std::string>& before)
    : app_(app),
      switches_(switches),
      typed_(::isatty(STDIN_FILENO) == 1),
      lines_(app, worlds, typed_),
      watch_(STDIN_FILENO, typed_ ? terminal::LineWatch::WhenFull::Loses : terminal::LineWatch::WhenFull::Waits,
             [this](std::string_view line) { return stops_at_once(line); }) {
    for (const std::string& line : before) lines_.lines().add(line);
}

std::vector<std::string> TypedLines::take_rest() {
    bool emptied = false;
    std::vector<std::string> read = watch_.take(emptied);
    if (emptied) lines_.lines().drop();
    std::vector<std::string> rest = lines_.lines().take_rest();
    rest.insert(rest.end(), std::make_move_iterator(read.begin()), std::make_move_iterator(read.end()));
    return rest;
}

// If a person typed the word for the stop key at a terminal, carries it out at once and returns true. In a file or a
// pipe, the word waits for its turn like any line of a script. Runs on the thread of the LineWatch.
bool TypedLines::stops_at_once(std::string_view line) {
    if (!typed_) return false;
    const auto parsed = core::parse_terminal_line(line);
    if (!parsed || parsed->command != core::Command::StopEverything) return false;
    switches_.stop();
    return true;
}

void TypedLines::take(double now_s, wizard::WizardSession* wizard, bool hand_is_sought) {
    // Query this first, so that take() below certainly returns the lines that arrived before the end.
    const bool ended = watch_.ended();
    bool emptied = false;
    std::vector<std::string> typed =
        watch_.take(emptied, terminal::LineWatch::kMostWaiting -
                                 std::min(lines_.lines().waiting(), terminal::LineWatch::kMostWaiting));
    if (emptied) lines_.lines().drop();
    for (std::string& line : typed) lines_.lines().add(std::move(line));
    if (lines_.take(now_s, wizard) || !ended) return;
    if (wizard) return wizard->end_of_lines();
    // The input has ended, so nobody can answer the welcome any more.
    if (app_.greeting_waits()) return void(app_.apply(core::LessonLeft{}, now_s));
    closed_ = !hand_is_sought;
}

}  // namespace handrail::program
