// Ways through a world on foot, ready to be asked for: the walkable space and its mesh, built once from a Scene.
// Building takes from milliseconds to seconds and any thread; asking shares scratch memory, so one thread at a time.
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

namespace handrail {

// The body of a person in a building or of a player in a game map, by the scene's kind; cells to match.
WalkBody walk_body(const Scene& scene, double radius_m, double height_m, double step_up_m);

class Navigation {
public:
    // Fails with one sentence: no floor, or stopped. Where the floor gives no mesh, or there is no memory for
    // one, ways are sought from place to place, which takes longer, and never over drops, lifts and teleporters.
    static Result<std::shared_ptr<Navigation>> make(const Scene& scene, const WalkBody& body,
                                                    const std::stop_token& stop = {});
    // Over a walkable space that make_walk_space has made of this scene before. Fails where it is stopped.
    static Result<std::shared_ptr<Navigation>> over(const Scene& scene, WalkSpace space,
                                                    const std::stop_token& stop = {});

    // Where leaves of open doors stand by now; at first there are none. Routes planned from here on go round them,
    // unless that is much longer than through one: who comes there can shut the door.
    void know_leaves(std::span<const OpenLeaf> leaves) { leaf_marks_ = mark_leaves(space_, leaves); }
    // Nobody gets through there: ways planned from here on lead round these boxes, on foot; where none does, to the
    // nearest place before them. Replaces what was blocked before.
    void block(std::span<const Aabb> boxes);
    // Somebody who goes along these points would meet a leaf.
    bool meets_leaf(std::span<const Vec3> points_m) const;

    // From where a body stands to a place, or to the nearest one to stand at beside it. Doors count as open. A route
    // that does not reach its goal ends at the nearest place that can be reached. No points: there is no floor at
    // `from_m`.
    Route plan(const Vec3& from_m, const Vec3& to_m, RouteWish wish = RouteWish::Safest);
    // Where one can stand nearest to a place, within 3 m; where the leaf of an open door is, beside it: it is where a
    // route to there ends.
    std::optional<Vec3> nearest_place(const Vec3& at_m) const;
    // True when one comes from one place to the other, doors open; drops, lifts and teleporters count as ways.
    bool reachable(const Vec3& from_m, const Vec3& to_m) const;

    const WalkSpace& space() const { return space_; }
    const NavMesh* mesh() const { return mesh_.get(); }  // null: there is none
    // What only finding rooms needs.
    void let_walls_go() { space_.walls.reset(); }
    // What a listener should know about how it was made; empty where all is plain.
    const std::vector<std::string>& said() const { return space_.said; }

private:
    Navigation() = default;
    // Stretches walked, and the links (of WalkSpace::links) between them.
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
        double from_m = 0.0, to_m = -1.0;  // along the points; nothing where to_m < from_m
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
    std::vector<std::uint32_t> piece_;                  // of each span: which connected floor it is part of
    std::vector<std::vector<std::uint32_t>> leads_to_;  // of each piece: those that links lead to
    std::vector<FeatureId> door_features_;              // of each of Scene::movers
    std::vector<std::uint32_t> door_groups_;
    std::vector<Vec3> door_places_;
    // What a search from cell to cell needs of each span, the same before and after it; made when it is first needed.
    struct Search {
        std::vector<float> best;
        std::vector<std::uint32_t> came, touched;
    };
    mutable Search search_;
    std::vector<bool> blocked_;             // of each span; empty: nothing is
    std::vector<std::uint8_t> leaf_marks_;  // of each span; empty: no door stands open
};

}  // namespace handrail
