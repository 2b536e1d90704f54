// Stores in which world the session is, and where the last session was. Reads the world that is to be entered next. App
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

// Returns one fault in full. If there are several, returns only the first, because reading all of them aloud took
// minutes. The menu lists the others.
std::string settings_faults_words(const std::vector<std::string>& faults);
std::vector<std::string> sentences_of(const std::vector<Diagnostic>& problems);

class WorldVisits {
public:
    // All arguments must outlive this object.
    WorldVisits(const ExploreArguments& arguments, settings::SettingsStore& settings, core::Session& app,
                const SessionVoice& say)
        : arguments_(arguments), settings_(settings), app_(app), say_(say) {}

    // take_news() returns sentences about problems with the list of worlds. crash_words() says that the previous
    // session did not end properly, and how to continue that session. Both return an empty text if there is nothing to
    // say.
    std::string take_news() { return recent_.take_news(); }
    std::string crash_words(bool with_window, double now_s);
    // Begins notes about this session. If this session crashes, the next one reports the crash from these notes. Call
    // it once, before anything else happens.
    void begin_notes(double now_s);
    // Updates the notes that begin_notes began. Call it once a frame.
    void keep_notes(double now_s);

    // Returns the world that the command line requests.
    core::WorldRequest first() const;
    // Enters the world. Announces the report on the world's file, and faults of its settings and its side file, as
    // parts of the reply of `requested_s`.
    void enter(LoadedWorld world, double requested_s);
    // Call once a frame. If the person has requested another world, reads it while this world continues. If that world
    // cannot be read, nothing changes. The settings must already contain all changes of this session.
    void change(double now_s);
    // Returns true if a world has brought or removed settings since the last call.
    bool take_new_settings() { return std::exchange(new_settings_, false); }
    const core::WorldRequest& here() const { return here_; }  // the current world; its file is absolute
    const std::filesystem::path& path() const { return here_.file; }
    // Sets a lesson's settings, which override those of the world until the lesson ends. With an empty list, only the
    // world's own settings apply.
    void set_lesson_settings(std::vector<std::pair<std::string, std::string>> settings, double now_s);
    bool reading() const { return next_ != nullptr; }
    // Cancels the reading of another world and announces that. Returns false if no world is being read.
    bool give_up_reading(double now_s);

    // Call once a frame. Stores the person's place, so that the person can continue there after a session that ended
    // without end().
    void note_place(double now_s);
    void end() {
        crash_signal_.reset();
        trace_.end();
    }

private:
    bool of_learner() const { return !arguments_.common.data_in.empty(); }
    void watch_file(double now_s);
    void begin_reading(core::WorldRequest request);
    void take_settings(settings::SettingsStore settings, const std::vector<Diagnostic>& problems, double requested_s);
    void go_on_at(core::LastPlace last, double now_s);

    const ExploreArguments& arguments_;
    settings::SettingsStore& settings_;
    core::Session& app_;
    const SessionVoice& say_;
    // A learner's list of worlds and notes are in the learner's own folder, so that the learner leaves no trace
    // elsewhere.
    core::RecentWorlds recent_{of_learner() ? arguments_.common.data_in / "recent-worlds.txt"
                                            : core::recent_worlds_path()};
    core::SessionTrace trace_{of_learner() ? arguments_.common.data_in / "sessions" : core::sessions_folder()};
    std::optional<CrashSignal> crash_signal_;
    std::optional<core::CrashNotes> notes_;
    std::uint64_t notes_kept_ = 0;
    bool new_settings_ = false;
    core::WorldRequest here_;  // the request for the current world, without the unit, which is stored next to the world
    std::optional<core::LastPlace> next_place_;  // where the person continues in the world that is being read
    WorldWatch watch_;
    std::unique_ptr<WorldLoading> next_;
    core::WorldRequest requested_;  // the request for the world that is being read
};

}  // namespace handrail::program
