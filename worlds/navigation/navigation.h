// Plans walking routes through a world, on the walkable space and its mesh, which are built once from a Scene. Building
// takes from milliseconds to seconds, on any thread. Queries share scratch memory, so only one thread at a time may
// make them.
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

// The body of a person in a building or of a player in a game map, by the kind of scene, with a suitable cell size.
WalkerMeasures walk_body(const Scene& scene, double radius_m, double height_m, double step_up_m);

class Navigation {
public:
    // Fails with one sentence if there is no floor or the request was stopped. If the floor gives no mesh, or memory
    // does not suffice for one, routes are planned from cell to cell. That takes longer, and such routes never use
    // drops, lifts and teleporters.
    static Result<std::shared_ptr<Navigation>> make(const Scene& scene, const WalkerMeasures& body,
                                                    const std::stop_token& stop = {});
    // Uses a walkable space that make_walk_space made of this scene before. Fails if it is stopped.
    static Result<std::shared_ptr<Navigation>> over(const Scene& scene, WalkSpace space,
                                                    const std::stop_token& stop = {});

    // Sets where the leaves of open doors are; at first there are none. Routes planned from now on go around them,
    // unless that is much longer than going through one, because the walker can shut the door.
    void know_leaves(std::span<const OpenLeaf> leaves) { leaf_marks_ = mark_leaves(space_, leaves); }
    // Sets boxes that nobody can pass. Routes planned from now on lead around them, on foot. If none does, they lead to
    // the nearest place before them. Replaces the boxes set before.
    void block(std::span<const Aabb> boxes);
    // Returns whether a walker along these points would meet a leaf.
    bool meets_leaf(std::span<const Vec3> points_m) const;

    // Plans a route from where a walker is to a place, or to the nearest place next to it where people can stand. Doors
    // count as open. A route that does not reach its goal ends at the nearest place that can be reached. A route
    // without points means that there is no floor at `from_m`.
    Route plan(const Vec3& from_m, const Vec3& to_m, RouteWish wish = RouteWish::Safest);
    // Where a route to that place ends: the nearest place to stand, within 3 m, next to the leaf of an open door if one
    // is there.
    std::optional<Vec3> nearest_place(const Vec3& at_m) const;
    // Returns whether a walker can get from one place to the other with all doors open. Drops, lifts and teleporters
    // count as routes.
    bool reachable(const Vec3& from_m, const Vec3& to_m) const;

    const WalkSpace& space() const { return space_; }
    const NavMesh* mesh() const { return mesh_.get(); }  // null if there is none
    // Frees the floor without furniture, which only the search for rooms needs.
    void let_walls_go() { space_.walls.reset(); }
    // What to announce about how it was made; empty if there is nothing special.
    const std::vector<std::string>& said() const { return space_.said; }

private:
    Navigation() = default;
    // Walked stretches, and the links (of WalkSpace::links) between them.
    struct Way {
        std::vector<std::vector<Vec3>> legs_m = std::vector<std::vector<Vec3>>(1);
        std::vector<std::uint32_t> links;
    };
    std::uint32_t span_from(const Vec3& feet_m) const;
    std::uint32_t span_to(const Vec3& at_m) const;
    std::vector<bool> pieces_from(std::uint32_t span) const;
    std::vector<std::uint32_t> over_cells(std::uint32_t from, std::uint32_t to, RouteWish wish) const;
    double cost(const Vec3& from_m, const Vec3& to_m, RouteWish wish) const;
    double span_cost(std::uint32_t span, RouteWish wish) const;
    bool in_leaf(std::uint32_t span) const { return !leaf_marks_.empty() && leaf_marks_[span] == kInLeaf; }
    std::uint32_t out_of_blocked(std::uint32_t span) const;
    bool meets_blocked(const Way& way) const;
    std::optional<Way> round_blocked(std::uint32_t from, std::uint32_t& to, const Vec3& to_m, RouteWish wish) const;
    std::uint32_t out_of_leaf(std::uint32_t span) const;
    struct Stretch {
        double from_m = 0.0, to_m = -1.0;  // distances along the points; none if to_m < from_m
    };
    Stretch in_leaves(std::span<const Vec3> points_m) const;
    void go_round_leaves(std::vector<Vec3>& points_m, RouteWish wish) const;
    void straighten(std::vector<Vec3>& points_m, RouteWish wish) const;
    void make_way(std::vector<Vec3>& points_m, RouteWish wish) const;
    std::optional<Way> over_mesh(std::uint32_t from, std::uint32_t to, RouteWish wish, bool over_links);
    void finish(Way& way, std::uint32_t to, RouteWish wish) const;
    double cost(const Way& way, RouteWish wish) const;
    std::optional<Way> best_over_mesh(std::uint32_t from, std::uint32_t to, RouteWish wish);
    void tell_passages(Route& route, const std::vector<Vec3>& leg) const;

    WalkSpace space_;
    std::unique_ptr<NavMesh> mesh_;
    std::vector<std::uint32_t> piece_;  // for each span: the connected piece of floor that it belongs to
    std::vector<std::vector<std::uint32_t>> leads_to_;  // for each piece: the pieces that links lead to
    std::vector<FeatureId> door_features_;              // for each entry of Scene::movers
    std::vector<std::uint32_t> door_groups_;
    std::vector<Vec3> door_places_;
    // Scratch data of over_cells for each span, restored after each search. Made when it is first needed.
    struct Search {
        std::vector<float> best;
        std::vector<std::uint32_t> came, touched;
    };
    mutable Search search_;
    std::vector<bool> blocked_;             // for each span; empty: nothing is blocked
    std::vector<std::uint8_t> leaf_marks_;  // for each span; empty: no door is open
};

}  // namespace handrail::navigation
