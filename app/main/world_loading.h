// A world on its way from its file to where it can be entered, read and made ready on a thread of its own. App thread.
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

namespace handrail {

// What was read: the world, how its file was read, and the settings that it brings.
struct LoadedWorld {
    EnteringWorld entering;
    WorldRequest asked;
    WorldRequest request;    // the same with the unit that a person has said before
    SettingsStore settings;  // those of SettingSource::World
    std::vector<Diagnostic> settings_problems;
};

// What the file next to the world sets (SettingSource::World), and on top of it what a lesson does.
SettingsStore settings_of(const WorldRequest& request, std::vector<Diagnostic>& problems);

class WorldLoading {
public:
    // Begins at once.
    WorldLoading(const WorldRequest& request, const CommonArguments& common);

    bool ready() const { return task_.ready(); }
    // Gives `say` what is due: "Loading, 40 percent: building walls and floors."
    void tell(double now_s, const std::function<void(const std::string&)>& say) const { progress_.tell(now_s, say); }
    // Once, when ready. Fails as read_world does, or when memory did not suffice.
    Result<LoadedWorld> take();

private:
    LongWork progress_ = LongWork::begun();
    std::string file_;                                                 // its name
    BackgroundTask<Result<LoadedWorld>> task_{on_threads(), "world"};  // last: its thread uses the others
};

}  // namespace handrail
