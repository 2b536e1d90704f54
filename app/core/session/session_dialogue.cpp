// The part of Session that passes keys and typed lines to lists and questions, and announces their replies. Use it on
// the app thread only.
#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/terminal_line.h"
#include "app/core/dialogue/typed_sentences.h"
#include "app/core/session/session.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

// Returns true if the line is the word of a command, perhaps with a count or a choice, or a whole sentence for a
// command.
bool is_command_line(std::string_view line) {
    const auto parsed = parse_terminal_line(line);
    if (!parsed || (!parsed->leave && !parsed->command)) return false;
    return parsed->choice.empty() || command_of_word(line.substr(0, line.find_first_of(" \t"))) == parsed->command;
}

}  // namespace

bool Session::reply(const DialogueReply& reply, double now_s) {
    if (!reply.taken) return false;
    if (reply.denied) play(cues::SoundKind::Denied, now_s);
    if (reply.answer) state_.events.report(Answered{reply.answer->question, reply.answer->text}, now_s);
    if (!reply.words.empty()) answer(reply.words, now_s);
    return true;
}

bool Session::take_key(std::string_view key, double now_s) {
    // If the force key is a single letter, a list or question gets it first, because the person may be typing text.
    if (const auto command = state_.person.keys.find(key);
        command && in_list(*command) == InList::Always && (*command != Command::ToggleForces || key.size() > 1))
        return false;
    if (menu_.commands().take_key(std::string(key), now_s)) return true;
    if (!state_.lists.dialogue.is_open()) return false;
    quiet(now_s);
    return reply(state_.lists.dialogue.key(key, now_s), now_s);
}

bool Session::take_text(std::string_view utf8, double now_s) {
    if (!state_.lists.dialogue.is_open()) return false;
    quiet(now_s);
    return reply(state_.lists.dialogue.typed(utf8, now_s), now_s);
}

bool Session::leave_lists(double now_s) {
    constexpr int kDeepest = 16;  // limit of the loop, because leaving a list may open another one
    Dialogue& dialogue = state_.lists.dialogue;
    int left = 0;
    while (dialogue.is_open() && !dialogue.typing() && left < kDeepest) {
        (void)dialogue.key("Escape", now_s);
        ++left;
    }
    return left > 0;
}

bool Session::take_act(const ItemAct& act, double now_s) {
    if (!state_.lists.dialogue.is_open()) return false;
    quiet(now_s);
    return reply(state_.lists.dialogue.act(act, now_s), now_s);
}

bool Session::take_line(std::string_view line, double now_s) {
    const std::string_view bare = without_blanks(line);
    if (lesson_session_.take_line(bare, now_s) || menu_.commands().take_line(bare, now_s)) return true;
    if (!state_.lists.dialogue.is_open()) return answer_question(bare, now_s);
    if (const CommandInfo* row = find_command(line); row && in_list(row->command) == InList::Always) return false;
    quiet(now_s);
    const DialogueReply said = state_.lists.dialogue.line(line, now_s);
    const auto requested = [&]() -> std::optional<Command> {
        // While a list is open, a word for leaving the program means Command::Leave, because the word may be meant for
        // the list.
        if (is_quit_word(bare)) return Command::Leave;
        if (const auto command = command_of_word(bare)) return command;
        const auto sentence = typed_sentence(bare);
        return sentence && sentence->choice.empty() ? std::optional(sentence->command) : std::nullopt;
    };
    if (const auto command = said.denied ? requested() : std::nullopt;
        command && !state_.lists.dialogue.typing() && in_list(*command) != InList::Waits) {
        act(*command, now_s);
        return true;
    }
    if (said.denied && !state_.lists.dialogue.typing() && is_question(bare)) {
        leave_lists(now_s);
        return answer_question(bare, now_s);
    }
    return reply(said, now_s);
}

// Returns true if the line is no command and contains a question that the session answers.
bool Session::is_question(std::string_view line) const {
    return state_.world.scene && !is_command_line(line) && questions_.answers.knows(line);
}

bool Session::answer_question(std::string_view line, double now_s) {
    if (!is_question(line)) return false;
    quiet(now_s);
    where_.rooms.take_refused();  // Forgets refusals to other callers.
    questions_.too_early.reset();
    questions_.answers.answer(line, now_s);
    if (where_.rooms.take_refused()) questions_.too_early = Questions::TooEarly{{}, std::string(line), now_s};
    return true;
}

}  // namespace handrail::core
