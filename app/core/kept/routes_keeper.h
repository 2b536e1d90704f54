// Stores the rooms and routes of a world between two starts. Two functions over bytes, so that the session knows
// neither files nor processes. If they are empty, nothing is stored. Any thread except the app thread, because they
// wait for the disk.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

namespace handrail::core {

struct RoutesKeeper {
    // Returns what is stored under that key (ways_key in worlds/stored/stored_ways.h), unpacked; empty: nothing.
    std::function<std::string(const std::string& key, const std::stop_token& stop)> take;
    // Stores the packed bytes made by stored_ways.
    std::function<void(const std::string& key, std::string_view packed)> keep;

    explicit operator bool() const { return take && keep; }
};

}  // namespace handrail::core
