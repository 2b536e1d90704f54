// AppCore's part on the menu: everything by lists. What can be done, worlds, settings, keys and their rebinding, sounds; input help. App thread only.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "app/core/app_core.h"
#include "audio-cues/plan/sound_table.h"
#include "settings/adjust.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

// Where in the table each topic begins.
struct Topic {
    Command first;
    std::string_view key;
};
constexpr std::array kTopics{
    Topic{Command::Forward, "menu.walking"}, Topic{Command::ToggleForces, "menu.force"}, Topic{Command::WhereAmI, "menu.questions"},
    Topic{Command::Use, "menu.doors"},       Topic{Command::Menu, "menu.help"},          Topic{Command::HandForward, "menu.simulated_hand"},
};

std::vector<Command> commands_of(std::size_t topic) {
    const std::size_t begin = static_cast<std::size_t>(kTopics[topic].first);
    const std::size_t end = topic + 1 < kTopics.size() ? static_cast<std::size_t>(kTopics[topic + 1].first) : command_table().size();
    std::vector<Command> commands;
    for (std::size_t i = begin; i < end; ++i) commands.push_back(command_table()[i].command);
    return commands;
}

std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

std::string short_help(const CommandInfo& row) { return std::string(row.help().substr(0, row.help().find_last_not_of('.') + 1)); }

// A key's name as a person may type it; where the program has a window, the key itself is pressed.
bool may_be_key(std::string_view name) {
    const auto fits = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+'; };
    return !name.empty() && name.size() <= 32 && std::all_of(name.begin(), name.end(), fits);
}

}  // namespace

void AppCore::open_menu(double now_s) {
    ListSpec list;
    list.title = phrase("menu.title");
    list.stays_open = true;
    std::vector<std::function<void()>> acts;
    const auto add = [&](std::string name, std::function<void()> act) {
        list.items.push_back({std::move(name), {}, false});
        acts.push_back(std::move(act));
    };
    add(phrase("menu.what_i_can_do"), [this] { open_topics(false, last_tick_s_); });
    add(phrase("menu.worlds"), [this] { open_worlds(last_tick_s_); });
    add(phrase("language.menu"), [this] { open_languages(last_tick_s_); });
    add(phrase("menu.settings"), [this] { open_setting_topics(last_tick_s_); });
    add(phrase("menu.keys"), [this] { open_topics(true, last_tick_s_); });
    add(phrase("menu.sounds"), [this] { open_sounds(last_tick_s_); });
    for (const auto& [key, command] : {std::pair{"menu.say_keys", Command::Help}, std::pair{"menu.input_help", Command::InputHelp},
                                       std::pair{"menu.set_up", Command::Calibrate}, std::pair{"menu.leave", Command::Leave}})
        add(phrase(key), [this, command = command] {
            dialogue_.close_all();
            press(command, last_tick_s_);
            release(command);
        });
    list.chosen = [acts](std::size_t i) { acts[i](); };
    open_list(std::move(list), now_s);
}

// Commands by topic; to be done, or to be given another key.
void AppCore::open_topics(bool to_rebind, double now_s) {
    ListSpec list;
    list.title = phrase(to_rebind ? "menu.keys_of_what" : "menu.what_to_do");
    list.stays_open = true;
    list.items.push_back({phrase("menu.all_of_it"), fmt::format("{}", command_table().size()), false});
    for (std::size_t i = 0; i < kTopics.size(); ++i) list.items.push_back({phrase(kTopics[i].key), fmt::format("{}", commands_of(i).size()), false});
    list.chosen = [this, to_rebind](std::size_t i) {
        std::vector<Command> commands;
        if (i > 0) commands = commands_of(i - 1);
        else
            for (const CommandInfo& row : command_table()) commands.push_back(row.command);
        open_commands(std::move(commands), to_rebind, last_tick_s_);
    };
    if (to_rebind) {
        list.items.push_back({phrase("menu.one_hand"), setting_line("keyboard.hand", settings_).value, true});
        const std::size_t last = list.items.size() - 1;
        list.adjusted = [this](std::size_t, int by) { return change_setting("keyboard.hand", stepped("keyboard.hand", settings_, by)); };
        list.chosen = [this, last, open = list.chosen](std::size_t i) {
            if (i == last) answer(phrase("menu.one_hand_how"), last_tick_s_);
            else open(i);
        };
    }
    open_list(std::move(list), now_s);
}

