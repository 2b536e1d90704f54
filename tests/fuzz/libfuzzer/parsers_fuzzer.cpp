// Contains the entry point for libFuzzer. Usage: parsers_fuzzer NAME [arguments of libFuzzer]. If NAME is missing, the
// program lists the names of the parsers.
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/fuzz/harness.h"

namespace {
const handrail::fuzz::Harness* chosen = nullptr;

// Limit of processor time for one input. Processor time is measured, unlike by libFuzzer's own -timeout, because one
// second of it may take a minute on a loaded machine.
constexpr time_t kMostSeconds = 10;

// Called as a signal handler, so it may only call functions that are safe in one.
void end_as_too_slow(int) {
    constexpr char kSentence[] = "This input takes more than 10 s of the processor.\n";
    (void)!write(STDERR_FILENO, kSentence, sizeof kSentence - 1);
    std::abort();
}

void allow(time_t seconds) {
    const itimerval limit{{0, 0}, {seconds, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
}
}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argument_count, char*** arguments) {
    constexpr const char* kOfParent = "HANDRAIL_FUZZED";
    const auto choose = [](const char* name) {
        for (const auto& harness : handrail::fuzz::harnesses())
            if (name && harness.name == name) chosen = &harness;
    };
    // When libFuzzer starts this program again, for example to minimise a corpus, it omits NAME. The environment then
    // contains NAME.
    choose(std::getenv(kOfParent));
    if (chosen) {
        std::signal(SIGPROF, end_as_too_slow);
        return 0;
    }
    if (*argument_count > 1) choose((*arguments)[1]);
    if (!chosen) {
        for (const auto& harness : handrail::fuzz::harnesses())
            std::printf("%.*s\n", static_cast<int>(harness.name.size()), harness.name.data());
        std::exit(*argument_count > 1 ? 2 : 0);
    }
    for (int i = 1; i + 1 < *argument_count; ++i) (*arguments)[i] = (*arguments)[i + 1];
    --*argument_count;
    setenv(kOfParent, std::string(chosen->name).c_str(), 1);
    std::signal(SIGPROF, end_as_too_slow);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    allow(kMostSeconds);
    const std::string fault = chosen->fault({reinterpret_cast<const char*>(data), size});
    allow(0);
    if (!fault.empty()) {
        std::fprintf(stderr, "%s\n", fault.c_str());
        std::abort();
    }
    return 0;
}
