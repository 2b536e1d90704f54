#include "audio-cues/plan/sound_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::cues {
namespace {

using Sound = settings::Settings::Sound;

constexpr SoundInfo world(SoundKind kind, std::string_view name) {
    return {kind, name, &Sound::world_volume, &Sound::world};
}

constexpr std::array kTable{
    SoundInfo{SoundKind::Contact, "contact", &Sound::contact_volume, &Sound::contact},
    SoundInfo{SoundKind::Slide, "slide", &Sound::contact_volume, &Sound::slide},
    SoundInfo{SoundKind::Footstep, "footstep", &Sound::footstep_volume, &Sound::footstep},
    SoundInfo{SoundKind::Bump, "bump", &Sound::footstep_volume, &Sound::bump},
    SoundInfo{SoundKind::WallTone, "wall tone", &Sound::wall_tone_volume, &Sound::wall_tone},
    SoundInfo{SoundKind::Splash, "splash", &Sound::contact_volume, &Sound::splash},
    SoundInfo{SoundKind::DoorMoves, "door moves", &Sound::world_volume, &Sound::door},
    SoundInfo{SoundKind::DoorShuts, "door shuts", &Sound::world_volume, &Sound::door},
    SoundInfo{SoundKind::Bell, "bell", &Sound::earcon_volume, nullptr},
    SoundInfo{SoundKind::Corner, "corner", &Sound::earcon_volume, &Sound::corner},
    SoundInfo{SoundKind::Opening, "opening", &Sound::earcon_volume, &Sound::corner},
    SoundInfo{SoundKind::DropNear, "drop", &Sound::earcon_volume, &Sound::drop},
    SoundInfo{SoundKind::StairsUp, "stairs up", &Sound::earcon_volume, &Sound::ways},
    SoundInfo{SoundKind::StairsDown, "stairs down", &Sound::earcon_volume, &Sound::ways},
    SoundInfo{SoundKind::DoorNear, "door near", &Sound::world_volume, &Sound::ways},
    SoundInfo{SoundKind::Falls, "falls", &Sound::world_volume, &Sound::world},
    SoundInfo{SoundKind::Knock, "knock", &Sound::world_volume, &Sound::world},
    SoundInfo{SoundKind::Border, "border", &Sound::world_volume, &Sound::world},
    SoundInfo{SoundKind::Mark, "mark", &Sound::earcon_volume, &Sound::marks},
    SoundInfo{SoundKind::Landmark, "landmark", &Sound::earcon_volume, &Sound::marks},
    SoundInfo{SoundKind::Clue, "clue", &Sound::earcon_volume, &Sound::marks},
    SoundInfo{SoundKind::Beacon, "beacon", &Sound::beacon_volume, &Sound::beacon},
    SoundInfo{SoundKind::BeaconAhead, "beacon ahead", &Sound::beacon_volume, &Sound::beacon},
    SoundInfo{SoundKind::BeaconBehind, "beacon behind", &Sound::beacon_volume, &Sound::beacon},
    world(SoundKind::Hum, "hum"),
    world(SoundKind::Buzz, "buzz"),
    world(SoundKind::Drone, "drone"),
    world(SoundKind::Drip, "drip"),
    world(SoundKind::Wind, "wind"),
    world(SoundKind::Swamp, "swamp"),
    world(SoundKind::Thunder, "thunder"),
    world(SoundKind::Stream, "stream"),
    world(SoundKind::Fire, "fire"),
    world(SoundKind::Clock, "clock"),
    world(SoundKind::Fan, "fan"),
    world(SoundKind::Rain, "rain"),
    world(SoundKind::Birds, "birds"),
    world(SoundKind::Tolling, "tolling"),
    world(SoundKind::Music, "music"),
    world(SoundKind::HiddenClock, "hidden clock"),
    world(SoundKind::Shimmer, "shimmer"),
    SoundInfo{SoundKind::Denied, "denied", &Sound::earcon_volume, &Sound::denied},
    SoundInfo{SoundKind::ForcesOn, "forces on", &Sound::earcon_volume, &Sound::forces},
    SoundInfo{SoundKind::ForcesOff, "forces off", &Sound::earcon_volume, &Sound::forces},
    SoundInfo{SoundKind::TurnTick, "turn", &Sound::earcon_volume, &Sound::turn},
    SoundInfo{SoundKind::FrameSwitch, "frame switch", &Sound::earcon_volume, &Sound::frame},
    SoundInfo{SoundKind::Arrived, "arrived", &Sound::earcon_volume, &Sound::arrived},
    SoundInfo{SoundKind::Rim, "rim", &Sound::earcon_volume, &Sound::workspace},
    SoundInfo{SoundKind::RimBack, "rim back", &Sound::earcon_volume, &Sound::workspace},
    SoundInfo{SoundKind::Grab, "grab", &Sound::earcon_volume, &Sound::workspace},
    SoundInfo{SoundKind::LetGo, "let go", &Sound::earcon_volume, &Sound::workspace},
    SoundInfo{SoundKind::Click, "click", &Sound::earcon_volume, &Sound::desk},
    SoundInfo{SoundKind::GuideStart, "guide start", &Sound::earcon_volume, &Sound::guide},
    SoundInfo{SoundKind::GuideStop, "guide stop", &Sound::earcon_volume, &Sound::guide},
    SoundInfo{SoundKind::Warmer, "warmer", &Sound::beacon_volume, &Sound::beacon},
    SoundInfo{SoundKind::Colder, "colder", &Sound::beacon_volume, &Sound::beacon},
    SoundInfo{SoundKind::Alarm, "alarm", &Sound::earcon_volume, nullptr},
    SoundInfo{SoundKind::Beep, "beep", &Sound::earcon_volume, nullptr},
};
static_assert(kTable.size() == kSoundKinds);
constexpr bool in_order() {
    for (std::size_t i = 0; i < kTable.size(); ++i)
        if (static_cast<std::size_t>(kTable[i].kind) != i) return false;
    return true;
}
static_assert(in_order());

constexpr std::array<std::string_view, static_cast<std::size_t>(SoundClass::Generic) + 1> kMaterials{
    "plaster", "wood",  "brick",   "concrete", "tile", "carpet", "metal", "glass",  "stone",  "rubber",
    "grass",   "water", "plastic", "cloth",    "sand", "earth",  "ice",   "grille", "generic"};

// The first match decides, so a long word must come before any word that it contains.
struct WordRow {
    std::string_view word;
    SoundKind kind;
};
constexpr std::array kWords{
    WordRow{"thunder", SoundKind::Thunder},  WordRow{"storm", SoundKind::Thunder},
    WordRow{"explo", SoundKind::Thunder},    WordRow{"drip", SoundKind::Drip},
    WordRow{"drop", SoundKind::Drip},        WordRow{"leak", SoundKind::Drip},
    WordRow{"waterfall", SoundKind::Stream}, WordRow{"fountain", SoundKind::Stream},
    WordRow{"stream", SoundKind::Stream},    WordRow{"river", SoundKind::Stream},
    WordRow{"water", SoundKind::Stream},     WordRow{"splash", SoundKind::Stream},
    WordRow{"fire", SoundKind::Fire},        WordRow{"flame", SoundKind::Fire},
    WordRow{"torch", SoundKind::Fire},       WordRow{"lava", SoundKind::Fire},
    WordRow{"candle", SoundKind::Fire},      WordRow{"hiddenclock", SoundKind::HiddenClock},
    WordRow{"clock", SoundKind::Clock},      WordRow{"tick", SoundKind::Clock},
    WordRow{"watch", SoundKind::Clock},      WordRow{"swamp", SoundKind::Swamp},
    WordRow{"frog", SoundKind::Swamp},       WordRow{"cricket", SoundKind::Swamp},
    WordRow{"wind", SoundKind::Wind},        WordRow{"draught", SoundKind::Wind},
    WordRow{"suck", SoundKind::Wind},        WordRow{"breeze", SoundKind::Wind},
    WordRow{"rain", SoundKind::Rain},        WordRow{"snow", SoundKind::Wind},
    WordRow{"bird", SoundKind::Birds},       WordRow{"bell", SoundKind::Tolling},
    WordRow{"chime", SoundKind::Tolling},    WordRow{"toll", SoundKind::Tolling},
    WordRow{"music", SoundKind::Music},      WordRow{"radio", SoundKind::Music},
    WordRow{"song", SoundKind::Music},       WordRow{"speaker", SoundKind::Music},
    WordRow{"piano", SoundKind::Music},      WordRow{"steam", SoundKind::Fan},
    WordRow{"smoke", SoundKind::Fan},        WordRow{"vent", SoundKind::Fan},
    WordRow{"fan", SoundKind::Fan},          WordRow{"buzz", SoundKind::Buzz},
    WordRow{"flour", SoundKind::Buzz},       WordRow{"fluor", SoundKind::Buzz},
    WordRow{"spark", SoundKind::Buzz},       WordRow{"lamp", SoundKind::Buzz},
    WordRow{"electric", SoundKind::Buzz},    WordRow{"drone", SoundKind::Drone},
    WordRow{"machine", SoundKind::Drone},    WordRow{"engine", SoundKind::Drone},
    WordRow{"motor", SoundKind::Drone},      WordRow{"generator", SoundKind::Drone},
    WordRow{"hum", SoundKind::Hum},          WordRow{"comp", SoundKind::Hum},
    WordRow{"fridge", SoundKind::Hum},
};

}  // namespace

