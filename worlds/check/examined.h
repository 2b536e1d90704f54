// A world made ready to be looked at for faults: its solids by place. For the sources of worlds/check only.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "worlds/check/faults.h"
#include "worlds/geometry/box_index.h"

namespace handrail {

// How much of a room lies under a roof, in places to stand.
struct Cover {
    std::size_t under_roof = 0, open = 0;
    std::uint32_t first_open = kNothing;
    bool covered() const { return share(under_roof); }
    bool under_sky() const { return share(open); }

private:
    bool share(std::size_t part) const {
        return static_cast<double>(part) >= 0.9 * static_cast<double>(under_roof + open);
    }
};

class Examined {
public:
    Examined(const Scene& scene, const WalkSpace* space, const RoomGraph* graph);

    const Scene& scene;
    const WalkSpace* space;
    const RoomGraph* graph;

    // Places in Scene::solids of what stops a body and whose box meets this one, rising.
    const std::vector<std::uint32_t>& solids_near(const Aabb& box) const;
    // The first solid that stops a body and holds the point, grown by that much, and is not one of these features.
    const Solid* solid_at(const Vec3& at_m, double grow_m, const std::vector<FeatureId>& but = {}) const;
    // A sheet lies that near, or something holds the point.
    bool something_at(const Vec3& at_m, double near_m, const std::vector<FeatureId>& but = {}) const;
    // Below a point: the height of the first solid or sheet; nothing: there is none.
    std::optional<double> top_below(const Vec3& at_m) const;
    bool sheet_near(const Aabb& box) const;
    // Where the floor under a place stands in the file.
    SourcePlace ground_source(const Vec3& at_m) const;
    // The solids that are one thing.
    const std::vector<std::uint32_t>& solids_of(FeatureId feature) const { return solids_of_[feature.value]; }
    // The room beside or under which a thing is; kNothing: in none.
    std::uint32_t room_of(const Feature& feature) const;
    std::string room_name(std::uint32_t room) const;
    // Where the room stands in the file, else its floor.
    SourcePlace room_source(std::uint32_t room) const;
    const Cover& cover(std::uint32_t room) const { return covers_[room]; }
    // Ground round a building whose file states its rooms: nobody's room.
    bool is_ground(std::uint32_t room) const;
    // What is called a thing here: objects with a body that are no part of the building.
    bool is_thing(FeatureId feature) const;

private:
    std::vector<std::uint32_t> bodies_;  // places in Scene::solids
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

}  // namespace handrail
