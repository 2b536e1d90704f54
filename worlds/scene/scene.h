// What a building is: solids, surfaces with names, volumes, starts. Built by a reader, then never changed: every view
// (HapticScene, drawing, sound, walking) is compiled from it and refers to it by FeatureId. World metres, z up.
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

// Anything that has a name: a joined wall, the floor of a room, a table, a door, a pool.
struct Feature {
    FeatureKind kind = FeatureKind::Wall;
    std::string name;        // without the material: "north wall", "Table"; what files and scenarios know it by
    OtherLanguages name_in;  // what it is called in others than the map's own
    // The map gave none: one of our own English names, said by spoken_name in the person's language.
    bool made_name = false;
    MaterialId material = kDefaultMaterial;
    Vec3 normal{0.0};  // outward, for walls, floors, ceilings and slopes; zero for objects
    Aabb bounds_m;
    double area_m2 = 0.0;   // exposed area
    bool landmark = false;  // fixed and unique here
    bool clue = false;      // helpful, may change
    bool base = false;      // the door at the base, where one is
    std::string message;    // spoken on entering a trigger; for others a longer description
    OtherLanguages message_in;
    bool made_message = false;  // the map gave none: `message` is the key of one of our own texts
    std::string hinge;          // side of a door's hinge: "north", "east", ... or empty
    std::string handle;         // side of a door's handle, likewise
    SourcePlace source;
};

// What a convex solid does.
enum class SolidRole : std::uint8_t {
    Solid,     // stops hand and body
    Mover,     // the same, and may move later: doors, lifts, buttons; stands as filed
    BodyClip,  // stops the body, never the hand
    Liquid,    // a volume to move through, felt by its viscosity
    Trigger,   // a volume whose feature's message is spoken once on entering
    Teleport,  // a doorway surface to elsewhere: not solid
    Illusion,  // seen, not touched
};

// A face that gives way under the hand, above the rest of its solid.
struct SoftFace {
    std::uint32_t face = 0;  // of the solid
    bool plastic = false;    // keeps a dent
    double depth_m = 0.0;
    double stiffness_fraction = 0.2;
    double recovery_s = 0.5;  // of one that comes back
    double yield_n = 1.0;     // of one that keeps a dent
};

struct Solid {
    ConvexSolid shape;
    SolidRole role = SolidRole::Solid;
    RoundShape round;  // what the hand feels, where it is no solid of flat faces; `shape` then stands around it
    FeatureId feature = kNoFeature;            // for objects, movers and volumes: the whole; else kNoFeature
    std::vector<FeatureId> face_features;      // size == shape.planes.size(); the name of what one touches there
    std::vector<MaterialId> face_materials;    // size == shape.planes.size()
    std::vector<bool> face_hidden;             // size == shape.planes.size(); wholly covered by other solids
    std::optional<double> viscosity_ns_per_m;  // liquids only, of hand speed; none: no drag
    double buoyancy_n = 0.0,
           film_n = 0.0;          // liquids only: what lifts a hand in it, what its surface holds back at most
    Vec3 flow_hand_m_per_s{0.0};  // liquids only: a stream, in hand speed
    std::optional<SoftFace> soft;
    SourcePlace source;
};

// A triangle of a mesh file or patch: a sheet without an inside. Degenerate ones are kept.
struct MeshTriangle {
    Vec3 a_m, b_m, c_m;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    TouchSide side = TouchSide::Both;
};

// Exposed surface for drawing, naming and area; hidden parts are gone.
struct SurfacePolygon {
    Polygon polygon;
    Vec3 normal{0.0};
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    SolidRole role = SolidRole::Solid;
};

struct Start {
    Vec3 feet_m{0.0};  // where the soles stand
    double heading_rad = 0.0;
    bool base = false;  // the start a single explorer takes first
    std::string name;
    SourcePlace source;
};

struct SoundSource {
    Vec3 position_m{0.0};
    std::string name;       // fit to be spoken: "computer hum"
    std::string sound;      // which sound: the class name or the key `sound`
    double loudness = 1.0;  // 0 to 1
    OtherLanguages name_in = {};
    bool made_name = false;  // the map gave none: `name` is the key of one of our own texts
};

