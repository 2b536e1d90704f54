// Measures of people, and of building parts made for people, that several parts of the program share. Each is defined
// only here, which a test checks. Values without a source are estimates.
#pragma once

namespace handrail {

inline constexpr double kGravity_m_per_s2 = 9.81;  // rounded from ISO 80000-3

// ---- reach and feet ----
inline constexpr double kArmsReach_m = 1.2;  // from the middle of the walker to what they grasp or operate
inline constexpr double kAtWall_m = 0.8;     // from the middle of the walker to a wall that they stand at
inline constexpr double kHandTap_m = 0.005;  // how far one press of a hand key moves the hand
// Least upward normal of ground that one can walk on: up to about 45 degrees of slope.
inline constexpr double kWalkableNormalZ = 0.7;
inline constexpr double kMostDrop_m = 1.2;  // nobody intends to step down farther than this

// ---- storeys ----
inline constexpr double kUsualStorey_m = 3.0;  // floor to floor, if the file does not say
// Things at least this much higher or lower than the person or than another floor count as above or below, not as next
// to.
inline constexpr double kAboveOrBelow_m = 1.5;
// Only buildings have storeys up to this height; a higher storey is a fault of the file.
inline constexpr double kHighestStorey_m = 12.0;

// ---- doors and lifts ----
inline constexpr double kDoorWait_s = 3.0;      // how long the door of a lift or a sliding door stands open
inline constexpr double kLiftDoorWait_s = 5.0;  // EN 81-70 requires 2 to 20 s
inline constexpr double kStandingRoom_m = 1.8;  // above the floor of something that carries a person
inline constexpr double kLeafThick_m = 0.04;
inline constexpr double kGroundAround_m = 8.0;     // width of the ground that readers lay round a building
inline constexpr double kUnderThreshold_m = 0.02;  // how far that ground lies under the floor inside
inline constexpr double kOutsideDoor_m = 1.5;      // how far in front of an outside door a walk starts

}  // namespace handrail
