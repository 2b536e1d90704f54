// Linked into test programs of which not every test says THREADS: who starts a thread elsewhere ends the program with a
// sentence. So the thread sanitizer, which is given only what says THREADS, misses none. Stands in front of the C
// library's own function by the order in which names are looked up. HANDRAIL_THREADS_IN: the tests of the program that
// may start threads, as `Suite.*` and `Suite.name` with colons between.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace one_thread {

bool may_start_threads() {
#ifdef HANDRAIL_THREADS_IN
    constexpr std::string_view listed = HANDRAIL_THREADS_IN;
#else
    constexpr std::string_view listed;
#endif
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    if (!test) return false;
    const std::string suite = std::string(test->test_suite_name()) + ".", name = suite + test->name();
    for (std::string_view left = listed; !left.empty();) {
        const std::size_t end = left.find(':');
        const std::string_view one = left.substr(0, end);
        left = end == std::string_view::npos ? std::string_view() : left.substr(end + 1);
        if (one == name || (one.ends_with(".*") && one.substr(0, one.size() - 1) == suite)) return true;
    }
    return false;
}

}  // namespace one_thread

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                              void* argument) noexcept {
    if (one_thread::may_start_threads()) {
        using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
        static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
        if (create) return create(thread, attributes, start, argument);
    }
    std::fputs(
        "A thread was started in a test that has none: say THREADS in its handrail_test(), or name it in THREADS_IN "
        "there, so that the "
        "thread sanitizer runs it too.\n",
        stderr);
    std::abort();
}