std::span<const SoundInfo> sound_table() { return kTable; }

const SoundInfo& info(SoundKind kind) { return kTable[static_cast<std::size_t>(kind)]; }

std::string_view material_sound_name(SoundClass material) { return kMaterials[static_cast<std::size_t>(material)]; }

std::vector<DictionaryEntry> sound_dictionary() {
    std::vector<DictionaryEntry> all;
    for (const SoundInfo& row : kTable)
        if (row.kind != SoundKind::Contact) {
            std::string key = fmt::format("sound.{}", row.name);
            std::replace(key.begin(), key.end(), ' ', '_');
            all.push_back({row.kind, SoundClass::Wood, phrase(key)});
        }
    for (int m = 0; m < static_cast<int>(SoundClass::Generic); ++m) {
        const auto material = static_cast<SoundClass>(m);
        all.push_back(
            {SoundKind::Contact, material, phrase(fmt::format("sound_contact.{}", material_sound_name(material)))});
    }
    return all;
}

SoundKind world_sound_of(std::string_view word) {
    std::string letters = lower_ascii(word);
    std::erase_if(letters, [](char c) { return c < 'a' || c > 'z'; });
    // In maps, the class names of such entities begin with "ambient", which says nothing about the sound.
    if (letters.starts_with("ambient")) letters.erase(0, 7);
    for (const WordRow& row : kWords)
        if (letters.find(row.word) != std::string::npos) return row.kind;
    return SoundKind::Shimmer;
}

double distance_gain(SoundKind kind, double distance_m) {
    contract_pre(distance_m >= 0.0);
    if (is_earcon(kind)) return 1.0;
    if (is_world_sound(kind)) {
        // Sounds fade out over this last part of their range, so that none begins suddenly.
        constexpr double kFades_m = 10.0;
        return std::clamp((kWorldSoundRange_m - distance_m) / kFades_m, 0.0, 1.0) / std::max(1.0, distance_m);
    }
    // A beacon stays audible at any distance.
    constexpr double kNear_m = 2.0, kRollOff = 0.5, kBeaconLeast = 0.35;
    const double gain = kNear_m / (kNear_m + kRollOff * std::max(0.0, distance_m - kNear_m));
    return is_beacon(kind) ? std::max(gain, kBeaconLeast) : gain;
}

}  // namespace handrail::cues
