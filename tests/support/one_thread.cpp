// Linked into test programs that say nothing of THREADS: whoever starts a thread there ends the program with a
// sentence. So the thread sanitizer, which is given only the programs that say THREADS, misses none. Stands in front of
// the C library's own function by the order in which names are looked up.
#include <pthread.h>

#include <cstdio>
#include <cstdlib>

extern "C" int pthread_create(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*) noexcept {
    std::fputs(
        "A thread was started in a test program that has none: say THREADS in its handrail_test(), so that the thread "
        "sanitizer runs it too.\n",
        stderr);
    std::abort();
}
