// Maps between the device frame and the world, while the walker carries the workspace along. The walker moves at the
// app's frame rate, but the hand is rendered a thousand times a second. So the poses are played back about one frame
// late, with interpolation. Walking into a wall then feels like one smooth push and not like a staircase. Plain state,
// servo thread only; real-time safe; arithmetic of + - x / only, so that the results of all builds are bit-identical.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "worlds/base/vec.h"

namespace handrail::servo {

// Pose of the hand's workspace in the world at a moment. The servo interpolates between the last poses, so that a
// moving walker feels smooth. world = origin_m + rotate(heading_rad, S * device), where S is the scale.
struct WorkspacePose {
    Vec3 origin_m{0.0};        // middle of the device's workspace, in the world
    double heading_rad = 0.0;  // in Map frame 0, in Walk frame the walker's heading
    double time_s = 0.0;  // time at which the walker was at this pose, by the servo's Clock; rises from pose to pose
    // A new number means a teleport, a new world or a new scale. Poses are not interpolated across it, and the force
    // ramps in again.
    std::uint32_t jump = 0;
};

// A pose in a form that is quick to apply to many points.
struct WorkspaceFrame {
    Vec3 origin_m{0.0};
    Vec3 right{1.0, 0.0, 0.0};    // the device's x axis in the world
    Vec3 forward{0.0, 1.0, 0.0};  // the device's y axis in the world; the device's z axis is always up

    Vec3 to_world(const Vec3& device_m, double world_m_per_hand_m) const noexcept {
        const Vec3 scaled = device_m * world_m_per_hand_m;
        return origin_m + right * scaled.x + forward * scaled.y + Vec3(0.0, 0.0, scaled.z);
    }
    // Converts a direction or force, without origin and scale.
    Vec3 turn_to_world(const Vec3& device) const noexcept {
        return right * device.x + forward * device.y + Vec3(0.0, 0.0, device.z);
    }
    Vec3 turn_to_device(const Vec3& world) const noexcept {
        return {glm::dot(world, right), glm::dot(world, forward), world.z};
    }
};

// Computes sine and cosine to 2e-16 for headings up to 1e6 turns. The function uses a polynomial, because the C
// library's result may differ between machines.
void sin_cos_of_heading(double heading_rad, double& sine, double& cosine) noexcept;

WorkspaceFrame frame_of(const Vec3& origin_m, double heading_rad) noexcept;

class PosePlayback {
public:
    // Adds the newest pose that the servo knows at `now_s`; call it in every tick. A pose that was given before, or
    // that is not finite, changes nothing. Returns true if the workspace jumped, so that everything felt before is
    // invalid.
    bool give(const WorkspacePose& newest, double now_s) noexcept;
    // Returns the frame at `now_s`, which is `dt_s` after the last call. The lag of the playback is the longest recent
    // wait for the next pose, about a frame, plus 4 ms. If a pose is late, the playback waits at the last one and
    // continues from there without a step. While the lag is being adjusted, the speed of the playback differs from real
    // time by at most a tenth.
    WorkspaceFrame at(double now_s, double dt_s) noexcept;
    // Returns the time of the pose that at() last played, by the clock of WorkspacePose::time_s.
    double played_s() const noexcept { return play_s_; }

private:
    // Number of stored poses. They cover half a second of frames, or 32 ms if a pose is given in every tick.
    static constexpr std::size_t kPoses = 32;

    const WorkspacePose& pose(std::size_t i) const noexcept { return poses_[(first_ + i) % kPoses]; }
    void push(const WorkspacePose& pose) noexcept;
    WorkspaceFrame frame(const Vec3& origin_m, double heading_rad) noexcept;

    std::array<WorkspacePose, kPoses> poses_{};
    std::size_t first_ = 0, count_ = 0;
    WorkspaceFrame turned_;        // cached axes for the last heading, which seldom changes
    double turned_for_rad_ = 0.0;  // the heading of turned_
    double play_s_ = 0.0;          // the time that is played, between the times of two poses
    // Longest recent time from a pose's time until the next pose arrived. It decays by 0.5 % with each pose.
    double wait_s_ = 1.0 / 60.0;
};

}  // namespace handrail::servo
