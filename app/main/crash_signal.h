// Notes in a file how the program ends when a signal ends it: its number, and where in the program that was, as
// distances from its beginning, which tell nothing of the machine. Then it ends as it would have.
#pragma once

#include <filesystem>

namespace handrail {

// Catches the signals of a crash for as long as it lives; one at a time. An empty file: does nothing.
class CrashSignal {
public:
    explicit CrashSignal(const std::filesystem::path& file);
    ~CrashSignal();
    CrashSignal(const CrashSignal&) = delete;
    CrashSignal& operator=(const CrashSignal&) = delete;

private:
    bool caught_ = false;
};

}  // namespace handrail
