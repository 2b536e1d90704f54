// Contains the harnesses for maps, meshes and pictures. Each must give a consistent Scene or an error.
#include <zlib.h>

#include <cstdio>

#include "app/import/kept_scene.h"
#include "tests/fuzz/harness.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/zip_text.h"
#include "worlds/readers/height_picture.h"
#include "worlds/readers/reader.h"
#include "worlds/stored/stored_scene.h"

namespace handrail::fuzz {
namespace {

std::string scene_fault(const Result<Scene>& scene) {
    if (!scene) return words_fault(scene.error().sentence());
    if (const Result<void> valid = validate(*scene); !valid) return valid.error().sentence();
    for (const Diagnostic& diagnostic : scene->report.warnings)
        if (std::string fault = words_fault(diagnostic.sentence()); !fault.empty()) return fault;
    return {};
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char c : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(c);
    return value;
}

// Returns the PNG with correct checksums of its chunks, so that mutated bytes pass the reader's check.
std::string with_right_checksums(std::string_view bytes) {
    std::string png(bytes);
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t length = big_endian(std::string_view(png).substr(at));
        if (length > png.size() - at - 12) break;
        const auto* chunk = reinterpret_cast<const Bytef*>(png.data()) + at + 4;
        const auto checksum = static_cast<std::uint32_t>(::crc32(0, chunk, static_cast<uInt>(length + 4)));
        for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = static_cast<char>(checksum >> (24 - 8 * i));
        at += 12 + length;
    }
    return png;
}

// Returns the bytes of a cached world, to which the harness applies all edits. The bytes are generated, so that no
// stored file becomes outdated when the Scene gets another member.
const std::string& kept_scene_bytes() {
    static const std::string bytes = [] {
        const std::string map =
            test::content_of((test::project_root() / "tests/fuzz/inputs/map/seeds/room.map").string());
        const Result<Scene> scene = read_quake_map(map, "room.map");
        return scene ? stored::stored(*scene) : std::string();
    }();
    return bytes;
}

// Applies edits line by line: "AT BYTE" sets a byte, "AT +BYTE" inserts one, "AT -COUNT" removes some, "cut AT" drops
// the rest. AT wraps round at the end of the bytes. Other lines are ignored.
std::string edited(std::string kept, std::string_view edits) {
    for (std::size_t from = 0; from < edits.size() && !kept.empty();) {
        const std::size_t end = std::min(edits.find('\n', from), edits.size());
        const std::string line(edits.substr(from, std::min<std::size_t>(end - from, 60)));
        from = end + 1;
        unsigned long at = 0, value = 0;
        char sign = 0;
        if (std::sscanf(line.c_str(), "cut %lu", &at) == 1) kept.resize(at % kept.size());
        else if (std::sscanf(line.c_str(), "%lu %c%lu", &at, &sign, &value) == 3 && sign == '+')
            kept.insert(at % kept.size(), 1, static_cast<char>(value));
        else if (sign == '-') kept.erase(at % kept.size(), value % 4096);
        else if (std::sscanf(line.c_str(), "%lu %lu", &at, &value) == 2)
            kept[at % kept.size()] = static_cast<char>(value);
    }
    return kept;
}

std::string picture_of_fault(std::string_view bytes) {
    const Result<HeightPicture> picture = read_height_picture(bytes, "fuzz.png");
    if (!picture) return words_fault(picture.error().sentence());
    if (picture->width < 1 || picture->height < 1) return "a picture without points";
    if (picture->width > kLargestPictureSide || picture->height > kLargestPictureSide)
        return "a picture larger than the largest";
    if (picture->depths.size() != static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height))
        return "a picture of another size";
    for (const float depth : picture->depths)
        if (!(depth >= 0.0F && depth <= 1.0F)) return "a depth that is none";
    return {};
}

}  // namespace

std::string map_fault(std::string_view bytes) {
    ReadOptions options;
    options.read_next_to = [](const std::string&) -> Result<std::string> { return fail("There is no such file."); };
    return scene_fault(read_quake_map(bytes, "fuzz.map", options));
}

std::string gltf_fault(std::string_view bytes) { return scene_fault(read_gltf(bytes, "fuzz.glb")); }
std::string ply_fault(std::string_view bytes) { return scene_fault(read_ply(bytes, "fuzz.ply")); }
std::string stl_fault(std::string_view bytes) { return scene_fault(read_stl(bytes, "fuzz.stl")); }
std::string obj_fault(std::string_view bytes) { return scene_fault(read_obj(bytes, "fuzz.obj")); }

// Reads the bytes as an IFC model, or as an archive with a model if they look like an archive.
std::string ifc_fault(std::string_view bytes) {
    if (is_ifczip("fuzz.zip", bytes)) return scene_fault(read_ifczip(bytes, "fuzz.ifczip"));
    return scene_fault(read_ifc(bytes, "fuzz.ifc"));
}

std::string osm_fault(std::string_view bytes) { return scene_fault(read_osm(bytes, "fuzz.osm")); }

std::string rooms_fault(std::string_view bytes) { return scene_fault(read_words(bytes, "fuzz.rooms")); }

// Reads the bytes as an archive. Then builds an archive from the texts in the bytes, each after a line "--- NAME", and
// reads that archive, too.
std::string imdf_fault(std::string_view bytes) {
    if (std::string fault = scene_fault(read_imdf(bytes, "fuzz.imdf.zip")); !fault.empty()) return fault;
    std::map<std::string, std::string> files;
    for (std::size_t at = bytes.find("--- "); at < bytes.size();) {
        const std::size_t line = std::min(bytes.find('\n', at), bytes.size()),
                          end = std::min(bytes.find("\n--- ", line), bytes.size());
        files[std::string(bytes.substr(at + 4, line - at - std::min<std::size_t>(line - at, 4)))] =
            bytes.substr(line, end - line);
        at = end == bytes.size() ? end : end + 1;
    }
    return scene_fault(read_imdf(test::zipped(files), "fuzz.imdf.zip"));
}

// Edits a cached world as an attacker who can forge the cache's digest could edit it. The edits are applied once to the
// whole cache entry and once to the scene in it.
std::string kept_fault(std::string_view bytes) {
    const std::vector<NeighbourFile> beside{{"beside.png", std::string(64, 'a')}};
    const std::string whole = kept_scene(beside, kept_scene_bytes());
    for (const std::string& kept : {edited(whole, bytes), kept_scene(beside, edited(kept_scene_bytes(), bytes))}) {
        for (const bool good : {true, false}) {
            const auto scene = scene_in(kept, [&](const std::vector<NeighbourFile>&) { return good; });
            if (!scene) {
                if (std::string fault = words_fault(scene.error().sentence()); !fault.empty()) return fault;
                continue;
            }
            if (good != scene->has_value()) return "what is out of date was taken, or what is good was not";
            if (!*scene) continue;
            if (const Result<void> valid = validate(**scene); !valid) return valid.error().sentence();
        }
    }
    return {};
}

std::string picture_fault(std::string_view bytes) {
    if (std::string fault = picture_of_fault(bytes); !fault.empty()) return fault;
    return picture_of_fault(with_right_checksums(bytes));
}

}  // namespace handrail::fuzz
