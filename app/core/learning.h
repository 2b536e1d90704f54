// Learning a place: what of its walls was touched and of its floor walked, and what is left. The place is the free floor around a body that one gets to
// on foot without passing a door. Plain state and pure functions; app thread; world metres. Notes cost nothing to speak of; looking at a place costs a few
// rays for every ten centimetres of its floor, so it is done when somebody asks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/walker.h"

namespace handrail {

// Touched by hand or by a body that trails or bumps: a stretch of wall `reach_m` to either side of the point.
struct TouchNote {
    Vec3 point_m{0.0};
    Vec3 normal{0.0};  // level, out of the wall
    double reach_m = 0.0;
};

class LearningNotes {
public:
    void touched(const Vec3& point_m, const Vec3& normal, double reach_m);
    void walked(const Vec3& feet_m);
    const std::vector<TouchNote>& touches() const { return touches_; }
    const std::vector<Vec3>& steps_m() const { return steps_m_; }
    std::size_t count() const { return noted_; }  // rises with each note

private:
    std::vector<TouchNote> touches_;
    std::vector<Vec3> steps_m_;
    std::size_t noted_ = 0;
};

// A stretch of the outer boundary of a place, seen through the side of one cell.
struct WallSample {
    Vec3 point_m{0.0};
    Vec3 normal{0.0};
    FeatureId feature = kNoFeature;
    double length_m = 0.0;  // of wall; a slanted one is met by cells from two sides and shared between them
};

struct Place {
    static constexpr double kCell_m = 0.1;
    Vec3 origin_m{0.0};  // south-west corner of the first cell, at the height of the floor
    int wide = 0, deep = 0;
    std::vector<bool> free;  // wide x deep, row by row from the south
    std::vector<WallSample> walls;
    bool whole = true;  // false: larger than is looked at

    bool is_free(int x, int y) const { return x >= 0 && y >= 0 && x < wide && y < deep && free[static_cast<std::size_t>(y * wide + x)]; }
    Vec3 middle_m(int x, int y) const { return origin_m + Vec3((x + 0.5) * kCell_m, (y + 0.5) * kCell_m, 0.0); }
    bool holds(const Vec3& feet_m) const;
    double area_m2() const;
};
// The place around a body, up to 15 m away. Doors bound it, open or shut; so do falls and steps too high to climb. What stands free in it is no wall.
Place place_around(const BodyWorld& world, const Vec3& feet_m, const BodySize& body);

struct WallProgress {
    FeatureId feature = kNoFeature;
    double length_m = 0.0, touched_m = 0.0;
    bool done() const { return touched_m >= 0.95 * length_m; }
};
struct Progress {
    double perimeter_m = 0.0, touched_m = 0.0;  // of walls and doors and what stands against them
    double floor_m2 = 0.0, walked_m2 = 0.0;     // walked: within half a metre of where one went
    std::vector<WallProgress> walls;            // in the order of the boundary's features
    int doors = 0, doors_found = 0;             // found: touched
    double perimeter_share() const { return perimeter_m > 0.0 ? touched_m / perimeter_m : 1.0; }
    double floor_share() const { return floor_m2 > 0.0 ? walked_m2 / floor_m2 : 1.0; }
};
Progress progress_of(const Place& place, const LearningNotes& notes, const Scene& scene);

// The nearest stretch of wall (at least half a metre) or floor (at least half a square metre) that is not known yet; none: all is.
struct Unexplored {
    Vec3 point_m{0.0};
    bool wall = false;
    FeatureId feature = kNoFeature;
};
std::optional<Unexplored> nearest_unexplored(const Place& place, const LearningNotes& notes, const Vec3& feet_m);

// Lanes a metre apart across the whole place, first those that run north, then those that run east; done once most of it was walked along.
struct Lane {
    bool north = true;
    double at_m = 0.0;  // x of a lane that runs north, y of one that runs east
    double length_m = 0.0, walked_m = 0.0;
    bool done() const { return walked_m >= 0.8 * length_m; }
};
std::vector<Lane> lanes_of(const Place& place, const LearningNotes& notes);

inline constexpr double kFloorReach_m = 0.5;  // to either side of where one walked

}  // namespace handrail
