#include "audio-cues/sinks/openal_room.h"

#include <algorithm>

#include "worlds/base/contract.h"

namespace handrail::sinks {
namespace {

// The reverberation effect is changed only if the reverberation time has changed by the factor kRoomChange, and at most
// once in kRoom_s.
constexpr double kRoomChange = 1.08, kRoom_s = 0.5;
// OpenAL Soft 1.19.1 reverberates for this much longer than requested, as measured from 0.3 to 4 s.
constexpr double kEffectLonger_s = 0.045;

}  // namespace

void OpenALRoom::make() {
    effect_ = slot_ = 0;
    const auto gen_effects = reinterpret_cast<LPALGENEFFECTS>(alGetProcAddress("alGenEffects"));
    const auto effect_i = reinterpret_cast<LPALEFFECTI>(alGetProcAddress("alEffecti"));
    const auto gen_slots = reinterpret_cast<LPALGENAUXILIARYEFFECTSLOTS>(alGetProcAddress("alGenAuxiliaryEffectSlots"));
    effect_f_ = reinterpret_cast<LPALEFFECTF>(alGetProcAddress("alEffectf"));
    slot_i_ = reinterpret_cast<LPALAUXILIARYEFFECTSLOTI>(alGetProcAddress("alAuxiliaryEffectSloti"));
    slot_f_ = reinterpret_cast<LPALAUXILIARYEFFECTSLOTF>(alGetProcAddress("alAuxiliaryEffectSlotf"));
    if (gen_effects == nullptr || effect_i == nullptr || gen_slots == nullptr || effect_f_ == nullptr ||
        slot_i_ == nullptr || slot_f_ == nullptr)
        return;
    gen_effects(1, &effect_);
    effect_i(effect_, AL_EFFECT_TYPE, AL_EFFECT_EAXREVERB);
    effect_i(effect_, AL_EAXREVERB_DECAY_HFLIMIT, AL_FALSE);
    effect_f_(effect_, AL_EAXREVERB_DECAY_HFRATIO, 1.0F);
    effect_f_(effect_, AL_EAXREVERB_GAIN, 1.0F);
    gen_slots(1, &slot_);
    slot_f_(slot_, AL_EFFECTSLOT_GAIN, 0.0F);
    room_s_ = slot_gain_ = 0.0;
    if (alGetError() == AL_NO_ERROR) return;
    drop();
}

void OpenALRoom::drop() {
    if (slot_ != 0)
        reinterpret_cast<LPALDELETEAUXILIARYEFFECTSLOTS>(alGetProcAddress("alDeleteAuxiliaryEffectSlots"))(1, &slot_);
    if (effect_ != 0) reinterpret_cast<LPALDELETEEFFECTS>(alGetProcAddress("alDeleteEffects"))(1, &effect_);
    effect_ = slot_ = 0;
    alGetError();
}

void OpenALRoom::update(double now_s, double reverberation_s, double share) {
    contract_pre(share >= 0.0 && share <= 1.0);
    if (slot_ == 0) return;
    const double wanted_s = std::clamp(reverberation_s, 0.0, 8.0);
    const double gain = wanted_s <= 0.0 || hushed_ ? 0.0 : share;
    if (gain != slot_gain_) slot_f_(slot_, AL_EFFECTSLOT_GAIN, static_cast<float>(slot_gain_ = gain));
    const bool changed = wanted_s > room_s_ * kRoomChange || wanted_s * kRoomChange < room_s_;
    if (gain <= 0.0 || !changed || now_s < next_room_s_) return;
    room_s_ = wanted_s;
    next_room_s_ = now_s + kRoom_s;
    effect_f_(effect_, AL_EAXREVERB_DECAY_TIME, static_cast<float>(std::max(room_s_ - kEffectLonger_s, 0.1)));
    slot_i_(slot_, AL_EFFECTSLOT_EFFECT, static_cast<ALint>(effect_));
}

void OpenALRoom::send(ALuint source, bool in_room, ALuint filter) const {
    if (slot_ == 0) return;
    alSource3i(source, AL_AUXILIARY_SEND_FILTER, in_room ? static_cast<ALint>(slot_) : AL_EFFECTSLOT_NULL, 0,
               in_room && filter != 0 ? static_cast<ALint>(filter) : AL_FILTER_NULL);
}

}  // namespace handrail::sinks
