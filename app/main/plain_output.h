// Filters what commands print, because names come from files that others made. It drops direction controls, which would
// reverse the words that follow, and all control characters except line ends and tabs. Used by one thread; costs a look
// at each byte.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace handrail::program {

class PlainOutput : std::streambuf, public std::ostream {
public:
    // `to` outlives this object.
    explicit PlainOutput(std::ostream& to) : std::ostream(static_cast<std::streambuf*>(this)), to_(to) {}
    ~PlainOutput() override { let_go(); }
    PlainOutput(const PlainOutput&) = delete;
    PlainOutput& operator=(const PlainOutput&) = delete;

private:
    int overflow(int byte) override;
    int sync() override;
    void let_go();

    std::ostream& to_;
    std::string held_;  // the first bytes of a possible direction control, at most two
};

}  // namespace handrail::program
