// A world prepared for the search for faults: its solids are indexed by place. Only for the sources of worlds/check.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "worlds/check/faults.h"
#include "worlds/geometry/box_index.h"

namespace handrail::check {

// How many of a room's places to stand are under a roof, and how many are open.
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

    // Indices in Scene::solids, rising, of the solids that stop a body and whose box meets this one. The reference is
    // valid until the next query.
    const std::vector<std::uint32_t>& solids_near(const Aabb& box) const;
    // The first solid that stops a body and, grown by grow_m, contains the point. Skips the features in `but`.
    const Solid* solid_at(const Vec3& at_m, double grow_m, const std::vector<FeatureId>& but = {}) const;
    // True if a sheet is within near_m, or a solid contains the point.
    bool something_at(const Vec3& at_m, double near_m, const std::vector<FeatureId>& but = {}) const;
    // The height of the first solid or sheet below a point; empty if there is none.
    std::optional<double> top_below(const Vec3& at_m) const;
    bool sheet_near(const Aabb& box) const;
    // The place in the file of the floor under a point.
    SourcePlace ground_source(const Vec3& at_m) const;
    // The solids of a thing.
    const std::vector<std::uint32_t>& solids_of(FeatureId feature) const { return solids_of_[feature.value]; }
    // The room that a thing is next to or below; kNothing if there is none.
    std::uint32_t room_of(const Feature& feature) const;
    std::string room_name(std::uint32_t room) const;
    // The place in the file of the room, else of its floor.
    SourcePlace room_source(std::uint32_t room) const;
    const Cover& cover(std::uint32_t room) const { return covers_[room]; }
    // True for the ground round a building whose file states its rooms; it belongs to no room.
    bool is_ground(std::uint32_t room) const;
    // True for things: objects with a solid that are no part of the building.
    bool is_thing(FeatureId feature) const;

private:
    std::vector<std::uint32_t> bodies_;  // indices into Scene::solids
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
