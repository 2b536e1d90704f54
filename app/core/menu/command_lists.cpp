#include "app/core/menu/command_lists.h"

#include <algorithm>
#include <array>

#include "app/core/dialogue/command_words.h"
#include "app/core/menu/setting_lists.h"
#include "settings/adjust.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/base/typist.h"

namespace handrail::core {
namespace {

// A topic of the lists: its first command in the command table, and the key of its name in the texts.
struct Topic {
    Command first;
    std::string_view key;
};
constexpr std::array kTopics{
    Topic{Command::Forward, "menu.walking"},    Topic{Command::ToggleForces, "menu.force"},
    Topic{Command::WhereAmI, "menu.questions"}, Topic{Command::Use, "menu.doors"},
    Topic{Command::Menu, "menu.help"},          Topic{Command::HandForward, "menu.simulated_hand"},
};

std::vector<Command> commands_of(std::size_t topic) {
    const std::size_t begin = static_cast<std::size_t>(kTopics[topic].first);
    const std::size_t end =
        topic + 1 < kTopics.size() ? static_cast<std::size_t>(kTopics[topic + 1].first) : command_table().size();
    std::vector<Command> commands;
    for (std::size_t i = begin; i < end; ++i) commands.push_back(command_table()[i].command);
    return commands;
}

std::string short_help(const CommandInfo& row) {
    return std::string(row.help().substr(0, row.help().find_last_not_of('.') + 1));
}

std::string setting_of_keys(Command command) { return "keys." + std::string(info(command).word); }

std::string counted(std::size_t commands) { return phrase("menu.commands", {{"count", commands}}); }

// Returns true if a typed text may be the name of a key. In a window, the person presses the key instead.
bool may_be_key(std::string_view name) {
    const auto fits = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+';
    };
    return !name.empty() && name.size() <= 32 && std::all_of(name.begin(), name.end(), fits);
}

}  // namespace

void CommandLists::open(bool to_rebind, double now_s) {
    ListSpec list;
    list.title = phrase(to_rebind ? "menu.keys_of_what" : "menu.what_to_do");
    list.stays_open = true;
    list.items.push_back({phrase("menu.all_of_it"), counted(command_table().size()), false});
    for (std::size_t i = 0; i < kTopics.size(); ++i)
        list.items.push_back({phrase(kTopics[i].key), counted(commands_of(i).size()), false});
    if (!to_rebind) list.items.push_back({phrase("menu.search"), {}, false});
    list.chosen = [this, to_rebind](std::size_t i) {
        if (i == kTopics.size() + 1) return request_search(context_.tick_s);
        std::vector<Command> commands;
        if (i > 0) commands = commands_of(i - 1);
        else
            for (const CommandInfo& row : command_table()) commands.push_back(row.command);
        open_commands(std::move(commands), to_rebind, context_.tick_s);
    };
    if (to_rebind) {
        list.items.push_back(
            {phrase("menu.one_hand"), settings::setting_line("keyboard.hand", context_.settings).value, true});
        const std::size_t last = list.items.size() - 1;
        list.adjusted = [this](std::size_t, int by) { return step_setting(context_, "keyboard.hand", by); };
        list.chosen = [this, last, open = list.chosen](std::size_t i) {
            if (i == last) context_.answer(phrase("menu.one_hand_how"), context_.tick_s);
            else open(i);
        };
    }
    context_.open_list(std::move(list), now_s);
}

// Asks for a word, and searches for it in the names and help lines of all commands.
void CommandLists::request_search(double now_s) {
    TextSpec question;
    question.question = phrase("menu.search_for");
    question.done = [this](const std::string& typed) {
        const std::string part = lower_ascii(typed);
        std::vector<Command> commands;
        for (const CommandInfo& row : command_table())
            if (lower_ascii(row.help()).find(part) != std::string::npos ||
                lower_ascii(spoken_word(row.command)).find(part) != std::string::npos)
                commands.push_back(row.command);
        if (commands.empty()) return context_.answer(phrase("menu.none_found", {{"typed", typed}}), context_.tick_s);
        open_commands(std::move(commands), false, context_.tick_s);
    };
    context_.request_text(std::move(question), now_s);
}