void AppCore::open_commands(std::vector<Command> commands, bool to_rebind, double now_s) {
    ListSpec list;
    list.title = phrase(to_rebind ? "menu.which_command" : "menu.what_to_do");
    list.stays_open = to_rebind;
    for (const Command command : commands) {
        const std::string keys = keys_.keys_of(command);
        list.items.push_back({short_help(info(command)), keys.empty() ? phrase("menu.no_key") : keys, false});
    }
    list.chosen = [this, to_rebind, commands](std::size_t i) {
        if (to_rebind) return open_rebinding(commands[i], last_tick_s_);
        press(commands[i], last_tick_s_);
        release(commands[i]);
    };
    open_list(std::move(list), now_s);
}

// ---- keys ----

void AppCore::open_rebinding(Command command, double now_s) {
    const std::string keys = keys_.keys_of(command);
    if (command == Command::StopEverything) return answer(phrase("menu.stop_key_stays"), now_s);
    ListSpec list;
    list.title = phrase("menu.command_keys", {{"command", short_help(info(command))}, {"keys", keys.empty() ? phrase("menu.no_key") : keys}});
    list.items = {{phrase("menu.another_key"), {}, false}, {phrase("menu.one_more_key"), {}, false}, {phrase("menu.first_key"), {}, false}};
    list.stays_open = true;
    list.chosen = [this, command](std::size_t i) {
        dialogue_.key("Escape", last_tick_s_);  // back to the commands
        if (i == 2) {
            const std::string built_in(keys_.default_keys(command));
            change_keys({{command, built_in.empty() ? "none" : built_in}});
            return answer(phrase("menu.command_has_again", {{"command", short_help(info(command))}, {"keys", keys_.keys_of(command)}}), last_tick_s_);
        }
        rebinding_ = Rebinding{command, i == 1};
        answer(phrase("menu.press_new_key", {{"help", info(command).help()}}), last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

void AppCore::take_new_key(const std::string& key, double now_s) {
    const Rebinding wanted = *std::exchange(rebinding_, std::nullopt);
    if (key == "Escape") return answer(phrase("menu.left_as_it_is"), now_s);
    if (!may_be_key(key)) {
        play(SoundKind::Denied, now_s);
        return answer(phrase("menu.no_keys_name", {{"key", key}}), now_s);
    }
    const auto give = [this, key, wanted](std::vector<std::pair<Command, std::string>> changes, double at_s) {
        const std::string before = wanted.one_more ? keys_.words_of_keys(wanted.command) : std::string{};
        changes.emplace_back(wanted.command, before.empty() ? key : before + " " + key);
        change_keys(changes);
        answer(phrase("menu.command_has", {{"command", short_help(info(wanted.command))}, {"keys", keys_.keys_of(wanted.command)}}), at_s);
    };
    const auto owner = keys_.find(key);
    if (owner == wanted.command) return answer(phrase("menu.does_that", {{"key", key}}), now_s);
    if (!owner) return give({}, now_s);
    if (*owner == Command::StopEverything || *owner == Command::Leave || *owner == Command::StopSpeech) {
        play(SoundKind::Denied, now_s);
        return answer(phrase("menu.always_does", {{"key", spoken_key(key)}, {"help", info(*owner).help()}}), now_s);
    }
    // A conflict: told, and the person decides.
    const std::string rest = keys_.words_of_keys(*owner, key);
    ListSpec list;
    list.title = phrase("menu.does_already", {{"key", spoken_key(key)}, {"help", info(*owner).help()}});
    list.items = {{phrase("menu.take_away"), rest.empty() ? phrase("menu.then_without_key") : phrase("menu.keeps", {{"keys", rest}}), false},
                  {phrase("menu.leave_it"), {}, false}};
    list.stays_open = true;
    list.chosen = [this, give, rest, owner = *owner](std::size_t i) {
        dialogue_.key("Escape", last_tick_s_);
        if (i == 1) return answer(phrase("menu.left_as_it_is"), last_tick_s_);
        give({{owner, rest.empty() ? "none" : rest}}, last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

void AppCore::change_keys(const std::vector<std::pair<Command, std::string>>& changes) {
    for (const auto& [command, keys] : changes) {
        settings_.keys[std::string(info(command).word)] = keys;
        setting_changes_.emplace_back(fmt::format("keys.{}", info(command).word), keys);
    }
    keys_ = KeyMap(settings_.keys, settings_.keyboard.hand);
}

void AppCore::toggle_input_help(double now_s) {
    input_help_ = !input_help_;
    const std::string key = keys_.keys_of(Command::InputHelp);
    answer(input_help_ ? phrase("menu.input_help_on", {{"key", key}}) : phrase("menu.input_help_off"), now_s);
}

// True: the key was explained, or is the new key of a command, and does nothing else.
bool AppCore::take_key_apart(const std::string& key, double now_s) {
    if (rebinding_) {
        quiet(now_s);
        take_new_key(key, now_s);
        return true;
    }
    if (!input_help_) return false;
    const auto command = keys_.find(key);
    if (command == Command::InputHelp) return false;
    quiet(now_s);
    answer(command ? phrase("menu.key_does", {{"key", spoken_key(key)}, {"help", info(*command).help()}}) : phrase("menu.key_does_nothing", {{"key", spoken_key(key)}}), now_s);
    return true;
}

// A line of a terminal: a key's name while one is asked for, a command's word in input help.
bool AppCore::take_line_apart(std::string_view line, double now_s) {
    line = without_blanks(line);
    if (lesson_ && lesson_->goal() == LessonGoal::Begin) {
        for (const auto& [word, command] :
             {std::pair{"", Command::Use}, std::pair{"enter", Command::Use}, std::pair{"space", Command::Repeat}, std::pair{"escape", Command::Leave}})
            if (lower_ascii(line) == word) {
                press(command, now_s);
                release(command);
                return true;
            }
    }
    if (rebinding_) {
        take_new_key(std::string(line), now_s);
        return true;
    }
    if (!input_help_) return false;
    const CommandInfo* row = find_command(line);
    if (!row || row->command == Command::InputHelp) return false;
    const std::string keys = keys_.keys_of(row->command);
    const std::string does = phrase("menu.key_does", {{"key", row->word}, {"help", row->help()}});
    answer(keys.empty() ? does : does + " " + phrase("menu.its_key", {{"keys", keys}}), now_s);
    return true;
}

// ---- settings ----

// Changes one setting, live and to be saved; what it is then, or why it cannot be.
std::string AppCore::change_setting(std::string_view key, const std::string& value) {
    Settings changed = settings_;
    if (const auto set = set_in(changed, key, value); !set) return set.error().message;
    setting_changes_.emplace_back(std::string(key), value);
    change_settings(changed, last_tick_s_);
    return setting_line(key, settings_).value;
}

void AppCore::open_setting_topics(double now_s) {
    ListSpec list;
    list.title = phrase("menu.settings");
    list.stays_open = true;
    const std::vector<std::string_view> topics = setting_topics();
    for (const std::string_view topic : topics) list.items.push_back({sentence_case(topic_name(topic)), {}, false});
    list.chosen = [this, topics](std::size_t i) { open_settings(topics[i], last_tick_s_); };
    open_list(std::move(list), now_s);
}

void AppCore::open_settings(std::string_view topic, double now_s) {
    ListSpec list;
    list.title = phrase("menu.settings_of", {{"topic", sentence_case(topic_name(topic))}});
    list.stays_open = true;
    std::vector<std::string_view> keys;
    for (const SettingLine& line : setting_lines(topic, settings_)) {
        list.items.push_back({sentence_case(line.name), line.value, line.steps});
        keys.push_back(line.key);
    }
    list.adjusted = [this, keys](std::size_t i, int by) { return change_setting(keys[i], stepped(keys[i], settings_, by)); };
    list.chosen = [this, keys, topic](std::size_t i) {
        const SettingLine line = setting_line(keys[i], settings_);
        TextSpec question;
        question.question = phrase("menu.setting_question", {{"meaning", line.meaning}, {"value", line.value}, {"range", line.range}});
        question.done = [this, topic, key = keys[i]](std::string typed) {
            const std::string value = change_setting(key, typed);
            std::vector<ListItem> items;
            for (const SettingLine& now : setting_lines(topic, settings_)) items.push_back({sentence_case(now.name), now.value, now.steps});
            dialogue_.change_items(std::move(items));
            answer(value, last_tick_s_);
        };
        ask_text(std::move(question), last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

// ---- worlds ----

void AppCore::want_world(const std::filesystem::path& file) {
    world_wanted_ = file;
    answer(phrase("menu.going_to", {{"world", name_of_file(file)}}), last_tick_s_);
}

void AppCore::open_worlds(double now_s) {
    ListSpec list;
    list.title = phrase("menu.worlds");
    list.stays_open = true;
    std::vector<std::filesystem::path> files;
    const auto add = [&](const std::filesystem::path& file, std::string_view where) {
        if (std::find(files.begin(), files.end(), file) != files.end()) return;
        list.items.push_back({name_of_file(file), std::string(where), false});
        files.push_back(file);
    };
    for (const std::filesystem::path& file : shelf_.recent) add(file, phrase("menu.visited_before"));
    for (const ShelvedWorld& world : worlds_in(shelf_.bundled)) add(world.file, phrase("menu.bundled"));
    list.items.push_back({phrase("menu.another_world"), {}, false});
    list.chosen = [this, files](std::size_t i) {
        if (i < files.size()) {
            dialogue_.close_all();
            return want_world(files[i]);
        }
        TextSpec question;
        question.question = phrase("menu.which_file");
        question.done = [this](const std::string& path) { open_folder(path, last_tick_s_); };
        ask_text(std::move(question), last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

void AppCore::open_folder(const std::filesystem::path& typed, double now_s) {
    std::filesystem::path path = typed;
    const char* home = std::getenv("HOME");
    if (const std::string text = typed.string(); home && (text == "~" || text.starts_with("~/")))
        path = std::filesystem::path(home) / text.substr(std::min<std::size_t>(2, text.size()));
    std::error_code ec;
    if (std::filesystem::is_regular_file(path, ec)) {
        dialogue_.close_all();
        return want_world(path);
    }
    const std::vector<ShelvedWorld> worlds = worlds_in(path);
    if (worlds.empty()) {
        play(SoundKind::Denied, now_s);
        return answer(phrase("menu.no_world_at", {{"path", path.string()}}), now_s);
    }
    ListSpec list;
    list.title = name_of_file(path);
    std::vector<std::filesystem::path> files;
    for (const ShelvedWorld& world : worlds) {
        list.items.push_back({world.name, {}, false});
        files.push_back(world.file);
    }
    list.chosen = [this, files](std::size_t i) { want_world(files[i]); };
    open_list(std::move(list), now_s);
}

// ---- sounds ----

void AppCore::open_sounds(double now_s) {
    ListSpec list;
    list.title = phrase("menu.sounds_title");
    list.stays_open = true;
    const auto entries = std::make_shared<const std::vector<DictionaryEntry>>(sound_dictionary());
    for (const DictionaryEntry& entry : *entries) list.items.push_back({entry.text, {}, false});
    list.chosen = [this, entries](std::size_t i) {
        CueRequest request;
        request.kind = CueRequestKind::Demonstrate;
        request.time_s = last_tick_s_;
        request.text = (*entries)[i].text;
        request.sound = (*entries)[i].kind;
        request.material = (*entries)[i].material;
        request.position_m = listener().ears_m + forward_of_heading(heading_rad_);
        cue(std::move(request));
    };
    open_list(std::move(list), now_s);
}

}  // namespace handrail
