// What commands print, without what would steer a terminal or turn round the words that follow: names come from files
// that others made. Control characters but line ends and tabs, and direction controls, are left out. One thread; costs
// a look at each byte.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace handrail {

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
    std::string held_;  // the begin of what may be a direction control, up to two bytes
};

}  // namespace handrail
