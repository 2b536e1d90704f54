// Plans walking routes through a world, on its walkable space and the mesh of that space. Both are made once from a
// Scene, which takes from milliseconds to seconds on any thread. Queries share scratch memory, so only one thread at a
// time may make them.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "worlds/navigation/nav_mesh.h"
#include "worlds/navigation/open_leaves.h"
#include "worlds/navigation/route.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

// Returns the measures of a person in a building, or of a player in a game map, depending on the kind of scene. They
// include a suitable cell size.
WalkerMeasures walker_measures(const Scene& scene, double radius_m, double height_m, double step_up_m);

class Navigation {
public:
    // Fails with one sentence if there is no floor or if `stop` was requested. If no mesh can be made from the floor,
    // or memory does not suffice for one, the object plans routes from cell to cell. That costs more time, and such
    // routes never use drops, lifts and teleporters.
    static Result<std::shared_ptr<Navigation>> make(const Scene& scene, const WalkerMeasures& body,
                                                    const std::stop_token& stop = {});
    // Uses a walkable space that an earlier call of make_walk_space made of this scene. Fails if `stop` was requested.
    static Result<std::shared_ptr<Navigation>> over(const Scene& scene, WalkSpace space,
                                                    const std::stop_token& stop = {});

    // Sets where the leaves of open doors are; initially there are none. Routes planned from now on go around these
    // leaves, unless the route around a leaf is much longer than the route through it. In that case the walker can shut
    // the door.
    void know_leaves(std::span<const OpenLeaf> leaves) { leaf_marks_ = mark_leaves(space_, leaves); }
    // Sets boxes that nobody can pass, instead of those set before. Routes planned from now on lead around the boxes,
    // on foot. If no route leads around them, a route ends at the nearest place before them.
    void block(std::span<const Aabb> boxes);
    // Returns whether a walker along these points would touch a leaf.
    bool meets_leaf(std::span<const Vec3> points_m) const;

    // Plans a route from a walker's place to another place, or to the place nearest to that one where people can stand.
    // All doors are assumed to be open. If the goal cannot be reached, the route ends at the nearest place that can be
    // reached. A route without points means that there is no floor at `from_m`.
    Route plan(const Vec3& from_m, const Vec3& to_m, RoutePreference preference = RoutePreference::Safest);
    // Returns where a route to that place would end: the nearest place to stand within 3 m. If the leaf of an open door
    // is at that place, the route ends next to the leaf.
    std::optional<Vec3> nearest_place(const Vec3& at_m) const;
    // Returns whether a walker can get from one place to the other with all doors open. The walker may use drops, lifts
    // and teleporters.
    bool reachable(const Vec3& from_m, const Vec3& to_m) const;

    const WalkSpace& space() const { return space_; }
    const NavMesh* mesh() const { return mesh_.get(); }  // null if no mesh could be made
    // Frees the copy of the floor without furniture, which only the search for rooms needs.
    void let_walls_go() { space_.walls.reset(); }
    // Returns sentences about how the walkable space was made, which the program announces; empty if there is nothing
    // special.
    const std::vector<std::string>& said() const { return space_.said; }

private:
    Navigation() = default;
    // A planned route before it is refined: walked legs, with a link of WalkSpace::links between each two of them.
    struct Way {
        std::vector<std::vector<Vec3>> legs_m = std::vector<std::vector<Vec3>>(1);
        std::vector<std::uint32_t> links;
    };
    std::uint32_t span_from(const Vec3& feet_m) const;
    std::uint32_t span_to(const Vec3& at_m) const;
    std::vector<bool> pieces_from(std::uint32_t span) const;
    std::vector<std::uint32_t> over_cells(std::uint32_t from, std::uint32_t to, RoutePreference preference) const;
    double cost(const Vec3& from_m, const Vec3& to_m, RoutePreference preference) const;
    double span_cost(std::uint32_t span, RoutePreference preference) const;
    bool in_leaf(std::uint32_t span) const { return !leaf_marks_.empty() && leaf_marks_[span] == kInLeaf; }
    std::uint32_t out_of_blocked(std::uint32_t span) const;
    bool meets_blocked(const Way& way) const;
    std::optional<Way> round_blocked(std::uint32_t from, std::uint32_t& to, const Vec3& to_m,
                                     RoutePreference preference) const;
    std::uint32_t out_of_leaf(std::uint32_t span) const;
    struct Stretch {
        // Distances along the points at which the stretch begins and ends; to_m < from_m: no stretch.
        double from_m = 0.0, to_m = -1.0;
    };
    Stretch in_leaves(std::span<const Vec3> points_m) const;
    void go_round_leaves(std::vector<Vec3>& points_m, RoutePreference preference) const;
    void straighten(std::vector<Vec3>& points_m, RoutePreference preference) const;
    void keep_clear(std::vector<Vec3>& points_m, RoutePreference preference) const;
    std::optional<Way> over_mesh(std::uint32_t from, std::uint32_t to, RoutePreference preference, bool over_links);
    void finish(Way& way, std::uint32_t to, RoutePreference preference) const;
    double cost(const Way& way, RoutePreference preference) const;
    std::optional<Way> best_over_mesh(std::uint32_t from, std::uint32_t to, RoutePreference preference);
    void add_passages(Route& route, const std::vector<Vec3>& leg) const;

    WalkSpace space_;
    std::unique_ptr<NavMesh> mesh_;
    std::vector<std::uint32_t> piece_;  // for each span: number of the connected piece of floor that contains it
    std::vector<std::vector<std::uint32_t>> leads_to_;  // for each piece of floor: the pieces to which links lead
    std::vector<FeatureId> door_features_;              // for each entry of Scene::movers: the feature of its door
    std::vector<std::uint32_t> door_groups_;
    std::vector<Vec3> door_places_;
    // Scratch data of over_cells for each span. The first search allocates it, and each search restores it.
    struct Search {
        std::vector<float> best;
        std::vector<std::uint32_t> came, touched;
    };
    mutable Search search_;
    std::vector<bool> blocked_;             // for each span: whether it is blocked; empty: nothing is blocked
    std::vector<std::uint8_t> leaf_marks_;  // for each span: its mark from mark_leaves; empty: no door is open
};

}  // namespace handrail::navigation
