#include "audio-cues/plan/sound_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "audio-cues/plan/speakable.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

using Sound = Settings::Sound;

constexpr SoundInfo world(SoundKind kind, std::string_view name, std::string_view meaning) {
    return {kind, name, meaning, &Sound::world_volume, &Sound::world};
}

constexpr std::array kTable{
    SoundInfo{SoundKind::Contact, "contact", "the hand meets a surface", &Sound::contact_volume, &Sound::contact},
    SoundInfo{SoundKind::Slide, "slide", "the hand slides along a surface", &Sound::contact_volume, &Sound::slide},
    SoundInfo{SoundKind::Footstep, "footstep", "a step, on the floor you hear", &Sound::footstep_volume, &Sound::footstep},
    SoundInfo{SoundKind::Bump, "bump", "you walked into something", &Sound::footstep_volume, &Sound::bump},
    SoundInfo{SoundKind::WallTone, "wall tone", "a wall is near, on the side you hear it; louder the nearer", &Sound::wall_tone_volume, &Sound::wall_tone},
    SoundInfo{SoundKind::Splash, "splash", "hand or body is in a liquid", &Sound::contact_volume, &Sound::splash},
    SoundInfo{SoundKind::DoorMoves, "door moves", "a door, lift or button sets off", &Sound::world_volume, &Sound::door},
    SoundInfo{SoundKind::DoorShuts, "door shuts", "a door is shut again", &Sound::world_volume, &Sound::door},
    SoundInfo{SoundKind::Bell, "bell", "tells which ear is which", &Sound::earcon_volume, nullptr},
    SoundInfo{SoundKind::Corner, "corner", "two walls meet here", &Sound::earcon_volume, &Sound::corner},
    SoundInfo{SoundKind::Opening, "opening", "the wall beside you is open here", &Sound::earcon_volume, &Sound::corner},
    SoundInfo{SoundKind::DropNear, "drop", "an edge is ahead; faster the nearer", &Sound::earcon_volume, &Sound::drop},
    SoundInfo{SoundKind::StairsUp, "stairs up", "stairs up are ahead", &Sound::earcon_volume, &Sound::ways},
    SoundInfo{SoundKind::StairsDown, "stairs down", "stairs down are ahead", &Sound::earcon_volume, &Sound::ways},
    SoundInfo{SoundKind::DoorNear, "door near", "a door is before you; faster the nearer", &Sound::world_volume, &Sound::ways},
    SoundInfo{SoundKind::Mark, "mark", "hand or body is near a mark that you set", &Sound::earcon_volume, &Sound::marks},
    SoundInfo{SoundKind::Landmark, "landmark", "you touch or pass a landmark, which stays where it is", &Sound::earcon_volume, &Sound::marks},
    SoundInfo{SoundKind::Clue, "clue", "you touch or pass a clue, which may change", &Sound::earcon_volume, &Sound::marks},
    SoundInfo{SoundKind::Beacon, "beacon", "where you want to go is at this side; faster the nearer", &Sound::beacon_volume, &Sound::beacon},
    SoundInfo{SoundKind::BeaconAhead, "beacon ahead", "where you want to go is straight ahead", &Sound::beacon_volume, &Sound::beacon},
    SoundInfo{SoundKind::BeaconBehind, "beacon behind", "where you want to go is behind you", &Sound::beacon_volume, &Sound::beacon},
    world(SoundKind::Hum, "hum", "a computer or other machine that hums"),
    world(SoundKind::Buzz, "buzz", "a lamp or transformer"),
    world(SoundKind::Drone, "drone", "a large machine or engine"),
    world(SoundKind::Drip, "drip", "dripping water"),
    world(SoundKind::Wind, "wind", "wind or a draught"),
    world(SoundKind::Swamp, "swamp", "a swamp, with its animals"),
    world(SoundKind::Thunder, "thunder", "thunder far away"),
    world(SoundKind::Stream, "stream", "running water, a fountain"),
    world(SoundKind::Fire, "fire", "a fire or a torch"),
    world(SoundKind::Clock, "clock", "a ticking clock"),
    world(SoundKind::Fan, "fan", "a fan or steam"),
    world(SoundKind::Rain, "rain", "rain"),
    world(SoundKind::Birds, "birds", "birds"),
    world(SoundKind::Tolling, "tolling", "a bell in the distance"),
    world(SoundKind::Music, "music", "music or a loudspeaker"),
    world(SoundKind::Shimmer, "shimmer", "something else that sounds or glitters"),
    SoundInfo{SoundKind::Denied, "denied", "this cannot be done", &Sound::earcon_volume, &Sound::denied},
    SoundInfo{SoundKind::ForcesOn, "forces on", "forces are on", &Sound::earcon_volume, &Sound::forces},
    SoundInfo{SoundKind::ForcesOff, "forces off", "forces are off", &Sound::earcon_volume, &Sound::forces},
    SoundInfo{SoundKind::TurnTick, "turn", "you turned by one notch", &Sound::earcon_volume, &Sound::turn},
    SoundInfo{SoundKind::FrameSwitch, "frame switch", "changed between Map and Walk", &Sound::earcon_volume, &Sound::frame},
    SoundInfo{SoundKind::Arrived, "arrived", "you have arrived", &Sound::earcon_volume, &Sound::arrived},
    SoundInfo{SoundKind::Rim, "rim", "the hand is past the rim and the workspace moves on", &Sound::earcon_volume, &Sound::workspace},
    SoundInfo{SoundKind::RimBack, "rim back", "the hand is back inside the rim", &Sound::earcon_volume, &Sound::workspace},
    SoundInfo{SoundKind::Grab, "grab", "the world goes along with the hand", &Sound::earcon_volume, &Sound::workspace},
    SoundInfo{SoundKind::LetGo, "let go", "the world is let go of", &Sound::earcon_volume, &Sound::workspace},
    SoundInfo{SoundKind::Click, "click", "you came to your desk or left it, or pressed something there", &Sound::earcon_volume, &Sound::desk},
    SoundInfo{SoundKind::GuideStart, "guide start", "your hand will be led", &Sound::earcon_volume, &Sound::guide},
    SoundInfo{SoundKind::GuideStop, "guide stop", "your hand is not led any more", &Sound::earcon_volume, &Sound::guide},
    SoundInfo{SoundKind::Warmer, "warmer", "the faster it ticks, the nearer your hand is to what you look for", &Sound::beacon_volume, &Sound::beacon},
    SoundInfo{SoundKind::Alarm, "alarm", "something is wrong; the reason is said", &Sound::earcon_volume, nullptr},
    SoundInfo{SoundKind::Beep, "beep", "stands for speech where there is no voice", &Sound::earcon_volume, nullptr},
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

// Longer words stand before those they hold.
struct WordRow {
    std::string_view word;
    SoundKind kind;
};
constexpr std::array kWords{
    WordRow{"thunder", SoundKind::Thunder},  WordRow{"storm", SoundKind::Thunder},   WordRow{"explo", SoundKind::Thunder},
    WordRow{"drip", SoundKind::Drip},        WordRow{"drop", SoundKind::Drip},       WordRow{"leak", SoundKind::Drip},
    WordRow{"waterfall", SoundKind::Stream}, WordRow{"fountain", SoundKind::Stream}, WordRow{"stream", SoundKind::Stream},
    WordRow{"river", SoundKind::Stream},     WordRow{"water", SoundKind::Stream},    WordRow{"splash", SoundKind::Stream},
    WordRow{"fire", SoundKind::Fire},        WordRow{"flame", SoundKind::Fire},      WordRow{"torch", SoundKind::Fire},
    WordRow{"lava", SoundKind::Fire},        WordRow{"candle", SoundKind::Fire},     WordRow{"clock", SoundKind::Clock},
    WordRow{"tick", SoundKind::Clock},       WordRow{"watch", SoundKind::Clock},     WordRow{"swamp", SoundKind::Swamp},
    WordRow{"frog", SoundKind::Swamp},       WordRow{"cricket", SoundKind::Swamp},   WordRow{"wind", SoundKind::Wind},
    WordRow{"draught", SoundKind::Wind},     WordRow{"suck", SoundKind::Wind},       WordRow{"breeze", SoundKind::Wind},
    WordRow{"rain", SoundKind::Rain},        WordRow{"snow", SoundKind::Wind},       WordRow{"bird", SoundKind::Birds},
    WordRow{"bell", SoundKind::Tolling},     WordRow{"chime", SoundKind::Tolling},   WordRow{"toll", SoundKind::Tolling},
    WordRow{"music", SoundKind::Music},      WordRow{"radio", SoundKind::Music},     WordRow{"song", SoundKind::Music},
    WordRow{"speaker", SoundKind::Music},    WordRow{"piano", SoundKind::Music},     WordRow{"steam", SoundKind::Fan},
    WordRow{"smoke", SoundKind::Fan},        WordRow{"vent", SoundKind::Fan},        WordRow{"fan", SoundKind::Fan},
    WordRow{"buzz", SoundKind::Buzz},        WordRow{"flour", SoundKind::Buzz},      WordRow{"fluor", SoundKind::Buzz},
    WordRow{"spark", SoundKind::Buzz},       WordRow{"lamp", SoundKind::Buzz},       WordRow{"electric", SoundKind::Buzz},
    WordRow{"drone", SoundKind::Drone},      WordRow{"machine", SoundKind::Drone},   WordRow{"engine", SoundKind::Drone},
    WordRow{"motor", SoundKind::Drone},      WordRow{"generator", SoundKind::Drone}, WordRow{"hum", SoundKind::Hum},
    WordRow{"comp", SoundKind::Hum},         WordRow{"fridge", SoundKind::Hum},
};

}  // namespace

