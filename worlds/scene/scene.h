// Defines the content of a building: solids, named surfaces, volumes and starts, in world metres with z up. A reader
// builds a Scene; afterwards it never changes. Every representation (for touch, drawing, sound and walking) is compiled
// from the Scene and refers to its parts by FeatureId.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/language.h"
#include "worlds/base/result.h"
#include "worlds/geometry/convex.h"
#include "worlds/geometry/placement.h"
#include "worlds/geometry/round_shapes.h"
#include "worlds/geometry/triangle_mesh.h"
#include "worlds/scene/effect.h"
#include "worlds/scene/free_body.h"
#include "worlds/scene/labyrinth.h"
#include "worlds/scene/material.h"
#include "worlds/scene/mover.h"
#include "worlds/scene/source_place.h"

namespace handrail {

enum class FeatureKind { Wall, Floor, Ceiling, Slope, Object, Door, Button, Lift, Mover, Liquid, Trigger, Teleport };

// A part of the world that has a name: a joined wall, the floor of a room, a table, a door, a pool.
struct Feature {
    FeatureKind kind = FeatureKind::Wall;
    // The name without the material: "north wall", "Table". Files and scenarios identify the feature by this name.
    std::string name;
    OtherLanguages name_in;  // the feature's name in languages other than the map's own
    // The map gave no name, so `name` is one of our own English names, which spoken_name translates.
    bool made_name = false;
    MaterialId material = kDefaultMaterial;
    Vec3 normal{0.0};  // outward normal of walls, floors, ceilings and slopes; zero for objects
    Aabb bounds_m;
    double area_m2 = 0.0;   // area of the exposed surface
    bool landmark = false;  // the feature is fixed, and unique in this world
    bool clue = false;      // the feature helps with orientation, but may change
    bool base = false;      // true for the door at the base, if there is one
    std::string message;  // for a trigger: the text announced on entering it; for other features: a longer description
    OtherLanguages message_in;
    bool made_message = false;  // the map gave no message, so `message` is the key of one of our own texts
    std::string hinge;          // the side on which a door's hinge is: "north", "east", ... or empty
    std::string handle;         // the side on which a door's handle is: "north", "east", ... or empty
    SourcePlace source;
};

// The effect of a convex solid on the hand and the walker.
enum class SolidRole : std::uint8_t {
    Solid,     // stops the hand and the walker
    Mover,     // stops both, but may move: a door, lift or button; its position is that in the file
    BodyClip,  // stops the walker, but never the hand
    Liquid,    // a volume that both can move through; the hand feels its viscosity
    Trigger,   // a volume whose feature's message is announced once when the person enters it
    Teleport,  // a surface that leads elsewhere, like a doorway; not solid
    Illusion,  // can be seen, but not touched
};

// A soft layer over one face of a solid; the rest of the solid stays hard.
struct SoftFace {
    std::uint32_t face = 0;  // index of the soft face in the solid
    bool plastic = false;    // true: the face keeps a dent; false: it recovers
    double depth_m = 0.0;
    double stiffness_fraction = 0.2;
    double recovery_s = 0.5;  // time to recover, for a face that recovers
    double yield_n = 1.0;     // force from which on a dent remains, for a face that keeps a dent
};

inline constexpr std::uint32_t kNoGroup = 0xffffffffU;

// Solids that belong together in the editor. A group may be inside another one.
struct Group {
    std::string name;                 // the name as the map gives it
    std::uint32_t inside = kNoGroup;  // index of the group that contains this one; it comes earlier in Scene::groups
    bool hidden = false;              // true: the hand does not feel the solids of this group
    bool operator==(const Group&) const = default;
};

struct Solid {
    ConvexSolid shape;
    SolidRole role = SolidRole::Solid;
    RoundShape round;                // the exact shape that the hand feels, if it is round; `shape` then encloses it
    FeatureId feature = kNoFeature;  // the feature of the whole solid, for objects, movers and volumes; else kNoFeature
    // The feature that is announced when each face is touched; size == shape.planes.size().
    std::vector<FeatureId> face_features;
    std::vector<MaterialId> face_materials;  // the material of each face; size == shape.planes.size()
    std::vector<bool> face_hidden;  // size == shape.planes.size(); true for a face that other solids cover wholly
    std::optional<double> viscosity_ns_per_m;  // for liquids only: drag per speed of the hand; empty: no drag
    // For liquids only: the buoyancy of the hand, and the greatest force with which the surface film resists the hand.
    double buoyancy_n = 0.0, film_n = 0.0;
    Vec3 flow_hand_m_per_s{0.0};  // for liquids only: the current, as a speed of the hand
    std::optional<SoftFace> soft;
    // Radius of the outer edges in metres of hand travel, as the map states it; empty: the person's own setting.
    std::optional<double> edge_rounding_hand_m;
    std::uint32_t group = kNoGroup;  // index of the solid's group in Scene::groups
    SourcePlace source;
};

// A triangle of a mesh file or a patch. It is a sheet without an inside. Degenerate triangles are kept.
struct MeshTriangle {
    Vec3 a_m, b_m, c_m;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    TouchSide side = TouchSide::Both;
};

// An exposed polygon for drawing, naming and measuring area. Hidden parts have been removed.
struct SurfacePolygon {
    Polygon polygon;
    Vec3 normal{0.0};
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    SolidRole role = SolidRole::Solid;
};

struct Start {
    Vec3 feet_m{0.0};  // position of the soles
    double heading_rad = 0.0;
    bool base = false;  // true for the start that a single explorer uses
    std::string name;
    SourcePlace source;
};

struct SoundSource {
    Vec3 position_m{0.0};
    std::string name;       // for speech: "computer hum"
    std::string sound;      // selects the sound: a class name or the value of the key `sound`
    double loudness = 1.0;  // loudness of the source, 0 to 1
    OtherLanguages name_in = {};
    bool made_name = false;  // the map gave no name, so `name` is the key of one of our own texts
};

// The name that the map gives to the room that contains the place at_m.
struct RoomName {
    Vec3 at_m{0.0};
    std::string name;  // name of the room for speech
    OtherLanguages name_in = {};
};

struct Scene;

// An object with its own scene, placed in this world. It may be moved, turned, added and removed while it is touched.
// One model may be placed several times.
struct PlacedModel {
    FeatureId feature = kNoFeature;  // in this scene; the whole object has the name of this feature
    std::shared_ptr<const Scene> model;
    MaterialId material = kDefaultMaterial;  // in this scene; the materials of the model itself are ignored
    Placement at;
};

struct StatedBuilding;

// The numbers and sentences that the reader found, for the honest report and for `handrail info`. The counts are
// defined as for `info --json`.
struct ReadReport {
    std::string format;  // the format: "map", "obj", "ifc"
    int brushes = 0, polygons = 0, polygons_kept = 0, polygons_hidden = 0, triangles = 0;
    int liquids = 0, movers = 0, doors = 0, starts = 0;
    int patches = 0;  // number of curved patches that were read; the counts above do not include their triangles
    // Sentences for the person about what was guessed, simplified and left out.
    std::vector<std::string> guessed, simplified, left_out;
    std::vector<Diagnostic> warnings;  // the first warnings, at most 20
    int warnings_in_all = 0;           // number of all warnings, including those beyond the first 20
};

struct Scene {
    std::string name;  // for speech: the world's message, else the file name as words
    OtherLanguages name_in;
    std::string source_file;  // path of the file, as the caller gave it
    bool game_map = false;    // true: the walker has the size of a game character: 1.7 m tall, with steps of 0.57 m
    double metres_per_unit = 1.0;
    Aabb bounds_m;                    // bounds of the solids where the file has them
    std::vector<Material> materials;  // materials[0] is the default wall
    std::vector<Feature> features;    // features, indexed by FeatureId::value
    std::vector<Solid> solids;
    std::vector<MeshTriangle> triangles;
    std::vector<PlacedModel> placed;
    std::vector<SurfacePolygon> surfaces;
    std::vector<Start> starts;  // in file order; the base start is marked
    std::vector<SoundSource> sounds;
    std::vector<RoomName> room_names;
    std::vector<Effect> effects;   // forces in space, without visible geometry
    std::vector<Mover> movers;     // which of the solids can move, and where to
    LabyrinthPlan labyrinth;       // the labyrinth game of this world, if there is one
    std::vector<FreeBody> bodies;  // which of the solids are free to move; at most FreeBody::kMost bodies
    std::vector<Switch> switches;
    std::vector<Group> groups;
    // Rooms and doors as the file itself states them (worlds/scene/stated_building.h). Null if the file states no rooms
    // and doors.
    std::shared_ptr<const StatedBuilding> stated;
    ReadReport report;

