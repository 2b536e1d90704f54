// Writes a file if a signal ends the program: which signal it was, and where in the program it struck. Code addresses
// are distances from the program's beginning, so they reveal nothing about the machine. The program then ends as if the
// signal had not been caught.
#pragma once

#include <filesystem>

namespace handrail::program {

// Catches crash signals while the object exists. Only one object at a time may exist. With an empty file name, the
// object does nothing.
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
