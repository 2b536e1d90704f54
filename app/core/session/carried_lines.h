// Carries out typed lines one after the other. Each line begins when the effect of the previous line is over, so that a
// script does what a reader expects. Use it on the app thread.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/session/session.h"

namespace handrail::core {

class CarriedLines {
public:
    // `app` must outlive this object.
    explicit CarriedLines(Session& app) : app_(app) {}

    void add(std::string line) { lines_.push_back(std::move(line)); }
    std::size_t waiting() const { return lines_.size(); }
    // Returns true if all added lines have been carried out, including their repetitions.
    bool done() const { return lines_.empty() && repeat_left_ == 0; }
    // Drops all lines that have not been carried out.
    void drop();
    // Drops all lines that have not been carried out, and returns them, so that the caller can carry them out.
    std::vector<std::string> take_rest();
    // Removes and returns the next line, so that the caller can carry it out. Returns no value if no line waits.
    std::optional<std::string> take_next();
    // Returns true if the next line leaves the program or the world.
    bool next_leaves() const;
    // Carries out the next line if it is time. Call it once a frame, before the session's tick. Returns false if there
    // was nothing to do and nothing to wait for.
    bool take(double now_s);
    // Returns true if a line requested the end of the program.
    bool left() const { return left_; }

private:
    void carry_out(const std::string& line, double now_s);
    void tap(Command command, int times, double now_s);

    Session& app_;
    std::deque<std::string> lines_;
    Command repeat_command_ = Command::Forward;
    int repeat_left_ = 0;
    double settle_until_s_ = 0.0;
    bool left_ = false;
};

}  // namespace handrail::core
