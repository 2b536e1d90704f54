// Stores the rooms and routes of a world between two runs of the program. The functions receive and return bytes,
// so that the session needs to know nothing about files or processes. If they are empty, nothing is stored. They wait
// for the disk, so any thread except the app thread may call them.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/navigation/walk_space.h"

namespace handrail::core {

struct RoutesKeeper {
    // Returns the key of a world and a size of the walker (navigation_key in worlds/stored/stored_navigation.h).
    std::function<std::string(const Scene& scene, const navigation::WalkerMeasures& body)> key_of;
    // Returns the unpacked bytes stored under `key`, or an empty string.
    std::function<std::string(const std::string& key, const std::stop_token& stop)> take;
    // Stores bytes that stored_navigation has packed.
    std::function<void(const std::string& key, std::string_view packed)> keep;

    explicit operator bool() const { return key_of && take && keep; }
};

}  // namespace handrail::core
