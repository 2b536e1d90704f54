#include "app/main/commands.h"

namespace handrail {

int run_touch(const TouchArguments&, std::ostream&, std::ostream& err) {
    err << "The command touch is being written.\n";
    return 1;
}

}  // namespace handrail
