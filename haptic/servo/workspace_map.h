// Maps between device frame and world, with the workspace carried along by the walker. The walker moves at the app's
// frame rate, but the hand is rendered a thousand times a second. Poses are therefore played back about one frame late
// and interpolated. Walking into a wall is then one smooth push and not a staircase. Plain state, servo thread only;
// real-time safe; arithmetic of + - x / only, so that the results of all builds are bit-identical.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "worlds/base/vec.h"

namespace handrail::servo {

// Where the hand's workspace is in the world at a moment. The servo interpolates between the last poses, so that a
// moving walker is felt smoothly. world = origin_m + rotate(heading_rad, S * device).
struct WorkspacePose {
    Vec3 origin_m{0.0};        // position in the world of the middle of the device's workspace
    double heading_rad = 0.0;  // 0 in Map frame; the walker's heading in Walk frame
    double time_s = 0.0;       // of the servo's Clock, when the walker was there; rises from pose to pose
    // A new number means a teleport, a new world or a new scale: poses are not interpolated across it, and the force
    // ramps in again.
    std::uint32_t jump = 0;
};

// A pose prepared for transforming many points.
struct WorkspaceFrame {
    Vec3 origin_m{0.0};
    Vec3 right{1.0, 0.0, 0.0};    // device x in the world
    Vec3 forward{0.0, 1.0, 0.0};  // device y in the world; device z is up

    Vec3 to_world(const Vec3& device_m, double world_m_per_hand_m) const noexcept {
        const Vec3 scaled = device_m * world_m_per_hand_m;
        return origin_m + right * scaled.x + forward * scaled.y + Vec3(0.0, 0.0, scaled.z);
    }
    // For directions and forces, which have no origin and no scale.
    Vec3 turn_to_world(const Vec3& device) const noexcept {
        return right * device.x + forward * device.y + Vec3(0.0, 0.0, device.z);
    }
    Vec3 turn_to_device(const Vec3& world) const noexcept {
        return {glm::dot(world, right), glm::dot(world, forward), world.z};
    }
};

// Sine and cosine to 2e-16 for headings up to 1e6 turns, from a polynomial in this file: the C library's result may
// differ between machines.
void sin_cos_of_heading(double heading_rad, double& sine, double& cosine) noexcept;

WorkspaceFrame frame_of(const Vec3& origin_m, double heading_rad) noexcept;

class PosePlayback {
public:
    // Takes the newest pose that the servo knows at now_s; call it in every tick. A pose that was given before, or that
    // is not finite, changes nothing. Returns true if the workspace jumped, so that nothing felt before is valid.
    bool give(const WorkspacePose& newest, double now_s) noexcept;
    // Returns the frame at now_s, dt_s after the last call. The lag of the playback is the longest recent wait for the
    // next pose, about a frame, plus 4 ms. If a pose is late, the playback waits at the last one and continues from
    // there without a step. While it adjusts its lag, its speed differs from real time by at most a tenth.
    WorkspaceFrame at(double now_s, double dt_s) noexcept;
    // The moment that at() last played, in the clock of WorkspacePose::time_s.
    double played_s() const noexcept { return play_s_; }

private:
    static constexpr std::size_t kPoses = 32;  // half a second of frames, or 32 ms if a pose is given in every tick

    const WorkspacePose& pose(std::size_t i) const noexcept { return poses_[(first_ + i) % kPoses]; }
    void push(const WorkspacePose& pose) noexcept;
    WorkspaceFrame frame(const Vec3& origin_m, double heading_rad) noexcept;

    std::array<WorkspacePose, kPoses> poses_{};
    std::size_t first_ = 0, count_ = 0;
    WorkspaceFrame turned_;        // cached for the last heading, which seldom changes
    double turned_for_rad_ = 0.0;  // that heading
    double play_s_ = 0.0;          // the moment being played, between the times of two poses
    // Longest recent wait from a pose's time until the next pose arrived. It decays by 0.5 % with each pose.
    double wait_s_ = 1.0 / 60.0;
};

}  // namespace handrail::servo
