// Plays the sounds at their places. OpenALVoices decides which sounds are heard, how loud, and from which direction for
// the listener's present position. Audio thread only, with the context current.
#pragma once

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/efx.h>

#include <array>
#include <cstdint>
#include <vector>

#include "audio-cues/plan/cue_planner.h"
#include "audio-cues/sinks/openal_room.h"
#include "audio-cues/sinks/sound_pack.h"
#include "audio-cues/sinks/synth.h"
#include "settings/settings.h"

namespace handrail::sinks {

// Time after which a silenced source is stopped. The mixer fades it within 5.3 ms.
inline constexpr double kFadeOut_s = 0.020;

// An OpenAL source and the sound that it plays.
struct SinkVoice {
    ALuint source = 0;
    bool active = false;
    bool leaving = false;  // a loop that fades to level 0 and then ends
    bool ending = false;   // the voice is fading and will be stopped at stop_at_s
    double stop_at_s = 0.0;
    cues::SoundCue cue;
    double level = 1.0;           // level of the fade, 0 to 1
    bool audible = true;          // false: muted, because there are too many sounds
    double may_sound_at_s = 0.0;  // a muted world sound stays muted until this time
    double muffled_db = 0.0;      // present value, which moves towards cue.muffled_db
    double filtered_db = -1.0;    // value of muffled_db for which the filter is set
    ALuint filter = 0;
    double pulse = 0.0;       // phase of the loop's swells, 0 to 1
    std::uint64_t order = 0;  // order of starting; a larger number is newer
};

// The person's hearing settings and position at this moment.
struct Listening {
    cues::Listener listener;
    settings::Settings::Sound sound;
    double now_s = 0.0;
};

class OpenALVoices {
public:
    // Number of voices for one-shots. It is more than can be heard at once, so that sounds beyond the limit can fade
    // out.
    static constexpr std::size_t kOneShots = 8;
    static constexpr std::size_t kOwnLoops = 3;  // the wall tone, and one slide loop for each hand
    // Number of voices for world sounds: those that are heard, and as many that are fading out.
    static constexpr std::size_t kWorldVoices = 6;
    // In this order: WallTone, Slide of each hand, then the world's loops.
    using Loops = std::array<SinkVoice, kOwnLoops + kWorldVoices>;

    // `hearing`, `room` and `pack` must outlive this object. `most` is the number of sounds that can be heard at once.
    OpenALVoices(const Listening& hearing, OpenALRoom& room, const SoundPack& pack, int most)
        : hearing_(hearing), room_(room), pack_(pack), most_(most) {}

    // Call load_filters() first; it returns false if OpenAL lacks the extension. Then call make_sources().
    bool load_filters(ALCdevice* device);
    void make_sources(bool filters);
    void drop_sources();
    void drop_buffers();

    void play(const cues::SoundCue& cue);
    void set_loop(const cues::SoundCue& cue);
    void stop_all();
    // Updates all voices. `spoken_over` says that the voice speaks, so that all sounds except danger are quieter.
    void update(double dt_s, bool spoken_over, double ducking_db);
    int playing() const;

    const Loops& loops() const { return loops_; }
    // Call it after a change of the device. The loops in `before` continue.
    void go_on(const Loops& before);

private:
    ALuint buffer_of(const cues::SoundCue& cue);
    bool muffle(SinkVoice& voice) const;
    void send_to_room(const SinkVoice& voice) const;
    void apply(SinkVoice& voice) const;
    void start(SinkVoice& voice, const cues::SoundCue& cue, double level);
    void end(SinkVoice& voice, bool at_once = true);
    SinkVoice& free_one_shot();
    SinkVoice* loop_of(const cues::SoundCue& cue);
    double strength(const SinkVoice& voice) const;
    std::vector<SinkVoice*> competing();
    void limit();
    void stop_ended_one_shots();
    void update_loop(SinkVoice& voice, double dt_s);

    const Listening& hearing_;
    OpenALRoom& room_;
    const SoundPack& pack_;
    int most_;
    LPALGENFILTERS gen_filters_ = nullptr;
    LPALDELETEFILTERS delete_filters_ = nullptr;
    LPALFILTERI filter_i_ = nullptr;
    LPALFILTERF filter_f_ = nullptr;
    std::array<ALuint, kSounds> buffers_{};  // buffers, indexed by sound_index(); 0: not created yet
    std::array<SinkVoice, kOneShots> one_shots_{};
    Loops loops_{};
    double duck_ = 1.0;
    std::uint64_t order_ = 0;
};

}  // namespace handrail::sinks
