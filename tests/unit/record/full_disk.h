// Makes writes to files fail in this test program, as on a full disk.
#pragma once

namespace handrail::test {

// Makes writes to files fail with ENOSPC from any thread, until this object is destroyed. Write number `from_write`,
// counted from 1, stores only half of its bytes; all later writes fail. If `from_write` is 0, all writes fail.
class FullDisk {
public:
    explicit FullDisk(long from_write);
    ~FullDisk();
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    static bool struck();
};

}  // namespace handrail::test
