// Writes to a file how a signal ended the program: the signal's number, and where in the program it struck. Places are
// distances from the program's beginning, which reveal nothing about the machine. The program then ends as it would
// have anyway.
#pragma once

#include <filesystem>

namespace handrail::program {

// Catches crash signals while it lives; only one object at a time. With an empty file it does nothing.
class CrashSignal {
public:
    explicit CrashSignal(const std::filesystem::path& file);
    ~CrashSignal();
    CrashSignal(const CrashSignal&) = delete;
    CrashSignal& operator=(const CrashSignal&) = delete;

private:
    bool caught_ = false;
};

}  // namespace handrail::program
