// The settings as a session changes them, and how they are saved: soon after each change and not only at the end. A
// background task writes them, since a disk may take long. App thread.
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
    // All of these outlive this object.
    KeptSettings(settings::SettingsStore& settings, Clock& clock, const SessionVoice& say)
        : settings_(settings), clock_(clock), say_(say) {}

    // Applies live changes in their order; returns true if at least one was accepted. A rejected change leaves its
    // setting as it was.
    bool take(const std::vector<std::pair<std::string, std::string>>& changes);
    // Call once a frame; saves what is due, and announces what cannot be saved.
    void keep_saved(double now_s);
    // The last chance to save. Call it while there still is a voice.
    void save_at_the_end(std::ostream& err);

private:
    void tell_unsaved(const Result<void>& saved, double now_s);

    settings::SettingsStore& settings_;
    Clock& clock_;
    const SessionVoice& say_;
    core::SaveSoon save_;
    core::BackgroundWriter writer_{on_threads(), write_named_file_atomically};
};

}  // namespace handrail::program
