// A world on its way from its file to where it can be entered, read and made ready on a thread of its own. App thread.
#pragma once

#include <functional>
#include <future>
#include <stop_token>
#include <string>
#include <vector>

#include "app/core/kept/world_request.h"
#include "app/core/world/entering.h"
#include "app/main/commands.h"
#include "app/main/long_work.h"
#include "settings/settings.h"

namespace handrail {

// What was read: the world, how its file was read, and the settings that it brings.
struct LoadedWorld {
    EnteringWorld entering;
    WorldRequest asked;
    WorldRequest request;    // the same with the unit that a person has said before
    SettingsStore settings;  // those of SettingSource::World
    std::vector<Diagnostic> settings_problems;
};

class WorldLoading {
public:
    // Begins at once.
    WorldLoading(const WorldRequest& request, const CommonArguments& common);
    // Stops what is not done yet, and waits for that.
    ~WorldLoading();
    WorldLoading(const WorldLoading&) = delete;
    WorldLoading& operator=(const WorldLoading&) = delete;

    bool ready() const;
    // Gives `say` what is due: "Loading, 40 percent: building walls and floors."
    void tell(double now_s, const std::function<void(const std::string&)>& say) const { progress_.tell(now_s, say); }
    // Once, when ready. Fails as read_world does.
    Result<LoadedWorld> take() { return result_.get(); }

private:
    LongWork progress_ = LongWork::begun();
    std::stop_source stop_;
    std::future<Result<LoadedWorld>> result_;  // last: its thread uses the others, and it waits for that
};

}  // namespace handrail
