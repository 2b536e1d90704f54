#include "app/core/session/carried_lines.h"

#include <iterator>
#include <utility>

#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/terminal_line.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kSettles_s = 0.2;

// Returns true if the command takes a count and makes all steps or notches at once. If such a command were repeated
// instead, it would continue after the first step has met something.
bool counts_by_itself(Command command) {
    return is_one_of(command, {Command::TrailLeft, Command::TrailRight, Command::Retrace}) || steps_or_turns(command);
}

}  // namespace

void CarriedLines::drop() {
    lines_.clear();
    repeat_left_ = 0;
}

std::vector<std::string> CarriedLines::take_rest() {
    std::vector<std::string> rest(std::make_move_iterator(lines_.begin()), std::make_move_iterator(lines_.end()));
    drop();
    return rest;
}

std::optional<std::string> CarriedLines::take_next() {
    if (lines_.empty()) return std::nullopt;
    std::string line = std::move(lines_.front());
    lines_.pop_front();
    return line;
}

bool CarriedLines::next_leaves() const {
    if (lines_.empty()) return false;
    const auto parsed = parse_terminal_line(lines_.front());
    return parsed && (parsed->leave || parsed->command == Command::Leave);
}

bool CarriedLines::take(double now_s) {
    // Waits until directions have been planned, unless the next line leaves the program.
    if (repeat_left_ == 0 && (!app_.idle() || (app_.guide().plans_legs() && !next_leaves()))) {
        // After the planning, wait a little longer, so that the result is spoken before the next line interrupts it.
        settle_until_s_ = now_s + kSettles_s;
        return true;
    }
    if (now_s < settle_until_s_) return true;
    if (repeat_left_ > 0) {
        --repeat_left_;
        tap(repeat_command_, 1, now_s);
        return true;
    }
    const auto line = take_next();
    if (!line) return false;
    carry_out(*line, now_s);
    return true;
}

void CarriedLines::carry_out(const std::string& line, double now_s) {
    const auto parsed = parse_terminal_line(line);
    // The session knows a command only by its word in the command table. A command that always acts is preferred to a
    // name in a list.
    const std::string word = parsed && parsed->command ? std::string(info(*parsed->command).word) : line;
    const bool always = parsed && parsed->command && in_list(*parsed->command) == InList::Always;
    // If the open list cannot use a command or question, this function closes the list. The command is then carried
    // out.
    if (parsed && parsed->command && in_list(*parsed->command) == InList::Waits && app_.dialogue().is_open() &&
        !app_.dialogue().typing() && !app_.dialogue().has_use_for(line))
        app_.apply(ListsLeft{}, now_s);
    if (app_.apply(LineTyped{always ? word : line}, now_s)) return;
    if (!always && word != line && app_.apply(LineTyped{word}, now_s)) return;
    if (!parsed) {
        const std::string hint = app_.question_hint(line);
        return void(app_.apply(Announcement{hint.empty() ? parsed.error().message : parsed.error().message + " " + hint,
                                            cues::SpeechClass::Answer},
                               now_s));
    }
    if (parsed->leave) {
        left_ = true;
    } else if (parsed->command) {
        repeat_command_ = *parsed->command;
        const bool counts = counts_by_itself(repeat_command_);
        repeat_left_ = counts ? 0 : parsed->times - 1;
        tap(repeat_command_, counts ? parsed->times : 1, now_s);
    }
}

void CarriedLines::tap(Command command, int times, double now_s) {
    app_.apply(CommandDown{command, times}, now_s);
    app_.apply(CommandUp{command}, now_s);
    // A simulated hand needs a moment to arrive at its target.
    if (command >= Command::HandForward && command <= Command::HandCentre) settle_until_s_ = now_s + kSettles_s;
}

}  // namespace handrail::core
