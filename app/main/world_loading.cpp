#include "app/main/world_loading.h"

#include <chrono>
#include <filesystem>

#include "app/core/scenario/read_request.h"
#include "app/main/lesson_here.h"
#include "app/main/world_files.h"
#include "worlds/base/executor.h"

namespace handrail {

namespace {

// What the file next to the world sets, and on top of it what a lesson does: house.settings.toml next to house.map.
void take_settings(LoadedWorld& world) {
    world.settings_problems =
        world.settings.load_file(std::filesystem::path(world.request.file).replace_extension(".settings.toml"),
                                 SettingSource::World, toml_beside_worlds());
    for (const auto& [key, value] : world.request.settings)
        if (const auto set = world.settings.set(key, value, SettingSource::World); !set)
            world.settings_problems.push_back({Severity::Error, {}, 0, 0, set.error().message, {}});
}

}  // namespace

WorldLoading::WorldLoading(const WorldRequest& request, const CommonArguments& common)
    : result_(std::async(std::launch::async, [this, request, common]() -> Result<LoadedWorld> {
          name_this_thread("world");
          LoadedWorld loaded;
          loaded.asked = request;
          loaded.request = with_kept_unit(request, common);
          const std::filesystem::path& path = request.file;
          ReadOptions options = progress_.followed(read_options(loaded.request));
          options.stop = stop_.get_token();
          Result<ImportedWorld> world = imported(path, options);
          if (!world) return tl::unexpected(world.error());
          progress_.reading("import.touch");
          loaded.entering = make_ready_to_touch(
              std::make_shared<const Scene>(mended(std::move(world->scene), path, common)), stop_.get_token());
          loaded.entering.ways = ways_in_cache();
          take_settings(loaded);
          std::error_code ec;
          read_lessons_ahead(std::filesystem::absolute(path, ec), stop_.get_token());
          return loaded;
      })) {}

WorldLoading::~WorldLoading() { stop_.request_stop(); }

bool WorldLoading::ready() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

}  // namespace handrail
