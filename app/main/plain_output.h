// Filters the output of commands, because it may contain names from files of unknown origin. Drops direction controls,
// which would reverse the order of the following words, and all control characters except line ends and tabs. Only one
// thread may use an object. Costs one look at each byte.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace handrail::program {

class PlainOutput : std::streambuf, public std::ostream {
public:
    // `to` must outlive this object.
    explicit PlainOutput(std::ostream& to) : std::ostream(static_cast<std::streambuf*>(this)), to_(to) {}
    ~PlainOutput() override { let_go(); }
    PlainOutput(const PlainOutput&) = delete;
    PlainOutput& operator=(const PlainOutput&) = delete;

private:
    int overflow(int byte) override;
    int sync() override;
    void let_go();

    std::ostream& to_;
    std::string held_;  // the last bytes, which may be the beginning of a direction control; at most two
};

}  // namespace handrail::program
