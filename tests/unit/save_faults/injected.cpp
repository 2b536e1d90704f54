#include "tests/unit/save_faults/injected.h"

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace handrail::test {
namespace {

struct Disk {
    WriteFault fault = WriteFault::None;
    bool armed = false, struck = false;
    long at = 0, calls = 0;
    int error = 0;
};
thread_local Disk disk;

struct Memory {
    bool armed = false, struck = false, all_after = false;
    long left = 0;
};
thread_local Memory memory;

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

// Counts this call and returns whether it must fail.
bool fails() {
    if (!disk.armed) return false;
    const bool now = disk.calls++ == disk.at;
    if (now) disk.struck = true;
    const bool fails = now && disk.fault == WriteFault::Error;
    if (fails) errno = disk.error;
    return fails;
}

void* allocate(std::size_t size) {
    if (memory.armed && (memory.struck ? memory.all_after : memory.left-- == 0)) {
        memory.struck = true;
        return nullptr;
    }
    return std::malloc(size ? size : 1);
}

void* allocate_or_throw(std::size_t size) {
    if (void* p = allocate(size)) return p;
    throw std::bad_alloc();
}

}  // namespace

BrokenDisk::BrokenDisk(WriteFault fault, long at_call, int error) { disk = {fault, true, false, at_call, 0, error}; }
BrokenDisk::~BrokenDisk() { disk.armed = false; }
bool BrokenDisk::struck() { return disk.struck; }
long BrokenDisk::calls() { return disk.calls; }

NoMemory::NoMemory(long at_allocation, bool all_after) { memory = {true, false, all_after, at_allocation}; }
NoMemory::~NoMemory() { memory.armed = false; }
bool NoMemory::struck() { return memory.struck; }

}  // namespace handrail::test

// ---- replacements of the system's calls ----

using handrail::test::disk;
using handrail::test::fails;
using handrail::test::next;
using handrail::test::WriteFault;

extern "C" {

ssize_t write(int file, const void* data, size_t size) {
    static const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
    if (file <= 2) return real(file, data, size);
    if (disk.armed && disk.struck && disk.fault == WriteFault::ShortThenError) {
        errno = disk.error;
        return -1;
    }
    const bool was = disk.struck;
    if (fails()) return -1;
    const bool is_short = disk.armed && !was && disk.struck && disk.fault != WriteFault::Error;
    return real(file, data, is_short ? (size - size / 2 > 1 ? size - size / 2 - 1 : size) : size);
}

int fsync(int file) {
    static const auto real = next<int (*)(int)>("fsync");
    return fails() ? -1 : real(file);
}

int fchmod(int file, mode_t mode) {
    static const auto real = next<int (*)(int, mode_t)>("fchmod");
    return fails() ? -1 : real(file, mode);
}

int rename(const char* from, const char* to) {
    static const auto real = next<int (*)(const char*, const char*)>("rename");
    return fails() ? -1 : real(from, to);
}

int mkostemp(char* name, int flags) {
    static const auto real = next<int (*)(char*, int)>("mkostemp");
    return fails() ? -1 : real(name, flags);
}
}

void* operator new(std::size_t size) { return handrail::test::allocate_or_throw(size); }
void* operator new[](std::size_t size) { return handrail::test::allocate_or_throw(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return handrail::test::allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return handrail::test::allocate(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }
