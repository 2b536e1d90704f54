// Measures how much of a room the person has learnt: which walls were touched, which floor was walked, and what is
// left. A Place is a room of the world's room graph: the floor where the walker can stand, extended to the walls. Plain
// state and pure functions for the app thread, in world metres. Adding a note costs almost nothing. Examining a room
// casts a few rays for each cell along its walls, once, on the first query.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "app/core/world/walker.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// A touch by the hand, or by a walker that trails a wall or bumps into it. The touch covers the wall for `reach_m` on
// either side of `point_m`.
struct TouchNote {
    Vec3 point_m{0.0};
    Vec3 normal{0.0};  // normal of the wall; horizontal, points out of the wall
    double reach_m = 0.0;
};

// All touches and steps of a session. A touch or step at a spot that is already stored is dropped, unless a touch
// reaches farther than before. A spot is a few centimetres wide, so even a long session needs little memory.
class LearningNotes {
public:
    void touched(const Vec3& point_m, const Vec3& normal, double reach_m);
    void walked(const Vec3& feet_m);
    const std::vector<TouchNote>& touches() const { return touches_; }
    const std::vector<Vec3>& steps_m() const { return steps_m_; }
    std::size_t count() const { return touches_.size() + steps_m_.size(); }
    // Returns true if any touch or step is inside the box.
    bool any_in(const Aabb& box) const;

private:
    std::vector<TouchNote> touches_;
    std::vector<Vec3> steps_m_;
    std::unordered_map<std::uint64_t, double> spots_;  // the reach of the touch at each spot
};

// A piece of the outer boundary of a place, as seen from one side of one cell.
struct WallSample {
    Vec3 point_m{0.0};
    Vec3 normal{0.0};
    FeatureId feature = kNoFeature;
    // Length of wall that this sample stands for. If two cells see a slanted wall, they share its length.
    double length_m = 0.0;
};

// An exit of a place. It is found once the person has touched what closes the exit, or has been there.
struct PlaceExit {
    std::vector<FeatureId> features;  // all leaves of the door
    Vec3 at_m{0.0};
    double width_m = 0.0;
    bool door = false;
};

struct Place {
    double cell_m = 0.05;
    Vec3 origin_m{0.0};  // south-west corner of the first cell, at the mean height of the floor
    int wide = 0, deep = 0;
    std::vector<bool> free;       // `wide` times `deep` cells, in rows from south to north
    std::vector<float> height_m;  // height of each free cell above the origin
    std::vector<WallSample> walls;
    std::vector<PlaceExit> exits;

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(wide) + static_cast<std::size_t>(x);
    }
    bool is_free(int x, int y) const { return x >= 0 && y >= 0 && x < wide && y < deep && free[at(x, y)]; }
    Vec3 middle_m(int x, int y) const {
        return origin_m + Vec3((x + 0.5) * cell_m, (y + 0.5) * cell_m, static_cast<double>(height_m[at(x, y)]));
    }
    double area_m2() const;
};
// Makes the place to learn from a room. The boundary of the place consists of walls, doors, open or shut, other rooms,
// drops and steps too high to climb. Free-standing objects are not part of the boundary. Its exits are the portals of
// the room and doors that lead nowhere, but not edges with a drop.
Place place_of_room(const WalkerWorld& world, const navigation::WalkSpace& space, const navigation::RoomGraph& graph,
                    std::uint32_t room);

// A place, together with the parts of it that the person knows.
class Learnt {
public:
    explicit Learnt(Place place);
    // Adds the notes that were made since the last call. If there are none, the call costs nothing.
    void lay(const LearningNotes& notes);
    const Place& place() const { return place_; }
    bool knows_wall(std::size_t wall) const { return known_[wall]; }
    bool walked(int x, int y) const {
        return place_.is_free(x, y) && walked_[place_.at(x, y)];
    }  // returns true if the cell is within kFloorReach_m of the person's path
    bool along_lane(int x, int y) const {
        return place_.is_free(x, y) && beside_[place_.at(x, y)];
    }  // returns true if the cell is so near to the person's path that a lane there is walked
    bool found(const PlaceExit& exit) const;

private:
    Place place_;
    // What the person knows of each wall, cell, cell and exit, in this order.
    std::vector<bool> known_, walked_, beside_, taken_;
    std::size_t touches_ = 0, steps_ = 0;  // numbers of touches and steps that lay() has used until now
};

struct WallProgress {
    FeatureId feature = kNoFeature;
    double length_m = 0.0, touched_m = 0.0;
    bool done() const { return touched_m >= 0.95 * length_m; }
};
struct Progress {
    double perimeter_m = 0.0, touched_m = 0.0;  // both lengths include doors and what stands against the walls
    double floor_m2 = 0.0, walked_m2 = 0.0;     // walked: within half a metre of the person's path
    std::vector<WallProgress> walls;  // walls of at least the width of a hand, in the order of the boundary's features
    int exits = 0, exits_found = 0;
    bool doors_only = true;  // true: all exits are doors
    double perimeter_share() const { return perimeter_m > 0.0 ? touched_m / perimeter_m : 1.0; }
    double floor_share() const { return floor_m2 > 0.0 ? walked_m2 / floor_m2 : 1.0; }
    bool done() const { return perimeter_share() >= 0.95 && floor_share() >= 0.95; }
};
Progress progress_of(const Learnt& learnt);

// The nearest part of the place that the person does not know yet: a stretch of wall of at least half a metre, or a
// floor area of at least half a square metre. nearest_unexplored() returns no value if the person knows everything.
struct Unexplored {
    Vec3 point_m{0.0};
    bool wall = false;
    FeatureId feature = kNoFeature;
};
std::optional<Unexplored> nearest_unexplored(const Learnt& learnt, const Vec3& feet_m);

// One of the parallel strips, one metre apart, that cross the whole place. The lanes that run north come first, then
// those that run east. A lane is done once the person has walked along most of it.
struct Lane {
    bool north = true;
    double at_m = 0.0;  // x coordinate of a lane that runs north, y coordinate of a lane that runs east
    double length_m = 0.0, walked_m = 0.0;
    bool done() const { return walked_m >= 0.8 * length_m; }
};
std::vector<Lane> lanes_of(const Learnt& learnt);

// Floor within this distance on either side of the person's path has been walked.
inline constexpr double kFloorReach_m = 0.5;

}  // namespace handrail::core
