// The haptic view of a building: what a hand can touch and nothing else. Immutable once built, so the servo thread
// reads it without locks. World metres in double, stored relative to origin_m so that far-away buildings lose nothing.
// Features are named by FeatureId; ask Scene on the app thread for words. Built by compile_haptic (haptic/compile)
// through HapticSceneBuilder.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "haptic/render/effect_volume.h"
#include "haptic/render/mesh_shading.h"
#include "haptic/render/relief.h"
#include "haptic/render/soft_patch.h"
#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"
#include "worlds/geometry/bvh.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/geometry/convex.h"
#include "worlds/geometry/placement.h"
#include "worlds/geometry/round_shapes.h"
#include "worlds/geometry/triangle_mesh.h"

namespace handrail {

// Negative: the tuning's default holds.
struct HapticMaterial {
    double stiffness_fraction = -1.0;
    double friction_static = -1.0;
    double friction_kinetic = -1.0;
    double damping_ns_per_m = -1.0;
    std::int32_t relief = -1;  // into HapticScene::reliefs; -1: plain
};

// What is touched where: the answer to "which surface is this?".
struct SurfaceLabel {
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    bool hidden = false;  // wholly covered by other solids; names nothing while another face can

    bool operator==(const SurfaceLabel&) const = default;
};

enum class ObstacleKind : std::uint8_t {
    Triangle,  // sheet, no inside
    Polygon,   // flat convex sheet, no inside
    Box,       // axis-aligned
    Brush,     // convex solid given by its planes
    Sphere,
    Capsule,
    Cylinder,
    Cone,
    Custom,  // convex solid given by a function
};
inline constexpr std::size_t kObstacleKinds = 9;

// A convex solid of one's own, given by a function. It runs on the servo thread: no allocation, lock or exception, and
// only + - * / and square root, so that every machine gives the same numbers. For a place outside the solid it gives
// the nearest place of the surface and the distance, with an error far below what is felt (1e-9 m); for one inside, any
// negative distance. Exact at every place is the plane: dot(normal, o) <= dot(normal, point_m) for every place o of the
// solid, normal of length 1. That is what keeps a ball outside at any speed.
struct CustomObstacle {
    ClosestPoint (*closest)(const Vec3& at_m, const void* data) noexcept = nullptr;  // the solid's own coordinates
    std::shared_ptr<const void> data;                                                // lives as long as the scene
    Vec3 position_m{0.0};                                                            // of the own zero, world
    Aabb bounds_m;  // around the solid, own coordinates
};
// True when it has a function and a size, and the function keeps the promise above at 386 places around and between
// them.
bool is_sound(const CustomObstacle& obstacle);

// One convex thing that stops the proxy.
struct Obstacle {
    ObstacleKind kind = ObstacleKind::Triangle;
    TouchSide side = TouchSide::Both;  // of sheets; solids have none
    std::uint16_t rounding = 0;        // of a box or brush: into roundings_m
    std::uint32_t shape = 0;        // into mesh.triangles or the list of its kind; for a brush the first of its planes
    std::uint32_t planes = 0;       // of a brush
    std::uint32_t first_label = 0;  // triangle 1 (shared by triangles that follow each other), polygon 2 (front, back),
                                    // box 6 (-x +x -y +y -z +z), brush one per plane, sphere, capsule and custom 1,
                                    // cylinder 3 (side, bottom, top), cone 2 (side, base)
};

// The corners of one flat polygon among HapticScene::polygon_corners.
struct PolygonRange {
    Vec3 normal{0.0};
    std::uint32_t first_corner = 0, corners = 0;
};

// A volume to move through. A point in it is felt by its viscosity, in Ns/m of hand speed. Buoyancy and film act at the
// open surface: the exposed face that looks up most; a liquid without one has neither.
struct LiquidVolume {
    std::vector<Plane> planes;
    std::vector<bool> hidden;  // per plane: covered, so no surface of the liquid
    FeatureId feature = kNoFeature;
    double viscosity_ns_per_m = 0.0;  // 0: no drag
    double buoyancy_n = 0.0;          // lifts what is in it; at most 1
    double film_n = 0.0;              // what the surface holds back at most; at most 0.5
    Vec3 flow_hand_m_per_s{0.0};      // the stream carries a still hand with viscosity times this, at most 2 N

