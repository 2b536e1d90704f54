#include "worlds/base/contract.h"

#include <cstdio>
#include <cstdlib>

namespace handrail::detail {

void contract_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "Handrail has a fault of its own at %s line %d: %s does not hold. Please report this.\n", file,
                 line, condition);
    std::abort();
}

}  // namespace handrail::detail
