// Selects the sounds of the world that reach the ears: it computes how much walls and doors muffle each sound, and
// which sounds are played, usually three. It consists of pure functions, and of a small state over an immutable world.
// Use it on the app thread only. Each tick traces at most eight of the sources in range.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "app/core/context/spotlight.h"
#include "app/core/world/walker_world.h"
#include "audio-cues/plan/cue_planner.h"

namespace handrail::core {

// Returns by how many dB doors, walls and things between the ears and the source weaken a sound at high frequencies.
// The value is the average over several lines around the head, so a sound half behind an edge is half as audible. A
// solid that contains the ears or the source does not muffle the sound.
double muffling_db(const WalkerWorld& world, const Vec3& ears_m, const Vec3& source_m);

inline constexpr double kDoorMuffles_db = 14.0, kWallMuffles_db = 24.0, kThingMuffles_db = 3.0;
inline constexpr double kUnheard_db = 45.0;  // with more muffling than this, a sound is inaudible

// Returns the reverberation time of the room around the ears: the seconds in which a sound decays by 60 dB, by Sabine's
// formula (0.161 V / A). Rays in all directions measure the volume and surface, and the materials they hit give the
// absorption. Openings absorb all sound. Returns 0 outdoors. The error is within 10 % anywhere in an upright room with
// a convex outline.
double reverberation_s(const WalkerWorld& world, const Vec3& ears_m);

// A sound that a feature adds at a fixed place.
struct AddedSound {
    cues::SoundKind kind = cues::SoundKind::Shimmer;
    Vec3 position_m{0.0};
    double loudness = 1.0;      // loudness from 0 to 1
    double pulses_per_s = 0.0;  // how often a second the sound swells; 0: it is steady

    bool operator==(const AddedSound&) const = default;
};

// Limits what is played, by the person's settings.
struct SoundLimits {
    std::optional<Spotlight> spotlight = {};  // a value: sources outside this beam are silent
    std::size_t most = 3;                     // greatest number of sources that play at once
};

class Soundscape {
public:
    // A new sound replaces a playing sound if the new one has been louder by at least kLouder_db for kFor_s.
    static constexpr double kLouder_db = 3.0, kFor_s = 0.5;

    // Stops the sounds that `scene` does not contain. Call it when another world is entered or when the world has
    // changed.
    void enter(const Scene& scene);
    // Sets the sounds that features add to the sounds of the world. This list replaces the list of the previous call.
    void add(const std::vector<AddedSound>& sounds);
    // Reverberation time in seconds of the room around the ears; measured twice a second.
    double reverberation_s() const { return reverberation_s_; }
    // Selects the sounds for the position of the ears, and appends the changes since the last tick to `cues`.
    void tick(const WalkerWorld& world, const Vec3& ears_m, double now_s, std::vector<cues::CueRequest>& cues,
              const SoundLimits& limits = {});

private:
    struct Source {
        cues::SoundKind kind = cues::SoundKind::Shimmer;
        Vec3 position_m{0.0};
        double loudness = 1.0, pulses_per_s = 0.0;
        double muffled_db = 0.0;
        double level_db = -1e9;  // level of the sound at the ears
        bool known = false;      // true: the muffling of this source has been computed
        bool heard = false;
        // For a source that is not playing: time since which it has been loud enough to play.
        double louder_since_s = 0.0;
    };
    void choose(std::size_t most, double now_s);

    std::vector<Source> sources_;
    std::size_t added_ = 0;               // number of added sounds, at the end of sources_
    std::size_t next_ = 0;                // source whose muffling is computed next
    std::vector<cues::CueRequest> sent_;  // the requests that were sent to the planner last
    double reverberation_s_ = 0.0;
    double next_room_s_ = -1.0;  // time of the next measurement of the reverberation; negative: at once
};

// Steps through the sound dictionary entry by entry, and starts again after the last entry.
class SoundDictionary {
public:
    // Returns the request that plays the entry `by` places after the present one, in front of the listener.
    cues::CueRequest step(int by, const cues::Listener& listener, double now_s);

private:
    int shown_ = -1;  // index of the entry that was played last; -1: none yet
};

}  // namespace handrail::core
