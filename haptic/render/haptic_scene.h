// Defines the haptic view of a building: only what a hand can touch. A HapticScene is immutable once built, so the
// servo thread reads it without locks. World metres in double precision, stored relative to origin_m so that buildings
// far from the world's origin lose no precision. Features are identified by FeatureId; query Scene on the app thread
// for their names. compile_haptic() in haptic/compile builds the scene through HapticSceneBuilder.
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

namespace handrail::render {

// The haptic properties of a material. A negative value means that the default of TouchTuning applies.
struct HapticMaterial {
    double stiffness_fraction = -1.0;
    double friction_static = -1.0;
    double friction_kinetic = -1.0;
    double damping_ns_per_m = -1.0;
    std::int32_t relief = -1;  // index of the material's texture in HapticScene::reliefs; -1: smooth
};

// The feature and material of a surface.
struct SurfaceLabel {
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    // The face is completely covered by other solids. It gives a contact its name only if no other face can.
    bool hidden = false;

    bool operator==(const SurfaceLabel&) const = default;
};

enum class ObstacleKind : std::uint8_t {
    Triangle,  // a sheet without an inside
    Polygon,   // a flat convex sheet without an inside
    Box,       // axis-aligned box
    Brush,     // convex solid given by planes
    Sphere,
    Capsule,
    Cylinder,
    Cone,
    Custom,  // convex solid given by a function, CustomObstacle
};
inline constexpr std::size_t kObstacleKinds = 9;

// A convex solid that the caller defines by a function. The function runs on the servo thread: it must not allocate,
// lock or throw. It may use only + - * / and square root, so that every machine computes the same numbers. For a place
// outside the solid it returns the nearest point of the surface and the distance, with an error far below what can be
// felt (1e-9 m). For a place inside it returns any negative distance. The plane through that point must support the
// solid exactly: dot(normal, o) <= dot(normal, point_m) for every point o of the solid, with a normal of length 1. This
// keeps the proxy outside at any speed.
struct CustomObstacle {
    // Returns the closest point for a position in the solid's own coordinates.
    ClosestPoint (*closest)(const Vec3& at_m, const void* data) noexcept = nullptr;
    std::shared_ptr<const void> data;  // data for the function; must live as long as the scene
    Vec3 position_m{0.0};              // position of the solid's own origin in the world
    Aabb bounds_m;                     // bounds in the solid's own coordinates
};
// Returns true if the obstacle has a function and a size, and the function meets the requirements of CustomObstacle.
// The requirements are tested at 386 positions around the solid, and between these positions.
bool is_sound(const CustomObstacle& obstacle);

// One convex obstacle that stops the proxy.
struct Obstacle {
    ObstacleKind kind = ObstacleKind::Triangle;
    TouchSide side = TouchSide::Both;  // touchable side of a sheet; solids ignore it
    std::uint16_t rounding = 0;        // for a box or brush: index in roundings_m
    // Index of the obstacle's triangle in mesh.triangles, or of its shape in the list of its kind. For a brush, index
    // of the first of its planes.
    std::uint32_t shape = 0;
    std::uint32_t planes = 0;  // number of planes of a brush
    // Index of the obstacle's first label. The numbers of labels are: triangle 1 (shared by consecutive triangles),
    // polygon 2 (front, back), box 6 (-x +x -y +y -z +z), brush one per plane, sphere, capsule and custom 1, cylinder 3
    // (side, bottom, top), cone 2 (side, base).
    std::uint32_t first_label = 0;
};

// A flat polygon, whose corners are a range of HapticScene::polygon_corners.
struct PolygonRange {
    Vec3 normal{0.0};
    std::uint32_t first_corner = 0, corners = 0;
};

// A volume of liquid that the hand moves through. Inside it the hand feels its viscosity, in Ns/m of hand speed.
// Buoyancy and film act at the open surface, which is the exposed face that faces up the most. A liquid without such a
// face has neither.
struct LiquidVolume {
    std::vector<Plane> planes;
    std::vector<bool> hidden;  // for each plane: true if it is covered, so that it is not a surface of the liquid
    FeatureId feature = kNoFeature;
    double viscosity_ns_per_m = 0.0;  // drag per hand speed; 0: no drag
    double buoyancy_n = 0.0;          // upward force on a hand in the liquid; at most 1
    double film_n = 0.0;              // greatest force with which the surface film holds the hand back; at most 0.5
    // Velocity of the current, which pushes a still hand with a force of viscosity times this speed, at most 2 N.
    Vec3 flow_hand_m_per_s{0.0};

