// The settings as a session changes them, and their way to the disk: saved soon and not only at the end, beside this
// thread, since a disk may take long. App thread.
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

namespace handrail {

class KeptSettings {
public:
    // All outlive this object.
    KeptSettings(SettingsStore& settings, Clock& clock, const SessionVoice& say)
        : settings_(settings), clock_(clock), say_(say) {}

    // Live changes, in their order; true where one was taken. What cannot be set is left as it was.
    bool take(const std::vector<std::pair<std::string, std::string>>& changes);
    // Once a frame: saves what is due, and tells what cannot be saved.
    void keep_saved(double now_s);
    // The last chance; while there still is a voice.
    void save_at_the_end(std::ostream& err);

private:
    void tell_unsaved(const Result<void>& saved, double now_s);

    SettingsStore& settings_;
    Clock& clock_;
    const SessionVoice& say_;
    SaveSoon save_;
    BackgroundWriter writer_{on_threads(), write_named_file_atomically};
};

}  // namespace handrail
