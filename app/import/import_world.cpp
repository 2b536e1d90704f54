#include "app/import/import_world.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>

#include "app/import/kept_scene.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/stored/stored_scene.h"

namespace handrail {
namespace {

namespace fs = std::filesystem;

// The file as it is now.
struct FileState {
    std::uint64_t size = 0;
    timespec changed{};
    std::uint32_t checksum = 0;

    bool same_as(const FileState& other) const {
        return size == other.size && changed.tv_sec == other.changed.tv_sec &&
               changed.tv_nsec == other.changed.tv_nsec && checksum == other.checksum;
    }
};

// Nothing of what is no ordinary file, cannot be read or is not wanted any more: reading it says so.
std::optional<FileState> state_of(const fs::path& path, const std::stop_token& stop) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat of {};
    if (file.get() < 0 || ::fstat(file.get(), &of) != 0 || !S_ISREG(of.st_mode)) return std::nullopt;
    FileState state{static_cast<std::uint64_t>(of.st_size), of.st_mtim, 0};
    std::string bytes(std::size_t{1} << 20, '\0');
    for (;;) {
        if (stop.stop_requested()) return std::nullopt;
        const ssize_t got = ::read(file.get(), bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return std::nullopt;
        if (got == 0) return state;
        state.checksum = checksum(state.checksum, std::string_view(bytes.data(), static_cast<std::size_t>(got)));
    }
}

// Everything but the file that decides what becomes of it. A person's own words may change between two starts.
std::string said_by(const ReadOptions& options, const fs::path& path) {
    std::string said = fmt::format("{} {} {} {} {} {}\n{}\n{}", options.map_metres_per_unit,
                                   options.obj_metres_per_unit, options.unit_is_known, options.guess_materials,
                                   options.solid_meshes, options.building, path.filename().string(), spoken_language());
    const fs::path folder = spoken_language_folder();
    std::error_code ec;
    if (!folder.empty() && fs::is_directory(folder, ec))
        for (const std::string& code : {spoken_language(), std::string("en")})
            if (const auto own = state_of(folder / (code + ".toml"), {}))
                said += fmt::format("\n{} {} {:08x}", code, own->size, own->checksum);
    return said;
}

// True as long as those that were needed are there as they were, and those that were missing are missing.
bool same_beside(const fs::path& path, const std::vector<BesideFile>& beside, const std::stop_token& stop) {
    return std::all_of(beside.begin(), beside.end(), [&](const BesideFile& file) {
        const Result<std::string> bytes = read_file_beside(path, file.name, stop);
        return (bytes ? checksum(0, *bytes) : 0U) == file.checksum;
    });
}

}  // namespace

Result<ImportedWorld> import_world(const fs::path& path, const ReadOptions& options, const ImportHow& how) {
    ImportedWorld world;
    if (how.program.empty() || lower_ascii(path.extension().string()) == ".map" || options.read_beside) {
        Result<Scene> scene = read_world(path, options);
        if (!scene) return tl::unexpected(scene.error());
        world.scene = std::move(*scene);
        return world;
    }
    const bool keeps = !how.keep_in.empty();
    const std::optional<FileState> before = keeps ? state_of(path, options.stop) : std::nullopt;
    const std::string said = said_by(options, path);
    if (before) {
        if (const Result<std::string> file = read_whole_file(how.keep_in, std::size_t{2} << 30, options.stop)) {
            Result<std::optional<Scene>> scene = scene_in(*file, [&](const KeptFrom& from) {
                return from.version == kReaderVersion && from.size == before->size &&
                       from.checksum == before->checksum && from.said == said &&
                       same_beside(path, from.beside, options.stop);
            });
            if (scene && *scene) {
                world.scene = std::move(**scene);
                world.kept = true;
                if (options.progress) options.progress(1.0);
                return world;
            }
            world.kept_damaged = !scene.has_value();
        }
    }
    Result<ReadApart> read = read_apart(path, options, how.program, how.limits);
    if (!read) return tl::unexpected(read.error());
    Result<Scene> scene = scene_from(read->scene);
    if (!scene) return tl::unexpected(scene.error());
    world.scene = std::move(*scene);
    // What changed while it was read is not kept. Where it cannot be written the next start reads it again.
    if (before && before->size >= kLeastKept_bytes)
        if (const auto after = state_of(path, options.stop); after && after->same_as(*before))
            (void)write_file_atomically(
                how.keep_in,
                kept_file({kReaderVersion, before->size, before->checksum, said, read->beside}, read->scene));
    return world;
}

}  // namespace handrail
