#include "app/main/world_files.h"

#include <cstdlib>

#include "app/core/kept/kept_groups.h"
#include "app/core/kept/kept_unit.h"
#include "app/core/kept/labels.h"
#include "app/core/kept/made_doors.h"
#include "app/core/kept/side_file.h"
#include "app/core/kept/world_shelf.h"
#include "app/core/scenario/read_request.h"
#include "app/import/toml_apart.h"
#include "app/main/commands.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/scene/scene.h"
#include "worlds/stored/stored_navigation.h"

namespace handrail::program {

namespace fs = std::filesystem;

namespace {

// Returns the folder with the worlds that are installed with the program. A build folder contains a link to that
// folder, which this function follows. If the folder does not exist, returns its path all the same, so that an error
// can name it.
fs::path installed_folder() {
    const fs::path shared = shared_folder();
    if (shared.empty()) return {};
    std::error_code ec;
    fs::path installed = shared / "worlds";
    fs::path real = fs::canonical(installed, ec);
    return ec ? installed : real;
}

fs::path folder_as_set() {
    const char* set = std::getenv("HANDRAIL_WORLDS");
    return set && *set ? fs::path(set) : fs::path();
}

// Returns the absolute path of a world, with links followed.
fs::path real_world(const fs::path& world) {
    std::error_code ec;
    fs::path whole = fs::weakly_canonical(fs::absolute(world, ec), ec);
    return ec ? world : whole;
}

}  // namespace

fs::path shared_folder() {
    std::error_code ec;
    const fs::path program = fs::read_symlink("/proc/self/exe", ec);
    return ec ? fs::path() : program.parent_path().parent_path() / "share" / "handrail";
}

fs::path world_folder() {
    fs::path set = folder_as_set();
    return set.empty() ? installed_folder() : set;
}

bool is_shipped(const fs::path& world) {
    std::error_code ec;
    const fs::path folder = real_world(world).parent_path();
    for (const fs::path& ours : {folder_as_set(), installed_folder()})
        if (!ours.empty() && fs::equivalent(folder, ours, ec)) return true;
    return false;
}

fs::path kept_by(const fs::path& world) { return is_shipped(world) ? real_world(world) : world; }

std::optional<fs::path> world_by_name(const fs::path& name) {
    std::error_code ec;
    if (name.has_parent_path() || name.has_extension() || fs::exists(name, ec)) return std::nullopt;
    for (const core::ShelvedWorld& world : core::worlds_in(world_folder()))
        if (world.file.stem() == name || world.name == name.string()) return world.file;
    return std::nullopt;
}

std::vector<std::string> world_names() {
    std::vector<std::string> names;
    for (const core::ShelvedWorld& world : core::worlds_in(world_folder())) names.push_back(world.file.stem().string());
    return names;
}

Result<fs::path> world_given(const fs::path& word) {
    if (auto named = world_by_name(word)) return std::move(*named);
    std::error_code ec;
    if (word.has_parent_path() || word.has_extension() || fs::exists(word, ec)) return word;
    const std::vector<std::string> names = world_names();
    if (names.empty()) return word;
    return fail(phrase("program.no_world", {{"word", word.string()}, {"nearest", nearest_name(word.string(), names)}}));
}

Result<importing::ImportedWorld> imported(const fs::path& world, const readers::ReadOptions& options) {
    importing::ImportHow how;
    how.cache = cache::Cache(cache::user_cache_folder());
    return importing::import_world(world, options, how);
}

Result<Scene> imported_scene(const core::WorldRequest& request) {
    auto world = imported(request.file, core::read_options(request));
    if (!world) return tl::unexpected(std::move(world.error()));
    return std::move(world->scene);
}

const settings::TomlReader& toml_next_to_worlds() {
    static const settings::TomlReader reader = [] {
        const fs::path program = importing::find_reader_program();
        return program.empty() ? settings::TomlReader(settings::toml_of)
                               : settings::TomlReader(importing::TomlApart(program));
    }();
    return reader;
}

core::RoutesKeeper navigation_in_cache() {
    const cache::Cache cache(cache::user_cache_folder());
    const fs::path program = importing::find_reader_program();
    if (!cache || program.empty()) return {};
    const auto name_of = [](const std::string& key) { return key + ".ways"; };
    return {stored::navigation_key,
            [=](const std::string& key, const std::stop_token& stop) {
                const Descriptor file = cache.open(name_of(key));
                return file.get() < 0 ? std::string()
                                      : importing::unpack_navigation_apart({file.get(), name_of(key)}, program, stop);
            },
            [=](const std::string& key, std::string_view packed) { cache.keep(name_of(key), packed); }};
}

Scene mended(Scene scene, const fs::path& world, const CommonArguments& common) {
    const std::vector<MadeDoor> doors = core::kept_doors(
        kept_by(world), common.data_folder(), !common.data_in.empty() || is_shipped(world), toml_next_to_worlds());
    if (!doors.empty()) scene = with_made_doors(std::move(scene), doors);
    const fs::path kept = kept_by(world);
    const bool shipped = !common.data_in.empty() || is_shipped(world);
    scene = core::with_groups(std::move(scene),
                              core::kept_groups(kept, common.data_folder(), shipped, toml_next_to_worlds()));
    return core::with_labels(std::move(scene),
                             core::kept_labels(kept, common.data_folder(), shipped, toml_next_to_worlds()));
}

Result<Scene> mended_and_valid(Result<importing::ImportedWorld> read, const fs::path& world,
                               const CommonArguments& common) {
    if (!read) return tl::unexpected(std::move(read.error()));
    Scene scene = mended(std::move(read->scene), world, common);
    if (const Result<void> valid = validate(scene); !valid) return tl::unexpected(valid.error());
    return scene;
}

core::SideFile additions_to(const fs::path& world, const CommonArguments& common) {
    const fs::path kept = kept_by(world);
    if (common.data_in.empty())
        return core::SideFile::of_world(kept, core::user_data_folder(), is_shipped(world), toml_next_to_worlds());
    std::error_code ec;
    const fs::path own = core::SideFile::path_of(kept, common.data_in, true),
                   of_all = core::SideFile::path_of(kept, core::user_data_folder(), is_shipped(world));
    if (!fs::exists(own, ec) && fs::exists(of_all, ec)) {
        fs::create_directories(own.parent_path(), ec);
        fs::copy_file(of_all, own, ec);  // if copying fails, the learner begins without additions
    }
    return core::SideFile::of_world(kept, common.data_in, true, toml_next_to_worlds());
}

fs::path first_world() { return world_folder() / "first_room.map"; }

fs::path CommonArguments::data_folder() const { return data_in.empty() ? core::user_data_folder() : data_in; }

core::WorldRequest with_kept_unit(core::WorldRequest request, const CommonArguments& common) {
    if (!request.unit_m && !request.map_scale_m_per_unit)
        request.unit_m = core::kept_unit(kept_by(request.file), common.data_folder(),
                                         !common.data_in.empty() || is_shipped(request.file), toml_next_to_worlds());
    return request;
}

readers::ReadOptions CommonArguments::read_options(const fs::path& world) const {
    return handrail::core::read_options(with_kept_unit(request(world), *this));
}

}  // namespace handrail::program
