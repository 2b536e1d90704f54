// Measures of people, and of building parts made for people, that several parts of the program share. Each measure is
// defined only here; a test checks that. Values without a source are estimates.
#pragma once

namespace handrail {

inline constexpr double kGravity_m_per_s2 = 9.81;  // acceleration of free fall, rounded from ISO 80000-3

// ---- reach and feet ----
inline constexpr double kArmsReach_m = 1.2;  // greatest distance from the middle of the walker to an object in reach
inline constexpr double kAtWall_m = 0.8;     // distance from the middle of the walker to a wall that they stand at
inline constexpr double kHandTap_m = 0.005;  // distance by which one press of a hand key moves the hand
// Least z of the unit normal of walkable ground: it allows slopes of up to about 45 degrees.
inline constexpr double kWalkableNormalZ = 0.7;
inline constexpr double kMostDrop_m = 1.2;  // height of the deepest step down that anybody takes on purpose

// ---- storeys ----
inline constexpr double kUsualStorey_m = 3.0;  // height of a storey from floor to floor, assumed if the file gives none
// A thing is announced as above or below the person (or a floor as above or below another) from this height difference.
// With a smaller difference it is next to the person.
inline constexpr double kAboveOrBelow_m = 1.5;
// Greatest height of a storey. A higher storey is treated as a fault of the file.
inline constexpr double kHighestStorey_m = 12.0;

// ---- doors and lifts ----
inline constexpr double kDoorWait_s = 3.0;  // how long a sliding door stays open
// How long a lift door stays open. EN 81-70 requires 2 to 20 s. A person hears the next direction meanwhile, which
// takes several seconds.
inline constexpr double kLiftDoorWait_s = 10.0;
// Least free height above the floor of a lift or another platform that carries a person.
inline constexpr double kStandingRoom_m = 1.8;
inline constexpr double kLeafThick_m = 0.04;
inline constexpr double kGroundAround_m = 8.0;     // width of the strip of ground that readers add around a building
inline constexpr double kUnderThreshold_m = 0.02;  // how far that strip of ground is below the floor inside
inline constexpr double kOutsideDoor_m = 1.5;      // distance in front of an outside door at which the person starts

}  // namespace handrail
