// A file becomes a Scene. Readers take bytes and never crash, hang or half-load silently: each loss is a Diagnostic.
// App or worker thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct ReadOptions {
    double map_metres_per_unit = 1.0 / 32.0;        // for .map files (Quake: 1/32)
    bool guess_materials = true;                    // from texture names; exploring yes, replay no
    std::function<void(double fraction)> progress;  // 0 to 1, called from the reading thread; may be empty
};

// One map format: which files it takes and how it reads them. A table row, the MapReader seam.
struct MapReader {
    std::string_view name;                                                       // as in `info --json`: "map"
    bool (*accepts)(const std::filesystem::path& path, std::string_view bytes);  // by ending and first bytes
    Result<Scene> (*read)(std::string_view bytes, const std::string& file_name, const ReadOptions& options);
};

Result<Scene> read_quake_map(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});
Result<Scene> read_obj(std::string_view bytes, const std::string& file_name, const ReadOptions& options = {});

// Reads any file that one of the readers accepts. Fails with one sentence fit to be spoken when it is missing, unreadable,
// of a kind we do not read (named where recognised, with what to do), or holds nothing usable.
Result<Scene> read_world(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace handrail
