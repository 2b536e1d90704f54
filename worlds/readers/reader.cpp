#include "worlds/readers/reader.h"

#include "worlds/base/files.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

namespace fs = std::filesystem;

bool ends_in(const fs::path& path, std::string_view ending) { return lower_ascii(path.extension().string()) == ending; }

constexpr std::array kReaders{
    MapReader{"map", [](const fs::path& path, std::string_view) { return ends_in(path, ".map"); }, read_quake_map},
    MapReader{"obj", [](const fs::path& path, std::string_view) { return ends_in(path, ".obj"); }, read_obj},
};

// Files that are often given by mistake, told by their first bytes, and what to do then.
struct ForeignFile {
    std::string_view first_bytes, sentence;
};
constexpr std::array kForeign{
    ForeignFile{"version https://git-lfs", "This is only a pointer to a file that Git LFS holds. Fetch the real one with: git lfs pull."},
    ForeignFile{std::string_view("\x1D\0\0\0", 4), "This is a compiled Quake level. Handrail reads its source, the .map file it was made from."},
    ForeignFile{std::string_view("\x1E\0\0\0", 4), "This is a compiled Half-Life level. Handrail reads its source; save it as a .map file from the editor."},
    ForeignFile{"IBSP", "This is a compiled game level. Handrail reads its source, the .map file it was made from."},
    ForeignFile{"VBSP", "This is a compiled Source level. Handrail reads .map files; export one from the editor."},
    ForeignFile{"BSP2", "This is a compiled Quake level. Handrail reads its source, the .map file it was made from."},
    ForeignFile{"PACK", "This is a game archive. Unpack it and choose a .map file from it."},
    ForeignFile{"PK\x03\x04", "This is a zip archive. Unpack it and choose a world from it."},
    ForeignFile{"WAD2", "This file holds textures, not a building."},
    ForeignFile{"WAD3", "This file holds textures, not a building."},
    ForeignFile{"\x1F\x8B", "This file is compressed. Unpack it first."},
    ForeignFile{"%PDF", "This is a document, not a building."},
    ForeignFile{"\x89PNG", "This is a picture, not a building."},
    ForeignFile{"ISO-10303-21", "This is an IFC building model. Handrail does not read these yet; choose a .map or .obj file."},
    ForeignFile{"<?xml", "This is an XML file, perhaps from OpenStreetMap. Handrail does not read these yet; choose a .map or .obj file."},
    ForeignFile{"glTF", "This is a glTF model. Handrail does not read these yet; save it as .obj."},
    ForeignFile{"ply\n", "This is a PLY mesh. Handrail does not read these yet; save it as .obj."},
};

// Worldcraft's own format begins with a number and then three letters.
bool is_rmf(std::string_view bytes) { return bytes.size() > 7 && bytes.substr(4, 3) == "RMF"; }

constexpr std::size_t kLargestBeside_bytes = std::size_t{1} << 27;

// A world may bring files of its own folder and those below, and no others.
Result<std::string> read_beside(const fs::path& world, const std::string& other) {
    const fs::path name = fs::path(other).lexically_normal();
    if (name.empty() || name.is_absolute() || *name.begin() == "..") return fail("A file of a world must lie beside it or in a folder below.", other);
    return read_whole_file(world.parent_path() / name, kLargestBeside_bytes);
}

}  // namespace

Result<Scene> read_world(const fs::path& path, const ReadOptions& options) {
    const Result<std::string> bytes = read_whole_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string name = path.filename().string();
    if (bytes->empty()) return fail("This file is empty.", name);
    for (const ForeignFile& foreign : kForeign)
        if (bytes->starts_with(foreign.first_bytes)) return fail(std::string(foreign.sentence), name);
    if (is_rmf(*bytes)) return fail("This is a Worldcraft working file. Open it in the editor and export it as a .map file.", name);
    ReadOptions with_folder = options;
    if (!with_folder.read_beside) with_folder.read_beside = [&path](const std::string& other) { return read_beside(path, other); };
    for (const MapReader& reader : kReaders)
        if (reader.accepts(path, *bytes)) return reader.read(*bytes, name, with_folder);
    return fail("Handrail reads worlds from .map and .obj files, told by the file's ending. This file has another.", name);
}

}  // namespace handrail
