// Lists all commands with their keys. The person can carry out a command or give it another key. This class also
// provides the input help, in which a key only explains itself. Use it on the app thread only.
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

    // Opens the commands by topic. If `to_rebind` is true, choosing a command gives it another key. Otherwise choosing
    // a command carries it out.
    void open(bool to_rebind, double now_s);
    void toggle_input_help(double now_s);
    // Returns true if input help explained the key, or if the key became the new key of a command. The key then has no
    // other effect.
    bool take_key(const std::string& key, double now_s);
    // Processes a line typed in a terminal, without surrounding blanks. The line is the name of a key if a key is
    // requested, or the word of a command in input help. Returns false if the line was not used.
    bool take_line(std::string_view line, double now_s);

private:
    void request_search(double now_s);
    void open_commands(std::vector<Command> commands, bool to_rebind, double now_s);
    void open_rebinding(Command command, double now_s);
    void take_new_key(const std::string& key, double now_s);

    bool input_help_ = false;
    struct Rebinding {
        Command command;
        bool one_more = false;
    };
    std::optional<Rebinding> rebinding_;  // the command that gets the next key that the person presses
};

}  // namespace handrail::core
