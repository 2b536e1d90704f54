// Stores the settings that a session changes, and saves them soon after each change and once more at the end. A
// background task writes the file, because a disk may be slow. App thread.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/core/kept/background_writer.h"
#include "app/core/kept/save_soon.h"
#include "app/main/session_voice.h"
#include "settings/settings.h"
#include "worlds/base/clock.h"

namespace handrail::program {

class KeptSettings {
public:
    // All arguments must outlive this object.
    KeptSettings(settings::SettingsStore& settings, Clock& clock, const SessionVoice& say)
        : settings_(settings), clock_(clock), say_(say) {}

    // Applies changes of settings in their order. Returns true if at least one change was accepted. A rejected change
    // leaves its setting as it was.
    bool take(const std::vector<std::pair<std::string, std::string>>& changes);
    // Call once a frame. Saves changes that are due. Announces a failure to save them.
    void keep_saved(double now_s);
    // Saves the last changes. Call it while the session can still speak, so that a failure can be announced.
    void save_at_the_end(std::ostream& err);

private:
    void report_unsaved(const Result<void>& saved, double now_s);

    settings::SettingsStore& settings_;
    Clock& clock_;
    const SessionVoice& say_;
    core::SaveSoon save_;
    core::BackgroundWriter writer_{on_threads(), write_named_file_atomically};
};

}  // namespace handrail::program
