// Lets the parts of a session speak. The parts call a function that the owner of the session provides. App thread.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "worlds/base/clock.h"

namespace handrail::program {

class SessionVoice {
public:
    // The clock must outlive this object.
    SessionVoice(Clock& clock, std::function<void(std::string text, double requested_s)> speak)
        : clock_(clock), speak_(std::move(speak)) {}

    void operator()(std::string text) const { speak_(std::move(text), clock_.now_s()); }
    // Speaks a sentence. Sentences with the same `requested_s` form one reply: each waits for the one before. A
    // sentence with another `requested_s` interrupts them.
    void operator()(std::string text, double requested_s) const { speak_(std::move(text), requested_s); }

private:
    Clock& clock_;
    std::function<void(std::string, double)> speak_;
};

}  // namespace handrail::program
