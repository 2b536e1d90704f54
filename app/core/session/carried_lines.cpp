#include "app/core/session/carried_lines.h"

#include <iterator>
#include <utility>

#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/terminal_line.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

constexpr double kSettles_s = 0.2;

// So many steps or notches at once: a second one is no answer to what the first met.
bool counts_by_itself(Command command) {
    return is_one_of(command, {Command::TrailLeft, Command::TrailRight, Command::Retrace}) || steps_or_turns(command);
}

// Where else what is not in the list of that command may be.
std::optional<Command> other_list(Command command) {
    if (command == Command::Find) return Command::Routes;
    if (command == Command::Routes) return Command::Find;
    return std::nullopt;
}

}  // namespace

void CarriedLines::drop() {
    lines_.clear();
    repeat_left_ = 0;
    choice_.clear();
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
    // Directions that are still being planned are waited for, too, but not to leave.
    if (repeat_left_ == 0 && (!app_.idle() || (app_.guide().plans_legs() && !next_leaves()))) {
        settle_until_s_ = now_s + kSettles_s;  // what came of it wants to be said before the next line interrupts
        return true;
    }
    if (now_s < settle_until_s_) return true;
    if (repeat_left_ > 0) {
        --repeat_left_;
        tap(repeat_command_, 1, now_s);
        return true;
    }
    if (const std::string choice = std::exchange(choice_, {}); !choice.empty() && app_.dialogue().is_open()) {
        choose(choice, now_s);
        return true;
    }
    const auto line = take_next();
    if (!line) return false;
    carry_out(*line, now_s);
    return true;
}

// In the list that the last command opened. What is not there may be in the other list: a room is no thing, and a thing
// is no room. What is in neither closes the list, which nobody asked for.
void CarriedLines::choose(const std::string& choice, double now_s) {
    const bool holds = app_.dialogue().holds(choice);
    const auto other = other_list(repeat_command_);
    if (other && !looked_elsewhere_ && (!holds || means_room(choice))) {
        looked_elsewhere_ = true;
        app_.apply(ListsLeft{}, now_s);
        repeat_command_ = *other;
        choice_ = choice;
        return tap(*other, 1, now_s);
    }
    if (holds) return void(app_.apply(LineTyped{choice}, now_s));
    app_.apply(ListsLeft{}, now_s);
    app_.apply(Told{phrase("terminal.not_found", {{"typed", choice}, {"word", asked_by_}}), SpeechClass::Answer},
               now_s);
}

// "Where is the kitchen" asks for the room of that name, not for the kitchen counter.
bool CarriedLines::means_room(const std::string& choice) const {
    return repeat_command_ == Command::Find && !app_.dialogue().holds(choice, true) && app_.guide().leads_to(choice);
}

void CarriedLines::carry_out(const std::string& line, double now_s) {
    const auto parsed = parse_terminal_line(line);
    // The session knows a command by the word of the table alone. What always works comes before the
    // names of a list.
    const std::string word = parsed && parsed->command ? std::string(info(*parsed->command).word) : line;
    const bool always = parsed && parsed->command && in_list(*parsed->command) == InList::Always;
    // A command or question that the open list has no use for is carried out as if the list were closed.
    if (parsed && parsed->command && in_list(*parsed->command) == InList::Waits && app_.dialogue().is_open() &&
        !app_.dialogue().typing() && !app_.dialogue().has_use_for(line))
        app_.apply(ListsLeft{}, now_s);
    if (app_.apply(LineTyped{always ? word : line}, now_s)) return;
    if (!always && word != line && app_.apply(LineTyped{word}, now_s)) return;
    if (!parsed) return void(app_.apply(Told{parsed.error().message, SpeechClass::Answer}, now_s));
    if (parsed->leave) {
        left_ = true;
    } else if (parsed->command) {
        repeat_command_ = *parsed->command;
        choice_ = parsed->choice;
        asked_by_ = spoken_word(repeat_command_);
        looked_elsewhere_ = false;
        const bool counts = counts_by_itself(repeat_command_);
        repeat_left_ = counts ? 0 : parsed->times - 1;
        tap(repeat_command_, counts ? parsed->times : 1, now_s);
    }
}

void CarriedLines::tap(Command command, int times, double now_s) {
    app_.apply(CommandDown{command, times}, now_s);
    app_.apply(CommandUp{command}, now_s);
    // A hand that was told to move needs a moment to be there.
    if (command >= Command::HandForward && command <= Command::HandCentre) settle_until_s_ = now_s + kSettles_s;
}

}  // namespace handrail
