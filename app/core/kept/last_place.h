// Saves the place of a running session, so that after a crash, a kill or a power cut the next start can announce it and
// continue there. Each session has its own small file in the folder `sessions` and holds a lock on it. The system
// releases that lock however the session ends; a session that ends normally removes its file. So an unlocked file means
// a crash, and simultaneous sessions never mistake each other for crashed. App thread only; another thread writes the
// file, at most every kEvery_s.
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
    WorldRequest world;  // its file is absolute; settings of a lesson are not kept
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

// In the format of the file. Reading fails with a sentence and never returns half a place.
std::string text_of(const LastPlace& place);
Result<LastPlace> read_last_place(const std::string& text);

class SessionTrace {
public:
    static constexpr double kEvery_s = 3.0;

    // Looks in `folder` for sessions that crashed, removes their files, and begins a file for this session. If the
    // folder is empty, cannot be written, or its file system has no locks, nothing is kept and nothing is announced.
    explicit SessionTrace(const std::filesystem::path& folder);
    ~SessionTrace();  // without end(): as if the program had crashed
    SessionTrace(const SessionTrace&) = delete;
    SessionTrace& operator=(const SessionTrace&) = delete;

    // Whether an earlier session crashed, and the last known place of the latest one, if it had reached one.
    bool crashed() const;
    const std::optional<LastPlace>& left_at() const;
    // The report on that crash, in its own file in the folder `crash-reports` next to `folder`; empty if there is none.
    const std::filesystem::path& report() const;

    // Notes the present place. It is saved if it has changed and kEvery_s have passed.
    void note(const LastPlace& now, double now_s);
    // Saves the text of a crash report, at most every kEvery_s. Returns false if it is too early.
    bool note_report(const std::string& text, double now_s);
    // File in which to note a signal that ends the program: its number and a line feed, then anything else. Empty if
    // nothing is kept.
    std::filesystem::path signal_file() const;
    // The session ends normally.
    void end();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// $XDG_STATE_HOME/handrail/sessions, else ~/.local/state/...; empty if neither is known.
std::filesystem::path sessions_folder();

}  // namespace handrail::core
