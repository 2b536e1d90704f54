// Sounds as text: the name of each and its direction, for people who read instead of hearing. Short and without
// brackets. Sounds that always come with words are left out. Sounds that repeat or continue are reported again only if
// something about them has changed or some time has passed. Plain state; one thread.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "audio-cues/plan/sinks.h"

namespace handrail::cues {

class SoundWords {
public:
    static constexpr double kBeats_s = 3.0;    // after this a rhythmic sound is reported again
    static constexpr double kGoesOn_s = 30.0;  // after this a continuous sound is reported again

    // Returns the text for a sound that starts, or for a loop that sounds or changes; empty: nothing new.
    std::string tell(const SoundCue& cue, const Listener& ears, double now_s);
    // The loop has ended, so it is reported again when it comes again.
    void forget(SoundKind kind, std::uint32_t source) { told_.erase({kind, source}); }

private:
    struct Told {
        std::string text;
        double time_s = 0.0;
    };
    std::map<std::pair<SoundKind, std::uint32_t>, Told> told_;
};

}  // namespace handrail::cues
