// A file becomes a Scene. Readers take bytes and never crash, hang or half-load silently: each loss is a Diagnostic.
// App or worker thread.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/base/files.h"
#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct ReadOptions {
    double map_metres_per_unit = 1.0 / 32.0;  // for .map files (Quake: 1/32)
    double obj_metres_per_unit = 1.0;         // for .obj, .ply and .stl files
    // A person said it: read_world asks no more whether a very wide or narrow world is meant so.
    bool unit_is_known = false;
    bool guess_materials = true;  // from texture names; exploring yes, replay no
    bool solid_meshes = true;     // closed things of an .obj are solid; exploring yes, replay no
    std::string building;         // of a file with several, by its name or number; empty: the one with most rooms
    // Another file of the world, by its name relative to the world's own, such as a height picture; empty: there is
    // none to be had.
    std::function<Result<std::string>(const std::string& name)> read_beside;
    std::function<void(double fraction)> progress;      // 0 to 1, called from the reading thread; may be empty
    std::function<void(std::string_view stage)> stage;  // what it is at, a text's key ("import.shapes"); may be empty
    std::stop_token stop;  // looked at many times a second, whatever the file holds; the reading fails then, and nobody
                           // needs its sentence
};

// One map format: which files it takes and how it reads them. A table row, the MapReader seam.
struct MapReader {
    std::string_view name;                                                       // as in `info --json`: "map"
    bool (*accepts)(const std::filesystem::path& path, std::string_view bytes);  // by ending and first bytes
    Result<Scene> (*read)(std::string_view bytes, const std::string& file_name, const ReadOptions& options);
};

// Quake-family .map, Standard and Valve 220. Keys of our own, on any entity that has brushes unless said otherwise:
//   name       spoken name; on worldspawn the world's. All brushes of an entity with a name are one thing.
//   material   a name of material_library(); stiffness 0 to 1 of what the device can render; friction 0 to 2 (Coulomb's
//   mu) friction_static 0 to 2; damping 0 to 10 Ns/m of hand speed texture_wave sine, square or none; texture_period 1
//   to 100 mm, texture_depth 0 to 5 mm, friction_wave 0 to 0.3, texture_angle in degrees; texture_picture, a PNG beside
//   the map, with texture_size in units landmark, clue   0 or 1;   hinge, handle   north, north-east, ... or left,
//   right, top, bottom (doors) message    a longer description; of a trigger: spoken on entering it cs_name    liquid,
//   dynamic_box, dynamic_sphere, dynamic_cylinder; else a name;   viscosity 0 to 100 Ns/m of hand speed (liquids) shape
//   box, sphere, cylinder, cone or capsule: one exact shape in the box around the entity's brushes; axis   x, y, z, -x,
//   -y or -z: its direction sound      makes the entity a sound source (with an origin, or at the middle of its
//   brushes); ambient_* classes and particles (particle*, torches,
//              flames, env_fire, env_spark*, env_steam, env_smoke*) are sources without it;   volume   0 to 1
//   free       1: a thing of its own is free to move, which dynamic_* are without it; 0: it is not. Then mass 0.01 to
//              10,000 kg, else density 20 to 20,000 kg/m3 (600), elasticity 0 to 0.95 (0.2), rolling 0 to 1 (0.1), and
//              friction and friction_static of the surface (0.4, and 1.25 times as much)
//   building   on worldspawn: 1 a building with the body of a person, 0 a game map. Without it a map with game things
//   (wad or worldtype on
//              worldspawn; lights, items, monsters, weapons, ambients, deathmatch starts) is a game map, unless it has
//              a `thing` or a cs_name.
// A start's origin lies 24 units above the soles; info_player_start is the base, else the first start.
Result<Scene> read_quake_map(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
// Wavefront .obj: z up, in metres unless the options say otherwise. `o` and `g` name features, `usemtl` materials.
// A thing that is closed is solid, as below; all else are Scene::triangles.
Result<Scene> read_obj(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// glTF 2.0 as .glb or .gltf (with its .bin beside it): in metres, y up, turned to z up; nodes are things with their
// names. PLY and STL: one thing, or one for each solid of an STL in words, z up, in metres unless the options say
// otherwise. A closed mesh is solid, whatever its form, unless others lie in it, or it is convex and alone; the rest
// are sheets.
Result<Scene> read_gltf(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
Result<Scene> read_ply(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
Result<Scene> read_stl(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// IFC, whatever unit the file states: a building with rooms and doors as the file has them (worlds/ifc).
Result<Scene> read_ifc(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
// The same in a ZIP archive (.ifczip, or one whose first file is an .ifc), which holds one model.
Result<Scene> read_ifczip(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
bool is_ifczip(const std::filesystem::path& path, std::string_view bytes);

// OpenStreetMap, .osm, .osm.bz2 or .osm.pbf: a building drawn with Simple Indoor Tagging, or the ways of a place
// (worlds/osm).
Result<Scene> read_osm(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// IMDF, a .zip of GeoJSON: levels, units as rooms, openings as doors (worlds/imdf).
Result<Scene> read_imdf(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// .rooms, a text that describes rooms in words, English or German (worlds/words).
Result<Scene> read_words(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// Reads any file that one of the readers accepts. Fails with one sentence fit to be spoken when it is missing,
// unreadable, of a kind we do not read (named where recognised, with what to do), or holds nothing usable. If neither
// file nor options say what a unit is, and the world would be over 2 km or under 2 m wide, or a mesh over 100 m high,
// its first warning says so and how wide it would be in millimetres, inches and feet.
Result<Scene> read_world(const std::filesystem::path& path, const ReadOptions& options = {});

// The same of bytes that were read already. Only the name of `path` matters; without options.read_beside the files next
// to it are read too.
Result<Scene> read_world_bytes(const std::filesystem::path& path, std::string_view bytes, const ReadOptions& options);

inline constexpr std::size_t kLargestWorld_bytes = std::size_t{1} << 30;
inline constexpr std::size_t kLargestBeside_bytes = std::size_t{1} << 27;

// A file that a world brings, by its name relative to the world's own: from its folder and those below, and no others.
// Links are refused: they could lead anywhere.
Result<OpenFile> open_file_beside(const std::filesystem::path& world, const std::string& name);
Result<std::string> read_file_beside(const std::filesystem::path& world, const std::string& name,
                                     const std::stop_token& stop);

}  // namespace handrail
