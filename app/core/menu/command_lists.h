// Lists of all commands with their keys, to carry out a command or to give it another key. Also input help, which
// explains a key instead of acting on it. App thread only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/context/session_part.h"

namespace handrail::core {

class CommandLists : SessionPart {
public:
    explicit CommandLists(const SessionContext& context) : SessionPart(context) {}

    // Opens the commands by topic, to carry one out or to give it another key.
    void open(bool to_rebind, double now_s);
    void toggle_input_help(double now_s);
    // Returns true if the key was explained or became the new key of a command; it then has no other effect.
    bool take_key(const std::string& key, double now_s);
    // A terminal line without surrounding blanks: the name of a key if one is requested, or a command's word in input
    // help.
    bool take_line(std::string_view line, double now_s);

private:
    void ask_for_search(double now_s);
    void open_commands(std::vector<Command> commands, bool to_rebind, double now_s);
    void open_rebinding(Command command, double now_s);
    void take_new_key(const std::string& key, double now_s);

    bool input_help_ = false;
    struct Rebinding {
        Command command;
        bool one_more = false;
    };
    std::optional<Rebinding> rebinding_;  // the command that gets the next key
};

}  // namespace handrail::core
