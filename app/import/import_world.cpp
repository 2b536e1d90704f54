#include "app/import/import_world.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>

#include "app/import/kept_scene.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/cache/sha256.h"
#include "worlds/stored/stored_scene.h"

namespace handrail::importing {
namespace {

namespace fs = std::filesystem;

// Identifies the contents of a file at the time when the file was read.
struct FileState {
    std::uint64_t size = 0;
    timespec changed{};
    std::string sha256;

    bool same_as(const FileState& other) const {
        return size == other.size && changed.tv_sec == other.changed.tv_sec &&
               changed.tv_nsec == other.changed.tv_nsec && sha256 == other.sha256;
    }
};

// Returns the state of the file. Returns nothing if the file is smaller than `least_bytes`, is not a regular file, or
// cannot be read, or if `stop` was requested. Reports no error, because read_world reports the reason later.
std::optional<FileState> state_of(const fs::path& path, std::uint64_t least_bytes, const std::stop_token& stop) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat of {};
    if (file.get() < 0 || ::fstat(file.get(), &of) != 0 || !S_ISREG(of.st_mode)) return std::nullopt;
    FileState state{static_cast<std::uint64_t>(of.st_size), of.st_mtim, {}};
    if (state.size < least_bytes) return std::nullopt;
    cache::Sha256 sum;
    std::string bytes(std::size_t{1} << 20, '\0');
    for (;;) {
        if (stop.stop_requested()) return std::nullopt;
        const ssize_t got = ::read(file.get(), bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return std::nullopt;
        if (got == 0) break;
        sum.add(std::string_view(bytes.data(), static_cast<std::size_t>(got)));
    }
    state.sha256 = sum.hex();
    return state;
}

// Returns the cache key. The key depends on everything that affects the result, except the files next to the world.
// That includes the person's own language files, which may change between two starts.
std::string name_in_cache(const FileState& file, const readers::ReadOptions& options, const fs::path& path) {
    cache::Sha256 sum;
    sum.add_counted(fmt::format("{:x} {} {} {} {} {} {}", stored::kWorldsVersion, file.sha256,
                                options.map_metres_per_unit, options.obj_metres_per_unit, options.unit_is_known,
                                options.guess_materials, options.solid_meshes));
    for (const std::string& text : {options.building, path.filename().string(), spoken_language()})
        sum.add_counted(text);
    const fs::path folder = spoken_language_folder();
    if (!folder.empty())
        for (const std::string& code : {spoken_language(), std::string("en")})
            if (const auto own = state_of(folder / (code + ".toml"), 0, {})) sum.add_counted(code + " " + own->sha256);
    return sum.hex() + ".scene";
}

Result<ImportedWorld> read_here(const fs::path& path, const readers::ReadOptions& options) {
    Result<Scene> scene = readers::read_world(path, options);
    if (!scene) return tl::unexpected(scene.error());
    ImportedWorld world;
    world.scene = std::move(*scene);
    return world;
}

}  // namespace

Result<ImportedWorld> import_world(const fs::path& path, const readers::ReadOptions& options, const ImportHow& how) {
    if (how.program.empty() || options.read_next_to) return read_here(path, options);
    const bool map = lower_ascii(path.extension().string()) == ".map";
    const std::optional<FileState> before =
        how.cache ? state_of(path, map ? kLeastKeptMap_bytes : kLeastKept_bytes, options.stop)
                  : std::optional<FileState>();
    const std::string name = before ? name_in_cache(*before, options, path) : std::string();
    const Descriptor kept = before ? how.cache.open(name) : Descriptor(-1);
    Result<ReadApart> read = read_apart(path, options, how.program, how.limits, {kept.get(), name});
    if (!read) return tl::unexpected(read.error());
    Result<Scene> scene = stored::scene_from(read->scene);
    if (!scene) return tl::unexpected(scene.error());
    if (read->kept && options.progress) options.progress(1.0);
    // Store the result in the cache only if the file did not change while it was read.
    if (before && !read->kept)
        if (const auto after = state_of(path, 0, options.stop); after && after->same_as(*before))
            how.cache.keep(name, kept_scene(read->beside, read->scene));
    return ImportedWorld{std::move(*scene), read->kept, read->kept_damaged};
}

}  // namespace handrail::importing
