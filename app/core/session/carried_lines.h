// Typed lines, carried out one after the other: each begins when what the one before began is over, so a script reads
// as it happens. App thread.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/session/session.h"

namespace handrail {

class CarriedLines {
public:
    // The session outlives this object.
    explicit CarriedLines(Session& app) : app_(app) {}

    void add(std::string line) { lines_.push_back(std::move(line)); }
    std::size_t waiting() const { return lines_.size(); }
    // All lines that were added have been carried out, with all their repetitions.
    bool done() const { return lines_.empty() && repeat_left_ == 0 && choice_.empty(); }
    // Forgets what has not been carried out yet.
    void drop();
    // The same, and returns the lines, so that the caller can carry them out.
    std::vector<std::string> take_rest();
    // Takes the next line, so that the caller can carry it out. None if no line waits.
    std::optional<std::string> take_next();
    // The next line leaves the program or the world.
    bool next_leaves() const;
    // Once a frame, before the session's tick. False if there was nothing to do and nothing is waited for.
    bool take(double now_s);
    // A line asked to end the program.
    bool left() const { return left_; }

private:
    bool means_room(const std::string& choice) const;
    void carry_out(const std::string& line, double now_s);
    void choose(const std::string& choice, double now_s);
    void tap(Command command, int times, double now_s);

    Session& app_;
    std::deque<std::string> lines_;
    Command repeat_command_ = Command::Forward;
    std::string asked_by_;  // what to type for the list in which the choice was looked for first
    int repeat_left_ = 0;
    std::string choice_;             // to be made in the list that the last command opens
    bool looked_elsewhere_ = false;  // for the choice, in the other list too
    double settle_until_s_ = 0.0;
    bool left_ = false;
};

}  // namespace handrail
