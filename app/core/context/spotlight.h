// Restricts what sounds to a beam, like a spotlight in the dark: the world's own sounds, marks, landmarks and clues
// sound only inside the beam. The beam starts at the walker and points straight ahead or towards the hand. Warnings,
// the beacon and the sounds of touch are not restricted. Pure functions of the context, for the app thread.
#pragma once

#include <optional>

#include "app/core/context/session_context.h"

namespace handrail::core {

// A sector of the horizontal plane. Height does not matter.
struct Spotlight {
    Vec3 from_m{0.0};
    double heading_rad = 0.0, half_rad = kPi;

    // Returns true if the place is inside the sector or within kAtHand_m of its origin.
    bool shows(const Vec3& place_m) const;
    static constexpr double kAtHand_m = 0.3;
};

// Returns the beam that the settings choose. Returns no value if the spotlight is off. If the position of the hand is
// unknown, or the hand is at the walker, a beam towards the hand points ahead.
std::optional<Spotlight> spotlight(const SessionContext& context);
// Switches to the next kind of spotlight and announces it: ahead, towards the hand, off. Without a hand, the second one
// is left out.
void turn_spotlight_on(const SessionContext& context, double now_s);

}  // namespace handrail::core
