// Turns a file into a Scene. Readers accept any bytes. They never crash, hang or lose content silently: each loss is
// reported as a Diagnostic. Used on the app thread or on a worker thread.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/base/files.h"
#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

struct ReadOptions {
    double map_metres_per_unit = 1.0 / 32.0;  // unit of .map files (Quake: 1/32)
    double obj_metres_per_unit = 1.0;         // unit of .obj, .ply and .stl files
    // The person stated the unit, so read_world does not warn about a very wide or narrow world.
    bool unit_is_known = false;
    bool guess_materials = true;  // guess materials from texture names; true for exploring, false for replay
    bool solid_meshes = true;     // make closed objects of an .obj solid; true for exploring, false for replay
    // Name or number of the building to read, if the file has several; empty: the one with the most rooms.
    std::string building;
    // Reads another file of the world, such as a height picture. `name` is relative to the world's own file. If empty,
    // no other files can be read.
    std::function<Result<std::string>(const std::string& name)> read_next_to;
    // Called on the reading thread with the progress from 0 to 1; may be empty.
    std::function<void(double fraction)> progress;
    // Called with the current stage, as the key of a text ("import.shapes"); may be empty.
    std::function<void(std::string_view stage)> stage;
    // Readers check `stop` many times a second, whatever the file contains. After a stop request, reading fails; ignore
    // the sentence of that failure.
    std::stop_token stop;
};

// One file format: which files it accepts and how they are read. A MapReader is a row of the table of readers, to which
// new formats are added.
struct MapReader {
    std::string_view name;  // name of the format, as in `info --json`: "map"
    // Returns true if the reader accepts a file with this ending of its name and these first bytes.
    bool (*accepts)(const std::filesystem::path& path, std::string_view bytes);
    Result<Scene> (*read)(std::string_view bytes, const std::string& file_name, const ReadOptions& options);
};

// Reads .map files of the Quake family, Standard and Valve 220. These keys are Handrail's own. They apply to any entity
// with brushes unless the table says otherwise; defaults are in brackets.
//
//   key              value                     meaning
//   name             text                      spoken name; on worldspawn that of the world; the brushes of a named
//                                              entity are one thing
//   material         a name                    from material_library()
//   stiffness        0 to 1                    share of what the device can render
//   friction         0 to 2                    Coulomb's mu while sliding
//   friction_static  0 to 2                    Coulomb's mu at rest
//   damping          0 to 10 Ns/m              force per speed of the hand
//   texture_wave     sine, square or none      soft ridges, bars, or no waves
//   texture_period   1 to 100 mm               distance from ridge to ridge
//   texture_depth    0 to 5 mm                 depth of the texture below the plain surface
//   friction_wave    0 to 0.3                  share by which the friction rises and falls
//   texture_angle    degrees                   counter-clockwise turn of the texture
//   texture_picture  file name                 a PNG next to the map
//   texture_size     map units                 width of one copy of the picture
//   landmark, clue   0 or 1
//   hinge, handle    north, north-east, ...,   side of a door on which its hinge or handle is
//                    left, right, top, bottom
//   message          text                      a longer description; for a trigger, announced on entering it
//   cs_name          liquid, dynamic_box,      any other value is a name
//                    dynamic_sphere,
//                    dynamic_cylinder
//   viscosity        0 to 100 Ns/m             drag of a liquid per speed of the hand
//   shape            box, sphere, cylinder,    one exact shape in the box around the entity's brushes
//                    cone, capsule
//   axis             x, y, z, -x, -y, -z       direction of that shape
//   sound            text                      makes the entity a sound source, at its origin or at the middle of its
//                                              brushes; ambient_* classes and particles (particle*, torches, flames,
//                                              env_fire, env_spark*, env_steam, env_smoke*) are sources without this
//                                              key
//   volume           0 to 1                    loudness of that sound
//   free             0 or 1                    1: a separate object is free to move; dynamic_* are free unless this
//                                              key is 0; the next six rows apply to free bodies
//   mass             0.01 to 10,000 kg         if missing, it follows from the density
//   density          20 to 20,000 kg/m3 (600)
//   elasticity       0 to 0.95 (0.2)
//   rolling          0 to 1 (0.1)
//   friction         as above (0.4)
//   friction_static  as above                  (1.25 times the friction)
//   building         0 or 1                    on worldspawn only; 1: a building, with a walker of human size; 0: a
//                                              game map
//
// Without the key `building`, a map with things of a game is a game map, unless it has a `thing` or a cs_name. Things
// of a game are the keys wad or worldtype on worldspawn, lights, items, monsters, weapons, ambients and deathmatch
// starts. A start's origin is 24 units above the soles. The base is info_player_start, else the first start.
Result<Scene> read_quake_map(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
// Reads Wavefront .obj: z up, in metres unless the options state another unit. `o` and `g` name features, `usemtl`
// names materials. Closed meshes are solid, as described below for glTF; everything else becomes Scene::triangles.
Result<Scene> read_obj(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// These functions read meshes. read_gltf reads glTF 2.0 as .glb or .gltf (with its .bin next to it). glTF is in metres
// with y up and is turned to z up; its nodes become things with their names. PLY and STL files give one thing, or one
// for each solid of a text STL; they have z up and are in metres unless the options state another unit. In all these
// formats a closed mesh is solid, unless it contains other meshes, or is convex and the only one. All other meshes
// become sheets.
Result<Scene> read_gltf(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
Result<Scene> read_ply(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
Result<Scene> read_stl(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// Reads IFC in the unit that the file states: a building with the rooms and doors of the file (worlds/ifc).
Result<Scene> read_ifc(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
// Reads IFC in a ZIP archive with one model (.ifczip, or an archive whose first file is an .ifc).
Result<Scene> read_ifczip(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
bool is_ifczip(const std::filesystem::path& path, std::string_view bytes);

// Reads OpenStreetMap as .osm, .osm.bz2 or .osm.pbf: a building drawn with Simple Indoor Tagging, or the streets and
// paths of an area (worlds/osm).
Result<Scene> read_osm(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// Reads IMDF, a .zip of GeoJSON files: levels, units as rooms, openings as doors (worlds/imdf).
Result<Scene> read_imdf(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// Reads .rooms, a text that describes rooms in English or German (worlds/words).
Result<Scene> read_words(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// Reads any file that one of the readers accepts. Fails with one sentence that can be spoken if the file is missing,
// unreadable, in a format that no reader reads, or without usable content. For a known format, the sentence names it
// and says what to do instead. Some files state no unit, and the options may state none either. If such a world would
// be over 2 km or under 2 m wide, or a mesh over 100 m high, the first warning says so. It also says how wide the world
// would be in millimetres, inches and feet.
Result<Scene> read_world(const std::filesystem::path& path, const ReadOptions& options = {});

// Like read_world, for bytes that were read already; only the name of `path` is used. If options.read_next_to is empty,
// other files of the world are read from the folder of `path`.
Result<Scene> read_world_bytes(const std::filesystem::path& path, std::string_view bytes, const ReadOptions& options);

inline constexpr std::size_t kLargestWorld_bytes = std::size_t{1} << 30;
inline constexpr std::size_t kLargestNeighbour_bytes = std::size_t{1} << 27;

// Opens a file that belongs to a world. `name` is relative to the world's own file. Only files in the world's folder or
// below it are allowed. Links are refused, because they could lead anywhere.
Result<OpenFile> open_file_next_to(const std::filesystem::path& world, const std::string& name);
Result<std::string> read_file_next_to(const std::filesystem::path& world, const std::string& name,
                                      const std::stop_token& stop);

}  // namespace handrail::readers
