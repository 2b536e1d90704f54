// Holds the moving bodies that the proxy follows, because they may soon reach the proxy. All other bodies stay farther
// than far_m from far_from_m during their current movements. The solver finds a body that comes nearer when the body's
// next movement begins, or when the proxy has moved on. Plain values of fixed size: they allocate only in their
// constructors. ProxySolver owns them; the same thread and rules apply.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "haptic/render/haptic_scene.h"
#include "haptic/render/tick_assert.h"

namespace handrail::render {

// A body's state at the last move of the proxy.
struct ProxyTrack {
    Placement at, from, to;  // in the world: the pose now, and the poses at the start and end of this move
    Placement before;        // pose before the current sub-step
    Placement wanted;        // last commanded pose; while the body waits, `at` differs from it
    PlacedFrame frame;       // the frame of `at`, in the scene's own coordinates
    bool present = false;
    bool moved = false;          // true if the body moves in the current sub-step
    bool jumped = false;         // its commanded pose is too far away for the sub-steps of one move
    bool short_of_room = false;  // some of its near obstacles could not become candidates
    int waited = 0;              // number of moves for which the body has waited
    bool unknown = false;        // there was no time yet to gather its obstacles
    bool crowded = false;        // at the last search, more of its obstacles were near than kComfortableCandidates
    bool leaves = false;         // while gathering: its candidates are to be dropped and perhaps gathered again
    // Some of the body's obstacles may be candidates. If false, the sphere with radius reach_m bounds them all.
    bool looked_at = false;
    // Radius of a sphere around the origin of the body's frame that contains the body, world metres.
    double reach_m = 0.0;
    // If looked_at is true, every obstacle of the body that is nearer to known_from_m than known_m is a candidate. In
    // the body's own frame.
    Vec3 known_from_m{0.0};
    double known_m = -1.0;  // in world metres

    // Returns the distance around a place, in the scene's own coordinates, within which every obstacle of the body is a
    // candidate.
    double known_around_m(const Vec3& local_m) const noexcept {
        return looked_at ? known_m - glm::length(frame.to_own(local_m) - known_from_m) * frame.scale
                         : glm::length(local_m - frame.position_m) - reach_m;
    }
};

struct ProxyTracks {
    // Greatest number of followed bodies. If more are near, the nearest are followed and the proxy stops before it
    // reaches the others.
    static constexpr int kMost = 1024;
    static constexpr std::uint16_t kNoSlot = 0xFFFF;

    std::vector<ProxyTrack> by_slot = std::vector<ProxyTrack>(kMost);
    std::vector<std::uint16_t> slots =  // for each body the slot of its track, or kNoSlot
        std::vector<std::uint16_t>(HapticScene::kMostBodies, kNoSlot);
    // For each body, a lower bound of its distance; used only while track_near() examines all bodies.
    std::vector<double> least_m = std::vector<double>(HapticScene::kMostBodies);
    // Indices of the followed bodies, in rising order.
    std::vector<std::uint16_t> followed = std::vector<std::uint16_t>(kMost);
    std::vector<std::uint16_t> free_slots = std::vector<std::uint16_t>(kMost);
    std::size_t count = 0;
    std::size_t bodies = 0;  // number of bodies in the scene

    Vec3 far_from_m{0.0};  // the place to which far_m belongs, in scene coordinates
    double far_m = 0.0;
    double near_m = 0.0;  // distance around the proxy within which bodies must have a track
    // Square of the distance that the proxy may move from far_from_m before the solver searches for near bodies again.
    double far_enough_m2 = -1.0;
    // The proxy might leave the range of far_m in this move. It must stop at the end of that range.
    bool far_short = false;
    bool all = false;          // for checks: follow every body as long as there are tracks
    std::uint64_t ways = 0;    // number of the current movements (BodyPaths)
    std::uint64_t number = 0;  // number of the poses (BodyPoses) that the solver used last
    // Distance around the anchor that was known after the last gathering, over all searched bodies.
    double known_m = 0.0;
    bool moved = false;    // some of the searched bodies have moved since the last gathering
    bool unknown = false;  // the obstacles of at least one body have not been gathered yet
    bool behind = false;   // at least one body has not reached its commanded pose

    ProxyTracks() { free_all(); }

    bool follows(std::size_t body) const noexcept { return slots[body] != kNoSlot; }
    // Returns the track of a body that is followed.
    ProxyTrack& of(std::size_t body) noexcept {
        tick_assert(follows(body));
        return by_slot[slots[body]];
    }
    const ProxyTrack& of(std::size_t body) const noexcept {
        tick_assert(follows(body));
        return by_slot[slots[body]];
    }
    // Indices of the followed bodies.
    std::span<const std::uint16_t> ids() const noexcept { return std::span(followed).first(count); }

    void clear() noexcept {
        for (const std::uint16_t body : ids()) slots[body] = kNoSlot;
        free_all();
        count = 0;
    }
    // Gives a body a track; it must not have one. Returns null if no track is left.
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
    // Keeps only the tracks for which stays(body, track) returns true.
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
