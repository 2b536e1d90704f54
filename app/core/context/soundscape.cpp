#include "app/core/context/soundscape.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "audio-cues/plan/sound_table.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr std::size_t kFollowedPerTick = 8;
// Half the width of the head. It is smaller than the radius of any walker, so no ear is inside a wall.
constexpr double kHeadHalf_m = 0.12;
// Solids with a gap smaller than this muffle like one wall, because a wall may consist of several brushes.
constexpr double kOneObstacle_m = 0.05;
constexpr double kLikeAWall_m = 1.9;  // a thing of at least this height muffles sound like a wall
// level at the ears, before any volume setting; a sound below this level is not played
constexpr double kSilent_db = -46.0;
constexpr double kRoomEvery_s = 0.5;
constexpr double kMoved_m = 0.02, kChanged_db = 0.25, kChanged_pulses_per_s = 0.2;

double loss_of(const Scene& scene, const Crossing& crossing) {
    const Feature* feature = scene.find(crossing.feature);
    if (feature == nullptr) return kWallMuffles_db;
    if (feature->kind == FeatureKind::Door) return kDoorMuffles_db;
    if (scene.material(crossing.material).sound == SoundClass::Glass) return kDoorMuffles_db;
    if (feature->kind == FeatureKind::Object && feature->bounds_m.size_m().z < kLikeAWall_m) return kThingMuffles_db;
    return kWallMuffles_db;
}

double along_line_db(const WalkerWorld& world, const Vec3& from_m, const Vec3& to_m) {
    std::vector<Crossing> crossings = world.crossings(from_m, to_m);
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.enter_m < b.enter_m; });
    double sum_db = 0.0, until_m = -1.0, here_db = 0.0;
    for (const Crossing& crossing : crossings) {
        if (crossing.enter_m > until_m + kOneObstacle_m) {
            sum_db += here_db;
            here_db = 0.0;
        }
        here_db = std::max(here_db, loss_of(world.scene(), crossing));
        until_m = std::max(until_m, crossing.leave_m);
    }
    return sum_db + here_db;
}

// Returns the share of sound that a material absorbs at 1 kHz. From tables of room acoustics (Kuttruff, Room Acoustics,
// 2009), without furniture.
double absorption_of(SoundClass material) {
    constexpr std::array<double, static_cast<std::size_t>(SoundClass::Generic) + 1> kShares{
        /* plaster, wood, brick, concrete, tile */ 0.05,
        0.10,
        0.04,
        0.03,
        0.02,
        /* carpet, metal, glass, stone, rubber  */ 0.35,
        0.05,
        0.05,
        0.02,
        0.10,
        /* grass, water, plastic, cloth, sand   */ 0.50,
        0.01,
        0.08,
        0.50,
        0.40,
        /* earth, ice, grille, generic          */ 0.40,
        0.02,
        0.30,
        0.10};
    return kShares[static_cast<std::size_t>(material)];
}

double decibels(double gain) { return gain > 0.0 ? 20.0 * std::log10(gain) : -1e9; }

}  // namespace

double muffling_db(const WalkerWorld& world, const Vec3& ears_m, const Vec3& source_m) {
    contract_pre(is_finite(ears_m) && is_finite(source_m));
    const Vec3 way = source_m - ears_m;
    const Vec3 across = glm::cross(way, Vec3(0.0, 0.0, 1.0));
    const double length = glm::length(across);
    const Vec3 side = length > 1e-9 ? across * (kHeadHalf_m / length) : Vec3(kHeadHalf_m, 0.0, 0.0);
    double energy = 0.0;
    for (const double s : {-1.0, 0.0, 1.0})
        energy += std::pow(10.0, -along_line_db(world, ears_m + side * s, source_m) / 10.0);
    return -10.0 * std::log10(energy / 3.0);
}

