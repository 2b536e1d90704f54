// Learning a place: which of its walls were touched, which of its floor was walked, and what is left. The place is a
// room of the world's room graph: the floor where the walker can stand, widened to the walls. Plain state and pure
// functions; app thread; world metres. Notes cost almost nothing. Examining a room costs a few rays for each cell along
// its walls, once, on the first query.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "app/core/world/walker.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// A touch by the hand, or by a walker that trails or bumps into a wall: a stretch of wall `reach_m` to either side of
// the point.
struct TouchNote {
    Vec3 point_m{0.0};
    Vec3 normal{0.0};  // level, out of the wall
    double reach_m = 0.0;
};

// A repetition at the same spot of a few centimetres is not noted again, so that a long session keeps everything.
class LearningNotes {
public:
    void touched(const Vec3& point_m, const Vec3& normal, double reach_m);
    void walked(const Vec3& feet_m);
    const std::vector<TouchNote>& touches() const { return touches_; }
    const std::vector<Vec3>& steps_m() const { return steps_m_; }
    std::size_t count() const { return touches_.size() + steps_m_.size(); }
    // True if anything in that box was touched or walked on.
    bool any_in(const Aabb& box) const;

private:
    std::vector<TouchNote> touches_;
    std::vector<Vec3> steps_m_;
    std::unordered_map<std::uint64_t, double> spots_;  // with the reach of the touch there
};

// A stretch of the outer boundary of a place, as seen through the side of one cell.
struct WallSample {
    Vec3 point_m{0.0};
    Vec3 normal{0.0};
    FeatureId feature = kNoFeature;
    double length_m = 0.0;  // length of wall; a slanted wall is shared between the cells that see it from two sides
};

// An exit of a place. It counts as found once the person touches what closes it, or goes there.
struct PlaceExit {
    std::vector<FeatureId> features;  // every leaf of a door
    Vec3 at_m{0.0};
    double width_m = 0.0;
    bool door = false;
};

struct Place {
    double cell_m = 0.05;
    Vec3 origin_m{0.0};  // south-west corner of the first cell, at the mean height of the floor
    int wide = 0, deep = 0;
    std::vector<bool> free;       // wide x deep, row by row from the south
    std::vector<float> height_m;  // of each free cell, above the origin
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
// A room as a place to learn. Its boundary is doors, open or shut, other rooms, drops and steps too high to climb.
// Free-standing objects are not walls. Its exits are the portals of the room and doors that lead nowhere; edges with a
// drop are not exits.
Place place_of_room(const WalkerWorld& world, const navigation::WalkSpace& space, const navigation::RoomGraph& graph,
                    std::uint32_t room);

// A place and what is known of it.
class Learnt {
public:
    explicit Learnt(Place place);
    // Adds what was noted since the last call; costs nothing if that is nothing.
    void lay(const LearningNotes& notes);
    const Place& place() const { return place_; }
    bool knows_wall(std::size_t wall) const { return known_[wall]; }
    bool walked(int x, int y) const {
        return place_.is_free(x, y) && walked_[place_.at(x, y)];
    }  // within kFloorReach_m of the person's path
    bool along_lane(int x, int y) const {
        return place_.is_free(x, y) && beside_[place_.at(x, y)];
    }  // nearer than that
    bool found(const PlaceExit& exit) const;

private:
    Place place_;
    std::vector<bool> known_, walked_, beside_, gone_to_;  // of walls, cells, cells and exits
    std::size_t touches_ = 0, steps_ = 0;                  // number of notes used up to now
};

struct WallProgress {
    FeatureId feature = kNoFeature;
    double length_m = 0.0, touched_m = 0.0;
    bool done() const { return touched_m >= 0.95 * length_m; }
};
struct Progress {
    double perimeter_m = 0.0, touched_m = 0.0;  // of walls, doors and what stands against them
    double floor_m2 = 0.0, walked_m2 = 0.0;     // walked: within half a metre of the person's path
    std::vector<WallProgress> walls;            // at least a hand's width, in the order of the boundary's features
    int exits = 0, exits_found = 0;
    bool doors_only = true;  // all exits are doors
    double perimeter_share() const { return perimeter_m > 0.0 ? touched_m / perimeter_m : 1.0; }
    double floor_share() const { return floor_m2 > 0.0 ? walked_m2 / floor_m2 : 1.0; }
    bool done() const { return perimeter_share() >= 0.95 && floor_share() >= 0.95; }
};
Progress progress_of(const Learnt& learnt);

// The nearest stretch of wall (at least half a metre) or floor (at least half a square metre) that is not known yet; no
// value: everything is known.
struct Unexplored {
    Vec3 point_m{0.0};
    bool wall = false;
    FeatureId feature = kNoFeature;
};
std::optional<Unexplored> nearest_unexplored(const Learnt& learnt, const Vec3& feet_m);

// Lanes one metre apart across the whole place, first those that run north, then those that run east. A lane is done
// once most of it was walked along.
struct Lane {
    bool north = true;
    double at_m = 0.0;  // x of a lane that runs north, y of one that runs east
    double length_m = 0.0, walked_m = 0.0;
    bool done() const { return walked_m >= 0.8 * length_m; }
};
std::vector<Lane> lanes_of(const Learnt& learnt);

inline constexpr double kFloorReach_m = 0.5;  // to either side of the person's path

}  // namespace handrail::core
