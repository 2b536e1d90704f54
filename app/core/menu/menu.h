// The menu: everything by lists. It owns the lists of commands, worlds and languages. App thread only.
#pragma once

#include <string>

#include "app/core/context/session_context.h"
#include "app/core/menu/command_lists.h"
#include "app/core/menu/language_list.h"
#include "app/core/menu/world_lists.h"

namespace handrail {

class Menu {
public:
    explicit Menu(const SessionContext& context)
        : context_(context), commands_(context), worlds_(context), languages_(context) {}
    Menu(const Menu&) = delete;  // open lists know it by its place
    Menu& operator=(const Menu&) = delete;

    // The menu, all keys, input help and languages. False: it is another's.
    bool act(Command command, double now_s);

    CommandLists& commands() { return commands_; }
    WorldLists& worlds() { return worlds_; }
    LanguageList& languages() { return languages_; }

private:
    void open(double now_s);
    void open_sounds(double now_s);

    const SessionContext& context_;
    CommandLists commands_;
    WorldLists worlds_;
    LanguageList languages_;
};

}  // namespace handrail
