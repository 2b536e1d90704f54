// Which of the world's sounds reach the ears: how they come there past walls and doors, and which three of them are
// heard. Pure functions and a small state over an immutable world; app thread. Cost: of the sources in range at most
// eight are followed each tick.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/core/world/body_world.h"
#include "audio-cues/plan/cue_planner.h"

namespace handrail {

// What doors, walls and things between two places take from a sound, in dB, high tones apart. Around the head, not
// through a single line: a sound that is half behind an edge is half heard. What either end stands in does not count.
double muffling_db(const BodyWorld& world, const Vec3& ears_m, const Vec3& source_m);

inline constexpr double kDoorMuffles_db = 14.0, kWallMuffles_db = 24.0, kThingMuffles_db = 3.0;
inline constexpr double kUnheard_db = 45.0;  // more than this on the way is silence

// How long the room around these ears reverberates, in seconds until 60 dB are gone, by Sabine (0.161 V / A): volume
// and surface from rays all round, absorption from what they meet; openings swallow all. 0 in the open. Within 10 % for
// an upright room with convex outline, wherever one stands in it.
double reverberation_s(const BodyWorld& world, const Vec3& ears_m);

// A sound that a feature lets a place make.
struct AddedSound {
    SoundKind kind = SoundKind::Shimmer;
    Vec3 position_m{0.0};
    double loudness = 1.0;      // 0 to 1
    double pulses_per_s = 0.0;  // swells that often; 0: steady

    bool operator==(const AddedSound&) const = default;
};

class Soundscape {
public:
    static constexpr std::size_t kMost = 3;
    // A sound that is not heard yet takes the place of one that is when it is louder by this for so long.
    static constexpr double kLouder_db = 3.0, kFor_s = 0.5;

    // Another world, or the same one changed: what sounds is told to stop unless it goes on.
    void enter(const Scene& scene);
    // Sounds beside those of the world, in place of what was added before.
    void add(const std::vector<AddedSound>& sounds);
    double reverberation_s() const { return reverberation_s_; }  // of the room around, found out twice a second
    // Follows the ears; what changed since the last tick goes to `cues`.
    void tick(const BodyWorld& world, const Vec3& ears_m, double now_s, std::vector<CueRequest>& cues);

private:
    struct Source {
        SoundKind kind = SoundKind::Shimmer;
        Vec3 position_m{0.0};
        double loudness = 1.0, pulses_per_s = 0.0;
        double muffled_db = 0.0;
        double level_db = -1e9;  // at the ears
        bool known = false;      // muffling was computed
        bool heard = false;
        double louder_since_s = 0.0;  // not heard: since when it would deserve to be
    };
    void choose(double now_s);

    std::vector<Source> sources_;
    std::size_t added_ = 0;         // the last of them
    std::size_t next_ = 0;          // whose way is followed next
    std::vector<CueRequest> told_;  // as the planner knows it
    double reverberation_s_ = 0.0;
    double next_room_s_ = -1.0;  // when to look at the room again; negative: at once
};

// Goes through the sound dictionary, one entry a step, and round.
class SoundDictionary {
public:
    // What the planner is to show: the entry `by` further on, played in front of the listener.
    CueRequest step(int by, const Listener& listener, double now_s);

private:
    int shown_ = -1;  // none yet
};

}  // namespace handrail
