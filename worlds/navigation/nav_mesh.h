// Makes a polygon mesh of the walkable spans, tile by tile, and finds shortest paths on it. It uses Recast and Detour,
// which only nav_mesh.cpp includes. Queries are not const because they share scratch memory, so only one thread at a
// time may make them. Making the mesh costs time and memory in proportion to the floor.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

// Returns the cost of a metre over this span; 1 is the cost of comfortable floor.
double cost_per_m(const WalkSpan& span, RoutePreference preference);

// A path over the mesh. Straight lines or links of WalkSpace::links join its corners.
struct MeshPath {
    struct Corner {
        Vec3 place_m{0.0};
        std::uint32_t link = kNothing;  // the link that leads from this corner to the next, if any
    };
    std::vector<Corner> corners;
    bool complete = false;
};

class NavMesh {
public:
    // Fails with a sentence if no mesh can be made of the walkable space. The space must outlive the mesh.
    static Result<NavMesh> make(const WalkSpace& space, const std::stop_token& stop = {});
    ~NavMesh();
    NavMesh(NavMesh&&) noexcept;
    NavMesh& operator=(NavMesh&&) noexcept;

    // Returns the path from the middle of one span to the middle of another. Returns nothing if one of them is not on
    // any polygon. `over_links`: the path may use links. Without links the path is closer to the shortest one, because
    // Detour can then look straight ahead. Detour ignores heights when it does that, so it would confuse the two ends
    // of a link.
    std::optional<MeshPath> path(std::uint32_t from, std::uint32_t to, RoutePreference preference, bool over_links);
    // Returns the cost of using a link.
    static double cost_of(const WalkLink& link, double length_m, RoutePreference preference);
    int polygons() const;
    std::size_t bytes() const;
    // Returns the number of links that no path can use, because their ends are more than a tile (64 m) apart.
    std::size_t far_links() const;

private:
    struct Parts;
    explicit NavMesh(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace handrail::navigation
