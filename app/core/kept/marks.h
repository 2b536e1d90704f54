// Places that a person has marked in a world: what a mark holds, how it is kept in the side file, and whether it still
// fits a world that was edited since. Pure functions over plain values; app thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct Mark {
    std::string name;
    Vec3 place_m{0.0};    // world
    std::string near;     // name of what was nearest when it was set; empty: nothing within kNear_m
    double near_m = 0.0;  // to its bounds
    std::string world;    // checksum of the world's file then; empty: unknown
    bool fits = true;     // what was near is still there as far away; found out on entering, not kept
    SideEntry kept;       // keys of the file that this version does not know
};

inline constexpr double kNearMark_m = 3.0;   // farther things say nothing of a place
inline constexpr double kMarkMoved_m = 0.5;  // how much nearer or farther its thing may be than it was

// What a person may look for by name: things, and whatever the map calls a landmark or a clue; not plain walls and
// floors.
bool is_thing(const Feature& feature);

// In the order of the file. Entries without a name or a place are left out and stay in the file; `faults` tells of
// each.
std::vector<Mark> read_marks(const SideFile& file, std::vector<Error>& faults);
void write_marks(SideFile& file, const std::vector<Mark>& marks);

// What is nearest to a place and has a name: things, doors, landmarks; where there is none within reach, a wall.
struct NearThing {
    std::string name;
    double distance_m = 0.0;
};
NearThing nearest_thing(const Scene& scene, const Vec3& place_m);

// A new mark there: "Mark 3, near radiator", with the first number that no mark of that pattern has.
Mark new_mark(const Scene& scene, const SideFile& file, const std::vector<Mark>& marks, const Vec3& place_m);

// Finds out which marks still fit. Those that were set in this very world always do.
void check_marks(const Scene& scene, const SideFile& file, std::vector<Mark>& marks);
// "This world has changed since you set marks. 2 of 5 no longer fit: Mark 1, near radiator; stairs." Empty when all
// fit.
std::string unfit_sentence(const std::vector<Mark>& marks);

}  // namespace handrail