std::span<const SoundInfo> sound_table() { return kTable; }

const SoundInfo& info(SoundKind kind) { return kTable[static_cast<std::size_t>(kind)]; }

std::string_view material_sound_name(SoundClass material) { return kMaterials[static_cast<std::size_t>(material)]; }

std::vector<DictionaryEntry> sound_dictionary() {
    std::vector<DictionaryEntry> all;
    for (const SoundInfo& row : kTable)
        if (row.kind != SoundKind::Contact) all.push_back({row.kind, SoundClass::Wood, sentence_case(fmt::format("{}: {}.", row.name, row.meaning))});
    for (int m = 0; m < static_cast<int>(SoundClass::Generic); ++m) {
        const auto material = static_cast<SoundClass>(m);
        all.push_back({SoundKind::Contact, material, sentence_case(fmt::format("contact with {}.", material_sound_name(material)))});
    }
    return all;
}

SoundKind world_sound_of(std::string_view word) {
    std::string letters = lower_ascii(word);
    std::erase_if(letters, [](char c) { return c < 'a' || c > 'z'; });
    // Every class of such entities begins with "ambient"; it says nothing.
    if (letters.starts_with("ambient")) letters.erase(0, 7);
    for (const WordRow& row : kWords)
        if (letters.find(row.word) != std::string::npos) return row.kind;
    return SoundKind::Shimmer;
}

double distance_gain(SoundKind kind, double distance_m) {
    if (is_earcon(kind)) return 1.0;
    if (is_world_sound(kind)) {
        constexpr double kFades_m = 10.0;  // the last part of the range, so that nothing begins at a step
        return std::clamp((kWorldSoundRange_m - distance_m) / kFades_m, 0.0, 1.0) / std::max(1.0, distance_m);
    }
    constexpr double kNear_m = 2.0, kRollOff = 0.5, kBeaconLeast = 0.35;  // a beacon calls from as far as it is set
    const double gain = kNear_m / (kNear_m + kRollOff * std::max(0.0, distance_m - kNear_m));
    return is_beacon(kind) ? std::max(gain, kBeaconLeast) : gain;
}

}  // namespace handrail