    // Worked out when the scene is built.
    int surface = -1;  // of planes; -1: none is open and looks up
    double inner_radius_m = 0.0;
    double crowd_stiffness_n_per_m = 0.0;  // of its drag, film and buoyancy and of all effects that overlap it
};

struct HapticScene;

// A thing that may move, turn, grow, appear and vanish as one: a door leaf, a crate. Its obstacles stand in its own
// frame, each once however many bodies share the shape; their labels' materials are the whole scene's.
struct HapticBody {
    FeatureId feature = kNoFeature;
    std::shared_ptr<const HapticScene> shape;  // its obstacles; its own bodies, liquids and materials are not looked at
    Placement start;                           // where it stands until a BodyPose says otherwise, world
    bool present = true;                       // likewise
    double reach_m = 0.0;                      // no point of it is farther from its frame's zero, own metres
};

// Where a body is at a tick.
struct BodyPose {
    Placement at;  // world
    bool present = true;

    bool operator==(const BodyPose&) const = default;
};

// A body on its way from one pose to another, as it looks at a glance: its frame's zero is never farther than
// half_way_m from middle_m.
struct MovingBody {
    std::uint32_t body = 0;
    double half_way_m = 0.0;
    double most_scale = 1.0;
    Vec3 middle_m{0.0};  // world
};

// How bodies go from their poses to others: a pose on the way is worked out when somebody asks for it, and nobody asks
// for those of things that are far.
struct BodyWays {
    std::uint64_t number = 0;         // of these ways
    std::uint64_t number_before = 0;  // of the ways that ended where these begin; 0: unknown
    std::span<const BodyPose> to{};   // the other ends; empty: nothing moves
    double part = 0.0;                // of the ways
    std::span<const MovingBody>
        moving{};  // who moves, comes or goes on them, in rising order, where number_before is known
};

// Where all bodies of a scene are on a tick, in its order, or nothing at all: every body as the scene has it.
struct BodyPoses {
    std::span<const BodyPose> poses{};
    // Changes whenever a pose does, so that a tick on which nothing moves looks at none of them.
    std::uint64_t number = 0;
    // Null: the poses are where the bodies are, and anybody may have moved with a new number.
    const BodyWays* ways = nullptr;

    std::uint64_t ways_number() const noexcept { return ways ? ways->number : number; }
    bool know(std::size_t body) const noexcept { return body < poses.size(); }
    // know(body)
    BodyPose at(std::size_t body) const noexcept {
        const BodyPose& a = poses[body];
        if (!ways || body >= ways->to.size()) return a;
        const BodyPose& b = ways->to[body];
        return a.present && b.present && !(a.at == b.at) ? BodyPose{between(a.at, b.at, ways->part), true} : a;
    }
};

struct HapticScene {
    // A number that is not looked at beyond its size in tables: a tick tracks only bodies that are near.
    static constexpr std::size_t kMostBodies = 16384;

    std::uint32_t generation = 0;  // differs for every scene built in this process
    std::uint32_t world =
        0;               // the same for scenes that are one world with something added or removed; else the generation
    Vec3 origin_m{0.0};  // world place of the local zero; everything below is local
    std::vector<Obstacle> obstacles;
    TriangleMesh mesh;  // corners shared by all triangles that have them
    std::vector<Aabb> boxes;
    std::vector<Plane> planes;
    std::vector<double> roundings_m{0.0};  // radii of the edges of boxes and brushes; [0]: sharp
    std::vector<PolygonRange> polygons;
    std::vector<PolygonCorner> polygon_corners;
    std::vector<SphereShape> spheres;
    std::vector<CapsuleShape> capsules;
    std::vector<CylinderShape> cylinders;
    std::vector<ConeShape> cones;
    std::vector<CustomObstacle> customs;
    std::vector<SurfaceLabel> labels;
    bool one_sided_sheets = false;               // some sheet can be touched from one side only
    Bvh obstacle_bvh;                            // item i is obstacles[i]
    std::vector<LiquidVolume> liquids;           // in the file's order
    Bvh liquid_bvh;                              // item i is liquids[i]
    bool media = false;                          // there are liquids, effects or soft patches
    bool liquid_surfaces = false;                // some liquid has buoyancy or a film
    bool plain = false;                          // has nothing that PlainFeatures leaves out (tick_features.h)
    bool plain_afar = false;                     // nothing but bodies: plain while none of them is near
    std::vector<EffectVolume> effects;           // in the file's order
    Bvh effect_bvh;                              // item i is effects[i], those that hang on no body
    std::vector<std::uint32_t> hanging_effects;  // of effects: those that hang on a body
    std::vector<SoftPatch> soft_patches;
    std::vector<HapticBody> bodies;         // at most kMostBodies
    std::vector<HapticMaterial> materials;  // same order as Scene::materials; entry 0 is the default wall
    std::vector<Relief> reliefs;            // height and friction textures
    MeshShading shading;                    // of `mesh`, where asked for
    bool fields = false;                    // reliefs or shading, here or in a body
    std::vector<std::uint8_t>
        relief_axis;  // by FeatureId of a mesh: 0, 1 or 2, the axis along which its textures are laid on

