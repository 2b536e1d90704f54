// What a body bumps into: the scene's solids as convex pieces, swept by an upright box-like body or a point. Immutable
// after it is built; any thread. A trace is exact: the body's Minkowski sum with each convex piece is met by a moving
// point, so nothing is tunnelled at any speed. Only pieces whose box the way goes through before it has met something
// are looked at. What stands still of a building is made once and shared by all worlds in which only things stand
// elsewhere.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "worlds/geometry/box_index.h"
#include "worlds/scene/scene.h"
#include "worlds/scene/stair_rule.h"

namespace handrail {

// An upright cylinder standing on its reference point; radius 0 and height 0 is a ray.
struct BodyShape {
    double radius_m = 0.0;
    double height_m = 0.0;
};

struct TraceHit {
    double fraction = 1.0;  // of the way, 1 when nothing was met
    Vec3 end_m{0.0};        // where the reference point stops, kContactGap_m before the surface
    Vec3 normal{0.0};       // of the surface that was met
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    bool hit = false;
    std::uint32_t piece = 0xFFFFFFFFU;  // which was met, for BodyWorld::hides()
};

// A stretch of a straight way that lies in something solid, from its start.
struct Crossing {
    double enter_m = 0.0, leave_m = 0.0;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
};

// Doors, landmarks, clues, liquids and things: what an answer to "what is around" may name. A bare wall is not.
bool told_when_seen(const Feature& feature);

class BodyWorld {
public:
    // placed: where the scene's placed things stand, in their order; left out, where the scene has them.
    explicit BodyWorld(std::shared_ptr<const Scene> scene, std::span<const Placement> placed = {});
    // The same building with its things elsewhere, or other things: `scene` has the solids and triangles of the one
    // before. What stands as before is taken over: the cheaper the fewer of its things have moved.
    BodyWorld(const BodyWorld& before, std::shared_ptr<const Scene> scene, std::span<const Placement> placed = {});

    const Scene& scene() const { return *scene_; }
    // Moves the body from one place towards another and stops at the first solid. A piece that the body already
    // overlaps at the start lets it out, up and down, and never farther in; one that its middle is in is ignored, so
    // that one can always walk out of it. So is what a ray starts in. `through_clips`: rays look through what only
    // stops bodies. `but_placed`: this placed thing is not there.
    TraceHit trace(const Vec3& from_m, const Vec3& to_m, const BodyShape& body, bool through_clips = false,
                   std::int32_t but_placed = kNoPlaced) const;
    // Everything solid on a straight way, in no order; what only stops bodies and what holds either end is left out.
    std::vector<Crossing> crossings(const Vec3& from_m, const Vec3& to_m) const;
    // Is this piece (TraceHit::piece) part of stairs? From and to them a body climbs steps of StairRule::step_m().
    bool is_stairs(std::uint32_t piece) const;
    bool has_stairs() const { return building_->stairs.any(); }
    // True when a solid overlaps the body standing there.
    bool blocked(const Vec3& feet_m, const BodyShape& body) const;
    // Volumes of that role (Liquid, Trigger, Teleport) which the upright line feet..feet+height meets; feature ids in
    // file order.
    std::vector<FeatureId> volumes_at(const Vec3& feet_m, double height_m, SolidRole role) const;

    // Does this piece alone (TraceHit::piece) lie before everything in the box, seen from there? Never wrongly: a line
    // of sight to any place in the box meets it, and meets it before anything that lies in the box.
    bool hides(std::uint32_t piece, const Vec3& eye_m, const Aabb& box) const;
    // Features that stand still and may be told of when they are in sight, each with the box of all that goes by its
    // name.
    struct Sights {
        std::vector<FeatureId> features;
        std::vector<Aabb> boxes;
        BoxIndex tree;
    };
    const Sights& standing() const { return building_->sights; }
    // The box of all that goes by a thing's name where it stands now. Index of Scene::placed.
    const Aabb& box_of_placed(std::size_t thing) const { return things_[thing]->box_m; }

    static constexpr std::int32_t kNoPlaced = -2;
    // A body stops this far from a surface, so that rounding never lets it in.
    static constexpr double kContactGap_m = 1e-4;

private:
    struct Piece {
        std::uint32_t first_plane = 0, plane_count = 0;
        Aabb bounds_m;
        bool clip_only = false;
        bool narrow = false;      // met as stairs are: see StairRule
        std::uint32_t solid = 0;  // index of Scene::solids, or of triangles when `triangle`
        bool triangle = false;
        std::int32_t placed = -1;  // index of Scene::placed, whose name it goes by; -1: of the building itself
    };
    struct Bound {
        Plane plane;
        std::int32_t face = -1;  // index of the solid's plane; -1 for added bevels
    };
    struct Pieces {
        std::vector<Bound> bounds;
        std::vector<Piece> pieces;  // sorted by bounds_m.min_m.x, then y
        BoxIndex tree;
        // `stairs`: null for what is set down, which is never part of stairs.
        void add_scene(const Scene& scene, const PlacedFrame* frame, std::int32_t placed, const StairRule* stairs);
        void add_piece(const std::vector<Bound>& of_piece, Piece piece);
        void arrange();
    };
    struct Building {
        StairRule stairs;
        Pieces pieces;
        std::vector<std::uint32_t> volumes;  // of Scene::solids: what one can be in
        Sights sights;
    };
    // A placed thing where it stands. Its pieces count their planes from zero.
    struct Thing {
        std::shared_ptr<const Scene> model;
        Placement at;
        Pieces pieces;  // without a tree
        Aabb box_m;
    };
    static std::shared_ptr<const Building> built(const Scene& scene);
    void set_down(std::span<const Placement> placed, const BodyWorld* before);
    static Thing thing_of(const PlacedModel& placed, const Placement& at, std::int32_t number);
    const Piece& piece(std::uint32_t number) const;
    template <class Visit>
    void visit_near(const Aabb& box, Visit visit) const;
    void name_hit(const Piece& piece, std::int32_t face, const Vec3& normal, FeatureId& feature,
                  MaterialId& material) const;

    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const Building> building_;
    std::vector<std::shared_ptr<const Thing>> things_;  // in the order of Scene::placed
    Pieces placed_;                                     // of all of them
};

}  // namespace handrail
