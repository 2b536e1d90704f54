// A page has one thread, which needs no name.
#include <pthread.h>

extern "C" int pthread_setname_np(pthread_t /*thread*/, const char* /*name*/) { return 0; }
