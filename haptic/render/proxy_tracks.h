// The moving bodies that the proxy follows: those near enough to be met soon. All others are known to stay farther than
// far_m from far_from_m on the ways that are being played; who comes nearer on the next ways is found when those begin,
// and the rest when the ball has gone on. Plain values of fixed room: they allocate in their constructors only. Owned
// by ProxySolver; its thread and rules.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "haptic/render/haptic_scene.h"
#include "haptic/render/tick_assert.h"

namespace handrail {

// A body as the ball last met it.
struct ProxyTrack {
    Placement at, from, to;  // world: now, and the way of this move
    Placement before;        // this sub-step
    Placement wanted;        // where it was told to be last; `at` is behind it while it waits
    PlacedFrame frame;       // of `at`, in the scene's own coordinates
    bool present = false;
    bool moved = false;          // on this sub-step
    bool jumped = false;         // it was told to be elsewhere than it can have come to
    bool short_of_room = false;  // there was none for all that is near enough
    int waited = 0;              // moves
    bool unknown = false;        // there was no time yet to look for its candidates
    bool crowded = false;        // had more near than are comfortable when it was looked at last
    bool leaves = false;         // while gathering: what there is of it goes, to be looked at anew or not at all
    bool looked_at = false;      // some of it may be candidates; else all of it is as far as its sphere
    double reach_m = 0.0;        // of that sphere around its frame's zero, world metres
    Vec3 known_from_m{0.0};      // looked at: own frame; every obstacle nearer to here than known_m is a candidate
    double known_m = -1.0;       // world metres

    // How far around a place, in the scene's own coordinates, every obstacle of it is a candidate.
    double known_around_m(const Vec3& local_m) const noexcept {
        return looked_at ? known_m - glm::length(frame.to_own(local_m) - known_from_m) * frame.scale
                         : glm::length(local_m - frame.position_m) - reach_m;
    }
};

struct ProxyTracks {
    static constexpr int kMost = 1024;  // of more bodies the nearest, and the ball stops short of the rest
    static constexpr std::uint16_t kNoSlot = 0xFFFF;

    std::vector<ProxyTrack> by_slot = std::vector<ProxyTrack>(kMost);
    std::vector<std::uint16_t> slots =  // by body: where its track is, or kNoSlot
        std::vector<std::uint16_t>(HapticScene::kMostBodies, kNoSlot);
    std::vector<double> least_m = std::vector<double>(HapticScene::kMostBodies);  // by body, while all are looked at
    std::vector<std::uint16_t> followed = std::vector<std::uint16_t>(kMost);      // bodies, in rising order
    std::vector<std::uint16_t> free_slots = std::vector<std::uint16_t>(kMost);
    std::size_t count = 0;
    std::size_t bodies = 0;  // of the scene

    Vec3 far_from_m{0.0};  // scene coordinates
    double far_m = 0.0;
    double near_m = 0.0;          // how far around the ball bodies must have a track
    double far_enough_m2 = -1.0;  // squared: how far the ball may be from far_from_m until bodies are looked for anew
    bool far_short = false;       // the ball may go beyond what far_m is good for; then it stops there
    bool all = false;             // for checks: every body has a track, as far as there is room
    std::uint64_t ways = 0;       // the number of the ways that are being played
    std::uint64_t number = 0;     // of the poses that were taken last
    double known_m = 0.0;         // around the anchor, of those that were looked at, at the last gathering
    bool moved = false;           // some of those, since then
    bool unknown = false;         // some body waits to be looked at
    bool behind = false;          // some body is not where it was told to be

    ProxyTracks() { free_all(); }

    bool follows(std::size_t body) const noexcept { return slots[body] != kNoSlot; }
    // Before: it is followed.
    ProxyTrack& of(std::size_t body) noexcept {
        tick_assert(follows(body));
        return by_slot[slots[body]];
    }
    const ProxyTrack& of(std::size_t body) const noexcept {
        tick_assert(follows(body));
        return by_slot[slots[body]];
    }
    // Their bodies.
    std::span<const std::uint16_t> ids() const noexcept { return std::span(followed).first(count); }

    void clear() noexcept {
        for (const std::uint16_t body : ids()) slots[body] = kNoSlot;
        free_all();
        count = 0;
    }
    // Before: the body has no track. Null: there is none left.
    ProxyTrack* add(std::uint16_t body) noexcept {
        tick_assert(!follows(body));
        if (count == followed.size()) return nullptr;
        const auto end = followed.begin() + static_cast<std::ptrdiff_t>(count);
        const auto at = std::lower_bound(followed.begin(), end, body);
        std::copy_backward(at, end, end + 1);
        *at = body;
        slots[body] = free_slots[free_slots.size() - 1 - count++];
        ProxyTrack& track = of(body);
        track = {};
        return &track;
    }
    // stays(body, track)
    template <class Stays>
    void keep_those(const Stays& stays) noexcept {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint16_t body = followed[k];
            if (stays(body, of(body))) {
                followed[kept++] = body;
                continue;
            }
            free_slots[free_slots.size() - count + (k - kept)] = slots[body];
            slots[body] = kNoSlot;
        }
        count = kept;
    }

private:
    void free_all() noexcept {
        for (std::size_t i = 0; i < free_slots.size(); ++i)
            free_slots[i] = static_cast<std::uint16_t>(free_slots.size() - 1 - i);
    }
};

}  // namespace handrail
