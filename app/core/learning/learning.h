// Learning a place: what of its walls was touched and of its floor walked, and what is left. The place is a room of the
// world's room graph: the floor its body can stand on, widened to the walls. Plain state and pure functions; app
// thread; world metres. Notes cost nothing to speak of; looking at a room costs a few rays for every cell along its
// walls, once, when somebody asks.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "app/core/world/walker.h"
#include "worlds/navigation/rooms.h"

namespace handrail {

// Touched by hand or by a body that trails or bumps: a stretch of wall `reach_m` to either side of the point.
struct TouchNote {
    Vec3 point_m{0.0};
    Vec3 normal{0.0};  // level, out of the wall
    double reach_m = 0.0;
};

// What was done before at the same spot of a few centimetres is not noted again, so that a long session keeps all of
// it.
class LearningNotes {
public:
    void touched(const Vec3& point_m, const Vec3& normal, double reach_m);
    void walked(const Vec3& feet_m);
    const std::vector<TouchNote>& touches() const { return touches_; }
    const std::vector<Vec3>& steps_m() const { return steps_m_; }
    std::size_t count() const { return touches_.size() + steps_m_.size(); }
    // Something was touched or walked in that box.
    bool any_in(const Aabb& box) const;

private:
    std::vector<TouchNote> touches_;
    std::vector<Vec3> steps_m_;
    std::unordered_map<std::uint64_t, double> spots_;  // and how far the touch there reached
};

// A stretch of the outer boundary of a place, seen through the side of one cell.
struct WallSample {
    Vec3 point_m{0.0};
    Vec3 normal{0.0};
    FeatureId feature = kNoFeature;
    double length_m = 0.0;  // of wall; a slanted one is met by cells from two sides and shared between them
};

// A way out of a place. It is found by touching what closes it, or by going there.
struct PlaceExit {
    std::vector<FeatureId> features;  // of a door each leaf
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
// A room as a place to learn. Doors bound it, open or shut; so do other rooms, falls and steps too high to climb. What
// stands free in it is no wall. Its exits are the portals of the room and doors that lead nowhere; edges one would fall
// from are none.
Place place_of_room(const BodyWorld& world, const WalkSpace& space, const RoomGraph& graph, std::uint32_t room);

// A place and what of it is known.
class Learnt {
public:
    explicit Learnt(Place place);
    // Lays what was noted since the last time on it; costs nothing where that is nothing.
    void lay(const LearningNotes& notes);
    const Place& place() const { return place_; }
    bool knows_wall(std::size_t wall) const { return known_[wall]; }
    bool walked(int x, int y) const {
        return place_.is_free(x, y) && walked_[place_.at(x, y)];
    }  // within kFloorReach_m
    bool along_lane(int x, int y) const {
        return place_.is_free(x, y) && beside_[place_.at(x, y)];
    }  // nearer than that
    bool found(const PlaceExit& exit) const;

private:
    Place place_;
    std::vector<bool> known_, walked_, beside_, gone_to_;  // of walls, cells, cells and exits
    std::size_t touches_ = 0, steps_ = 0;                  // laid so far
};

struct WallProgress {
    FeatureId feature = kNoFeature;
    double length_m = 0.0, touched_m = 0.0;
    bool done() const { return touched_m >= 0.95 * length_m; }
};
struct Progress {
    double perimeter_m = 0.0, touched_m = 0.0;  // of walls and doors and what stands against them
    double floor_m2 = 0.0, walked_m2 = 0.0;     // walked: within half a metre of where one went
    std::vector<WallProgress> walls;            // of a hand's width and more, in the order of the boundary's features
    int exits = 0, exits_found = 0;
    bool doors_only = true;  // among the exits
    double perimeter_share() const { return perimeter_m > 0.0 ? touched_m / perimeter_m : 1.0; }
    double floor_share() const { return floor_m2 > 0.0 ? walked_m2 / floor_m2 : 1.0; }
    bool done() const { return perimeter_share() >= 0.95 && floor_share() >= 0.95; }
};
Progress progress_of(const Learnt& learnt);

// The nearest stretch of wall (at least half a metre) or floor (at least half a square metre) that is not known yet;
// none: all is.
struct Unexplored {
    Vec3 point_m{0.0};
    bool wall = false;
    FeatureId feature = kNoFeature;
};
std::optional<Unexplored> nearest_unexplored(const Learnt& learnt, const Vec3& feet_m);

// Lanes a metre apart across the whole place, first those that run north, then those that run east; done once most of
// it was walked along.
struct Lane {
    bool north = true;
    double at_m = 0.0;  // x of a lane that runs north, y of one that runs east
    double length_m = 0.0, walked_m = 0.0;
    bool done() const { return walked_m >= 0.8 * length_m; }
};
std::vector<Lane> lanes_of(const Learnt& learnt);

inline constexpr double kFloorReach_m = 0.5;  // to either side of where one walked

}  // namespace handrail
