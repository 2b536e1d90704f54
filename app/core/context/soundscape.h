// Which of the world's sounds reach the ears: how walls and doors muffle them, and which three are played. Pure
// functions and a small state over an immutable world; app thread. Cost: each tick traces at most eight of the sources
// in range.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/core/world/walker_world.h"
#include "audio-cues/plan/cue_planner.h"

namespace handrail::core {

// How many dB doors, walls and things between two places take from a sound, at high frequencies. Several lines around
// the head are averaged, not a single one, so a sound half behind an edge is half as audible. Whatever contains one of
// the two places does not count.
double muffling_db(const WalkerWorld& world, const Vec3& ears_m, const Vec3& source_m);

inline constexpr double kDoorMuffles_db = 14.0, kWallMuffles_db = 24.0, kThingMuffles_db = 3.0;
inline constexpr double kUnheard_db = 45.0;  // above this a sound is silent

// Reverberation time of the room around the ears, in seconds until a sound has decayed by 60 dB, by Sabine (0.161 V /
// A). Rays in all directions give volume and surface, the materials they hit give the absorption, and openings absorb
// everything. 0 outdoors. The error is within 10 % anywhere in an upright room with a convex outline.
double reverberation_s(const WalkerWorld& world, const Vec3& ears_m);

// A sound that a feature adds at a place.
struct AddedSound {
    cues::SoundKind kind = cues::SoundKind::Shimmer;
    Vec3 position_m{0.0};
    double loudness = 1.0;      // 0 to 1
    double pulses_per_s = 0.0;  // swells per second; 0: steady

    bool operator==(const AddedSound&) const = default;
};

class Soundscape {
public:
    static constexpr std::size_t kMost = 3;
    // A new sound replaces a playing one if it has been louder by this much for this long.
    static constexpr double kLouder_db = 3.0, kFor_s = 0.5;

    // Call it when another world is entered or the world has changed. Sounds that do not continue are stopped.
    void enter(const Scene& scene);
    // Sets the sounds that features add to those of the world; replaces the earlier ones.
    void add(const std::vector<AddedSound>& sounds);
    double reverberation_s() const { return reverberation_s_; }  // of the room around; measured twice a second
    // Follows the ears; adds what has changed since the last tick to `cues`.
    void tick(const WalkerWorld& world, const Vec3& ears_m, double now_s, std::vector<cues::CueRequest>& cues);

private:
    struct Source {
        cues::SoundKind kind = cues::SoundKind::Shimmer;
        Vec3 position_m{0.0};
        double loudness = 1.0, pulses_per_s = 0.0;
        double muffled_db = 0.0;
        double level_db = -1e9;  // at the ears
        bool known = false;      // muffling has been computed
        bool heard = false;
        double louder_since_s = 0.0;  // if not heard: since when it is loud enough to be
    };
    void choose(double now_s);

    std::vector<Source> sources_;
    std::size_t added_ = 0;               // number of added sounds, at the end of sources_
    std::size_t next_ = 0;                // source whose muffling is computed next
    std::vector<cues::CueRequest> told_;  // as last sent to the planner
    double reverberation_s_ = 0.0;
    double next_room_s_ = -1.0;  // when to measure the room again; negative: at once
};

// Steps through the sound dictionary, one entry at a time, and starts again at its end.
class SoundDictionary {
public:
    // The request to the planner: plays the entry `by` places further on in front of the listener.
    cues::CueRequest step(int by, const cues::Listener& listener, double now_s);

private:
    int shown_ = -1;  // none yet
};

}  // namespace handrail::core
