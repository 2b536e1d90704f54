// Which world the session is in, which world is being read to be entered next, and where the last session was. App
// thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/kept/crash_notes.h"
#include "app/core/kept/last_place.h"
#include "app/core/kept/side_file.h"
#include "app/core/kept/world_shelf.h"
#include "app/core/session/session.h"
#include "app/main/commands.h"
#include "app/main/crash_signal.h"
#include "app/main/session_voice.h"
#include "app/main/world_loading.h"
#include "app/main/world_watch.h"

namespace handrail::program {

// One fault in full. If there are several, only the first, because reading all of them aloud took minutes; the menu
// lists them.
std::string settings_faults_words(const std::vector<std::string>& faults);
std::vector<std::string> sentences_of(const std::vector<Diagnostic>& problems);

class WorldVisits {
public:
    // All of these outlive this object.
    WorldVisits(const ExploreArguments& arguments, settings::SettingsStore& settings, core::Session& app,
                const SessionVoice& say)
        : arguments_(arguments), settings_(settings), app_(app), say_(say) {}

    // Problems with the list of worlds, and then a previous session that was never left, with the way to continue it.
    // Empty if there is nothing to say.
    std::string take_news() { return recent_.take_news(); }
    std::string crash_words(bool with_window, double now_s);
    // Call once, before anything else happens. Begins the notes from which a crash of this session would be reported.
    void begin_notes(double now_s);
    // Call once a frame.
    void keep_notes(double now_s);

    // The world that the command line requests.
    core::WorldRequest first() const;
    // Enters the world. Announces its report and the faults of its settings and its side file as parts of the reply of
    // `asked_s`.
    void enter(LoadedWorld world, double asked_s);
    // Call once a frame. Another world is read while this one continues; one that cannot be read changes nothing. The
    // settings must already contain all changes of this session.
    void change(double now_s);
    // True if a world has brought or removed settings since the last call.
    bool take_new_settings() { return std::exchange(new_settings_, false); }
    const core::WorldRequest& here() const { return here_; }  // the current world; its file is absolute
    const std::filesystem::path& path() const { return here_.file; }
    // Sets a lesson's settings on top of the world's own until the lesson ends. An empty list leaves the world's own
    // alone.
    void set_lesson_settings(std::vector<std::pair<std::string, std::string>> settings, double now_s);
    bool reading() const { return next_ != nullptr; }
    // Cancels the reading of another world and says so. Returns false if none is being read.
    bool give_up_reading(double now_s);

    // Call once a frame. It lets the person continue a session that ended without end().
    void note_place(double now_s);
    void end() {
        crash_signal_.reset();
        trace_.end();
    }

private:
    bool of_learner() const { return !arguments_.common.data_in.empty(); }
    core::SideFile additions_to(const std::filesystem::path& path) const;
    void watch_file(double now_s);
    void begin_reading(core::WorldRequest request);
    void take_settings(settings::SettingsStore settings, const std::vector<Diagnostic>& problems, double asked_s);
    void go_on_at(core::LastPlace last, double now_s);

    const ExploreArguments& arguments_;
    settings::SettingsStore& settings_;
    core::Session& app_;
    const SessionVoice& say_;
    // For a learner both are in the learner's own folder, so that no trace of them is left elsewhere.
    core::RecentWorlds recent_{of_learner() ? arguments_.common.data_in / "recent-worlds.txt"
                                            : core::recent_worlds_path()};
    core::SessionTrace trace_{of_learner() ? arguments_.common.data_in / "sessions" : core::sessions_folder()};
    std::optional<CrashSignal> crash_signal_;
    std::optional<core::CrashNotes> notes_;
    std::uint64_t notes_kept_ = 0;
    bool new_settings_ = false;
    core::WorldRequest here_;                    // without the unit, which is already kept next to the world
    std::optional<core::LastPlace> next_place_;  // where to continue in the world that is being read
    WorldWatch watch_;
    std::unique_ptr<WorldLoading> next_;
    core::WorldRequest asked_;  // the request for the world that is being read
};

}  // namespace handrail::program
