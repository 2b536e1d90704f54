// Defines what a stick, a puck or a pad in the hand requests of the walker. Plain data, which any thread may use.
#pragma once

namespace handrail::core {

// Shares of the walking speed and of the turning rate, from -1 to 1; 0 is the rest position.
struct Steering {
    double ahead = 0.0, right = 0.0, turn_right = 0.0;
    double cane_right_rad_per_s = 0.0;  // how fast a pad turns to the right in the hand, which swings the cane
    bool operator==(const Steering&) const = default;
};

}  // namespace handrail::core