    // The members below are computed when the scene is built.
    int surface = -1;  // plane of the open surface; -1: no exposed face faces up
    double inner_radius_m = 0.0;
    // Sum of the stiffness of the liquid's drag, film and buoyancy and of all effects that overlap the liquid.
    double crowd_stiffness_n_per_m = 0.0;
};

struct HapticScene;

// A thing that may move, turn, grow, appear and vanish as a whole, such as a door leaf or a crate. Its obstacles are in
// its own frame and stored once, however many bodies share the shape. The material numbers in their labels are indices
// in the whole scene's list.
struct HapticBody {
    FeatureId feature = kNoFeature;
    // The obstacles of the body. Any bodies, liquids and materials in `shape` are ignored.
    std::shared_ptr<const HapticScene> shape;
    Placement start;      // pose in the world, used until a BodyPose replaces it
    bool present = true;  // whether it is present, until a BodyPose says otherwise
    // Distance from the origin of the body's frame to the body's farthest point, in the body's own metres.
    double reach_m = 0.0;
};

// The pose of a body in a tick.
struct BodyPose {
    Placement at;  // pose in the world
    bool present = true;

    bool operator==(const BodyPose&) const = default;
};

// A rough bound for a body that moves from one pose to another. The origin of its frame is never farther than
// half_path_m from middle_m.
struct MovingBody {
    std::uint32_t body = 0;
    double half_path_m = 0.0;
    double most_scale = 1.0;
    Vec3 middle_m{0.0};  // middle of the movement, world
};

// A movement of bodies from the poses in BodyPoses to other poses. A pose in between is computed only when it is
// queried. No code queries those of far bodies.
struct BodyPaths {
    std::uint64_t number = 0;         // number of this movement
    std::uint64_t number_before = 0;  // number of the movement that ended where this movement begins; 0: not known
    std::span<const BodyPose> to{};   // the target poses; empty: no body moves
    double part = 0.0;                // completed part of the movement, 0 to 1
    // Bodies that move, appear or vanish in this movement, in rising order. Valid only if number_before is not 0.
    std::span<const MovingBody> moving{};
};

// The poses of all bodies of a scene in a tick, in the scene's order. If `poses` is empty, every body has its pose from
// the scene.
struct BodyPoses {
    std::span<const BodyPose> poses{};
    // Changes whenever a pose changes, so that a tick in which no body moves need not examine the poses.
    std::uint64_t number = 0;
    // The current movement, or null. If it is null, `poses` are the current poses, and a new `number` means that any
    // body may have moved.
    const BodyPaths* ways = nullptr;

    std::uint64_t ways_number() const noexcept { return ways ? ways->number : number; }
    bool know(std::size_t body) const noexcept { return body < poses.size(); }
    // Requires know(body).
    BodyPose at(std::size_t body) const noexcept {
        const BodyPose& a = poses[body];
        if (!ways || body >= ways->to.size()) return a;
        const BodyPose& b = ways->to[body];
        return a.present && b.present && !(a.at == b.at) ? BodyPose{between(a.at, b.at, ways->part), true} : a;
    }
};

struct HapticScene {
    // Greatest number of bodies. It affects only the size of some tables, because a tick follows only the bodies that
    // are near.
    static constexpr std::size_t kMostBodies = 16384;

