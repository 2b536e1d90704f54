// The moving bodies that the proxy follows: those near enough to be met soon. All others are known to stay farther than
// far_m from far_from_m during their current movements. Bodies that come nearer are found when their next movement
// begins, or when the proxy has moved on. Plain values with fixed room: they allocate in their constructors only. Owned
// by ProxySolver, with the same thread and rules.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "haptic/render/haptic_scene.h"
#include "haptic/render/tick_assert.h"

namespace handrail::render {

// A body as the proxy last met it.
struct ProxyTrack {
    Placement at, from, to;  // world: the pose now, and the start and end of this move
    Placement before;        // pose before this sub-step
    Placement wanted;        // the pose of the last command; `at` is behind it while the body waits
    PlacedFrame frame;       // the frame of `at`, in the scene's own coordinates
    bool present = false;
    bool moved = false;          // in this sub-step
    bool jumped = false;         // the command is farther away than the body can move in one go
    bool short_of_room = false;  // there was no room for all of its near obstacles
    int waited = 0;              // number of moves
    bool unknown = false;        // there was no time yet to look for its candidates
    bool crowded = false;        // at the last look, more of its obstacles were near than are comfortable
    bool leaves = false;         // while gathering: its candidates are dropped, to be looked at again or not at all
    bool looked_at = false;      // some of its obstacles may be candidates; otherwise the sphere below bounds all of it
    double reach_m = 0.0;        // radius of a sphere around its frame's zero that contains it, world metres
    // If looked_at, in its own frame: every obstacle nearer to this place than known_m is a candidate.
    Vec3 known_from_m{0.0};
    double known_m = -1.0;  // world metres

    // The distance around a place, in the scene's own coordinates, within which every obstacle of the body is a
    // candidate.
    double known_around_m(const Vec3& local_m) const noexcept {
        return looked_at ? known_m - glm::length(frame.to_own(local_m) - known_from_m) * frame.scale
                         : glm::length(local_m - frame.position_m) - reach_m;
    }
};

struct ProxyTracks {
    // If there are more near bodies, the nearest are followed and the proxy stops short of the others.
    static constexpr int kMost = 1024;
    static constexpr std::uint16_t kNoSlot = 0xFFFF;

    std::vector<ProxyTrack> by_slot = std::vector<ProxyTrack>(kMost);
    std::vector<std::uint16_t> slots =  // for each body the slot of its track, or kNoSlot
        std::vector<std::uint16_t>(HapticScene::kMostBodies, kNoSlot);
    // For each body, while all are looked at.
    std::vector<double> least_m = std::vector<double>(HapticScene::kMostBodies);
    std::vector<std::uint16_t> followed = std::vector<std::uint16_t>(kMost);  // indices of bodies, in rising order
    std::vector<std::uint16_t> free_slots = std::vector<std::uint16_t>(kMost);
    std::size_t count = 0;
    std::size_t bodies = 0;  // number of bodies in the scene

    Vec3 far_from_m{0.0};  // scene coordinates
    double far_m = 0.0;
    double near_m = 0.0;  // distance around the proxy within which bodies must have a track
    // Square of how far the proxy may move from far_from_m before bodies are looked for again.
    double far_enough_m2 = -1.0;
    bool far_short = false;    // the proxy might leave the range that far_m covers, where it must stop
    bool all = false;          // for checks: every body has a track, as long as there is room
    std::uint64_t ways = 0;    // the number of the current movements
    std::uint64_t number = 0;  // number of the poses that were taken last
    double known_m = 0.0;      // known distance around the anchor over all bodies looked at, at the last gathering
    bool moved = false;        // some of those bodies have moved since then
    bool unknown = false;      // some body still waits to be looked at
    bool behind = false;       // some body is not yet at its commanded pose

    ProxyTracks() { free_all(); }

    bool follows(std::size_t body) const noexcept { return slots[body] != kNoSlot; }
    // Requires that the body is followed.
    ProxyTrack& of(std::size_t body) noexcept {
        tick_assert(follows(body));
        return by_slot[slots[body]];
    }
    const ProxyTrack& of(std::size_t body) const noexcept {
        tick_assert(follows(body));
        return by_slot[slots[body]];
    }
    // The followed bodies.
    std::span<const std::uint16_t> ids() const noexcept { return std::span(followed).first(count); }

    void clear() noexcept {
        for (const std::uint16_t body : ids()) slots[body] = kNoSlot;
        free_all();
        count = 0;
    }
    // Requires that the body has no track. Returns null if no track is left.
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
    // Keeps the tracks for which stays(body, track) is true.
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

}  // namespace handrail::render
