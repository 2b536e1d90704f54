// Replaces the system's calls for writing files, and the allocator, in this test program. While one of the classes
// below is active, the n-th call on the thread that created it fails or does less than requested.
#pragma once

#include <new>

namespace handrail::test {

// The kinds of failure of a call for writing.
enum class WriteFault {
    None,
    Error,           // the call fails with `error`
    Short,           // a write stores one byte less than half; other calls work
    ShortThenError,  // like Short, but every later write fails with `error`, as on a disk that becomes full
};

// While this object exists, call number `at_call` of this thread fails.
class BrokenDisk {
public:
    BrokenDisk(WriteFault fault, long at_call, int error);
    ~BrokenDisk();
    BrokenDisk(const BrokenDisk&) = delete;
    BrokenDisk& operator=(const BrokenDisk&) = delete;
    static bool struck();  // true if the call that fails has happened
    static long calls();   // number of calls since the last object was created
};

// While this object exists, allocation number `at_allocation` of this thread throws std::bad_alloc. If `all_after` is
// true, all later ones throw, too.
class NoMemory {
public:
    NoMemory(long at_allocation, bool all_after);
    ~NoMemory();
    NoMemory(const NoMemory&) = delete;
    NoMemory& operator=(const NoMemory&) = delete;
    static bool struck();
};

}  // namespace handrail::test
