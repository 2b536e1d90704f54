// Places that a person has marked in a world: what a mark contains, how the side file stores it, and whether it still
// fits after the world was edited. Pure functions over plain values; app thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

struct Mark {
    std::string name;
    Vec3 place_m{0.0};    // world
    std::string near;     // name of the nearest thing when the mark was set; empty: nothing within kNearMark_m
    double near_m = 0.0;  // distance to its bounds
    std::string world;    // checksum of the world's file at that time; empty: unknown
    bool fits = true;     // the thing `near` still exists, about as far away; determined on entering, not stored
    SideEntry kept;       // keys of the file that this version does not know
};

inline constexpr double kNearMark_m = 3.0;   // more distant things do not identify a place
inline constexpr double kMarkMoved_m = 0.5;  // how much the distance to the thing may have changed

// True for what a person may search for by name: things, and whatever the map calls a landmark or a clue; not plain
// walls and floors.
bool is_thing(const Feature& feature);

// In the order of the file. Entries without a name or a place are left out but stay in the file; `faults` receives an
// error for each.
std::vector<Mark> read_marks(const SideFile& file, std::vector<Error>& faults);
void write_marks(SideFile& file, const std::vector<Mark>& marks);

// The nearest thing, door or landmark with a name; if none is within kNearMark_m, the nearest wall.
struct NearThing {
    std::string name;
    double distance_m = 0.0;
};
NearThing nearest_thing(const Scene& scene, const Vec3& place_m);

// A new mark at this place: "Mark 3, near radiator", with the first number that no such mark has.
Mark new_mark(const Scene& scene, const SideFile& file, const std::vector<Mark>& marks, const Vec3& place_m);

// Determines which marks still fit. Marks set in the same version of the world always do.
void check_marks(const Scene& scene, const SideFile& file, std::vector<Mark>& marks);
// "This world has changed since you set marks. 2 of 5 no longer fit: Mark 1, near radiator; stairs." Empty if all fit.
std::string unfit_sentence(const std::vector<Mark>& marks);

}  // namespace handrail::core
