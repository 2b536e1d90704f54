// Sounds told as text: what each is called and at which side it is, for who reads instead of hearing. Short and without
// brackets; what always comes with words of its own is left out, and what beats or goes on is told again only when
// something about it has changed or some time has passed. Plain state; one thread.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "audio-cues/plan/sinks.h"

namespace handrail {

class SoundWords {
public:
    static constexpr double kBeats_s = 3.0;    // a rhythm is told again after this
    static constexpr double kGoesOn_s = 30.0;  // what sounds all the time

    // Of a sound that starts, or of a loop that is or changes; empty: nothing new.
    std::string tell(const SoundCue& cue, const Listener& ears, double now_s);
    // That loop has ended: told anew when it comes again.
    void forget(SoundKind kind, std::uint32_t source) { told_.erase({kind, source}); }

private:
    struct Told {
        std::string text;
        double time_s = 0.0;
    };
    std::map<std::pair<SoundKind, std::uint32_t>, Told> told_;
};

}  // namespace handrail
