// Turns a file into a Scene. Readers accept any bytes and never crash, hang or silently lose content: each loss is a
// Diagnostic. App or worker thread.
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
    double map_metres_per_unit = 1.0 / 32.0;  // for .map files (Quake: 1/32)
    double obj_metres_per_unit = 1.0;         // for .obj, .ply and .stl files
    // The person stated the unit, so read_world does not ask whether a very wide or narrow world is intended.
    bool unit_is_known = false;
    bool guess_materials = true;  // from texture names; true for exploring, false for replay
    bool solid_meshes = true;     // closed things of an .obj are solid; true for exploring, false for replay
    std::string building;  // which building of a file with several, by name or number; empty: the one with most rooms
    // Reads another file of the world, such as a height picture, by its name relative to the world's own. Empty: no
    // other files can be read.
    std::function<Result<std::string>(const std::string& name)> read_beside;
    std::function<void(double fraction)> progress;  // 0 to 1, called on the reading thread; may be empty
    // Receives the current stage as a text's key ("import.shapes"); may be empty.
    std::function<void(std::string_view stage)> stage;
    // Checked many times a second, whatever the file contains; reading then fails, and its sentence is not used.
    std::stop_token stop;
};

// One file format: which files it accepts and how it reads them. A row of the reader table; new formats are added here.
struct MapReader {
    std::string_view name;  // as in `info --json`: "map"
    // Decides by the ending and the first bytes.
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
//   friction_static  0 to 2                    the same at rest
//   damping          0 to 10 Ns/m              per hand speed
//   texture_wave     sine, square or none
//   texture_period   1 to 100 mm
//   texture_depth    0 to 5 mm
//   friction_wave    0 to 0.3
//   texture_angle    degrees
//   texture_picture  file name                 a PNG next to the map
//   texture_size     map units                 width of one copy of the picture
//   landmark, clue   0 or 1
//   hinge, handle    north, north-east, ...,   of a door
//                    left, right, top, bottom
//   message          text                      a longer description; for a trigger, announced on entering it
//   cs_name          liquid, dynamic_box,      any other value is a name
//                    dynamic_sphere,
//                    dynamic_cylinder
//   viscosity        0 to 100 Ns/m             of a liquid, per hand speed
//   shape            box, sphere, cylinder,    one exact shape in the box around the entity's brushes
//                    cone, capsule
//   axis             x, y, z, -x, -y, -z       direction of that shape
//   sound            text                      makes the entity a sound source, at its origin or at the middle of its
//                                              brushes; ambient_* classes and particles (particle*, torches, flames,
//                                              env_fire, env_spark*, env_steam, env_smoke*) are sources without it
//   volume           0 to 1                    loudness of that sound
//   free             0 or 1                    1: a separate thing is free to move; dynamic_* are free without this key
//                                              unless it is 0; the next six rows apply to free bodies
//   mass             0.01 to 10,000 kg         if missing, it follows from the density
//   density          20 to 20,000 kg/m3 (600)
//   elasticity       0 to 0.95 (0.2)
//   rolling          0 to 1 (0.1)
//   friction         as above (0.4)
//   friction_static  as above                  (1.25 times the friction)
//   building         0 or 1                    on worldspawn only; 1: a building with a person's body, 0: a game map
//
// Without the key `building`, a map with things of a game is a game map, unless it has a `thing` or a cs_name. Things
// of a game are wad or worldtype on worldspawn, lights, items, monsters, weapons, ambients and deathmatch starts.
// A start's origin is 24 units above the soles. The base is info_player_start, else the first start.
Result<Scene> read_quake_map(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
// Reads Wavefront .obj: z up, in metres unless the options say otherwise. `o` and `g` name features, `usemtl`
// materials. Closed things are solid, as below; everything else becomes Scene::triangles.
Result<Scene> read_obj(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// Reads glTF 2.0 as .glb or .gltf (with its .bin next to it): in metres, y up, turned to z up; nodes are things with
// their names.
// PLY and STL have one thing, or one for each solid of a text STL: z up, in metres unless the options say otherwise. A
// closed mesh of any form is solid, unless it contains others, or is convex and alone. The rest are sheets.
Result<Scene> read_gltf(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
Result<Scene> read_ply(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
Result<Scene> read_stl(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// IFC in any unit that the file states: a building with the file's rooms and doors (worlds/ifc).
Result<Scene> read_ifc(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
// The same in a ZIP archive with one model (.ifczip, or an archive whose first file is an .ifc).
Result<Scene> read_ifczip(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
bool is_ifczip(const std::filesystem::path& path, std::string_view bytes);

// OpenStreetMap, as .osm, .osm.bz2 or .osm.pbf: a building drawn with Simple Indoor Tagging, or the streets and paths
// of an area (worlds/osm).
Result<Scene> read_osm(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// IMDF, a .zip of GeoJSON: levels, units as rooms, openings as doors (worlds/imdf).
Result<Scene> read_imdf(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// .rooms, a text that describes rooms in English or German (worlds/words).
Result<Scene> read_words(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// Reads any file that one of the readers accepts. Fails with one sentence that can be spoken if the file is missing,
// unreadable, of a format that we do not read, or without usable content. A known format is named, with what to do
// instead. If neither file nor options state the unit, and the world would be over 2 km or under 2 m wide, or a mesh
// over 100 m high, the first warning says so. It also says how wide the world would be in millimetres, inches and feet.
Result<Scene> read_world(const std::filesystem::path& path, const ReadOptions& options = {});

// The same for bytes that were read already; only the name of `path` is used. If options.read_beside is empty, the
// files next to it are still read.
Result<Scene> read_world_bytes(const std::filesystem::path& path, std::string_view bytes, const ReadOptions& options);

inline constexpr std::size_t kLargestWorld_bytes = std::size_t{1} << 30;
inline constexpr std::size_t kLargestNeighbour_bytes = std::size_t{1} << 27;

// Opens a file that belongs to a world, by its name relative to the world's own. Only files in the world's folder or
// below it are allowed. Links are refused, because they could lead anywhere.
Result<OpenFile> open_file_beside(const std::filesystem::path& world, const std::string& name);
Result<std::string> read_file_beside(const std::filesystem::path& world, const std::string& name,
                                     const std::stop_token& stop);

}  // namespace handrail::readers
