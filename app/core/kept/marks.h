// Stores marks, which are places that a person has marked in a world. It defines what a mark contains, how the side
// file stores it, and whether it still fits after the world was edited. Pure functions over plain values, for the app
// thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

struct Mark {
    std::string name;
    Vec3 place_m{0.0};    // position in world coordinates
    std::string near;     // name of the nearest thing when the mark was set; empty: nothing within kNearMark_m
    double near_m = 0.0;  // distance from the mark to the bounding box of that thing
    std::string world;    // checksum of the world's file when the mark was set; empty: not known
    // True: the thing `near` still exists at about the same distance. This is computed when the world is entered, and
    // not stored.
    bool fits = true;
    SideEntry kept;  // keys of the side file that this version does not know
};

// Largest distance from a mark to its thing. A thing farther away would not identify the place.
inline constexpr double kNearMark_m = 3.0;
inline constexpr double kMarkMoved_m = 0.5;  // how much the distance from a mark to its thing may have changed

// Returns true if a person may search for this feature by name: things, and everything that the map calls a landmark or
// a clue. Returns false for plain walls and floors.
bool is_thing(const Feature& feature);

// Returns the marks in the order of the side file. Entries without a name or a place stay in the file but are not
// returned. `faults` receives an error for each of them.
std::vector<Mark> read_marks(const SideFile& file, std::vector<Error>& faults);
void write_marks(SideFile& file, const std::vector<Mark>& marks);

// The nearest thing, door or landmark with a name, if one is within kNearMark_m. Otherwise, it is the nearest wall.
struct NearThing {
    std::string name;
    double distance_m = 0.0;
};
NearThing nearest_thing(const Scene& scene, const Vec3& place_m);

// Makes a mark at this place with a name such as "Mark 3, near radiator". The number is the first one that no other
// mark has.
Mark new_mark(const Scene& scene, const SideFile& file, const std::vector<Mark>& marks, const Vec3& place_m);

// Sets Mark::fits of each mark. If a mark was set in the same version of the world, it always fits.
void check_marks(const Scene& scene, const SideFile& file, std::vector<Mark>& marks);
// Returns "This world has changed since you set marks. 2 of 5 no longer fit: Mark 1, near radiator; stairs.", or an
// empty text if all marks fit.
std::string unfit_sentence(const std::vector<Mark>& marks);

}  // namespace handrail::core
