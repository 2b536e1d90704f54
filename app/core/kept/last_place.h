// Where a session is, kept while it runs, so that after a crash, a kill or a power cut the next start can say so and go
// on there. Each session has a small file of its own in the folder `sessions` and holds a lock on it, which the system
// gives back however the session ends; a session that was left removes its file. So a file that nobody holds is the
// sign, and sessions beside each other never take one for another's crash. App thread only; written on a thread beside,
// at most every kEvery_s.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/core/kept/world_request.h"
#include "worlds/base/result.h"
#include "worlds/base/vec.h"

namespace handrail {

struct LastPlace {
    WorldRequest world;  // its file is absolute; what a lesson sets is not kept
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

// As the file has it. Reading fails with a sentence; never half a place.
std::string text_of(const LastPlace& place);
Result<LastPlace> read_last_place(const std::string& text);

class SessionTrace {
public:
    static constexpr double kEvery_s = 3.0;

    // Looks for sessions in `folder` that ended without being left, takes what they left away, and begins a file of its
    // own. Where the folder cannot be written or the file system knows no locks, nothing is kept and nothing is told.
    // An empty folder: the same.
    explicit SessionTrace(const std::filesystem::path& folder);
    ~SessionTrace();  // without end(): as if the program had crashed
    SessionTrace(const SessionTrace&) = delete;
    SessionTrace& operator=(const SessionTrace&) = delete;

    // A session before ended without being left; the last place of the latest one, where it had come to one.
    bool crashed() const;
    const std::optional<LastPlace>& left_at() const;
    // What is known of it, in a file of its own in the folder `crash-reports` beside `folder`; empty where nothing is.
    const std::filesystem::path& report() const;

    // Where one is now. Kept when kEvery_s have passed and it is elsewhere.
    void note(const LastPlace& now, double now_s);
    // What would be told of a crash, at most every kEvery_s; false: later.
    bool note_report(const std::string& text, double now_s);
    // Where a signal that ends the program is to be noted: its number and a line feed, then what else there is; empty
    // where nothing is kept.
    std::filesystem::path signal_file() const;
    // The session is left in good order.
    void end();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// $XDG_STATE_HOME/handrail/sessions, else ~/.local/state/...; empty when neither is known.
std::filesystem::path sessions_folder();

}  // namespace handrail