double reverberation_s(const WalkerWorld& world, const Vec3& ears_m) {
    contract_pre(is_finite(ears_m));
    constexpr int kRays = 48;
    constexpr double kOpen_m = 30.0;
    struct Met {
        Vec3 at_m;
        double absorption;
        bool hit;
    };
    const auto meet = [&](const Vec3& way) {
        const TraceHit hit = world.trace(ears_m, ears_m + way * kOpen_m, WalkerShape{}, true);
        return Met{hit.end_m, hit.hit ? absorption_of(world.scene().material(hit.material).sound) : 1.0, hit.hit};
    };
    const Met up = meet({0.0, 0.0, 1.0}), down = meet({0.0, 0.0, -1.0});
    if (!up.hit || !down.hit) return 0.0;
    const double height_m = up.at_m.z - down.at_m.z;
    std::array<Met, kRays> round;
    int open = 0;
    for (int i = 0; i < kRays; ++i) {
        round[static_cast<std::size_t>(i)] = meet(forward_of_heading(2.0 * kPi * (i + 0.5) / kRays));
        if (!round[static_cast<std::size_t>(i)].hit) ++open;
    }
    if (open > kRays / 2) return 0.0;
    double floor_m2 = 0.0, walls_absorb_m2 = 0.0;
    for (std::size_t i = 0; i < kRays; ++i) {
        const Met &a = round[i], &b = round[(i + 1) % kRays];
        const Vec3 to_a = a.at_m - ears_m, to_b = b.at_m - ears_m;
        floor_m2 += 0.5 * std::abs(to_a.x * to_b.y - to_a.y * to_b.x);
        walls_absorb_m2 += glm::length(b.at_m - a.at_m) * height_m * 0.5 * (a.absorption + b.absorption);
    }
    return 0.161 * floor_m2 * height_m / (walls_absorb_m2 + floor_m2 * (up.absorption + down.absorption));
}

void Soundscape::enter(const Scene& scene) {
    sources_.clear();
    next_ = added_ = 0;
    next_room_s_ = -1.0;
    for (const SoundSource& sound : scene.sounds)
        sources_.push_back(
            {.kind = cues::world_sound_of(sound.sound), .position_m = sound.position_m, .loudness = sound.loudness});
}

void Soundscape::add(const std::vector<AddedSound>& sounds) {
    const std::size_t own = sources_.size() - added_;
    sources_.resize(own + sounds.size());
    next_ = 0;
    added_ = sounds.size();
    for (std::size_t i = 0; i < sounds.size(); ++i) {
        Source& source = sources_[own + i];
        // A sound of the same kind at the same place keeps its state.
        if (source.kind != sounds[i].kind || source.position_m != sounds[i].position_m) source = Source{};
        source.kind = sounds[i].kind;
        source.position_m = sounds[i].position_m;
        source.loudness = sounds[i].loudness;
        source.pulses_per_s = sounds[i].pulses_per_s;
    }
}

