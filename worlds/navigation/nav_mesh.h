// The walkable spans as a polygon mesh, made tile by tile, and the shortest paths over it. It uses Recast and Detour,
// which only nav_mesh.cpp includes. Queries are not const because they share scratch memory: one thread at a time.
// Making the mesh costs time and memory in proportion to the floor.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

// The cost of a metre over this span: 1 if it is comfortable.
double cost_per_m(const WalkSpan& span, RouteWish wish);

// A path over the mesh: straight stretches, with links of WalkSpace::links between some of them.
struct MeshPath {
    struct Corner {
        Vec3 place_m{0.0};
        std::uint32_t link = kNothing;  // the link from this corner to the next, if any
    };
    std::vector<Corner> corners;
    bool complete = false;
};

class NavMesh {
public:
    // Fails with a sentence if the walkable space gives no mesh. The space must outlive the mesh.
    static Result<NavMesh> make(const WalkSpace& space, const std::stop_token& stop = {});
    ~NavMesh();
    NavMesh(NavMesh&&) noexcept;
    NavMesh& operator=(NavMesh&&) noexcept;

    // The path from the middle of one span to that of another. Nothing if one of them is not on any polygon.
    // `over_links`: links may be taken. Without links the path is closer to the shortest, because Detour then looks
    // straight ahead. It does so in the plane, and would confuse the two ends of a link.
    std::optional<MeshPath> path(std::uint32_t from, std::uint32_t to, RouteWish wish, bool over_links);
    // The cost of taking a link.
    static double cost_of(const WalkLink& link, double length_m, RouteWish wish);
    int polygons() const;
    std::size_t bytes() const;
    // The number of links that no path can use, because their ends are more than a tile (64 m) apart.
    std::size_t far_links() const;

private:
    struct Parts;
    explicit NavMesh(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace handrail::navigation
