// Stores the commands whose keys are held down now. Plain state for the app thread only.
#pragma once

#include <algorithm>
#include <vector>

#include "app/core/dialogue/command.h"

namespace handrail::core {

class HeldKeys {
public:
    HeldKeys() : down_(command_table().size(), false) {}

    void press(Command command) { down_[static_cast<std::size_t>(command)] = true; }
    void release(Command command) { down_[static_cast<std::size_t>(command)] = false; }
    void release_all() { std::fill(down_.begin(), down_.end(), false); }
    bool held(Command command) const { return down_[static_cast<std::size_t>(command)]; }
    bool any() const { return std::find(down_.begin(), down_.end(), true) != down_.end(); }
    // Returns 1 or -1 for one of two opposite keys, and 0 if neither or both are down.
    double sign(Command plus, Command minus) const { return (held(plus) ? 1.0 : 0.0) - (held(minus) ? 1.0 : 0.0); }

private:
    std::vector<bool> down_;
};

}  // namespace handrail::core
