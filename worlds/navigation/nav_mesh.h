// The walkable spans as a mesh of polygons, made tile by tile, and shortest ways over it: Recast and Detour, which only
// nav_mesh.cpp knows. Queries are not const because they share scratch memory: one thread at a time. Making it costs
// time and memory in proportion to the floor.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "worlds/navigation/walk_space.h"

namespace handrail {

// What a metre over this span counts: 1 where it is comfortable.
double cost_per_m(const WalkSpan& span, RouteWish wish);

// A way over the mesh: stretches walked straight, between which a link of WalkSpace::links may stand.
struct MeshPath {
    struct Corner {
        Vec3 place_m{0.0};
        std::uint32_t link = kNothing;  // one takes this link from here to the next corner
    };
    std::vector<Corner> corners;
    bool complete = false;
};

class NavMesh {
public:
    // Fails with a sentence where the walkable space gives no mesh. The space must outlive the mesh.
    static Result<NavMesh> make(const WalkSpace& space, const std::stop_token& stop = {});
    ~NavMesh();
    NavMesh(NavMesh&&) noexcept;
    NavMesh& operator=(NavMesh&&) noexcept;

    // From the middle of one span to that of another. Nothing where one of them lies on no polygon. `over_links`: links
    // may be taken. Without it the way is nearer to the shortest: Detour then looks straight ahead, which it does in
    // the plane and so would take a link's other end for its own.
    std::optional<MeshPath> path(std::uint32_t from, std::uint32_t to, RouteWish wish, bool over_links);
    // What taking a link counts.
    static double cost_of(const WalkLink& link, double length_m, RouteWish wish);
    int polygons() const;
    std::size_t bytes() const;
    // Links over which no path leads, because their ends are more than a tile (64 m) apart.
    std::size_t far_links() const;

private:
    struct Parts;
    explicit NavMesh(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace handrail