    const Feature* find(FeatureId id) const { return id.value < features.size() ? &features[id.value] : nullptr; }
    const Material& material(MaterialId id) const { return materials[id < materials.size() ? id : kDefaultMaterial]; }
};

// Returns the feature's name, and its material if it has one, in the spoken language: "north wall, plaster" or "Table".
// If the name comes from the map, returns the map's translation, or else the name as the map states it. Empty for
// kNoFeature.
std::string spoken_name(const Scene& scene, FeatureId id);
// These functions return the name in the spoken language, without a material.
std::string spoken_name(const Feature& feature);
std::string spoken_name(const SoundSource& sound);
std::string spoken_name(const Scene& scene);
std::string spoken_message(const Feature& feature);
// Translates one of our own names ("north wall", "low block") or the name of a material. Any other name is returned
// unchanged.
std::string spoken_kind(std::string_view name);
std::string spoken_material(std::string_view name);
// Returns the name and material, such as "north wall, plaster", always in English, for tables and comparisons.
std::string stored_name(const Scene& scene, FeatureId id);

// Returns the index of this material in the scene; adds the material if it is new. Returns the default wall if there
// are too many materials for an index. For readers only.
MaterialId material_id(Scene& scene, const Material& material);

// Checks sizes, indices and finiteness of a Scene that a reader or code has built. Fails with the first fault.
Result<void> validate(const Scene& scene);

}  // namespace handrail
