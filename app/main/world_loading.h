// A world on its way from its file to where it can be entered, read and made ready on a thread of its own. App thread.
#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>

#include "app/core/world/entering.h"
#include "app/main/commands.h"

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
    // "Loading, 40 percent: building walls and floors.": how far the reading is, and what it is at.
    std::string how_far() const;
    // Once, when ready. Fails as read_world does.
    Result<EnteringWorld> take() { return result_.get(); }

private:
    void go_to(std::string_view stage);

    std::atomic<int> percent_{0};
    mutable std::mutex mutex_;  // held for the length of a copy
    std::string stage_;         // a text's key
    std::stop_source stop_;
    std::future<Result<EnteringWorld>> result_;  // last: its thread uses the others, and it waits for that
};

}  // namespace handrail
