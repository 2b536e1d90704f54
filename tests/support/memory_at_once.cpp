// In programs of tests under a sanitizer: memory that is asked for in blocks of 128 kB and more comes at once instead
// of page by page as it is touched, each page of which costs a virtual machine some microseconds; blocks of 2 MB and
// more in pages of that size, where the kernel has them. What glibc does by itself elsewhere (glibc.malloc.hugetlb, see
// CMakePresets.json) the sanitizers' allocators do not. It changes nothing that a test can see.

#include <sanitizer/allocator_interface.h>
#include <sys/mman.h>

#include <cstdint>

namespace {

constexpr std::size_t kBlock = 128U << 10U, kLargePage = 2U << 20U, kPage = 4096;

// Any thread, within its allocation. What the kernel refuses, and an older one does, is only slower.
void at_once(const volatile void* begin, std::size_t size) {
    if (size < kBlock) return;
    const auto address = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t whole = (address + kPage - 1) / kPage * kPage;
    const std::size_t length = (address + size - whole) / kPage * kPage;
    ::madvise(reinterpret_cast<void*>(whole), length, size < kLargePage ? MADV_POPULATE_WRITE : MADV_HUGEPAGE);
}

const int installed = __sanitizer_install_malloc_and_free_hooks(at_once, [](const volatile void*) {});

}  // namespace