// The map's own name for the room around a place.
struct RoomName {
    Vec3 at_m{0.0};
    std::string name;  // fit to be spoken
    OtherLanguages name_in = {};
};

struct Scene;

// A thing with a world of its own, set down in this one: it may be moved, turned, added and removed while it is
// touched. One model may stand in several places.
struct PlacedModel {
    FeatureId feature = kNoFeature;  // of this scene: all of the thing goes by this name
    std::shared_ptr<const Scene> model;
    MaterialId material = kDefaultMaterial;  // of this scene; the model's own materials are not looked at
    Placement at;
};

struct StatedBuilding;

// What the reader understood, for the honesty report and `handrail info`. Counts as defined for `info --json`.
struct ReadReport {
    std::string format;  // "map", "obj", "ifc"
    int brushes = 0, polygons = 0, polygons_kept = 0, polygons_hidden = 0, triangles = 0;
    int liquids = 0, movers = 0, doors = 0, starts = 0;
    int patches = 0;  // curved patches that were read; their triangles are not counted above
    std::vector<std::string> guessed, simplified, left_out;  // sentences
    std::vector<Diagnostic> warnings;                        // at most 20
    int warnings_in_all = 0;                                 // all that were met
};

struct Scene {
    std::string name;  // fit to be spoken: the world's message, else the file name in words
    OtherLanguages name_in;
    std::string source_file;  // as given
    bool game_map = false;    // game sizes for the body: 1.7 m tall, 0.57 m steps
    double metres_per_unit = 1.0;
    Aabb bounds_m;                    // of solids as they stand in the file
    std::vector<Material> materials;  // [0] is the default wall
    std::vector<Feature> features;    // indexed by FeatureId::value
    std::vector<Solid> solids;
    std::vector<MeshTriangle> triangles;
    std::vector<PlacedModel> placed;
    std::vector<SurfacePolygon> surfaces;
    std::vector<Start> starts;  // in file order; the base one is marked
    std::vector<SoundSource> sounds;
    std::vector<RoomName> room_names;
    std::vector<Effect> effects;   // forces that hang in space
    std::vector<Mover> movers;     // which of the solids above can go where
    LabyrinthPlan labyrinth;       // the game in this world, where there is one
    std::vector<FreeBody> bodies;  // which of them are free to move, at most FreeBody::kMost
    std::vector<Switch> switches;
    std::shared_ptr<const StatedBuilding>
        stated;  // rooms and doors as the file itself says them (worlds/scene/stated_building.h); null: it says none
    ReadReport report;

    const Feature* find(FeatureId id) const { return id.value < features.size() ? &features[id.value] : nullptr; }
    const Material& material(MaterialId id) const { return materials[id < materials.size() ? id : kDefaultMaterial]; }
};

// "north wall, plaster" or "Table": the feature's name with its material where it has one, as it is said in the
// language spoken. A name that the map gives is said as the map has it, in the language spoken where it has that too.
// Empty for kNoFeature.
std::string spoken_name(const Scene& scene, FeatureId id);
// The same without the material.
std::string spoken_name(const Feature& feature);
std::string spoken_name(const SoundSource& sound);
std::string spoken_name(const Scene& scene);
std::string spoken_message(const Feature& feature);
// One of our own names ("north wall", "low block"), or a material's, as it is said; a name that is none of ours stays
// as it is.
std::string spoken_kind(std::string_view name);
std::string spoken_material(std::string_view name);
// "north wall, plaster" in English and unchanged, whatever is spoken: for tables and to be compared.
std::string stored_name(const Scene& scene, FeatureId id);

// The number of this material in the scene, which gets it if it is new. Readers only. The default wall once there are
// too many to count.
MaterialId material_id(Scene& scene, const Material& material);

// Checks sizes, indices and finiteness of a Scene that a reader or code built; says the first thing that is wrong.
Result<void> validate(const Scene& scene);

}  // namespace handrail
