// Which world the session is in, which one is read to be entered next, and where the last session was. App thread.
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

namespace handrail {

// One fault in full; of several the first, for all of them at once took minutes. The menu lists them.
std::string settings_faults_words(const std::vector<std::string>& faults);
std::vector<std::string> sentences_of(const std::vector<Diagnostic>& problems);

class WorldVisits {
public:
    // All outlive this object.
    WorldVisits(const ExploreArguments& arguments, SettingsStore& settings, Session& app, const SessionVoice& say)
        : arguments_(arguments), settings_(settings), app_(app), say_(say) {}

    // What was amiss with the list of worlds, and then of a session before this one that was never left, with the way
    // to go on there; empty where there is nothing to say.
    std::string take_news() { return recent_.take_news(); }
    std::string crash_words(bool with_window, double now_s);
    // Once, before anything happens: what a report of a crash of this session would say from now on.
    void begin_notes(double now_s);
    // Once a frame.
    void keep_notes(double now_s);

    // The world that the command line asks for.
    WorldRequest first() const;
    // With what the world's report, its settings and its side file have to say, as parts of the reply of `asked_s`.
    void enter(LoadedWorld world, double asked_s);
    // Once a frame: another world is read while this one goes on; one that cannot be read leaves everything as it is.
    // The settings hold all changes of this session by then.
    void change(double now_s);
    // Settings came or went with a world since this was asked last.
    bool take_new_settings() { return std::exchange(new_settings_, false); }
    const WorldRequest& here() const { return here_; }  // the world one is in; its file is absolute
    const std::filesystem::path& path() const { return here_.file; }
    // A lesson sets these on top of the world's own settings, until it ends; empty: the world's own alone.
    void set_lesson_settings(std::vector<std::pair<std::string, std::string>> settings, double now_s);
    bool reading() const { return next_ != nullptr; }
    // Stays where one is instead, and says so. False when no other world is being read.
    bool give_up_reading(double now_s);

    // Once a frame: so that a session that ends otherwise than by end() is gone on with.
    void note_place(double now_s);
    void end() {
        crash_signal_.reset();
        trace_.end();
    }

private:
    bool of_learner() const { return !arguments_.common.data_in.empty(); }
    SideFile additions_to(const std::filesystem::path& path) const;
    void watch_file(double now_s);
    void begin_reading(WorldRequest request);
    void take_settings(SettingsStore settings, const std::vector<Diagnostic>& problems, double asked_s);
    void go_on_at(LastPlace last, double now_s);

    const ExploreArguments& arguments_;
    SettingsStore& settings_;
    Session& app_;
    const SessionVoice& say_;
    // A learner has both in the learner's own folder, so that nothing of them is left elsewhere.
    RecentWorlds recent_{of_learner() ? arguments_.common.data_in / "recent-worlds.txt" : recent_worlds_path()};
    SessionTrace trace_{of_learner() ? arguments_.common.data_in / "sessions" : sessions_folder()};
    std::optional<CrashSignal> crash_signal_;
    std::optional<CrashNotes> notes_;
    std::uint64_t notes_kept_ = 0;
    bool new_settings_ = false;
    WorldRequest here_;                    // without the unit, which is kept next to the world by now
    std::optional<LastPlace> next_place_;  // where to go on in the world that is read
    WorldWatch watch_;
    std::unique_ptr<WorldLoading> next_;
    WorldRequest asked_;  // of that one
};

}  // namespace handrail
