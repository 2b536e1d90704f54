// Belongs to test programs in which only some tests start threads. If any other test starts a thread, the program ends
// with a sentence. The thread sanitizer runs only the tests that handrail_test() in CMake calls THREADED, so this check
// ensures that no test with threads is left out. The linker finds the function below first, so it replaces the C
// library's own. The environment variable HANDRAIL_THREADED has the patterns of the tests that may start threads,
// separated by colons.
#include <dlfcn.h>
#include <fnmatch.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

namespace one_thread {

bool may_start_threads() {
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    if (!test) return false;
    const std::string name = std::string(test->test_suite_name()) + "." + test->name();
    std::istringstream patterns(HANDRAIL_THREADED);
    for (std::string pattern; std::getline(patterns, pattern, ':');)
        if (::fnmatch(pattern.c_str(), name.c_str(), 0) == 0) return true;
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
        "A test started a thread that handrail_test() does not call THREADED. Name the test there, so that the thread "
        "sanitizer runs it, too.\n",
        stderr);
    std::abort();
}