    // Local coordinates. Never empty of meaning: index < obstacles.size().
    ClosestPoint closest(std::uint32_t obstacle, const Vec3& local_m) const noexcept {
        const Obstacle& o = obstacles[obstacle];
        if (o.kind != ObstacleKind::Triangle) return closest_but_triangle(o, local_m);
        const Corners& t = mesh.triangles[o.shape];
        return closest_point_of_triangle(mesh.points_m[t[0]], mesh.points_m[t[1]], mesh.points_m[t[2]], local_m);
    }
    // Cheaper than closest(), for obstacles not near: some plane that supports the obstacle, and how far in front of it
    // the point is, no more than its distance. 0 where no such plane is plain to see.
    double quick_support(std::uint32_t obstacle, const Vec3& local_m, Vec3& normal) const noexcept {
        const Obstacle& o = obstacles[obstacle];
        if (o.kind != ObstacleKind::Triangle) return 0.0;
        const Corners& t = mesh.triangles[o.shape];
        return support_towards(mesh.points_m[t[0]], mesh.points_m[t[1]], mesh.points_m[t[2]], local_m, normal);
    }
    // Some surface is felt elsewhere than its obstacle lies: textures or shading (surface_field.h).
    bool has_fields() const noexcept { return fields; }
    bool solid(std::uint32_t obstacle) const noexcept { return obstacles[obstacle].kind > ObstacleKind::Polygon; }
    TriangleShape triangle(const Obstacle& o) const noexcept {
        const Corners& t = mesh.triangles[o.shape];
        return make_triangle(mesh.points_m[t[0]], mesh.points_m[t[1]], mesh.points_m[t[2]]);
    }
    // How far a point lies on the side from which a sheet of one side can be touched; negative: behind it. Sheets with
    // TouchSide::Front or Back only.
    double in_front_m(std::uint32_t obstacle, const Vec3& local_m) const noexcept;
    // True when two supporting planes with these normals touch one smooth piece of the obstacle, with no edge between:
    // the place nearest to a point can then be reached from the other without passing a corner.
    bool smooth_between(std::uint32_t obstacle, const Vec3& normal_a, const Vec3& normal_b) const noexcept;
    // The face that looks most along `normal`, hidden faces last: its number within the obstacle, and its label.
    std::uint32_t face(std::uint32_t obstacle, const Vec3& normal) const noexcept;
    const SurfaceLabel& label(std::uint32_t obstacle, std::uint32_t face) const noexcept {
        return labels[obstacles[obstacle].first_label + face];
    }
    const SurfaceLabel& surface(std::uint32_t obstacle, const Vec3& normal) const noexcept {
        return label(obstacle, face(obstacle, normal));
    }
    const HapticMaterial& material(MaterialId id) const noexcept {
        return materials[id < materials.size() ? id : kDefaultMaterial];
    }
    // The radius of the edges of a box or brush.
    double rounding_m(const Obstacle& o) const noexcept { return roundings_m[o.rounding]; }
    // How many obstacles of each kind, indexed by ObstacleKind. Looks at all of them: not for the tick.
    std::array<std::size_t, kObstacleKinds> obstacle_counts() const noexcept;

private:
    ClosestPoint closest_but_triangle(const Obstacle& o, const Vec3& local_m) const noexcept;
};

// Collects world-coordinate shapes, then builds the scene. Off the real-time path; one thread.
class HapticSceneBuilder {
public:
    // Entry 0 is the default wall; an empty list is given one.
    explicit HapticSceneBuilder(std::vector<HapticMaterial> materials = {});

