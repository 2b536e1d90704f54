// The reverberation of the surrounding room, as an OpenAL effect to which sounds are sent. Silent and without cost if
// the extension is missing. Audio thread only, with the context current.
#pragma once

#include <AL/al.h>
#include <AL/efx.h>

namespace handrail::sinks {

class OpenALRoom {
public:
    // Makes the effect of a room, if OpenAL has it. OpenAL's default balance of early and late sound stays: a plain
    // room.
    void make();
    void drop();
    // The reverberation is weak, and silent at once when all sound must stop. It follows changes of the room twice a
    // second. `share`: strength of its sound, 0 to 1.
    void update(double now_s, double reverberation_s, double share);
    void hush() { hushed_ = true; }
    void sound_again() { hushed_ = false; }

    // Connects a source to the room, through its filter if that has any effect; filter 0: none. OpenAL copies a filter
    // when it is attached.
    void send(ALuint source, bool in_room, ALuint filter) const;

private:
    LPALEFFECTF effect_f_ = nullptr;
    LPALAUXILIARYEFFECTSLOTI slot_i_ = nullptr;
    LPALAUXILIARYEFFECTSLOTF slot_f_ = nullptr;
    ALuint effect_ = 0, slot_ = 0;  // 0 if the extension is missing
    double room_s_ = 0.0;           // reverberation that the effect is set to
    double next_room_s_ = 0.0;      // time of the next permitted change
    double slot_gain_ = 0.0;
    bool hushed_ = false;  // until the next sound
};

}  // namespace handrail::sinks
