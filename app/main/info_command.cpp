#include "app/main/commands.h"

namespace handrail {

int run_info(const InfoArguments&, std::ostream&, std::ostream& err) {
    err << "The command info is being written.\n";
    return 1;
}

}  // namespace handrail
