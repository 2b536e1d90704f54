// Device frame <-> world, with the workspace carried by a walking body. The body moves at the app's frame rate, the
// hand is felt a thousand times a second: poses are played back about one frame late and interpolated between, so that
// walking into a wall is one smooth push and not a staircase. Plain state, servo thread only; real-time safe;
// arithmetic of + - x / only, so that every build agrees to the bit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "worlds/base/vec.h"

namespace handrail {

// Where the hand's workspace lies in the world at a moment; the servo interpolates between the last ones it was given,
// so that a walking body is felt smoothly. world = origin_m + rotate(heading_rad, S * device).
struct WorkspacePose {
    Vec3 origin_m{0.0};        // world place of the middle of the device's workspace
    double heading_rad = 0.0;  // 0 in Map frame; the body's heading in Walk frame
    double time_s = 0.0;       // of the servo's Clock, when the body was there; poses arrive in rising time
    std::uint32_t jump = 0;  // a new number: teleport, new world, scale change; not interpolated, force ramps in again
};

// A pose made ready for many points.
struct WorkspaceFrame {
    Vec3 origin_m{0.0};
    Vec3 right{1.0, 0.0, 0.0};    // device x in the world
    Vec3 forward{0.0, 1.0, 0.0};  // device y in the world; device z is up

    Vec3 to_world(const Vec3& device_m, double world_m_per_hand_m) const noexcept {
        const Vec3 scaled = device_m * world_m_per_hand_m;
        return origin_m + right * scaled.x + forward * scaled.y + Vec3(0.0, 0.0, scaled.z);
    }
    // Directions and forces, which have no origin and no scale.
    Vec3 turn_to_world(const Vec3& device) const noexcept {
        return right * device.x + forward * device.y + Vec3(0.0, 0.0, device.z);
    }
    Vec3 turn_to_device(const Vec3& world) const noexcept {
        return {glm::dot(world, right), glm::dot(world, forward), world.z};
    }
};

// Sine and cosine to 2e-16 for headings up to 1e6 turns, from a polynomial of our own: the C library's may differ
// between machines.
void sin_cos_of_heading(double heading_rad, double& sine, double& cosine) noexcept;

WorkspaceFrame frame_of(const Vec3& origin_m, double heading_rad) noexcept;

class PosePlayback {
public:
    // Takes the newest pose the servo knows at now_s, on every tick; one that was given before, or is not finite,
    // changes nothing. True when the workspace jumped: nothing of what was felt before holds.
    bool give(const WorkspacePose& newest, double now_s) noexcept;
    // The frame at now_s, dt_s after the last call. Plays the poses back as late as the longest recent wait for the
    // next one, about a frame, plus 4 ms. When a pose is late it waits at the last one and goes on from there without a
    // step; the playback's speed differs from real time by at most a tenth while it finds its lag.
    WorkspaceFrame at(double now_s, double dt_s) noexcept;
    // The moment that at() last played, on the clock of WorkspacePose::time_s.
    double played_s() const noexcept { return play_s_; }

private:
    static constexpr std::size_t kPoses = 32;  // half a second of frames; 32 ms of poses given at every tick

    const WorkspacePose& pose(std::size_t i) const noexcept { return poses_[(first_ + i) % kPoses]; }
    void push(const WorkspacePose& pose) noexcept;
    WorkspaceFrame frame(const Vec3& origin_m, double heading_rad) noexcept;

    std::array<WorkspacePose, kPoses> poses_{};
    std::size_t first_ = 0, count_ = 0;
    WorkspaceFrame turned_;        // with the last heading, which seldom changes
    double turned_for_rad_ = 0.0;  // that heading
    double play_s_ = 0.0;          // the moment now being played, between the times of poses
    // Longest recent wait from a pose's time until the next was here, forgetting 0.5 % at each.
    double wait_s_ = 1.0 / 60.0;
};

}  // namespace handrail
