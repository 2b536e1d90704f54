// Where the rooms and ways of a world are kept between two starts: two functions over bytes, so that the session knows
// no files and no processes. Without them nothing is kept. Any thread but the app's, because they wait for the disk.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

namespace handrail {

struct WaysKeeper {
    // What was kept under that key (ways_key in worlds/stored/stored_ways.h), unpacked; empty: nothing.
    std::function<std::string(const std::string& key, const std::stop_token& stop)> take;
    // Of stored_ways.
    std::function<void(const std::string& key, std::string_view packed)> keep;

    explicit operator bool() const { return take && keep; }
};

}  // namespace handrail
