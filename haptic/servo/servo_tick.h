// One millisecond of the hand: sample checks, workspace map, touch, faults, ForceLimiter. Plain function over plain state, the same in the
// servo thread, in scenarios and in tests. Never allocates, locks, throws, logs or reads a clock.
#pragma once

#include <array>
#include <cstdint>

#include "haptic/device/haptic_device.h"
#include "haptic/render/touch.h"
#include "worlds/base/vec.h"

namespace handrail {

// Where the hand's workspace lies in the world at a moment; the servo interpolates between the last two it was given, so that a
// walking body is felt smoothly. world = origin_m + rotate(heading_rad, S * device).
struct WorkspacePose {
    Vec3 origin_m{0.0};             // world place of the middle of the device's workspace
    double heading_rad = 0.0;       // 0 in Map frame; the body's heading in Walk frame
    double time_s = 0.0;            // when the body was there; poses arrive in rising time
    std::uint32_t jump = 0;         // a new number: teleport, new world, scale change; not interpolated, force ramps in again
};

enum class Fault : std::uint8_t {
    None, BadSample, Jump, Unplugged, DeviceSilent, LateLoop, Unhomed,
};
const char* fault_sentence(Fault fault);       // spoken: "The touch device was unplugged. Everything else goes on."

struct ServoTuning {
    TouchTuning touch;
    double force_ceiling_n = 2.5;   // chosen by the person; the device's peak always holds too
    bool forces_on = true;          // f key; ramps up over 1 s, down at once to zero within the fade time
    bool panic = false;             // F12: zero on this very tick, until cleared
    std::uint32_t confirm = 0;      // a new number lets a latched fault go (ramp of 1 s)
};

enum class ContactEventKind : std::uint8_t { Begin, Slide, End, EnterLiquid, LeaveLiquid, FaultRaised, FaultCleared };

// What ears need to know of the hand, in order, each with its tick time.
struct ContactEvent {
    ContactEventKind kind = ContactEventKind::Begin;
    double time_s = 0.0;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    Vec3 position_m{0.0};           // world, at the proxy
    double speed_m_per_s = 0.0;     // hand speed: approach for Begin, along the surface for Slide
    double force_n = 0.0;
    Fault fault = Fault::None;
};

// What the app and ears may know of the hand; published each tick.
struct ToolState {
    double time_s = 0.0;
    Vec3 hip_m{0.0}, proxy_m{0.0};            // world
    Vec3 hand_m{0.0};                         // device frame
    double ball_radius_m = 0.0;
    Vec3 force_n{0.0};                        // commanded, world axes, after the limiter
    double force_gain = 0.0;                  // ramp, 0 to 1
    ContactSet contacts;
    FeatureId liquid = kNoFeature;
    std::uint32_t buttons = 0;
    Fault fault = Fault::None;                // latched or present
    double contact_s = 0.0;                   // contact time since start (break hint)
    std::uint64_t ticks = 0;
    double rate_hz = 0.0;                     // measured over the last second
    std::uint32_t scene_generation = 0;
};

}  // namespace handrail
