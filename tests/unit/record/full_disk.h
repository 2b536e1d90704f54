// Files of this test program that take no more, as a full disk does.
#pragma once

namespace handrail::test {

// From the n-th write to a file on, by any thread, all fail with ENOSPC, until this goes; the one before takes half.
class FullDisk {
public:
    explicit FullDisk(long from_write);
    ~FullDisk();
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    static bool struck();
};

}  // namespace handrail::test
