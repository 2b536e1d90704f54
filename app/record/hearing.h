// Plays a recording back to a listener: its lines and knocks at their times, faster or slower, with pause and jumps.
// The playback pauses while the current voice needs longer for a line than the recorded voice did. Pure logic; the
// owner of the voice calls `go_on`.
#pragma once

#include <vector>

#include "app/record/recording.h"

namespace handrail::record {

class Hearing {
public:
    static constexpr double kSlowest = 0.5, kFastest = 4.0, kJump_s = 10.0;

    struct Knock {
        Vec3 at_m{0.0};
        double force_n = 0.0;
    };
    struct Heard {
        std::vector<SaidLine> lines;  // lines that became due; only the last of them has to be spoken
        std::vector<Knock> knocks;
    };

    // `recording` must outlive this object. `speed` must be from kSlowest to kFastest.
    Hearing(const Recording& recording, double speed);

    // Advances the playback by `dt_s` of real time, and returns what is heard in that time. `speaking`: the voice is
    // still speaking the lines that were returned before.
    Heard go_on(double dt_s, bool speaking);
    void stop_or_go_on() { stopped_ = !stopped_; }
    bool stopped() const { return stopped_; }
    // Jumps forwards or backwards by this time, but not beyond the ends of the recording.
    void jump(double by_s);

    double at_s() const { return at_s_; }  // current time, from the beginning of the recording
    double length_s() const { return length_s_; }
    bool over() const { return at_s_ >= length_s_ && next_ >= events_.size(); }
    // Returns where the walker was at the current time; null before the first tick.
    const FrameRow* place() const;

private:
    struct Event {
        double t_s = 0.0;
        SaidLine line;
        bool is_line = false;
        Knock knock;
    };

    const Recording& recording_;
    double speed_;
    std::vector<Event> events_;
    std::size_t next_ = 0;
    double at_s_ = 0.0, length_s_ = 0.0;
    bool stopped_ = false;
};

}  // namespace handrail::record
