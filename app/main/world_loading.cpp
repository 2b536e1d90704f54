#include "app/main/world_loading.h"

#include <chrono>

#include "app/main/lesson_here.h"
#include "app/main/world_files.h"

namespace handrail {

WorldLoading::WorldLoading(const std::filesystem::path& path, const CommonArguments& common)
    : result_(std::async(std::launch::async, [this, path, common]() -> Result<EnteringWorld> {
          ReadOptions options = progress_.followed(common.read_options(path));
          options.stop = stop_.get_token();
          Result<ImportedWorld> world = imported(path, options);
          if (!world) return tl::unexpected(world.error());
          progress_.reading("import.touch");
          EnteringWorld entering = make_ready_to_touch(
              std::make_shared<const Scene>(mended(std::move(world->scene), path, common)), stop_.get_token());
          entering.ways = ways_in_cache();
          std::error_code ec;
          read_lessons_ahead(std::filesystem::absolute(path, ec), stop_.get_token());
          return entering;
      })) {}

WorldLoading::~WorldLoading() { stop_.request_stop(); }

bool WorldLoading::ready() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

}  // namespace handrail
