// Reads a world from its file and prepares it for entering, on a separate thread. App thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/core/kept/world_request.h"
#include "app/core/world/entering.h"
#include "app/main/commands.h"
#include "app/main/long_work.h"
#include "settings/settings.h"
#include "worlds/base/background_task.h"

namespace handrail::program {

// The loaded world, how its file was read, and the settings that it brings.
struct LoadedWorld {
    core::EnteringWorld entering;
    core::WorldRequest asked;
    core::WorldRequest request;        // the same with the unit that a person has stated before
    settings::SettingsStore settings;  // only those of SettingSource::World
    std::vector<Diagnostic> settings_problems;
};

// The settings in the file next to the world (SettingSource::World), overridden by those of a lesson.
settings::SettingsStore settings_of(const core::WorldRequest& request, std::vector<Diagnostic>& problems);

class WorldLoading {
public:
    // Begins to load at once.
    WorldLoading(const core::WorldRequest& request, const CommonArguments& common);

    bool ready() const { return task_.ready(); }
    // Calls `say` with the sentence that is due: "Loading, 40 percent: building walls and floors."
    void tell(double now_s, const std::function<void(const std::string&)>& say) const { progress_.tell(now_s, say); }
    // Returns the world once, when ready. Fails as read_world does, or if memory did not suffice.
    Result<LoadedWorld> take();

private:
    LongWork progress_ = LongWork::begun();
    std::string file_;                                                 // name of the file
    BackgroundTask<Result<LoadedWorld>> task_{on_threads(), "world"};  // last: its thread uses the others
};

}  // namespace handrail::program
