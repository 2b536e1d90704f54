// Answers what a person asks about a place: what is around, ahead, or in one direction. Only things in line of sight
// are mentioned: nothing behind a wall or a closed door. Pure functions over an immutable world, in metres and radians,
// for the app thread.
// Settings::Speech::verbosity sets how much is said about a thing. 0 is treated as 1, because a person who asks always
// gets a name:
//   1 "Door"   2 "Door, 4 steps ahead"; a surface with its material   3 "Door, wood, shut, hinged left, 4 steps ahead"
//   4 "Door: it is 4 steps ahead. It is made of wood. It is shut, hinged left."
// Directions use sixteenths of a circle, as for exits. If distances are exact, directions use degrees.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/core/dialogue/words.h"
#include "app/core/world/walker_meets.h"

namespace handrail::core {

inline constexpr double kLookHeight_m = 1.0;  // height of the start of rays for descriptions, above most furniture
inline constexpr std::size_t kMostAhead = 4;

// The place where a person passes a door. Its open leaf may be next to that place.
struct Doorway {
    FeatureId door;
    Vec3 place_m{0.0};
};

struct Viewpoint {
    const WalkerWorld& world;
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
    // Size of the walker. An obstacle is everything that would stop any part of a walker of this size.
    WalkerSize size{};
    // Doorways of the doors that are announced by their doorway, as exits are. Any other door is announced by its
    // visible part.
    std::vector<Doorway> doorways{};
};

// A thing, a surface or a sound that can be announced.
struct Sight {
    Seen seen;         // seen.feature is kNoFeature for a sound
    std::string name;  // name without the material
    std::string material;
    bool surface = false;  // true: a wall, floor, ceiling or slope
};

// Returns things and named sounds in line of sight, the nearest first, at most `most`. If several have the same name,
// only the nearest of them is included. A sound that comes from one of the things is left out.
std::vector<Sight> in_sight(const Viewpoint& viewpoint, std::size_t most);
// Returns what a walker would bump into straight in this direction, or no value if nothing is within kSightRange_m.
std::optional<Sight> sight_along(const Viewpoint& viewpoint, double bearing_rad);

// For "around me". Returns one entry for each of the quarters ahead, right, behind and left. The entry is the nearest
// thing, or else what a straight ray hits, or else no value.
std::array<std::optional<Sight>, 4> around(const Viewpoint& viewpoint);
// For "ahead of me". Returns everything within 45 degrees of straight ahead, including the wall, the nearest first, at
// most kMostAhead.
std::vector<Sight> ahead(const Viewpoint& viewpoint);
// For "look". Returns at most two things within 11.25 degrees of this bearing, the nearest first. If a straight ray
// hits something farther away, the list ends with that.
std::vector<Sight> look_towards(const Viewpoint& viewpoint, double bearing_rad);

// How the person wants things to be announced.
struct DescriptionStyle {
    int verbosity = 2;
    settings::DirectionChoice directions = settings::DirectionChoice::Sides;
    DistanceWords distances;
    double heading_rad = 0.0;
};
// Returns the announcement of a thing. `state` is "shut", "open" and so on, or empty if the thing has no state. Left
// and right are as seen from the person's place.
std::string describe(const Sight& sight, const std::string& state, const DescriptionStyle& how);
// Returns the announcement without the direction, which has already been announced: "table, 2 steps".
std::string describe_there(const Sight& sight, const std::string& state, const DescriptionStyle& how);
// Returns "hinged left, handle right" for a door seen in this direction, or an empty text if the world does not state
// these sides.
std::string sides_of_door(const Feature& door, double bearing_rad);

// For a feature whose size is given in metres, returns the size in steps: "9 by 6 steps."
std::string steps_of_size(const Feature& feature, const DistanceWords& how);

// Provides the directions of "look" for successive presses: straight ahead first, then clockwise by sixteenths of a
// circle. The series begins again if the walker has moved or turned. If the hand has moved, the series begins with the
// direction in which the hand points.
class LookRound {
public:
    // Returns the next direction. `hand_rad` is the bearing from the walker to the hand, if the hand is away from the
    // walker.
    double step(int by, const Vec3& feet_m, double heading_rad, std::optional<double> hand_rad);

private:
    bool begun_ = false;
    Vec3 feet_m_{0.0};
    double heading_rad_ = 0.0, bearing_rad_ = 0.0;
    std::optional<double> hand_rad_;
};

// Returns "5 steps are 3.5 metres.", the direction of north, and with a hand also that length under the hand. The
// length is 5 steps indoors and 25 metres outdoors. `hand_scale` is in world metres per hand metre, 0 without a hand.
// `workspace_heading_rad` is the world direction that is "away from you" for the hand.
std::string scale_bar_words(bool outdoors, const DescriptionStyle& how, double hand_scale,
                            double workspace_heading_rad);
// Returns the position relative to the origin of the world: "3.0 metres east, 0.5 metres north, height 0 metres."
std::string coordinates_words(const Vec3& place_m);
// Returns the height of a place above the nearest floor below it, 0 to 100 m. Returns no value if there is no floor
// below.
std::optional<double> above_floor_m(const WalkerWorld& world, const Vec3& place_m);
// Returns true if something is above the head within 30 m.
bool under_roof(const WalkerWorld& world, const Vec3& feet_m);

}  // namespace handrail::core
