// Measures of people, and of what buildings do for people, on which several parts of the program must agree. Each
// stands here alone (a test looks). Estimates where no source is named.
#pragma once

namespace handrail {

inline constexpr double kGravity_m_per_s2 = 9.81;  // rounded from ISO 80000-3

// ---- reach and feet ----
inline constexpr double kArmsReach_m = 1.2;      // from the middle of the body to what it takes hold of or works
inline constexpr double kAtWall_m = 0.8;         // from the middle of the body to a wall that one stands at
inline constexpr double kHandTap_m = 0.005;      // of the hand, by one tap of a hand key
inline constexpr double kWalkableNormalZ = 0.7;  // of ground that carries: up to about 45 degrees of slope
inline constexpr double kMostDrop_m = 1.2;       // nobody steps down farther by intention

// ---- storeys ----
inline constexpr double kUsualStorey_m = 3.0;  // from floor to floor where a file says nothing
// What lies so much higher or lower than the person, or than another floor, is above or below and not beside.
inline constexpr double kAboveOrBelow_m = 1.5;
// Of a building and nothing else: higher storeys are faults of the file.
inline constexpr double kHighestStorey_m = 12.0;

// ---- doors and lifts ----
inline constexpr double kDoorWait_s = 3.0;      // that a door of a lift or a sliding door stands open
inline constexpr double kLiftDoorWait_s = 5.0;  // EN 81-70 asks for 2 to 20 s
inline constexpr double kStandingRoom_m = 1.8;  // over the floor of what carries a person
inline constexpr double kLeafThick_m = 0.04;
inline constexpr double kGroundAround_m = 8.0;     // of ground that is laid round a building
inline constexpr double kUnderThreshold_m = 0.02;  // so far that ground lies under the floor inside
inline constexpr double kOutsideDoor_m = 1.5;      // where one starts in front of a door to the outside

}  // namespace handrail
