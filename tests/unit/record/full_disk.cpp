#include "tests/unit/record/full_disk.h"

#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

namespace handrail::test {
namespace {

std::atomic<long> left{-1};  // number of writes until the first failure; -1: no limit
std::atomic<bool> hit{false};

}  // namespace

FullDisk::FullDisk(long from_write) {
    hit = false;
    left = from_write;
}
FullDisk::~FullDisk() { left = -1; }
bool FullDisk::struck() { return hit; }

}  // namespace handrail::test

extern "C" ssize_t write(int file, const void* data, size_t size) {
    using handrail::test::hit;
    using handrail::test::left;
    static const auto real = reinterpret_cast<ssize_t (*)(int, const void*, size_t)>(::dlsym(RTLD_NEXT, "write"));
    if (file <= 2 || left < 0) return real(file, data, size);
    if (left > 1) {
        --left;
        return real(file, data, size);
    }
    hit = true;
    if (left == 1 && size > 1) {
        left = 0;
        return real(file, data, size / 2);
    }
    errno = ENOSPC;
    return -1;
}
