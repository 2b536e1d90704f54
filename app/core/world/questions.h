// What a person asks of a place and what is answered: what is around, ahead, in one direction. Line of sight only: what
// stands behind a wall or a closed door is not told of. Pure functions over an immutable world; metres and radians; app
// thread. How much is told of a thing, by Settings::Speech::verbosity (a person who asks is always owed a name, so 0 is
// as 1):
//   1 "Door"   2 "Door, 4 steps ahead"; a surface with its material   3 "Door, wood, shut, hinged left, 4 steps ahead"
//   4 "Door: it is 4 steps ahead. It is made of wood. It is shut, hinged left."
// Directions are told by sixteenths of a circle, as exits are; in degrees where distances are told exactly.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/core/dialogue/words.h"
#include "app/core/world/body_meets.h"

namespace handrail {

inline constexpr double kLookHeight_m = 1.0;  // rays for words leave the body here, above most furniture
inline constexpr std::size_t kMostAhead = 4;

// Where a door lets one through, whose leaf may stand open beside it.
struct Doorway {
    FeatureId door;
    Vec3 place_m{0.0};
};

struct Asker {
    const BodyWorld& world;
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
    BodySize size{};                  // what stands in its way is in the way of all of it
    std::vector<Doorway> doorways{};  // doors that are told by them, as exits are; others by what is seen of them
};

// A thing, a surface or a sound that can be told of.
struct Sight {
    Seen seen;         // seen.feature is kNoFeature where it is a sound
    std::string name;  // without the material
    std::string material;
    bool surface = false;  // wall, floor, ceiling or slope
};

// Things and named sounds in line of sight, nearest first, at most `most`; of several with one name the nearest.
std::vector<Sight> in_sight(const Asker& asker, std::size_t most);
// What a body would bump into straight in that direction; none: nothing within kSightRange_m.
std::optional<Sight> sight_along(const Asker& asker, double bearing_rad);

// "Around me": for each quarter ahead, right, behind and left the nearest thing there, else what a straight look meets,
// else nothing.
std::array<std::optional<Sight>, 4> around(const Asker& asker);
// "Ahead of me": what lies within 45 degrees of straight ahead, the wall there too, nearest first, at most kMostAhead.
std::vector<Sight> ahead(const Asker& asker);
// "Look": things within 11.25 degrees of that bearing, nearest first, at most two, and then what a straight look meets
// where it is farther.
std::vector<Sight> look_towards(const Asker& asker, double bearing_rad);

// How things are told.
struct Telling {
    int verbosity = 2;
    DirectionChoice directions = DirectionChoice::Sides;
    DistanceWords distances;
    double heading_rad = 0.0;
};
// state: "shut", "open", ...; empty where it has none. Side words as the person sees it from where they stand.
std::string tell(const Sight& sight, const std::string& state, const Telling& how);
// The same where its direction has been told already: "table, 2 steps".
std::string tell_there(const Sight& sight, const std::string& state, const Telling& how);
// "hinged left, handle right" of a door seen in that direction; empty where the world does not say.
std::string sides_of_door(const Feature& door, double bearing_rad);

// "9 by 6 steps.", what its size in metres is in the person's own.
std::string steps_of_size(const Feature& feature, const DistanceWords& how);

// The directions of "look", one press after the other: straight ahead first, then clockwise by sixteenths of a circle.
// Begins anew where the body moved or turned, and where the hand moved: then with the direction in which the hand
// points.
class LookRound {
public:
    // hand_rad: the bearing from body to hand where a hand is held away from the body.
    double step(int by, const Vec3& feet_m, double heading_rad, std::optional<double> hand_rad);

private:
    bool begun_ = false;
    Vec3 feet_m_{0.0};
    double heading_rad_ = 0.0, bearing_rad_ = 0.0;
    std::optional<double> hand_rad_;
};

// "5 steps are 3.5 metres." and, with a hand, what that is under it; then where north is. Under a roof the bar is 5
// steps, outdoors 25 metres. hand_scale: world metres per hand metre, 0 without a hand; workspace_heading_rad: where
// the hand's "away from you" leads.
std::string scale_bar_words(bool outdoors, const Telling& how, double hand_scale, double workspace_heading_rad);
// "3.0 metres east, 0.5 metres north, height 0 metres." from the world's origin.
std::string coordinates_words(const Vec3& place_m);
// Height of a place above the nearest floor below it, 0 to 100 m; none: nothing is below.
std::optional<double> above_floor_m(const BodyWorld& world, const Vec3& place_m);
// Something is above the head, within 30 m.
bool under_roof(const BodyWorld& world, const Vec3& feet_m);

}  // namespace handrail
