// The system's calls for writing files, and the allocator, of this test program: armed, the n-th call of this thread
// fails or does less than it was asked to.
#pragma once

#include <new>

namespace handrail::test {

// What a call for writing does instead of its work.
enum class WriteFault {
    None,
    Error,           // fails with `error`
    Short,           // a write puts one byte less than half; anything else works
    ShortThenError,  // the same, and every write after it fails with `error`, as a disk that runs full
};

// For as long as it lives, on this thread.
class BrokenDisk {
public:
    BrokenDisk(WriteFault fault, long at_call, int error);
    ~BrokenDisk();
    BrokenDisk(const BrokenDisk&) = delete;
    BrokenDisk& operator=(const BrokenDisk&) = delete;
    static bool struck();  // the call has come
    static long calls();   // made since one was last armed
};

// The n-th allocation of this thread throws std::bad_alloc, and each after it too where `all_after`.
class NoMemory {
public:
    NoMemory(long at_allocation, bool all_after);
    ~NoMemory();
    NoMemory(const NoMemory&) = delete;
    NoMemory& operator=(const NoMemory&) = delete;
    static bool struck();
};

}  // namespace handrail::test
