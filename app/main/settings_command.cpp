#include "app/main/commands.h"

namespace handrail {

int run_settings(const SettingsArguments&, SettingsStore&, std::ostream&, std::ostream& err) {
    err << "The command settings is being written.\n";
    return 1;
}

}  // namespace handrail