void Soundscape::tick(const WalkerWorld& world, const Vec3& ears_m, double now_s, std::vector<cues::CueRequest>& cues,
                      const SoundLimits& limits) {
    contract_pre(is_finite(ears_m) && std::isfinite(now_s));
    // 1. Compute the level of each source at the ears. To limit the cost, compute the muffling of only some sources
    //   in each tick.
    std::size_t followed = 0;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
        Source& source = sources_[(next_ + i) % sources_.size()];
        if (limits.spotlight && !limits.spotlight->shows(source.position_m)) {
            source.level_db = -1e9;
            continue;
        }
        const double plain_db =
            decibels(source.loudness * cues::distance_gain(source.kind, glm::length(source.position_m - ears_m)));
        if (plain_db > kSilent_db && followed < kFollowedPerTick) {
            source.muffled_db = muffling_db(world, ears_m, source.position_m);
            source.known = true;
            if (++followed == kFollowedPerTick) next_ = (next_ + i + 1) % sources_.size();
        }
        source.level_db = source.known && source.muffled_db <= kUnheard_db ? plain_db - source.muffled_db : -1e9;
    }
    choose(limits.most, now_s);
    if (next_room_s_ < 0.0 || now_s >= next_room_s_) {
        next_room_s_ = now_s + kRoomEvery_s;
        reverberation_s_ = core::reverberation_s(world, ears_m);
    }
    // 2. Send the changes to the planner. Stop sounds first, to make room for new ones.
    const auto source_of = [&](const cues::CueRequest& sent) -> const Source* {
        if (sent.source >= sources_.size()) return nullptr;
        const Source& source = sources_[sent.source];
        return source.heard && source.kind == sent.sound ? &source : nullptr;
    };
    std::erase_if(sent_, [&](cues::CueRequest& sent) {
        if (source_of(sent) != nullptr) return false;
        sent.loudness = 0.0;
        sent.time_s = now_s;
        cues.push_back(sent);
        return true;
    });
    for (std::uint32_t i = 0; i < sources_.size(); ++i) {
        const Source& source = sources_[i];
        if (!source.heard) continue;
        const auto sent =
            std::find_if(sent_.begin(), sent_.end(), [&](const cues::CueRequest& t) { return t.source == i; });
        const bool known = sent != sent_.end();
        if (known && glm::length(sent->position_m - source.position_m) < kMoved_m &&
            std::abs(sent->muffled_db - source.muffled_db) < kChanged_db &&
            std::abs(sent->pulses_per_s - source.pulses_per_s) < kChanged_pulses_per_s)
            continue;
        cues::CueRequest request;
        request.kind = cues::CueRequestKind::WorldSound;
        request.time_s = now_s;
        request.sound = source.kind;
        request.position_m = source.position_m;
        request.loudness = source.loudness;
        request.muffled_db = source.muffled_db;
        request.pulses_per_s = source.pulses_per_s;
        request.source = i;
        if (known) *sent = request;
        else sent_.push_back(request);
        cues.push_back(std::move(request));
    }
}

void Soundscape::choose(std::size_t most, double now_s) {
    std::size_t heard = 0;
    for (Source& source : sources_) {
        if (source.level_db < kSilent_db) source.heard = false;
        if (source.heard) ++heard;
    }
    const auto louder = [](const Source& a, const Source& b) { return a.level_db < b.level_db; };
    while (true) {
        // Compare the loudest source that is not playing with the quietest one that is playing.
        Source *best = nullptr, *least = nullptr;
        for (Source& source : sources_) {
            Source*& rival = source.heard ? least : best;
            if (source.level_db >= kSilent_db &&
                (rival == nullptr || (source.heard ? louder(source, *rival) : louder(*rival, source))))
                rival = &source;
        }
        for (Source& source : sources_)
            if (source.heard || &source != best || heard < most || least == nullptr ||
                source.level_db < least->level_db + kLouder_db)
                source.louder_since_s = now_s;
        if (heard > most) {
            // The person has just chosen a smaller number.
            least->heard = false;
            --heard;
            continue;
        }
        if (best == nullptr) return;
        if (heard == most) {
            if (now_s - best->louder_since_s < kFor_s) return;
            least->heard = false;
            --heard;
        }
        best->heard = true;
        ++heard;
    }
}

cues::CueRequest SoundDictionary::step(int by, const cues::Listener& listener, double now_s) {
    const std::vector<cues::DictionaryEntry> entries = cues::sound_dictionary();
    const int count = static_cast<int>(entries.size());
    shown_ = shown_ < 0 && by < 0 ? count - 1 : (shown_ + by + count) % count;
    const cues::DictionaryEntry& entry = entries[static_cast<std::size_t>(shown_)];
    cues::CueRequest request;
    request.kind = cues::CueRequestKind::Demonstrate;
    request.time_s = now_s;
    request.sound = entry.kind;
    request.material = entry.material;
    request.text = phrase("session.sound_of", {{"sound", entry.text}, {"number", shown_ + 1}, {"count", count}});
    request.position_m = listener.ears_m + forward_of_heading(listener.heading_rad);
    return request;
}

}  // namespace handrail::core
