// The reverberation of the room around, as an effect of OpenAL's that sounds are sent to. Silent and without cost where
// there is no such extension. The audio thread, with the context current.
#pragma once

#include <AL/al.h>
#include <AL/efx.h>

namespace handrail {

class OpenALRoom {
public:
    // The effect of a room, if OpenAL has it. Its own shares of early and late sound stay as they are: a plain room.
    void make();
    void drop();
    // Weak, and silent at once when all sound is to stop; a room that changes is followed twice a second. `share`: of
    // its sound, 0 to 1.
    void update(double now_s, double reverberation_s, double share);
    void hush() { hushed_ = true; }
    void sound_again() { hushed_ = false; }

    // Sounds are sent there, through their filter where it has any effect; 0: none. A filter is copied when it is
    // attached.
    void send(ALuint source, bool in_room, ALuint filter) const;

private:
    LPALEFFECTF effect_f_ = nullptr;
    LPALAUXILIARYEFFECTSLOTI slot_i_ = nullptr;
    LPALAUXILIARYEFFECTSLOTF slot_f_ = nullptr;
    ALuint effect_ = 0, slot_ = 0;  // 0 where there is no such extension
    double room_s_ = 0.0;           // reverberation as the effect has it
    double next_room_s_ = 0.0;      // when it may follow again
    double slot_gain_ = 0.0;
    bool hushed_ = false;  // until something sounds
};

}  // namespace handrail
