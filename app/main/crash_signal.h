// If a signal ends the program, writes to a file which signal it was and where in the program it struck. Places are
// distances from the program's beginning, so they reveal nothing about the machine. The program then ends as it would
// have anyway.
#pragma once

#include <filesystem>

namespace handrail::program {

// Catches crash signals as long as the object exists. Only one object at a time may exist. With an empty file name it
// does nothing.
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