    std::uint32_t generation = 0;  // unique number among the scenes built in this process
    // Number that scenes share if they are the same world with things added or removed. For a new world it equals
    // `generation`.
    std::uint32_t world = 0;
    Vec3 origin_m{0.0};  // position of the local origin in the world; all members below are in local coordinates
    std::vector<Obstacle> obstacles;
    TriangleMesh mesh;  // triangles share their corners
    std::vector<Aabb> boxes;
    std::vector<Plane> planes;
    std::vector<double> roundings_m{0.0};  // radii of the edges of boxes and brushes; roundings_m[0] means sharp edges
    std::vector<PolygonRange> polygons;
    std::vector<PolygonCorner> polygon_corners;
    std::vector<SphereShape> spheres;
    std::vector<CapsuleShape> capsules;
    std::vector<CylinderShape> cylinders;
    std::vector<ConeShape> cones;
    std::vector<CustomObstacle> customs;
    std::vector<SurfaceLabel> labels;
    bool one_sided_sheets = false;      // at least one sheet can be touched from one side only
    Bvh obstacle_bvh;                   // BVH of the obstacles; item i is obstacles[i]
    std::vector<LiquidVolume> liquids;  // the liquids, in the order of the world file
    Bvh liquid_bvh;                     // BVH of the liquids; item i is liquids[i]
    bool media = false;                 // true if there are liquids, effects or soft patches
    bool liquid_surfaces = false;       // true if at least one liquid has buoyancy or a film
    bool plain = false;  // true if the scene has no feature that PlainFeatures leaves out (tick_features.h)
    // True if bodies are the only such feature. The scene is then plain while no body is near.
    bool plain_afar = false;
    std::vector<EffectVolume> effects;  // the effects, in the order of the world file
    Bvh effect_bvh;                     // BVH of the effects that are not attached to a body; item i is effects[i]
    std::vector<std::uint32_t> hanging_effects;  // indices of the effects that are attached to a body
    std::vector<SoftPatch> soft_patches;
    std::vector<HapticBody> bodies;  // the bodies that may move; at most kMostBodies
    // The materials, in the order of Scene::materials; entry 0 is the default wall.
    std::vector<HapticMaterial> materials;
    std::vector<Relief> reliefs;  // height and friction textures
    MeshShading shading;          // shading of `mesh`, if requested
    bool fields = false;          // true if the scene or one of its bodies has reliefs or shading
    // For each FeatureId of a mesh, the axis along which its textures are projected: 0, 1 or 2.
    std::vector<std::uint8_t> relief_axis;

    // Returns the point of an obstacle that is closest to local_m, in local coordinates. Requires obstacle <
    // obstacles.size().
    ClosestPoint closest(std::uint32_t obstacle, const Vec3& local_m) const noexcept {
        const Obstacle& o = obstacles[obstacle];
        if (o.kind != ObstacleKind::Triangle) return closest_but_triangle(o, local_m);
        const Corners& t = mesh.triangles[o.shape];
        return closest_point_of_triangle(mesh.points_m[t[0]], mesh.points_m[t[1]], mesh.points_m[t[2]], local_m);
    }
    // A cheaper version of closest() for obstacles that are not near. Sets `normal` to that of some plane that supports
    // the obstacle, and returns how far the point is in front of that plane. The result is a lower bound of the point's
    // distance from the obstacle. Returns 0 if no such plane is easily found.
    double quick_support(std::uint32_t obstacle, const Vec3& local_m, Vec3& normal) const noexcept {
        const Obstacle& o = obstacles[obstacle];
        if (o.kind != ObstacleKind::Triangle) return 0.0;
        const Corners& t = mesh.triangles[o.shape];
        return support_towards(mesh.points_m[t[0]], mesh.points_m[t[1]], mesh.points_m[t[2]], local_m, normal);
    }
    // Returns true if textures or shading make some surface feel higher or lower than its obstacle (surface_field.h).
    bool has_fields() const noexcept { return fields; }
    bool solid(std::uint32_t obstacle) const noexcept { return obstacles[obstacle].kind > ObstacleKind::Polygon; }
    TriangleShape triangle(const Obstacle& o) const noexcept {
        const Corners& t = mesh.triangles[o.shape];
        return make_triangle(mesh.points_m[t[0]], mesh.points_m[t[1]], mesh.points_m[t[2]]);
    }
    // Returns how far a point is in front of the touchable side of a one-sided sheet; negative: behind it. Only for
    // sheets with TouchSide::Front or Back.
    double in_front_m(std::uint32_t obstacle, const Vec3& local_m) const noexcept;
    // Returns true if two supporting planes with these normals touch one smooth piece of the obstacle, without an edge
    // between them. The proxy can then roll from one point of contact to the other without passing a corner.
    bool smooth_between(std::uint32_t obstacle, const Vec3& normal_a, const Vec3& normal_b) const noexcept;
    // Returns the face that faces most along `normal`, and its label. Faces are numbered within the obstacle; visible
    // faces are preferred.
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
    // Returns the radius of the edges of a box or brush.
    double rounding_m(const Obstacle& o) const noexcept { return roundings_m[o.rounding]; }
    // Returns the number of obstacles of each kind, indexed by ObstacleKind. The function visits every obstacle, so it
    // is not for the tick.
    std::array<std::size_t, kObstacleKinds> obstacle_counts() const noexcept;

private:
    ClosestPoint closest_but_triangle(const Obstacle& o, const Vec3& local_m) const noexcept;
};

// Collects shapes in world coordinates, then builds the scene. Not for the servo thread; one thread.
class HapticSceneBuilder {
public:
    // Entry 0 of `materials` is the default wall. An empty list gets one.
    explicit HapticSceneBuilder(std::vector<HapticMaterial> materials = {});

