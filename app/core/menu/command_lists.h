// All that can be done and by which keys, as lists: to do it, to give it another key; and input help, which tells what
// a key does instead of doing it. App thread only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/context/session_part.h"

namespace handrail {

class CommandLists : SessionPart {
public:
    explicit CommandLists(const SessionContext& context) : SessionPart(context) {}

    // Commands by topic; to be done, or to be given another key.
    void open(bool to_rebind, double now_s);
    void toggle_input_help(double now_s);
    // True: the key was explained, or is the new key of a command, and does nothing else.
    bool take_key(const std::string& key, double now_s);
    // A line of a terminal, without blanks around it: a key's name while one is asked for, a command's word in input
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
    std::optional<Rebinding> rebinding_;  // the next key is for that command
};

}  // namespace handrail
