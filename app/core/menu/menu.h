// Opens the menu, which leads to all other features through lists. It owns the lists of commands, worlds, languages and
// reports. Use it on the app thread only.
#pragma once

#include <string>

#include "app/core/context/session_part.h"
#include "app/core/menu/command_lists.h"
#include "app/core/menu/language_list.h"
#include "app/core/menu/report_lists.h"
#include "app/core/menu/world_lists.h"

namespace handrail::core {

class Menu : SessionPart {
public:
    explicit Menu(const SessionContext& context)
        : SessionPart(context), commands_(context), worlds_(context), languages_(context), reports_(context) {}

    // Carries out the commands for the menu, the list of keys, input help, languages, presets and devices. Returns
    // false for other commands.
    bool act(Command command, double now_s);

    CommandLists& commands() { return commands_; }
    WorldLists& worlds() { return worlds_; }
    LanguageList& languages() { return languages_; }
    ReportLists& reports() { return reports_; }
    const ReportLists& reports() const { return reports_; }

private:
    void open(double now_s);
    void open_sounds(double now_s);

    CommandLists commands_;
    WorldLists worlds_;
    LanguageList languages_;
    ReportLists reports_;
};

}  // namespace handrail::core
