// Describes sounds as text, for people who read instead of hearing. The text has the name of each sound and its
// direction, short and without brackets. Sounds that always come with a spoken text are left out. Sounds that repeat or
// continue are reported again only if their text has changed or some time has passed. Plain state; one thread.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "audio-cues/plan/sinks.h"

namespace handrail::cues {

class SoundWords {
public:
    static constexpr double kBeats_s = 3.0;    // a rhythmic sound is reported again after this time
    static constexpr double kGoesOn_s = 30.0;  // a continuous sound is reported again after this time

    // Returns the text for a sound that starts, or for a loop that sounds or changes. Returns an empty text if there is
    // nothing new.
    std::string describe(const SoundCue& cue, const Listener& ears, double now_s);
    // Call it when a loop has ended. The loop is then reported again when it returns.
    void forget(SoundKind kind, std::uint32_t source) { described_.erase({kind, source}); }

private:
    struct Described {
        std::string text;
        double time_s = 0.0;
    };
    std::map<std::pair<SoundKind, std::uint32_t>, Described> described_;
};

}  // namespace handrail::cues
