#include "app/main/commands.h"

namespace handrail {

int run_scenarios(const ScenarioArguments&, std::ostream&, std::ostream& err) {
    err << "The command scenario is being written.\n";
    return 1;
}

}  // namespace handrail
