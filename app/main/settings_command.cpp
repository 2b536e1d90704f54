#include "app/main/commands.h"

namespace handrail {

// One setting a line; --explain adds unit, range, meaning and source in whole phrases, so that a line read aloud makes sense by itself.
int run_settings(const SettingsArguments& arguments, SettingsStore& settings, std::ostream& out, std::ostream& err) {
    for (const SettingRow& row : settings.explain()) {
        out << row.key << " = " << row.value;
        if (arguments.explain) {
            if (!row.unit.empty()) out << " " << row.unit;
            out << " (" << row.range << "), from: " << source_name(row.source);
            if (!row.origin.empty()) out << " " << row.origin;
            out << ". " << row.meaning;
        }
        out << "\n";
    }
    out.flush();
    if (out) return 0;
    err << "The settings could not be printed.\n";
    return 1;
}

}  // namespace handrail
