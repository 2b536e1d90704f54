// Makes sure that the program ends in time once it has decided to end. The program then gives up work on other threads,
// such as the search for routes through a large building; some of that work is in libraries that cannot be stopped.
// Construct this object before everything whose destructor may have to wait. App thread. Once end_within was called,
// the object costs a sleeping thread.
#pragma once

#include <thread>

namespace handrail::program {

class EndInTime {
public:
    // Call this function after everything important is saved. If this object is not destroyed within `seconds`, the
    // process ends with `status`.
    void end_within(double seconds, int status);

private:
    std::jthread watch_;
};

}  // namespace handrail::program