    // Adds triangles as sheets that share their corners. `labels`: one for each triangle, or one for all.
    void add_mesh(const TriangleMesh& mesh, std::span<const SurfaceLabel> labels, TouchSide side = TouchSide::Both);
    void add_mesh(const TriangleMesh& mesh, const SurfaceLabel& label = {}, TouchSide side = TouchSide::Both) {
        add_mesh(mesh, std::span(&label, 1), side);
    }
    void add_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const SurfaceLabel& label = {},
                      TouchSide side = TouchSide::Both);
    // Adds a flat convex polygon, whose points must meet the requirements of make_polygon. `labels`: one, or front and
    // back.
    void add_polygon(std::span<const Vec3> points_m, std::span<const SurfaceLabel> labels,
                     TouchSide side = TouchSide::Both);
    void add_polygon(std::span<const Vec3> points_m, const SurfaceLabel& label = {}, TouchSide side = TouchSide::Both) {
        add_polygon(points_m, std::span(&label, 1), side);
    }
    // Adds an axis-aligned box. `labels`: one for all faces, or six in the order -x +x -y +y -z +z.
    void add_box(const Aabb& box_m, std::span<const SurfaceLabel> labels);
    void add_box(const Aabb& box_m, const SurfaceLabel& label = {}) { add_box(box_m, std::span(&label, 1)); }
    // Adds a bounded convex solid; an axis-aligned one becomes a box. `labels`: one for each plane, or one for all.
    // `rounding_m` is the radius of the solid's edges and corners. Every face must still have an area after it is moved
    // inwards by that radius.
    void add_solid(std::span<const Plane> planes, const Aabb& bounds_m, std::span<const SurfaceLabel> labels,
                   double rounding_m = 0.0);
    void add_solid(std::span<const Plane> planes, const Aabb& bounds_m, const SurfaceLabel& label = {}) {
        add_solid(planes, bounds_m, std::span(&label, 1));
    }
    // Add round solids. Sizes must be finite and not negative, and axes must have unit length; the caller must reject
    // others. `labels`: one for all faces, or one for each.
    void add_sphere(const SphereShape& sphere, const SurfaceLabel& label = {});
    void add_capsule(const CapsuleShape& capsule, const SurfaceLabel& label = {});
    // Labels: side, bottom, top.
    void add_cylinder(const CylinderShape& cylinder, std::span<const SurfaceLabel> labels);
    void add_cylinder(const CylinderShape& cylinder, const SurfaceLabel& label = {}) {
        add_cylinder(cylinder, std::span(&label, 1));
    }
    void add_cone(const ConeShape& cone, std::span<const SurfaceLabel> labels);  // labels: side, base
    void add_cone(const ConeShape& cone, const SurfaceLabel& label = {}) { add_cone(cone, std::span(&label, 1)); }
    // Adds an obstacle if is_sound() accepts it; otherwise returns false.
    bool add_custom(CustomObstacle obstacle, const SurfaceLabel& label = {});
    void add_liquid(LiquidVolume liquid, const Aabb& bounds_m);
    // Adds a soft patch. Returns false if is_sound() rejects it or there are kMostSoftPatches already.
    bool add_soft(SoftPatch patch);
    // Adds an effect. Returns false if is_sound() rejects it, or if it is attached to a body that has not been added
    // yet.
    bool add_effect(EffectVolume effect);
    // Adds a body. Its shape comes from a separate builder, in the body's frame. Returns false if there are kMostBodies
    // already.
    bool add_body(FeatureId feature, std::shared_ptr<const HapticScene> shape, const Placement& start,
                  bool present = true);
    // Makes the added triangles feel like the curved surface that they approximate (mesh_shading.h). Off by default.
    void shade_meshes() { shades_ = true; }
    // Sets the table that HapticMaterial::relief refers to, with origins in world metres. For `mesh_axis` see
    // HapticScene::relief_axis.
    void set_reliefs(std::vector<Relief> reliefs, std::vector<std::uint8_t> mesh_axis = {});

    // Returns the index and start pose of the first added body with the feature `feature`, or nothing if there is none.
    std::optional<std::pair<std::uint32_t, Placement>> body_of(FeatureId feature) const;

    // Builds the scene. If a hand touches another scene that this one replaces, `world` is HapticScene::world of that
    // scene; 0: a new world.
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

}  // namespace handrail::render
