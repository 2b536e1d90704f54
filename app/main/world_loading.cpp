#include "app/main/world_loading.h"

#include <filesystem>

#include "app/core/scenario/read_request.h"
#include "app/main/lesson_here.h"
#include "app/main/world_files.h"
#include "worlds/base/language.h"

namespace handrail::program {

settings::SettingsStore settings_of(const core::WorldRequest& request, std::vector<Diagnostic>& problems) {
    settings::SettingsStore settings;
    problems = settings.load_file(settings::settings_next_to(request.file), settings::SettingSource::World,
                                  toml_next_to_worlds());
    for (const auto& [key, value] : request.settings)
        if (const auto set = settings.set(key, value, settings::SettingSource::World); !set)
            problems.push_back({Severity::Error, {}, 0, 0, set.error().message, {}});
    return settings;
}

WorldLoading::WorldLoading(const core::WorldRequest& request, const CommonArguments& common, const WantedStart& start)
    : file_(request.file.filename().string()) {
    task_.begin([this, request, common, start](const std::stop_token& stop) -> Result<LoadedWorld> {
        LoadedWorld loaded;
        loaded.requested = request;
        loaded.request = with_kept_unit(request, common);
        const std::filesystem::path& path = request.file;
        readers::ReadOptions options = progress_.followed(core::read_options(loaded.request));
        options.stop = stop;
        Result<importing::ImportedWorld> world = imported(path, options);
        if (!world) return tl::unexpected(world.error());
        progress_.reading("import.touch");
        loaded.entering = core::make_ready_to_touch(
            std::make_shared<const Scene>(mended(std::move(world->scene), path, common)), stop);
        loaded.entering.ways = navigation_in_cache();
        if (!start.name.empty()) {
            loaded.additions = additions_to(path, common);
            loaded.begins_at = start_place(loaded.entering.file, start, *loaded.additions, loaded.entering.heading_rad,
                                           loaded.entering.ways);
        }
        loaded.settings = settings_of(loaded.request, loaded.settings_problems);
        std::error_code ec;
        read_lessons_ahead(std::filesystem::absolute(path, ec), stop);
        return loaded;
    });
}

Result<LoadedWorld> WorldLoading::take() {
    if (auto loaded = task_.take()) return std::move(*loaded);
    return fail(phrase("program.no_memory_for_world", {{"file", file_}}));
}

}  // namespace handrail::program
