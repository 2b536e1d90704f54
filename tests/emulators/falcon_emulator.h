// Emulates a Novint Falcon at its USB link: serial chip, boot ROM, firmware, three encoders and three motors. A
// simulated hand holds the grip. The emulator computes its geometry by bisection and finite differences, independently
// of the driver, so that it can contradict the driver. Axes of the Falcon: x right, y up, z towards the person. Not
// thread-safe; the umockdev test bed locks a mutex around it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <random>
#include <vector>

#include "haptic/drivers/byte_link.h"
#include "tests/support/names.h"
#include "worlds/base/clock.h"
#include "worlds/base/vec.h"

namespace handrail::test {

// Returns a firmware image with `data_bytes` of data in two blocks. A boot ROM accepts the image, but its contents have
// no meaning.
std::vector<std::uint8_t> boot_image(std::size_t data_bytes);

class FalconEmulator {
public:
    enum class Stage { Silent, BootRom, Loader, Running };

    // The simulated hand is a damped mass at `grip_m`, pushed by `push_n`. It moves for 1 ms in each frame. If `held`
    // is true, it stays at `grip_m`.
    Vec3 grip_m{0.0, 0.0, 0.145};
    Vec3 velocity_m_per_s{0.0};
    Vec3 push_n{0.0};
    double damping_ns_per_m = 8.0;
    double mass_kg = 0.1;
    bool held = true;
    int frames_until_homed = 0;
    // If true, homing works differently: two legs find their zero when the hand pulls the grip out, the third when it
    // pushes the grip in again.
    bool homes_by_moving = false;
    std::uint8_t buttons = 0;
    double counts_per_nm = 10000.0;  // motor counts for a torque of 1 Nm

    // Faults that the emulated device can have.
    int wrong_echo_at_byte = -1;  // index of a byte that the device echoes wrongly, once; -1: none
    int lose_every_nth_answer = 0;
    // The device holds every nth answer back until the next command. 0: none.
    int late_every_nth_answer = 0;
    int garbage_before_every_nth = 0;
    // The device sends only the first half of every nth answer. 0: none.
    int torn_every_nth_answer = 0;
    int stuck_leg = -1;
    bool leading_zero = false;
    bool deaf = false;  // the device has no power and does not respond

    Stage stage = Stage::Silent;
    std::vector<std::uint8_t> firmware;
    std::size_t firmware_wanted = 0;  // number of bytes after which the firmware starts

    // The data that the emulator has received from the driver.
    std::array<int, 3> motors{};
    std::uint64_t frames = 0, malformed = 0, over_range = 0, frames_before_homed_with_force = 0;
    double largest_force_n = 0.0;
    unsigned latency_ms = 16;
    bool homed() const { return homed_legs_ == 7; }
    Vec3 force_on_hand_n() const { return force_for(motors, grip_m); }
    // The emulator calls this after each frame.
    std::function<void(FalconEmulator&)> after_frame;

    // The chip's side of the USB connection.
    bool control(std::uint8_t request, std::uint16_t value);
    void out(const std::uint8_t* bytes, std::size_t size);
    // Returns one packet: two status bytes, then at most `room - 2` payload bytes.
    std::size_t in(std::uint8_t* bytes, std::size_t room);
    bool has_payload() const { return !to_host_.empty(); }

    static Vec3 leg_angles_at(const Vec3& grip_m);
    Vec3 force_for(const std::array<int, 3>& counts, const Vec3& at_m) const;

private:
    void run();
    void answer();
    void move_hand();
    void answer_host(std::initializer_list<std::uint8_t> bytes) { to_host_.insert(to_host_.end(), bytes); }

    std::deque<std::uint8_t> to_host_;
    std::vector<std::uint8_t> from_host_, late_;
    unsigned divisor_ = 0;
    bool speed_known_ = false;
    std::uint8_t homed_legs_ = 0;
    bool homing_requested_ = false;
    std::array<int, 3> encoders_{}, unknown_zero_{300, -120, 55};
    int stuck_at_ = 0;
    bool is_stuck_ = false;
    std::mt19937 random_{7};
};

// Connects the emulator to a ByteLink in virtual time. A read that finds no data lets the chip's latency timer expire.
class DirectFalconLink final : public ByteLink {
public:
    DirectFalconLink(FalconEmulator& falcon, VirtualClock& clock) : falcon_(falcon), clock_(clock) {}
    bool control(std::uint8_t request, std::uint16_t value) noexcept override;
    int write(std::span<const std::uint8_t> bytes, double timeout_s) noexcept override;
    int read(std::span<std::uint8_t> room, double timeout_s) noexcept override;

    bool unplugged = false;
    bool in_fragments = false;  // packets of 0 to 7 payload bytes
    std::uint64_t packets = 0;

private:
    FalconEmulator& falcon_;
    VirtualClock& clock_;
    std::mt19937 random_{11};
};

}  // namespace handrail::test
