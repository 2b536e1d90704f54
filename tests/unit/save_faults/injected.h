// Replaces the system's calls for writing files, and the allocator, in this test program. When armed, the n-th call on
// this thread fails or does less than requested.
#pragma once

#include <new>

namespace handrail::test {

// What a call for writing does instead.
enum class WriteFault {
    None,
    Error,           // the call fails with `error`
    Short,           // a write stores one byte less than half; other calls work
    ShortThenError,  // as Short, and every later write fails with `error`, like a disk that becomes full
};

// Active during its lifetime, on this thread.
class BrokenDisk {
public:
    BrokenDisk(WriteFault fault, long at_call, int error);
    ~BrokenDisk();
    BrokenDisk(const BrokenDisk&) = delete;
    BrokenDisk& operator=(const BrokenDisk&) = delete;
    static bool struck();  // true once the failing call has happened
    static long calls();   // number of calls since the last arming
};

// The n-th allocation of this thread throws std::bad_alloc; with `all_after`, so does every later one.
class NoMemory {
public:
    NoMemory(long at_allocation, bool all_after);
    ~NoMemory();
    NoMemory(const NoMemory&) = delete;
    NoMemory& operator=(const NoMemory&) = delete;
    static bool struck();
};

}  // namespace handrail::test
