// Makes writes to files fail in this test program, as on a full disk.
#pragma once

namespace handrail::test {

// From the n-th write to a file on, by any thread, all writes fail with ENOSPC until this object is destroyed. The
// write before that is only half done.
class FullDisk {
public:
    explicit FullDisk(long from_write);
    ~FullDisk();
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    static bool struck();
};

}  // namespace handrail::test
