// What a person asks about a place, and the answers: what is around, ahead, in one direction. Line of sight only: what
// is behind a wall or a closed door is not mentioned. Pure functions over an immutable world; metres and radians; app
// thread.
// Settings::Speech::verbosity sets how much is said about a thing; 0 acts as 1, because a person who asks always gets a
// name:
//   1 "Door"   2 "Door, 4 steps ahead"; a surface with its material   3 "Door, wood, shut, hinged left, 4 steps ahead"
//   4 "Door: it is 4 steps ahead. It is made of wood. It is shut, hinged left."
// Directions use sixteenths of a circle, as for exits; if distances are exact, they use degrees.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/core/dialogue/words.h"
#include "app/core/world/body_meets.h"

namespace handrail::core {

inline constexpr double kLookHeight_m = 1.0;  // origin of rays for words, above most furniture
inline constexpr std::size_t kMostAhead = 4;

// Where a door lets a person through; its open leaf may be next to it.
struct Doorway {
    FeatureId door;
    Vec3 place_m{0.0};
};

struct Asker {
    const WalkerWorld& world;
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
    WalkerSize size{};  // an obstacle to any part of this body counts
    // Of doors announced by their doorway, as exits are; other doors by what is seen of them.
    std::vector<Doorway> doorways{};
};

// A thing, a surface or a sound that can be announced.
struct Sight {
    Seen seen;         // seen.feature is kNoFeature for a sound
    std::string name;  // without the material
    std::string material;
    bool surface = false;  // wall, floor, ceiling or slope
};

// Things and named sounds in line of sight, nearest first, at most `most`. If several have the same name, only the
// nearest.
std::vector<Sight> in_sight(const Asker& asker, std::size_t most);
// What a walker would bump into straight in that direction; no value: nothing within kSightRange_m.
std::optional<Sight> sight_along(const Asker& asker, double bearing_rad);

// "Around me": for each of the quarters ahead, right, behind and left, the nearest thing there, otherwise what a
// straight ray hits, otherwise nothing.
std::array<std::optional<Sight>, 4> around(const Asker& asker);
// "Ahead of me": everything within 45 degrees of straight ahead, including the wall, nearest first, at most kMostAhead.
std::vector<Sight> ahead(const Asker& asker);
// "Look": at most two things within 11.25 degrees of that bearing, nearest first, and then what a straight ray hits, if
// that is farther.
std::vector<Sight> look_towards(const Asker& asker, double bearing_rad);

// The person's choice of words.
struct Telling {
    int verbosity = 2;
    settings::DirectionChoice directions = settings::DirectionChoice::Sides;
    DistanceWords distances;
    double heading_rad = 0.0;
};
// state: "shut", "open", ...; empty if it has none. Left and right are as seen from the person's place.
std::string tell(const Sight& sight, const std::string& state, const Telling& how);
// The same without the direction, which has been announced already: "table, 2 steps".
std::string tell_there(const Sight& sight, const std::string& state, const Telling& how);
// "hinged left, handle right" for a door seen in that direction; empty if the world does not say.
std::string sides_of_door(const Feature& door, double bearing_rad);

// "9 by 6 steps.": its size in steps, for one given in metres.
std::string steps_of_size(const Feature& feature, const DistanceWords& how);

// The directions of "look" for successive presses: straight ahead first, then clockwise by sixteenths of a circle. The
// series begins again if the walker moved or turned. If the hand moved, it begins with the direction in which the hand
// points.
class LookRound {
public:
    // hand_rad: bearing from walker to hand if the hand is away from the walker.
    double step(int by, const Vec3& feet_m, double heading_rad, std::optional<double> hand_rad);

private:
    bool begun_ = false;
    Vec3 feet_m_{0.0};
    double heading_rad_ = 0.0, bearing_rad_ = 0.0;
    std::optional<double> hand_rad_;
};

// "5 steps are 3.5 metres." and, with a hand, what that is under the hand; then the direction of north. Indoors the bar
// is 5 steps, outdoors 25 metres. hand_scale: world metres per hand metre, 0 without a hand. workspace_heading_rad:
// world direction of the hand's "away from you".
std::string scale_bar_words(bool outdoors, const Telling& how, double hand_scale, double workspace_heading_rad);
// "3.0 metres east, 0.5 metres north, height 0 metres.", from the world's origin.
std::string coordinates_words(const Vec3& place_m);
// Height of a place above the nearest floor below it, 0 to 100 m; no value: nothing is below.
std::optional<double> above_floor_m(const WalkerWorld& world, const Vec3& place_m);
// True if something is above the head, within 30 m.
bool under_roof(const WalkerWorld& world, const Vec3& feet_m);

}  // namespace handrail::core
