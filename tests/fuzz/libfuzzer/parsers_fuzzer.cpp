// Entry point for libFuzzer: parsers_fuzzer NAME [what libFuzzer takes]; without a name it lists the names.
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/harness.h"

namespace {
const handrail::fuzz::Harness* chosen = nullptr;
}

extern "C" int LLVMFuzzerInitialize(int* argument_count, char*** arguments) {
    if (*argument_count > 1)
        for (const auto& harness : handrail::fuzz::harnesses())
            if (harness.name == (*arguments)[1]) chosen = &harness;
    if (!chosen) {
        for (const auto& harness : handrail::fuzz::harnesses())
            std::printf("%.*s\n", static_cast<int>(harness.name.size()), harness.name.data());
        std::exit(*argument_count > 1 ? 2 : 0);
    }
    for (int i = 1; i + 1 < *argument_count; ++i) (*arguments)[i] = (*arguments)[i + 1];
    --*argument_count;
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string fault = chosen->fault({reinterpret_cast<const char*>(data), size});
    if (!fault.empty()) {
        std::fprintf(stderr, "%s\n", fault.c_str());
        std::abort();
    }
    return 0;
}