void CommandLists::open_commands(std::vector<Command> commands, bool to_rebind, double now_s) {
    ListSpec list;
    list.title = phrase(to_rebind ? "menu.which_command" : "menu.what_to_do");
    list.stays_open = to_rebind;
    for (const Command command : commands) {
        const std::string keys = context_.keys.keys_of(command);
        list.items.push_back({short_help(info(command)), keys.empty() ? phrase("menu.no_key") : keys, false});
    }
    list.chosen = [this, to_rebind, commands = std::move(commands)](std::size_t i) {
        if (to_rebind) return open_rebinding(commands[i], context_.tick_s);
        context_.session_requests.perform(commands[i], context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void CommandLists::open_rebinding(Command command, double now_s) {
    const std::string keys = context_.keys.keys_of(command);
    if (command == Command::StopEverything) return context_.answer(phrase("menu.stop_key_stays"), now_s);
    ListSpec list;
    list.title = phrase("menu.command_keys", {{"command", short_help(info(command))},
                                              {"keys", keys.empty() ? phrase("menu.no_key") : keys}});
    list.items = {{phrase("menu.another_key"), {}, false},
                  {phrase("menu.one_more_key"), {}, false},
                  {phrase("menu.first_key"), {}, false}};
    list.stays_open = true;
    list.chosen = [this, command](std::size_t i) {
        context_.lists.dialogue.key("Escape", context_.tick_s);  // The key Escape returns to the list of commands.
        if (i == 2) {
            const std::string built_in(context_.keys.default_keys(command));
            context_.set(setting_of_keys(command), built_in.empty() ? "none" : built_in, context_.tick_s);
            return context_.answer(phrase("menu.command_has_again", {{"command", short_help(info(command))},
                                                                     {"keys", context_.keys.keys_of(command)}}),
                                   context_.tick_s);
        }
        rebinding_ = Rebinding{command, i == 1};
        context_.answer(phrase("menu.press_new_key", {{"help", info(command).help()}}), context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void CommandLists::take_new_key(const std::string& key, double now_s) {
    const Rebinding wanted = *std::exchange(rebinding_, std::nullopt);
    if (key == "Escape") return context_.answer(phrase("menu.left_as_it_is"), now_s);
    if (!may_be_key(key)) {
        context_.play(cues::SoundKind::Denied, now_s);
        return context_.answer(phrase("menu.no_keys_name", {{"key", key}}), now_s);
    }
    const auto give = [this, key, wanted](std::vector<std::pair<Command, std::string>> changes, double at_s) {
        const std::string before = wanted.one_more ? context_.keys.words_of_keys(wanted.command) : std::string{};
        changes.emplace_back(wanted.command, before.empty() ? key : before + " " + key);
        for (const auto& [command, keys] : changes)
            if (const auto set = context_.session_requests.set(setting_of_keys(command), keys, at_s); !set)
                return context_.answer(set.error().message, at_s);
        context_.answer(phrase("menu.command_has", {{"command", short_help(info(wanted.command))},
                                                    {"keys", context_.keys.keys_of(wanted.command)}}),
                        at_s);
    };
    const auto owner = context_.keys.find(key);
    if (owner == wanted.command) return context_.answer(phrase("menu.does_that", {{"key", key}}), now_s);
    if (!owner) return give({}, now_s);
    if (*owner == Command::StopEverything || *owner == Command::Leave || *owner == Command::StopSpeech) {
        context_.play(cues::SoundKind::Denied, now_s);
        return context_.answer(phrase("menu.always_does", {{"key", spoken_key(key)}, {"help", info(*owner).help()}}),
                               now_s);
    }
    // The key already belongs to another command, so the person decides which command gets it.
    const std::string rest = context_.keys.words_of_keys(*owner, key);
    ListSpec list;
    list.title = phrase("menu.does_already", {{"key", spoken_key(key)}, {"help", info(*owner).help()}});
    list.items = {{phrase("menu.take_away"),
                   rest.empty() ? phrase("menu.then_without_key") : phrase("menu.keeps", {{"keys", rest}}), false},
                  {phrase("menu.leave_it"), {}, false}};
    list.stays_open = true;
    list.chosen = [this, give, rest, owner = *owner](std::size_t i) {
        context_.lists.dialogue.key("Escape", context_.tick_s);
        if (i == 1) return context_.answer(phrase("menu.left_as_it_is"), context_.tick_s);
        give({{owner, rest.empty() ? "none" : rest}}, context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void CommandLists::toggle_input_help(double now_s) {
    input_help_ = !input_help_;
    const std::string key = context_.keys.keys_of(Command::InputHelp);
    context_.answer(input_help_ ? phrase("menu.input_help_on", {{"key", key}}) : phrase("menu.input_help_off"), now_s);
}

bool CommandLists::take_key(const std::string& key, double now_s) {
    if (rebinding_) {
        context_.cues.quiet(now_s);
        take_new_key(key, now_s);
        return true;
    }
    if (!input_help_) return false;
    const auto command = context_.keys.find(key);
    if (command == Command::InputHelp) return false;
    context_.cues.quiet(now_s);
    context_.answer(command ? phrase("menu.key_does", {{"key", spoken_key(key)}, {"help", info(*command).help()}})
                            : phrase("menu.key_does_nothing", {{"key", spoken_key(key)}}),
                    now_s);
    return true;
}

bool CommandLists::take_line(std::string_view line, double now_s) {
    if (rebinding_) {
        take_new_key(std::string(line), now_s);
        return true;
    }
    if (!input_help_) return false;
    const CommandInfo* row = find_command(line);
    if (!row || row->command == Command::InputHelp) return false;
    const std::string keys = context_.keys.keys_of(row->command);
    const std::string does = phrase("menu.key_does", {{"key", row->word}, {"help", row->help()}});
    context_.answer(keys.empty() || speaks_to_typist() ? does : does + " " + phrase("menu.its_key", {{"keys", keys}}),
                    now_s);
    return true;
}

}  // namespace handrail::core
