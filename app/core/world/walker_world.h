// Defines the solids that a walker bumps into. The scene consists of convex pieces, against which an upright cylinder
// or a point is swept. The object is immutable after construction, so any thread may use it. A trace is exact: a moving
// point is tested against the Minkowski sum of the body and each convex piece, so a body cannot pass through a thin
// piece at any speed. A trace examines only pieces whose box the path crosses before the first hit. The fixed part of a
// building is made once, and worlds that differ only in the positions of things share it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "worlds/geometry/box_index.h"
#include "worlds/scene/scene.h"
#include "worlds/scene/stair_rule.h"

namespace handrail::core {

// An upright cylinder that stands on its reference point. With radius 0 and height 0, it is a ray.
struct WalkerShape {
    double radius_m = 0.0;
    double height_m = 0.0;
};

struct TraceHit {
    double fraction = 1.0;  // share of the path until the hit; 1: nothing was met
    Vec3 end_m{0.0};        // position of the reference point at the stop, kContactGap_m before the surface
    Vec3 normal{0.0};       // normal of the surface that was met
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    bool hit = false;
    std::uint32_t piece = 0xFFFFFFFFU;  // the piece that was met, for WalkerWorld::hides()
};

// A part of a straight line that is inside a solid. The distances are from the start of the line.
struct Crossing {
    double enter_m = 0.0, leave_m = 0.0;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
};

// Returns true for features that the answer to "what is around" may name: doors, landmarks, clues, liquids and things,
// but not bare walls.
bool named_when_seen(const Feature& feature);

class WalkerWorld {
public:
    // `placed` are the positions of the scene's placed things, in their order. If it is empty, they are as in the
    // scene.
    explicit WalkerWorld(std::shared_ptr<const Scene> scene, std::span<const Placement> placed = {});
    // Makes the same building with its things elsewhere, or with other things. `scene` has the same solids and
    // triangles as the scene of `before`. The pieces of things that have not moved are reused, so the cost depends on
    // the number of moved things.
    WalkerWorld(const WalkerWorld& before, std::shared_ptr<const Scene> scene, std::span<const Placement> placed = {});

    const Scene& scene() const { return *scene_; }
    // Moves the body from one place towards another and stops at the first solid.
    // - If the body overlaps a piece at the start, it can move out, up and down, but never farther in.
    // - A piece that contains the body's middle is ignored, so that a walker can always leave it. A ray ignores a
    //   piece in which it starts.
    // - `through_clips`: rays pass through solids that stop only bodies.
    // - `but_placed`: this placed thing is ignored.
    TraceHit trace(const Vec3& from_m, const Vec3& to_m, const WalkerShape& body, bool through_clips = false,
                   std::int32_t but_placed = kNoPlaced) const;
    // Returns all solids on a straight line, in no particular order. Solids that stop only bodies, and solids that
    // contain one of the ends, are left out.
    std::vector<Crossing> crossings(const Vec3& from_m, const Vec3& to_m) const;
    // Returns true if this piece (TraceHit::piece) is part of stairs, on which a walker climbs steps of
    // StairRule::step_m().
    bool is_stairs(std::uint32_t piece) const;
    bool has_stairs() const { return building_->stairs.any(); }
    // Returns true if a solid overlaps a body at this place.
    bool blocked(const Vec3& feet_m, const WalkerShape& body) const;
    // Returns the volumes of this role (Liquid, Trigger, Teleport) that the upright line from `feet_m` to `height_m`
    // above it crosses, as feature ids in the order of the file.
    std::vector<FeatureId> volumes_at(const Vec3& feet_m, double height_m, SolidRole role) const;

    // Returns true if this piece alone (TraceHit::piece) hides the whole box from the eye. If the result is true, every
    // line of sight into the box meets the piece before anything in the box. The result may be false although the piece
    // hides the box.
    bool hides(std::uint32_t piece, const Vec3& eye_m, const Aabb& box) const;
    // Fixed features that may be announced when they are in sight. Each feature has the box of everything with the name
    // of that feature.
    struct Sights {
        std::vector<FeatureId> features;
        std::vector<Aabb> boxes;
        BoxIndex tree;
    };
    const Sights& standing() const { return building_->sights; }
    // Returns the box of everything with the name of this thing, at its present position. `thing` is an index into
    // Scene::placed.
    const Aabb& box_of_placed(std::size_t thing) const { return things_[thing]->box_m; }

    static constexpr std::int32_t kNoPlaced = -2;
    // A body stops this far from a surface, so that rounding never puts it inside.
    static constexpr double kContactGap_m = 1e-4;

private:
    struct Piece {
        std::uint32_t first_plane = 0, plane_count = 0;
        Aabb bounds_m;
        bool clip_only = false;
        bool narrow = false;      // true: the piece is part of stairs; StairRule explains how a walker meets it
        std::uint32_t solid = 0;  // index in Scene::solids; if `triangle`, in Scene::triangles
        bool triangle = false;
        std::int32_t placed = -1;  // index in Scene::placed of the thing that gives the name; -1: part of the building
    };
    struct Bound {
        Plane plane;
        std::int32_t face = -1;  // index of the solid's plane; -1: an added bevel
    };
    struct Pieces {
        std::vector<Bound> bounds;
        std::vector<Piece> pieces;  // sorted by bounds_m.min_m.x, then y
        BoxIndex tree;
        // `stairs` is null for placed things, which are never part of stairs.
        void add_scene(const Scene& scene, const PlacedFrame* frame, std::int32_t placed, const StairRule* stairs);
        void add_piece(const std::vector<Bound>& of_piece, Piece piece);
        void arrange();
    };
    struct Building {
        StairRule stairs;
        Pieces pieces;
        std::vector<std::uint32_t> volumes;  // indices in Scene::solids of volumes that a walker can be in
        Sights sights;
    };
    // A placed thing at its position. The numbers of the planes of its pieces start from zero.
    struct Thing {
        std::shared_ptr<const Scene> model;
        Placement at;
        Pieces pieces;  // pieces of the thing; they have no tree
        Aabb box_m;
    };
    static std::shared_ptr<const Building> built(const Scene& scene);
    void set_down(std::span<const Placement> placed, const WalkerWorld* before);
    static Thing thing_of(const PlacedModel& placed, const Placement& at, std::int32_t number);
    const Piece& piece(std::uint32_t number) const;
    template <class Visit>
    void visit_near(const Aabb& box, Visit visit) const;
    void name_hit(const Piece& piece, std::int32_t face, const Vec3& normal, FeatureId& feature,
                  MaterialId& material) const;

    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const Building> building_;
    std::vector<std::shared_ptr<const Thing>> things_;  // in the order of Scene::placed
    Pieces placed_;                                     // pieces of all things
};

}  // namespace handrail::core
