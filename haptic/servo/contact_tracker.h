// Turns the contact set of each tick into events for the audio thread: the hand touched a surface, slid along it or
// left it; it entered or left a liquid. Only hand tremor is filtered out: a contact that is lost for less than 20 ms
// continues. The cue planner decides which names are announced, and how often. Plain state, servo thread only;
// real-time safe.
#pragma once

#include <array>
#include <cstdint>

#include "haptic/render/touch.h"
#include "haptic/servo/fault.h"

namespace handrail::servo {

enum class ContactEventKind : std::uint8_t {
    Begin,
    Slide,
    End,
    EnterLiquid,
    LeaveLiquid,
    FaultRaised,
    FaultCleared,
    // The hand began or stopped to move its workspace past the rim (WorkspaceMover).
    RimPassed,
    RimLeft,
    Grabbed,
    LetGo,
    // The wall towards the person's body let the hand through to the desk or back (PersonalSpace). The cause is a pull
    // of the hand, or a fault that makes the hand's position invalid.
    DeskEntered,
    DeskLeft,
};

// One event for the audio thread, with the time of its tick. Events come in order of time.
struct ContactEvent {
    ContactEventKind kind = ContactEventKind::Begin;
    double time_s = 0.0;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    Vec3 position_m{0.0};  // position of the proxy in the world
    // Speed of the hand. For Begin, it is the speed at which the hand approaches the surface. For Slide, it is the
    // speed along the surface; 0 means that the hand stopped. For liquids, it is the speed through the liquid.
    double speed_m_per_s = 0.0;
    double force_n = 0.0;  // force of this surface, before any ceiling
    Fault fault = Fault::None;
    std::uint8_t hand = 0;  // which of the two hands; set by the code that merges the events of both
};

// The events of one tick, in order. `lost` counts the events for which there was no room.
struct TickEvents {
    // Twice the worst case, in which 3 contacts begin, 8 end, a liquid changes and a fault is raised.
    static constexpr std::size_t kMost = 24;

    std::array<ContactEvent, kMost> list{};
    std::uint8_t count = 0;
    std::uint8_t lost = 0;

    void push(const ContactEvent& event) noexcept {
        if (count < kMost) list[count++] = event;
        else ++lost;
    }
    const ContactEvent* begin() const noexcept { return list.data(); }
    const ContactEvent* end() const noexcept { return list.data() + count; }
};

class ContactTracker {
public:
    // Time without contact after which the hand has left a surface or liquid.
    static constexpr double kLetGoS = 0.020;
    static constexpr double kSlideEveryS = 0.010;  // shortest time between two Slide events of one surface
    // Speeds of the hand along a surface at which a slide starts and stops.
    static constexpr double kSlideStartsMPerS = 0.001, kSlideStopsMPerS = 0.0005;

    // `velocity_m_per_s` is the velocity of the hand relative to the world, in world axes and hand metres per second.
    void update(const render::TouchResult& touch, const Vec3& velocity_m_per_s, double world_m_per_hand_m, double now_s,
                double dt_s, TickEvents& events) noexcept;
    // Ends every contact and leaves the liquid, because the hand is absent or in another place.
    void clear(double now_s, TickEvents& events) noexcept;

private:
    struct Held {
        FeatureId feature;
        MaterialId material = kDefaultMaterial;
        Vec3 position_m{0.0};
        double seen_s = 0.0;
        double reported_s = 0.0;     // time of the last Slide event
        double slide_m_per_s = 0.0;  // speed of the slide, filtered with one pole of 5 ms
        bool sliding = false;
    };

    void end(std::size_t index, double now_s, TickEvents& events) noexcept;

    std::array<Held, 8> held_{};
    std::size_t count_ = 0;
    FeatureId liquid_ = kNoFeature;
    double liquid_seen_s_ = 0.0;
    Vec3 liquid_position_m_{0.0};
};

}  // namespace handrail::servo
