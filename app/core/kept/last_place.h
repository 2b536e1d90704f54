// Saves the place of a running session. After a crash, a kill or a power cut, the next start announces that place and
// can continue there. Each session has a small file in the folder `sessions` and holds a lock on it. The system
// releases the lock however the session ends. A session that ends normally removes its file, so an unlocked file means
// a crash. A session that still runs holds its lock, so it is never reported as crashed. The app thread uses this
// class. A separate thread writes the file, at most every kEvery_s.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/core/kept/world_request.h"
#include "worlds/base/result.h"
#include "worlds/base/vec.h"

namespace handrail::core {

struct LastPlace {
    WorldRequest world;  // `world.file` is absolute; settings of a lesson are not included
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

// Convert a place to and from the format of the session's file. If the text is damaged, read_last_place() fails with a
// sentence and returns no place.
std::string text_of(const LastPlace& place);
Result<LastPlace> read_last_place(const std::string& text);

class SessionTrace {
public:
    static constexpr double kEvery_s = 3.0;

    // Searches `folder` for sessions that crashed, removes their files, and begins a file for this session. If `folder`
    // is empty, cannot be written, or is on a file system without locks, nothing is saved or announced.
    explicit SessionTrace(const std::filesystem::path& folder);
    ~SessionTrace();  // If end() was not called, the destructor leaves the files as after a crash.
    SessionTrace(const SessionTrace&) = delete;
    SessionTrace& operator=(const SessionTrace&) = delete;

    // crashed() returns true if an earlier session crashed. left_at() returns the last known place of the latest
    // crashed session, if that session had reached a place.
    bool crashed() const;
    const std::optional<LastPlace>& left_at() const;
    // Returns the path of the report on that crash, in the folder `crash-reports` next to `folder`. The path is empty
    // if there is no report.
    const std::filesystem::path& report() const;

    // Notes the present place. Saves it if the place has changed and kEvery_s have passed since the last save.
    void note(const LastPlace& now, double now_s);
    // Saves the text of a crash report, at most every kEvery_s. Returns false if the last save is more recent.
    bool note_report(const std::string& text, double now_s);
    // Returns the file for the signal that ends the program. The program writes the number of the signal and a line
    // feed there, then any text. The path is empty if nothing is saved.
    std::filesystem::path signal_file() const;
    // Call it when the session ends normally.
    void end();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Returns $XDG_STATE_HOME/handrail/sessions, or else ~/.local/state/handrail/sessions. The result is empty if neither
// path is known.
std::filesystem::path sessions_folder();

}  // namespace handrail::core
