#include "app/main/typed_keys.h"

#include <unistd.h>

#include <cstdlib>
#include <utility>

#include "worlds/base/language.h"

namespace handrail::program {
namespace {

// If the same key arrives again within this time, the key is assumed to be held down. The Linux console repeats eleven
// times a second, other terminals faster, and nobody taps a key so fast on purpose.
constexpr double kRepeats_s = 0.1;

std::string_view terminal_kind() {
    const char* kind = std::getenv("TERM");
    return kind ? kind : "";
}

// Writes to the terminal, which accepts a few characters without waiting.
void show(std::string_view text) {
    while (!text.empty()) {
        const ssize_t put = ::write(STDOUT_FILENO, text.data(), text.size());
        if (put <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(put));
    }
}

}  // namespace

std::unique_ptr<TypedKeys> TypedKeys::open(core::Session& app, WorldVisits& worlds, servo::ServoSwitches& switches,
                                           Clock& clock) {
    if (terminal_kind().empty() || terminal_kind() == "dumb") return nullptr;
    auto terminal = terminal::RawTerminal::take(STDIN_FILENO, STDOUT_FILENO);
    if (!terminal) return nullptr;
    return std::unique_ptr<TypedKeys>(new TypedKeys(std::move(terminal), app, worlds, switches, clock));
}

TypedKeys::TypedKeys(std::unique_ptr<terminal::RawTerminal> terminal, core::Session& app, WorldVisits& worlds,
                     servo::ServoSwitches& switches, Clock& clock)
    : app_(app),
      acts_(app, worlds),
      lines_(app, worlds, true),
      terminal_(std::move(terminal)),
      keys_(STDIN_FILENO, terminal::terminal_keyboard(spoken_language(), terminal_kind(), terminal_->erase()), clock,
            [keys = app.keys(), &switches](const std::string& key) {
                if (keys.find(key) != core::Command::StopEverything) return false;
                switches.stop();
                return true;
            }) {}

void TypedKeys::take(double now_s, wizard::WizardSession* wizard) {
    closed_ = closed_ || keys_.ended();
    bool emptied = false;
    const std::vector<terminal::TimedInput> came = keys_.take(emptied);
    if (emptied) {
        lines_.lines().drop();
        show(editor_.close());
    }
    for (const terminal::TimedInput& one : came) take_input(one, wizard, now_s);
    lines_.take(now_s, wizard);
}

void TypedKeys::take_input(const terminal::TimedInput& came, wizard::WizardSession* wizard, double now_s) {
    // The line was for the answer to a question. Another input has answered the question, or left it, so close the
    // line.
    if (editor_.is_open() && answers_ && !question_open(wizard)) show(editor_.close());
    if (!editor_.is_open()) {
        const terminal::TerminalInput& input = came.input;
        if (question_open(wizard) && (!input.text.empty() || input.key == "Enter" || input.key == "Backspace")) {
            answers_ = true;
            show(editor_.open());
        } else if (input.pasted || input.text == ":") {
            answers_ = false;
            show(editor_.open(":"));
            if (!input.pasted) return;
        }
    }
    if (editor_.is_open() && take_into_line(came.input, wizard, now_s)) return;
    if (!came.input.key.empty() || !came.input.text.empty()) take_key(came, wizard, now_s);
}

bool TypedKeys::take_into_line(const terminal::TerminalInput& input, wizard::WizardSession* wizard, double now_s) {
    terminal::LineEditor::Reply reply = editor_.take(input);
    show(reply.echo);
    for (std::string& line : reply.lines) {
        // Apply the answer to a question at once; other lines wait until a walk ends.
        if (question_open(wizard)) app_.apply(core::LineTyped{line}, now_s);
        else lines_.lines().add(std::move(line));
    }
    if (reply.left && answers_ && question_open(wizard))
        acts_.take({"Escape", window::KeyAction::Press}, wizard, now_s);
    return reply.taken;
}

void TypedKeys::take_key(const terminal::TimedInput& came, wizard::WizardSession* wizard, double now_s) {
    const std::string& key = came.input.key;
    const bool held = !key.empty() && key == last_key_ && came.at_s - last_key_s_ < kRepeats_s;
    last_key_ = key;
    last_key_s_ = came.at_s;
    // A newly pressed key discards the typed lines that are still waiting.
    if (!held) lines_.lines().drop();
    const auto command = app_.keys().find(key);
    const bool again =
        held && !wizard && !app_.dialogue().is_open() && command && core::info(*command).hold && app_.idle();
    if (held && !again) {
        acts_.take({key, window::KeyAction::Repeat}, wizard, now_s);
    } else {
        acts_.take({key, window::KeyAction::Press}, wizard, now_s);
    }
    if (!came.input.text.empty()) acts_.take_text(came.input.text, wizard, now_s);
    if (!held || again) acts_.take({key, window::KeyAction::Release}, wizard, now_s);
}

}  // namespace handrail::program
