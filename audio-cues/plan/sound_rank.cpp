#include "audio-cues/plan/sound_rank.h"

#include <array>

namespace handrail::cues {
namespace {

struct RankRow {
    std::string_view name;
    double lufs;
};
// Loudness of each rank in LUFS. Neighbouring ranks differ by two units, which people can distinguish. The rank
// "danger" is four units louder than the next.
constexpr std::array<RankRow, kSoundRanks> kRanks{{{"danger", -22.0},
                                                   {"blocked", -26.0},
                                                   {"route", -28.5},
                                                   {"landmark", -31.0},
                                                   {"step", -34.0},
                                                   {"background", -37.0}}};

}  // namespace

SoundRank rank_of(SoundKind kind) {
    if (is_world_sound(kind)) return SoundRank::Background;
    switch (kind) {
        case SoundKind::Alarm:
        case SoundKind::DropNear:
            return SoundRank::Danger;
        case SoundKind::Bump:
        case SoundKind::Denied:
            return SoundRank::Blocked;
        case SoundKind::Corner:
        case SoundKind::Opening:
        case SoundKind::StairsUp:
        case SoundKind::StairsDown:
        case SoundKind::DoorNear:
        case SoundKind::Beacon:
        case SoundKind::BeaconAhead:
        case SoundKind::BeaconBehind:
        case SoundKind::Warmer:
        case SoundKind::Colder:
        case SoundKind::Arrived:
        case SoundKind::GuideStart:
        case SoundKind::GuideStop:
        case SoundKind::Bell:
        case SoundKind::Beep:
            return SoundRank::Route;
        case SoundKind::Mark:
        case SoundKind::Landmark:
        case SoundKind::Clue:
        case SoundKind::DoorMoves:
        case SoundKind::DoorShuts:
        case SoundKind::Splash:
        case SoundKind::Falls:
        case SoundKind::Knock:
        case SoundKind::Border:
        case SoundKind::ForcesOn:
        case SoundKind::ForcesOff:
        case SoundKind::FrameSwitch:
            return SoundRank::Landmark;
        case SoundKind::Slide:
        case SoundKind::WallTone:
            return SoundRank::Background;
        default:
            return SoundRank::Step;
    }
}

std::string_view rank_name(SoundRank rank) { return kRanks[static_cast<std::size_t>(rank)].name; }

double loudness_of(SoundRank rank) { return kRanks[static_cast<std::size_t>(rank)].lufs; }

}  // namespace handrail::cues
