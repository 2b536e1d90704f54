#include "app/main/world_loading.h"

#include <chrono>

#include "worlds/readers/reader.h"

namespace handrail {

WorldLoading::WorldLoading(const std::filesystem::path& path, const CommonArguments& common)
    : result_(std::async(std::launch::async, [this, path, common]() -> Result<EnteringWorld> {
          ReadOptions options = common.read_options(path);
          options.stop = stop_.get_token();
          options.progress = [this](double fraction) {
              percent_.store(static_cast<int>(fraction * 100.0), std::memory_order_relaxed);
          };
          Result<Scene> scene = read_world(path, options);
          if (!scene) return tl::unexpected(scene.error());
          return make_ready_to_touch(std::make_shared<const Scene>(std::move(*scene)), stop_.get_token());
      })) {}

WorldLoading::~WorldLoading() { stop_.request_stop(); }

bool WorldLoading::ready() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

}  // namespace handrail
