#include "worlds/readers/reader.h"
#include "worlds/imdf/read_imdf.h"
#include "worlds/osm/osm_data.h"
#include "worlds/readers/foreign_formats.h"
#include "worlds/readers/units.h"

#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::readers {
namespace {

namespace fs = std::filesystem;

bool ends_in(const fs::path& path, std::string_view ending) { return lower_ascii(path.extension().string()) == ending; }

constexpr std::array kReaders{
    MapReader{"map", [](const fs::path& path, std::string_view) { return ends_in(path, ".map"); }, read_quake_map},
    MapReader{"obj", [](const fs::path& path, std::string_view) { return ends_in(path, ".obj"); }, read_obj},
    MapReader{"gltf",
              [](const fs::path& path, std::string_view bytes) {
                  return ends_in(path, ".glb") || ends_in(path, ".gltf") || bytes.starts_with("glTF");
              },
              read_gltf},
    MapReader{"ply",
              [](const fs::path& path, std::string_view bytes) {
                  return ends_in(path, ".ply") || bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
              },
              read_ply},
    MapReader{"stl", [](const fs::path& path, std::string_view) { return ends_in(path, ".stl"); }, read_stl},
    MapReader{"ifc",
              [](const fs::path& path, std::string_view bytes) {
                  return ends_in(path, ".ifc") || bytes.starts_with("ISO-10303-21");
              },
              read_ifc},
    MapReader{"ifczip", is_ifczip, read_ifczip},
    MapReader{"osm",
              [](const fs::path& path, std::string_view bytes) {
                  return osm::osm_form(bytes, path.filename().string()) != osm::OsmForm::None || ends_in(path, ".osm");
              },
              read_osm},
    MapReader{"rooms", [](const fs::path& path, std::string_view) { return ends_in(path, ".rooms"); }, read_words},
    MapReader{"imdf", [](const fs::path&, std::string_view bytes) { return imdf::is_imdf(bytes); }, read_imdf},
};

}  // namespace

Result<Scene> read_world_bytes(const fs::path& path, std::string_view bytes, const ReadOptions& options) {
    const std::string name = path.filename().string();
    if (bytes.empty()) return fail(phrase("reader.empty"), name);
    const bool ours =
        osm::osm_form(bytes, name) != osm::OsmForm::None || imdf::is_imdf(bytes) || is_ifczip(path, bytes);
    if (!ours)
        if (const std::string foreign = foreign_by_content(bytes); !foreign.empty()) return fail(foreign, name);
    ReadOptions with_folder = options;
    if (!with_folder.read_next_to)
        with_folder.read_next_to = [&](const std::string& other) {
            return read_file_next_to(path, other, options.stop);
        };
    for (const MapReader& reader : kReaders)
        if (reader.accepts(path, bytes)) {
            Result<Scene> scene = reader.read(bytes, name, with_folder);
            if (scene) question_axes(*scene);
            if (scene && !options.unit_is_known) question_unit(*scene);
            return scene;
        }
    const std::string foreign = foreign_by_ending(path);
    return fail(foreign.empty() ? phrase("reader.other_ending") : foreign, name);
}

Result<OpenFile> open_file_next_to(const fs::path& world, const std::string& other) {
    const fs::path name = fs::path(other).lexically_normal();
    if (name.empty() || name.is_absolute() || *name.begin() == ".." || other.find('\0') != std::string::npos)
        return fail(phrase("reader.elsewhere"), other);
    return open_file_within(world.has_parent_path() ? world.parent_path() : fs::path("."), name);
}

Result<std::string> read_file_next_to(const fs::path& world, const std::string& other, const std::stop_token& stop) {
    const Result<OpenFile> file = open_file_next_to(world, other);
    return file ? read_whole_file(*file, kLargestNeighbour_bytes, stop) : tl::unexpected(file.error());
}

Result<Scene> read_world(const fs::path& path, const ReadOptions& options) {
    const Result<std::string> bytes = read_whole_file(path, kLargestWorld_bytes, options.stop);
    return bytes ? read_world_bytes(path, *bytes, options) : tl::unexpected(bytes.error());
}

}  // namespace handrail::readers
