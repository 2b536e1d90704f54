// A world on its way from its file to where it can be entered, read and made ready on a thread of its own. App thread.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <stop_token>
#include <string>

#include "app/core/world/entering.h"
#include "app/main/commands.h"
#include "app/main/long_work.h"

namespace handrail {

class WorldLoading {
public:
    // Begins at once.
    WorldLoading(const std::filesystem::path& path, const CommonArguments& common);
    // Stops what is not done yet, and waits for that.
    ~WorldLoading();
    WorldLoading(const WorldLoading&) = delete;
    WorldLoading& operator=(const WorldLoading&) = delete;

    bool ready() const;
    // Gives `say` what is due: "Loading, 40 percent: building walls and floors."
    void tell(double now_s, const std::function<void(const std::string&)>& say) const { progress_.tell(now_s, say); }
    // Once, when ready. Fails as read_world does.
    Result<EnteringWorld> take() { return result_.get(); }

private:
    LongWork progress_ = LongWork::begun();
    std::stop_source stop_;
    std::future<Result<EnteringWorld>> result_;  // last: its thread uses the others, and it waits for that
};

}  // namespace handrail
