// Prepares a world for the search for faults: indexes its solids by position. Only the sources of worlds/check use it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "worlds/check/faults.h"
#include "worlds/geometry/box_index.h"

namespace handrail::check {

inline constexpr double kUpperDoor_m = 1.0;  // a door at least this far above the base is on an upper storey

// The number of a room's standing places that are under a roof, and the number in the open.
struct Cover {
    std::size_t under_roof = 0, open = 0;
    std::uint32_t first_open = navigation::kNothing;
    bool covered() const { return share(under_roof); }
    bool under_sky() const { return share(open); }

private:
    bool share(std::size_t part) const {
        return static_cast<double>(part) >= 0.9 * static_cast<double>(under_roof + open);
    }
};

class Examined {
public:
    Examined(const Scene& scene, const navigation::WalkSpace* space, const navigation::RoomGraph* graph);

    const Scene& scene;
    const navigation::WalkSpace* space;
    const navigation::RoomGraph* graph;

    // Returns the solids that stop a body and whose bounding box overlaps `box`, as rising indices into Scene::solids.
    // The reference is valid until the next query.
    const std::vector<std::uint32_t>& solids_near(const Aabb& box) const;
    // Returns the first solid that stops a body and, enlarged by grow_m, contains the point. Ignores the features in
    // `but`. Null if there is none.
    const Solid* solid_at(const Vec3& at_m, double grow_m, const std::vector<FeatureId>& but = {}) const;
    // True if a sheet is within near_m of the point, or a solid contains the point. Ignores the features in `but`.
    bool something_at(const Vec3& at_m, double near_m, const std::vector<FeatureId>& but = {}) const;
    // Returns the height of the top of the first solid or sheet below a point. Empty if there is none.
    std::optional<double> top_below(const Vec3& at_m) const;
    bool sheet_near(const Aabb& box) const;
    // Returns the line and column in the file of the floor below a point.
    SourcePlace ground_source(const Vec3& at_m) const;
    // Returns the solids of a thing, as indices into Scene::solids.
    const std::vector<std::uint32_t>& solids_of(FeatureId feature) const { return solids_of_[feature.value]; }
    // Returns the room of the place nearest to a thing at which a person can stand, at most 3 m below the bottom of the
    // thing; kNothing if there is none.
    std::uint32_t room_of(const Feature& feature) const;
    std::string room_name(std::uint32_t room) const;
    // Returns the line and column of the room in the file, or else those of its floor.
    SourcePlace room_source(std::uint32_t room) const;
    const Cover& cover(std::uint32_t room) const { return covers_[room]; }
    // True for the ground around a building whose file states its rooms. This ground is not part of any room.
    bool is_ground(std::uint32_t room) const;
    // True for things, that is, objects that have a solid and are not part of the building.
    bool is_thing(FeatureId feature) const;

private:
    std::vector<std::uint32_t> bodies_;  // the solids that stop a body, as indices into Scene::solids
    BoxIndex index_, sheets_;
    std::vector<std::vector<std::uint32_t>> solids_of_;
    std::vector<Cover> covers_;
    mutable std::vector<std::uint32_t> near_, sheets_near_;
};

void find_room_faults(const Examined& world, std::vector<WorldFault>& faults);
void find_outline_faults(const Examined& world, std::vector<WorldFault>& faults);
void find_unlike_faults(const Examined& world, std::vector<WorldFault>& faults);
void find_door_faults(const Examined& world, std::vector<WorldFault>& faults);
void find_shell_faults(const Examined& world, std::vector<WorldFault>& faults);
void find_thing_faults(const Examined& world, std::vector<WorldFault>& faults);

}  // namespace handrail::check
