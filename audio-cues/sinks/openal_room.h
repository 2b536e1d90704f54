// Renders the reverberation of the surrounding room, as an OpenAL effect to which sounds are sent. If OpenAL lacks the
// effects extension, there is no reverberation and no cost. Audio thread only, with the context current.
#pragma once

#include <AL/al.h>
#include <AL/efx.h>

namespace handrail::sinks {

class OpenALRoom {
public:
    // Creates the effect of a room, if OpenAL supports it. OpenAL's default balance of early and late sound is kept,
    // which suits a plain room.
    void make();
    void drop();
    // Adapts the weak reverberation to the room, at most twice a second. After hush(), the reverberation is silent at
    // once. `share` is the strength of the reverberation, 0 to 1.
    void update(double now_s, double reverberation_s, double share);
    void hush() { hushed_ = true; }
    void sound_again() { hushed_ = false; }

    // Connects a source to the room, through its filter if it has one; filter 0: none. OpenAL copies a filter when it
    // is attached.
    void send(ALuint source, bool in_room, ALuint filter) const;

private:
    LPALEFFECTF effect_f_ = nullptr;
    LPALAUXILIARYEFFECTSLOTI slot_i_ = nullptr;
    LPALAUXILIARYEFFECTSLOTF slot_f_ = nullptr;
    ALuint effect_ = 0, slot_ = 0;  // effect and its slot; 0 if OpenAL lacks the extension
    double room_s_ = 0.0;           // reverberation time for which the effect is set up
    double next_room_s_ = 0.0;      // earliest time of the next change
    double slot_gain_ = 0.0;
    bool hushed_ = false;  // true until the next sound starts
};

}  // namespace handrail::sinks
