// Reads a world from its file and prepares it for a session, on a separate thread. The app thread owns and uses the
// object.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/core/kept/world_request.h"
#include "app/core/world/entering.h"
#include "app/main/commands.h"
#include "app/main/long_work.h"
#include "app/main/start_place.h"
#include "settings/settings.h"
#include "worlds/base/background_task.h"

namespace handrail::program {

// The loaded world, the request by which it was read, and the settings that it brings.
struct LoadedWorld {
    core::EnteringWorld entering;
    core::WorldRequest requested;
    core::WorldRequest request;        // the same as `requested`, with the unit that a person has stated before
    settings::SettingsStore settings;  // only the settings of SettingSource::World
    std::vector<Diagnostic> settings_problems;
    // Set only if a place to start at was wanted: that place, or why there is none, and the person's additions to the
    // world, in which its name was searched for.
    std::optional<Result<core::Placed>> begins_at;
    std::optional<core::SideFile> additions;
};

// Returns the settings from the file next to the world (SettingSource::World). The settings of a lesson override them.
settings::SettingsStore settings_of(const core::WorldRequest& request, std::vector<Diagnostic>& problems);

class WorldLoading {
public:
    // Begins to load the world at once. If `start` has a name, also searches for that place.
    WorldLoading(const core::WorldRequest& request, const CommonArguments& common, const WantedStart& start = {});

    bool ready() const { return task_.ready(); }
    // Calls `say` with the sentence that is due, such as "Loading, 40 percent: building walls and floors."
    void report(double now_s, const std::function<void(const std::string&)>& say) const {
        progress_.report(now_s, say);
    }
    // Returns the world once, when it is ready. Fails as read_world does, and also if there was not enough memory.
    Result<LoadedWorld> take();

private:
    LongWork progress_ = LongWork::begun();
    std::string file_;  // name of the world's file
    // Declared last, because its thread uses the other members.
    BackgroundTask<Result<LoadedWorld>> task_{on_threads(), "world"};
};

}  // namespace handrail::program
