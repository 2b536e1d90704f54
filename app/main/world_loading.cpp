#include "app/main/world_loading.h"

#include <chrono>

#include "app/main/world_files.h"
#include "worlds/base/language.h"

namespace handrail {

WorldLoading::WorldLoading(const std::filesystem::path& path, const CommonArguments& common)
    : result_(std::async(std::launch::async, [this, path, common]() -> Result<EnteringWorld> {
          ReadOptions options = common.read_options(path);
          options.stop = stop_.get_token();
          options.progress = [this](double fraction) {
              percent_.store(static_cast<int>(fraction * 100.0), std::memory_order_relaxed);
          };
          options.stage = [this](std::string_view stage) { go_to(stage); };
          Result<ImportedWorld> world = imported(path, options);
          if (!world) return tl::unexpected(world.error());
          go_to("import.touch");
          return make_ready_to_touch(std::make_shared<const Scene>(std::move(world->scene)), stop_.get_token());
      })) {}

WorldLoading::~WorldLoading() { stop_.request_stop(); }

void WorldLoading::go_to(std::string_view stage) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
}

std::string WorldLoading::how_far() const {
    const std::lock_guard lock(mutex_);
    const int percent = percent_.load(std::memory_order_relaxed);
    if (stage_.empty()) return phrase("program.loading", {{"percent", percent}});
    return phrase("program.loading_at", {{"percent", percent}, {"stage", phrase(stage_)}});
}

bool WorldLoading::ready() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

}  // namespace handrail