    // Triangles as sheets that share their corners; labels: one per triangle or one for all.
    void add_mesh(const TriangleMesh& mesh, std::span<const SurfaceLabel> labels, TouchSide side = TouchSide::Both);
    void add_mesh(const TriangleMesh& mesh, const SurfaceLabel& label = {}, TouchSide side = TouchSide::Both) {
        add_mesh(mesh, std::span(&label, 1), side);
    }
    void add_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const SurfaceLabel& label = {},
                      TouchSide side = TouchSide::Both);
    // A flat convex polygon; labels: one, or front and back. See make_polygon for what it expects of the points.
    void add_polygon(std::span<const Vec3> points_m, std::span<const SurfaceLabel> labels,
                     TouchSide side = TouchSide::Both);
    void add_polygon(std::span<const Vec3> points_m, const SurfaceLabel& label = {}, TouchSide side = TouchSide::Both) {
        add_polygon(points_m, std::span(&label, 1), side);
    }
    // One label for all faces, or six: -x +x -y +y -z +z.
    void add_box(const Aabb& box_m, std::span<const SurfaceLabel> labels);
    void add_box(const Aabb& box_m, const SurfaceLabel& label = {}) { add_box(box_m, std::span(&label, 1)); }
    // A bounded convex solid; labels: one per plane or one for all. Becomes a box when it is an axis-aligned one.
    // rounding_m: of its edges and corners; every face must still have an area when it has moved in by as much.
    void add_solid(std::span<const Plane> planes, const Aabb& bounds_m, std::span<const SurfaceLabel> labels,
                   double rounding_m = 0.0);
    void add_solid(std::span<const Plane> planes, const Aabb& bounds_m, const SurfaceLabel& label = {}) {
        add_solid(planes, bounds_m, std::span(&label, 1));
    }
    // Round solids; sizes are finite and not negative, axes of unit length: whoever feeds the builder refuses others.
    // Labels: one for all faces, or one each.
    void add_sphere(const SphereShape& sphere, const SurfaceLabel& label = {});
    void add_capsule(const CapsuleShape& capsule, const SurfaceLabel& label = {});
    void add_cylinder(const CylinderShape& cylinder, std::span<const SurfaceLabel> labels);  // side, bottom, top
    void add_cylinder(const CylinderShape& cylinder, const SurfaceLabel& label = {}) {
        add_cylinder(cylinder, std::span(&label, 1));
    }
    void add_cone(const ConeShape& cone, std::span<const SurfaceLabel> labels);  // side, base
    void add_cone(const ConeShape& cone, const SurfaceLabel& label = {}) { add_cone(cone, std::span(&label, 1)); }
    // False, and nothing added, for one that is not sound.
    bool add_custom(CustomObstacle obstacle, const SurfaceLabel& label = {});
    void add_liquid(LiquidVolume liquid, const Aabb& bounds_m);
    // False, and nothing added, for one that is not sound or when there are kMostSoftPatches already.
    bool add_soft(SoftPatch patch);
    // False, and nothing added, for one that is not sound (is_sound) or hangs on a body that was not added before.
    bool add_effect(EffectVolume effect);
    // The shape comes from a builder of its own, in the body's frame. False, and nothing added, when there are
    // kMostBodies already.
    bool add_body(FeatureId feature, std::shared_ptr<const HapticScene> shape, const Placement& start,
                  bool present = true);
    // Lets the triangles added be felt as the curve they stand for (mesh_shading.h). Off unless asked for.
    void shade_meshes() { shades_ = true; }
    // What HapticMaterial::relief counts in; origins in world metres. `mesh_axis`: see HapticScene::relief_axis.
    void set_reliefs(std::vector<Relief> reliefs, std::vector<std::uint8_t> mesh_axis = {});

    // The number and the start of the first body of that name, if one was added.
    std::optional<std::pair<std::uint32_t, Placement>> body_of(FeatureId feature) const;

    // world: HapticScene::world of the scene that this one replaces while it is touched; 0: another world.
    std::shared_ptr<const HapticScene> build(std::uint32_t world = 0);

private:
    void choose_origin();
    void make_polygons();
    void settle_sides();
    void move_to_origin();
    void prepare_effects();
    void add_sheet(const Corners& corners, const SurfaceLabel& label, TouchSide side);
    std::uint16_t rounding(double rounding_m);
    void add_obstacle(ObstacleKind kind, std::size_t shape, std::size_t faces, std::span<const SurfaceLabel> labels,
                      const Aabb& bounds_m);

    bool shades_ = false;
    HapticScene scene_;
    std::vector<Aabb> obstacle_bounds_, liquid_bounds_, effect_bounds_;
};

}  // namespace handrail
