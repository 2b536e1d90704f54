// Saves the place of a running session. After a crash, a kill or a power cut, the next start announces that place and
// can continue there. Each session has a small file in the folder `sessions` and holds a lock on it. The system
// releases the lock however the session ends. A session that ends normally removes its file, so an unlocked file means
// a crash. Sessions that run at the same time never count as crashed. Used by the app thread; a separate thread writes
// the file, at most every kEvery_s.
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

// Convert a place to and from the format of the file. If the text is damaged, reading fails with a sentence and returns
// no place.
std::string text_of(const LastPlace& place);
Result<LastPlace> read_last_place(const std::string& text);

class SessionTrace {
public:
    static constexpr double kEvery_s = 3.0;

    // Looks in `folder` for sessions that crashed, removes their files, and begins a file for this session. If `folder`
    // is empty, cannot be written, or is on a file system without locks, nothing is saved or announced.
    explicit SessionTrace(const std::filesystem::path& folder);
    ~SessionTrace();  // if end() was not called, leaves the files as after a crash
    SessionTrace(const SessionTrace&) = delete;
    SessionTrace& operator=(const SessionTrace&) = delete;

    // True if an earlier session crashed. left_at() returns the last known place of the latest such session, if it had
    // reached one.
    bool crashed() const;
    const std::optional<LastPlace>& left_at() const;
    // Returns the path of the report on that crash, in the folder `crash-reports` next to `folder`. Empty if there is
    // no report.
    const std::filesystem::path& report() const;

    // Notes the present place. Saves it if it has changed and kEvery_s have passed since the last save.
    void note(const LastPlace& now, double now_s);
    // Saves the text of a crash report, at most every kEvery_s. Returns false if it is too early.
    bool note_report(const std::string& text, double now_s);
    // Returns the file in which to note a signal that ends the program: the number of the signal and a line feed, then
    // any text. Empty if nothing is saved.
    std::filesystem::path signal_file() const;
    // Call it when the session ends normally.
    void end();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Returns $XDG_STATE_HOME/handrail/sessions, or else ~/.local/state/handrail/sessions. Empty if neither path is known.
std::filesystem::path sessions_folder();

}  // namespace handrail::core
