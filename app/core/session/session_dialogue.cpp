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

// Returns the other list in which a name may be. The two lists are of things and of rooms.
std::optional<Command> other_list(Command command) {
    if (command == Command::Find) return Command::Routes;
    if (command == Command::Routes) return Command::Find;
    return std::nullopt;
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
    const auto answer_if_wish = [&] {
        const auto wish = wish_in(bare);
        if (wish) grant(*wish, bare, now_s);
        return wish.has_value();
    };
    if (!state_.lists.dialogue.is_open()) return answer_if_wish();
    if (const CommandInfo* row = find_command(line); row && in_list(row->command) == InList::Always) return false;
    quiet(now_s);
    const DialogueReply said = state_.lists.dialogue.line(line, now_s);
    if (!said.denied || state_.lists.dialogue.typing()) return reply(said, now_s);
    const auto requested = [&]() -> std::optional<Command> {
        // While a list is open, a word for leaving the program means Command::Leave, because the word may be meant for
        // the list.
        if (is_quit_word(bare)) return Command::Leave;
        if (const auto command = command_of_word(bare)) return command;
        const auto sentence = typed_sentence(bare);
        return sentence && sentence->choice.empty() ? std::optional(sentence->command) : std::nullopt;
    };
    if (const auto command = requested(); command && in_list(*command) != InList::Waits) {
        act(*command, now_s);
        return true;
    }
    return answer_if_wish() || reply(said, now_s);
}

// Returns what the line requests beyond the word of a command: the answer to a question, or a choice by name in a list
// that need not open.
std::optional<Session::Wish> Session::wish_in(std::string_view line) const {
    if (!state_.world.scene) return std::nullopt;
    const auto parsed = parse_terminal_line(line);
    const bool choice = parsed && parsed->command && !parsed->choice.empty();
    if (parsed && !choice && (parsed->leave || parsed->command)) return std::nullopt;
    // A person who types the word of a command wants its list, for example of the ways to find a thing. A route has
    // only one meaning.
    const bool by_word =
        choice && parsed->command != Command::Routes &&
        (takes_text(*parsed->command) || command_of_word(line.substr(0, line.find_first_of(" \t"))) == parsed->command);
    if (!by_word && questions_.answers.knows(line)) return Wish{};
    return choice ? std::optional(Wish{parsed->command, parsed->choice}) : std::nullopt;
}

void Session::grant(const Wish& wish, std::string_view line, double now_s) {
    leave_lists(now_s);
    quiet(now_s);
    where_.rooms.take_refused();  // Forgets refusals to other callers.
    questions_.too_early.reset();
    if (wish.command == Command::Label) places_.labels.take_text(wish.choice, now_s);
    else if (wish.command) choose(*wish.command, wish.choice, now_s);
    else questions_.answers.answer(line, now_s);
    if (questions_.too_early || where_.rooms.take_refused())
        questions_.too_early = Questions::TooEarly{{}, std::string(line), now_s};
}

// Chooses by name in the list that the command opens. If the name is not in it, searches the other list, of rooms or of
// things. The list is not announced, because the person did not request to hear it.
void Session::choose(Command command, const std::string& name, double now_s) {
    const auto other = other_list(command);
    std::optional<ListSpec> best;
    for (const auto each : {std::optional(command), other}) {
        if (!each) continue;
        auto list = state_.lists.take([&] {
            press(*each, now_s);
            release(*each);
        });
        if (!list) {
            // The owner opens these lists in its next turn. Otherwise, the session has said why there is no list.
            if (state_.requests.learners || state_.requests.devices) state_.lists.choose_when_opened(name);
            return;
        }
        const auto found = entry_called(*list, name);
        // "Where is the kitchen" means the room of that name, not the kitchen counter.
        const bool whole = found && is_called(*list, *found, name);
        if (found && (whole || !best)) best = std::move(list);
        if (whole || (found && each != Command::Find)) break;
    }
    if (best && best->chosen) return best->chosen(*entry_called(*best, name));
    answer(phrase("terminal.not_found", {{"typed", name}, {"word", spoken_word(command)}}), now_s);
}

}  // namespace handrail::core
