#include "audio-cues/plan/sound_words.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "audio-cues/plan/sound_table.h"
#include "worlds/base/language.h"

namespace handrail::cues {
namespace {

// Returns true for sounds that always come with a spoken text: names of touched things, blocked steps, headings, alarms
// and speech.
bool has_words_of_its_own(SoundKind kind) {
    constexpr std::array kWith{SoundKind::Contact,  SoundKind::Slide,     SoundKind::Bump,     SoundKind::TurnTick,
                               SoundKind::ForcesOn, SoundKind::ForcesOff, SoundKind::StairsUp, SoundKind::StairsDown,
                               SoundKind::Alarm,    SoundKind::Beep};
    return std::find(kWith.begin(), kWith.end(), kind) != kWith.end();
}

bool goes_on(SoundKind kind) { return is_world_sound(kind) || kind == SoundKind::WallTone; }

// Returns "Door near" for "Door near: a door is before you".
std::string name_of(SoundKind kind) {
    std::string key = "sound." + std::string(info(kind).name);
    std::replace(key.begin(), key.end(), ' ', '_');
    const std::string text = phrase(key);
    return text.substr(0, text.find(':'));
}

// Returns the name of a floor's material as part of a sentence.
std::string material_word(SoundClass material) {
    if (material == SoundClass::Grille) return phrase("material.steel_grille");
    if (material == SoundClass::Water) return phrase("kind.water");
    return phrase("material." + std::string(material_sound_name(material)));
}

std::string side_of(const Vec3& place_m, const Listener& ears) {
    constexpr std::array kSides{"direction.ahead",        "direction.half_right", "direction.right",
                                "direction.behind_right", "direction.behind",     "direction.behind_left",
                                "direction.left",         "direction.half_left"};
    const Vec3 way = place_m - ears.ears_m;
    if (std::hypot(way.x, way.y) < 0.3) return {};
    return phrase(kSides[nearest_eighth(std::atan2(way.x, way.y) - ears.heading_rad)]);
}

}  // namespace

std::string SoundWords::describe(const SoundCue& cue, const Listener& ears, double now_s) {
    if (has_words_of_its_own(cue.kind)) return {};
    std::string text, side;
    if (cue.kind == SoundKind::Footstep) {
        // Only the floor's material is written. If the person types commands as words, the session has already reported
        // the step itself as text.
        if (cue.material == SoundClass::Generic) return {};
        text = phrase("sound_words.steps_on", {{"material", material_word(cue.material)}});
    } else {
        text = name_of(cue.kind);
        if (!is_earcon(cue.kind) && !is_beacon(cue.kind)) side = side_of(cue.position_m, ears);
        if (cue.kind == SoundKind::Beacon) side = side_of(cue.position_m, ears);
    }
    if (!side.empty()) text = phrase("words.joined", {{"one", text}, {"other", side}});
    // All three beacon sounds have one name, and a change between them is no new sound.
    const SoundKind kind = is_beacon(cue.kind) ? SoundKind::Beacon : cue.kind;
    Described& described = described_[{kind, cue.source}];
    const bool same = described.text == text;
    const bool steps = cue.kind == SoundKind::Footstep;
    const double wait_s = goes_on(cue.kind) ? kGoesOn_s : kBeats_s;
    if (same && (steps || now_s - described.time_s < wait_s)) return {};
    // Waits before it reports a continuing sound again. Otherwise a person who turns on the spot would get a line for
    // every sound whenever its direction changes.
    if (!same && goes_on(cue.kind) && !described.text.empty() && now_s - described.time_s < kBeats_s) return {};
    described = {text, now_s};
    return text;
}

}  // namespace handrail::cues
