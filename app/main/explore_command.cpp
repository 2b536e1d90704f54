#include "app/main/commands.h"

namespace handrail {

int run_explore(const ExploreArguments&, SettingsStore&, std::ostream&, std::ostream& err) {
    err << "The command explore is being written.\n";
    return 1;
}

}  // namespace handrail
