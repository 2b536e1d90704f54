// Turns the contact set of each tick into what ears need: a surface was met, is slid along, was left; a liquid was
// entered or left. Debounced only as far as hands tremble: a contact lost for less than 20 ms goes on. Saying a name
// once is the cue planner's business. Plain state, servo thread only; real-time safe.
#pragma once

#include <array>
#include <cstdint>

#include "haptic/render/touch.h"
#include "haptic/servo/fault.h"

namespace handrail {

enum class ContactEventKind : std::uint8_t {
    Begin,
    Slide,
    End,
    EnterLiquid,
    LeaveLiquid,
    FaultRaised,
    FaultCleared,
    // The hand moves its workspace (WorkspaceMover).
    RimPassed,
    RimLeft,
    Grabbed,
    LetGo,
    // The wall towards the body let the hand through (PersonalSpace), on its own or because the place was lost.
    DeskEntered,
    DeskLeft,
};

// What ears need to know of the hand, in order, each with its tick time.
struct ContactEvent {
    ContactEventKind kind = ContactEventKind::Begin;
    double time_s = 0.0;
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    Vec3 position_m{0.0};  // world, at the proxy
    // Hand speed: approach for Begin, along the surface for Slide (0: it stopped), through it for liquids.
    double speed_m_per_s = 0.0;
    double force_n = 0.0;  // from this surface, before any ceiling
    Fault fault = Fault::None;
    std::uint8_t hand = 0;  // which of two; whoever collects the events of both writes it
};

// What one tick has to tell, in order. A tick that has more to tell than fits says so in `lost`.
struct TickEvents {
    // Twice what 3 contacts begun, 8 ended, a liquid changed and a fault raised need.
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
    static constexpr double kLetGoS = 0.020;       // a contact or liquid is left when it was away this long
    static constexpr double kSlideEveryS = 0.010;  // between two Slide events of one surface
    static constexpr double kSlideStartsMPerS = 0.001, kSlideStopsMPerS = 0.0005;  // hand speed along the surface

    // velocity_m_per_s: of the hand relative to the world, world axes, hand metres per second.
    void update(const TouchResult& touch, const Vec3& velocity_m_per_s, double world_m_per_hand_m, double now_s,
                double dt_s, TickEvents& events) noexcept;
    // The hand is gone or elsewhere: ends every contact and leaves the liquid.
    void clear(double now_s, TickEvents& events) noexcept;

private:
    struct Held {
        FeatureId feature;
        MaterialId material = kDefaultMaterial;
        Vec3 position_m{0.0};
        double seen_s = 0.0;
        double told_s = 0.0;         // when the last Slide was told
        double slide_m_per_s = 0.0;  // one pole of 5 ms
        bool sliding = false;
    };

    void end(std::size_t index, double now_s, TickEvents& events) noexcept;

    std::array<Held, 8> held_{};
    std::size_t count_ = 0;
    FeatureId liquid_ = kNoFeature;
    double liquid_seen_s_ = 0.0;
    Vec3 liquid_position_m_{0.0};
};

}  // namespace handrail
