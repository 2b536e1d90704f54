#include "haptic/drivers/companion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptic/drivers/ff_link.h"
#include "haptic/drivers/found_device.h"
#include "haptic/drivers/playstation_pad.h"
#include "haptic/drivers/space_mouse.h"
#include "worlds/base/language.h"

namespace handrail::drivers {
namespace {

constexpr double kStickDeadBand = 0.1;

constexpr std::uint32_t bit(CompanionButton button) { return 1U << static_cast<unsigned>(button); }

struct ButtonPlace {
    unsigned from;
    CompanionButton to;
};

template <std::size_t N>
std::uint32_t translated(std::uint32_t buttons, const std::array<ButtonPlace, N>& places) noexcept {
    std::uint32_t out = 0;
    for (const ButtonPlace& place : places)
        if (buttons >> place.from & 1U) out |= bit(place.to);
    return out;
}

// Buttons of a Sony pad from bit 0 on: square cross circle triangle L1 R1 L2 R2 create options L3 R3.
constexpr std::array kPadButtons{
    ButtonPlace{0, CompanionButton::West},         ButtonPlace{1, CompanionButton::South},
    ButtonPlace{2, CompanionButton::East},         ButtonPlace{3, CompanionButton::North},
    ButtonPlace{4, CompanionButton::LeftShoulder}, ButtonPlace{5, CompanionButton::RightShoulder},
    ButtonPlace{8, CompanionButton::LeftSpecial},  ButtonPlace{9, CompanionButton::RightSpecial},
    ButtonPlace{10, CompanionButton::LeftStick},   ButtonPlace{11, CompanionButton::RightStick}};
// Game pad buttons of the Linux kernel, counted from its first joystick button.
constexpr std::array kEventButtons{
    ButtonPlace{16, CompanionButton::South},        ButtonPlace{17, CompanionButton::East},
    ButtonPlace{19, CompanionButton::North},        ButtonPlace{20, CompanionButton::West},
    ButtonPlace{22, CompanionButton::LeftShoulder}, ButtonPlace{23, CompanionButton::RightShoulder},
    ButtonPlace{26, CompanionButton::LeftSpecial},  ButtonPlace{27, CompanionButton::RightSpecial},
    ButtonPlace{29, CompanionButton::LeftStick},    ButtonPlace{30, CompanionButton::RightStick}};
constexpr std::array kPuckButtons{ButtonPlace{0, CompanionButton::South}, ButtonPlace{1, CompanionButton::West}};

// Converts the hat's position to button bits. The hat counts eighths of a turn, clockwise from up; 8 means that it is
// not pressed.
std::uint32_t hat_buttons(int hat) noexcept {
    std::uint32_t out = 0;
    if (hat == 7 || hat == 0 || hat == 1) out |= bit(CompanionButton::Up);
    if (hat >= 1 && hat <= 3) out |= bit(CompanionButton::Right);
    if (hat >= 3 && hat <= 5) out |= bit(CompanionButton::Down);
    if (hat >= 5 && hat <= 7) out |= bit(CompanionButton::Left);
    return out;
}

// Returns 0 for a rate that a pad reports while it is held still, from the drift of its sensor or a tremor of the hand.
double without_tremor(double rate_rad_per_s) noexcept {
    constexpr double kStill_rad_per_s = 0.1;
    return std::abs(rate_rad_per_s) < kStill_rad_per_s ? 0.0 : rate_rad_per_s;
}

class PadCompanion final : public Companion {
public:
    explicit PadCompanion(std::unique_ptr<PlaystationPad> pad) : pad_(std::move(pad)) {}
    bool read(CompanionState& state, double) noexcept override {
        if (const auto input = pad_->read(0.0)) input_ = *input;
        state.ahead = stick_curve(input_.left_y);
        state.right = stick_curve(input_.left_x);
        state.turn_right = stick_curve(input_.right_x);
        state.yaw_right_rad_per_s = without_tremor(input_.yaw_right_rad_per_s);
        state.buttons = translated(input_.buttons, kPadButtons) | hat_buttons(input_.hat);
        return !pad_->lost();
    }
    bool cue(const device::FingerCue& cue) noexcept override { return pad_->write(pad_output_for(cue)); }

private:
    std::unique_ptr<PlaystationPad> pad_;
    PadInput input_;
};

class PuckCompanion final : public Companion {
public:
    explicit PuckCompanion(std::unique_ptr<HidLink> link) : puck_(std::move(link)) { puck_.light(true); }
    ~PuckCompanion() override { puck_.light(false); }
    bool read(CompanionState& state, double now_s) noexcept override {
        const PuckState& puck = puck_.poll(now_s);
        state.ahead = puck.move.y;
        state.right = puck.move.x;
        state.turn_right = -puck.turn.z;
        state.buttons = translated(puck.buttons, kPuckButtons);
        return !puck_.lost();
    }
    bool cue(const device::FingerCue&) noexcept override { return !puck_.lost(); }

private:
    SpaceMouse puck_;
};

// A pad that only vibrates: strong pulses for knocks, weak ones for grain. The pad has no trigger that could resist, so
// a hum indicates nearness.
class RumbleCompanion final : public Companion {
public:
    explicit RumbleCompanion(std::unique_ptr<FfLink> link) : link_(std::move(link)) {}
    bool read(CompanionState& state, double) noexcept override {
        FfLink::Stick stick;
        const bool there = link_->poll(stick);
        state.ahead = stick_curve(-stick.y);
        state.turn_right = stick_curve(stick.x);
        state.right = 0.0;
        state.buttons = translated(stick.buttons, kEventButtons);
        return there;
    }
    bool cue(const device::FingerCue& cue) noexcept override {
        constexpr double kHum = 0.3;
        const double hum = kHum * cue.nearness * cue.hardness;
        return link_->rumble(std::max(cue.knock, cue.doorway ? 1.0 : 0.0), std::max(cue.grain, hum));
    }

private:
    std::unique_ptr<FfLink> link_;
};

Result<std::unique_ptr<Companion>> open_hid_companion(const HidDeviceInfo& hid) {
    auto link = open_hid_link(hid);
    if (!link) return tl::unexpected(link.error());
    const auto identity = playstation_pad(hid.vendor, hid.product);
    if (!identity) return std::unique_ptr<Companion>(std::make_unique<PuckCompanion>(std::move(*link)));
    auto pad = std::make_unique<PlaystationPad>(std::move(*link), identity->model,
                                                hid.bluetooth ? PadBus::Bluetooth : PadBus::Usb);
    if (const auto opened = pad->open(); !opened) return tl::unexpected(opened.error());
    return std::unique_ptr<Companion>(std::make_unique<PadCompanion>(std::move(pad)));
}

}  // namespace

double stick_curve(double share) noexcept {
    const double beyond = (std::abs(share) - kStickDeadBand) / (1.0 - kStickDeadBand);
    return beyond > 0.0 ? std::copysign(std::min(1.0, beyond * beyond), share) : 0.0;
}

std::vector<FoundCompanion> find_companions() {
    std::vector<FoundCompanion> found;
    bool pad_over_hid = false;
    for (const HidDeviceInfo& hid : list_hid_devices()) {
        const auto identity = playstation_pad(hid.vendor, hid.product);
        if (identity) {
            found.push_back({std::string(identity->name), std::string(identity->spoken), hid.path, hid.permitted,
                             phrase("companion.pad")});
            pad_over_hid = pad_over_hid || hid.permitted;
        } else if (is_space_mouse(hid)) {
            found.push_back(
                {"spacemouse", companion_model("spacemouse"), hid.path, hid.permitted, phrase("companion.puck")});
        }
    }
    for (const FfDeviceInfo& ff : list_ff_devices()) {
        if (!ff.abilities.rumble || (ff.abilities.constant && ff.abilities.stick)) continue;
        if (pad_over_hid && is_event_node_of_a_playstation_pad(ff.name)) continue;
        found.push_back({"rumble-pad", ff.name.empty() ? companion_model("rumble-pad") : ff.name, ff.path, true,
                         phrase("companion.rumble")});
    }
    return found;
}

Result<std::unique_ptr<Companion>> open_companion(const FoundCompanion& found) {
    if (!found.permitted)
        return fail(phrase("companion.not_permitted", {{"device", found.model}, {"advice", permission_advice()}}));
    if (found.name == "rumble-pad") {
        auto link = open_ff_link(found.path);
        if (!link) return tl::unexpected(link.error());
        return std::unique_ptr<Companion>(std::make_unique<RumbleCompanion>(std::move(*link)));
    }
    for (const HidDeviceInfo& hid : list_hid_devices())
        if (hid.path == found.path) return open_hid_companion(hid);
    return fail(phrase("companion.gone", {{"device", found.model}}));
}

std::vector<std::string> companion_names() { return {"dualsense", "dualshock4", "spacemouse", "rumble-pad"}; }

std::string companion_model(std::string_view name) {
    if (name == "dualsense") return "DualSense";
    if (name == "dualshock4") return "DualShock 4";
    if (name == "spacemouse") return "SpaceMouse";
    return phrase("companion.rumble_pad");
}

}  // namespace handrail::drivers
