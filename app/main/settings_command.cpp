#include "app/main/commands.h"
#include "worlds/base/language.h"

namespace handrail::program {

// Prints one setting per line. With --explain, also prints unit, range, meaning and source in whole phrases, so that
// each line makes sense when it is read aloud alone.
int run_settings(const SettingsArguments& arguments, settings::SettingsStore& settings, std::ostream& out,
                 std::ostream& err) {
    for (const settings::SettingRow& row : settings.explain()) {
        if (!arguments.explain) {
            out << row.key << " = " << row.value << "\n";
            continue;
        }
        std::string source(settings::source_name(row.source));
        if (!row.origin.empty()) source = phrase("program.source", {{"source", source}, {"origin", row.origin}});
        out << phrase(row.unit.empty() ? "program.setting" : "program.setting_unit", {{"key", row.key},
                                                                                      {"value", row.value},
                                                                                      {"unit", row.unit},
                                                                                      {"range", row.range},
                                                                                      {"source", source},
                                                                                      {"meaning", row.meaning}})
            << "\n";
    }
    out.flush();
    if (out) return 0;
    err << phrase("program.settings_not_printed") << "\n";
    return 1;
}

}  // namespace handrail::program
