#include "tests/emulators/falcon_emulator.h"
#include "tests/support/names.h"

#include <algorithm>
#include <cmath>

namespace handrail::test {
namespace {

// Dimensions of the Falcon's legs in metres.
constexpr double kThigh = 0.060, kRod = 0.1025, kJoints = 0.0225;
constexpr double kFrameMs = 1e-3;

double leg_direction(int leg) { return radians_from_degrees(105.0 - 120.0 * leg); }

// Returns |knee - grip|^2 - reach^2 in the plane of `leg`. The leg closes where the result is zero.
double open_by(const Vec3& grip, int leg, double angle) {
    const double phi = leg_direction(leg);
    const double u = grip.x * std::cos(phi) + grip.y * std::sin(phi) - 0.0400 + 0.01443;
    const double v = -grip.x * std::sin(phi) + grip.y * std::cos(phi) + 0.02309 - 0.025;
    const double reach = kJoints + std::sqrt(kRod * kRod - v * v);
    const double a = u - kThigh * std::cos(angle), b = grip.z - kThigh * std::sin(angle);
    return a * a + b * b - reach * reach;
}

std::uint8_t low_byte(int value) { return static_cast<std::uint8_t>(value & 0xff); }

}  // namespace

std::vector<std::uint8_t> boot_image(std::size_t data_bytes) {
    std::vector<std::uint8_t> image;
    const auto word = [&](unsigned value) {
        image.push_back(static_cast<std::uint8_t>(value & 0xff));
        image.push_back(static_cast<std::uint8_t>(value >> 8));
    };
    word(0x08AA);
    for (int i = 0; i < 8; ++i) word(0);
    word(0x003F);
    word(0x8000);
    const std::size_t words = data_bytes / 2, first = words / 3;
    unsigned next = 1;
    for (const std::size_t count : {first, words - first}) {
        if (count == 0) continue;
        word(static_cast<unsigned>(count));
        word(0x003F);
        word(0x8000);
        for (std::size_t i = 0; i < count; ++i) word((next = next * 25173 + 13849) & 0xffff);
    }
    word(0);
    return image;
}

// Returns the angle of each leg at which it closes. Bisection, from the side of the grip to the opposite side.
Vec3 FalconEmulator::leg_angles_at(const Vec3& grip) {
    Vec3 angles{0.0};
    for (int leg = 0; leg < 3; ++leg) {
        const double phi = leg_direction(leg);
        const double towards = std::atan2(grip.z, grip.x * std::cos(phi) + grip.y * std::sin(phi) - 0.0400 + 0.01443);
        double near = towards, far = towards - kPi;  // open_by() is negative near the grip and positive on the far side
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (near + far);
            (open_by(grip, leg, middle) > 0.0 ? far : near) = middle;
        }
        angles[leg] = 0.5 * (near + far);
    }
    return angles;
}

// Returns the force of the motors on the grip. It is the motors' work over a small displacement, by finite differences.
Vec3 FalconEmulator::force_for(const std::array<int, 3>& counts, const Vec3& at) const {
    constexpr double kStep = 1e-6;
    Vec3 force{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 step{0.0};
        step[axis] = kStep;
        const Vec3 turned = (leg_angles_at(at + step) - leg_angles_at(at - step)) / (2.0 * kStep);
        for (int leg = 0; leg < 3; ++leg)
            force[axis] += turned[leg] * (-counts[static_cast<std::size_t>(leg)] / counts_per_nm);
    }
    return force;
}

bool FalconEmulator::control(std::uint8_t request, std::uint16_t value) {
    switch (request) {
        case 0:
            if (value != 2) to_host_.clear();
            if (value != 1) from_host_.clear();
            return true;
        case 1:
            if ((value & 0x0101) == 0x0101 && stage != Stage::Running && !deaf) {
                stage = Stage::BootRom;
                firmware.clear();
                speed_known_ = false;
            }
            return true;
        case 2:
        case 4:
            return true;
        case 3:
            divisor_ = value;
            return true;
        case 9:
            latency_ms = value & 0xffU;
            return true;
        default:
            return false;
    }
}

void FalconEmulator::out(const std::uint8_t* bytes, std::size_t size) {
    from_host_.insert(from_host_.end(), bytes, bytes + size);
    run();
}

std::size_t FalconEmulator::in(std::uint8_t* bytes, std::size_t room) {
    if (room < 2) return 0;
    bytes[0] = 0x01;
    bytes[1] = 0x60;
    std::size_t size = 2;
    while (size < std::min<std::size_t>(room, 64) && !to_host_.empty()) {
        bytes[size++] = to_host_.front();
        to_host_.pop_front();
    }
    return size;
}

void FalconEmulator::run() {
    for (;;) {
        switch (stage) {
            case Stage::Silent:
                from_host_.clear();
                return;
            case Stage::BootRom:
                if (divisor_ == 0x4138) {
                    if (from_host_.size() < 3) return;
                    const bool hello = from_host_[0] == 0x0a && from_host_[1] == 0x43 && from_host_[2] == 0x0d;
                    from_host_.erase(from_host_.begin(), from_host_.begin() + 3);
                    if (!hello) {
                        ++malformed;
                        continue;
                    }
                    if (leading_zero) answer_host({0x00});
                    answer_host({0x0a, 0x44, 0x2c, 0x0d});
                    stage = Stage::Loader;
                    continue;
                }
                from_host_.clear();
                return;
            case Stage::Loader:
                if (divisor_ == 0x0015) {
                    for (const std::uint8_t byte : from_host_) {
                        if (!speed_known_) {
                            speed_known_ = byte == 0x41;
                            if (speed_known_) to_host_.push_back(byte);
                            continue;
                        }
                        firmware.push_back(byte);
                        const bool wrong =
                            wrong_echo_at_byte >= 0 && static_cast<int>(firmware.size()) == wrong_echo_at_byte;
                        if (wrong) wrong_echo_at_byte = -1;
                        to_host_.push_back(wrong ? static_cast<std::uint8_t>(byte ^ 0x55) : byte);
                    }
                    from_host_.clear();
                    return;
                }
                if (divisor_ == 0x0002 && !firmware.empty() && firmware.size() == firmware_wanted) {
                    stage = Stage::Running;
                    continue;
                }
                from_host_.clear();
                return;
            case Stage::Running: {
                if (divisor_ != 0x0002) {
                    from_host_.clear();
                    return;
                }
                while (!from_host_.empty() && from_host_[0] != '<') {
                    from_host_.erase(from_host_.begin());
                    ++malformed;
                }
                if (from_host_.size() < 16) return;
                std::array<int, 3> wanted{};
                bool sound = from_host_[15] == '>';
                for (std::size_t leg = 0; leg < 3; ++leg) {
                    unsigned bits = 0;
                    for (std::size_t i = 0; i < 4; ++i) {
                        const unsigned nibble = from_host_[1 + 4 * leg + i] - 0x41U;
                        sound = sound && nibble <= 15;
                        bits |= (nibble & 15) << (4 * i);
                    }
                    wanted[leg] = static_cast<std::int16_t>(bits);
                    if (sound && std::abs(wanted[leg]) > 4095) ++over_range;
                }
                if (!sound) {
                    from_host_.erase(from_host_.begin());
                    ++malformed;
                    continue;
                }
                homing_requested_ = ((from_host_[13] - 0x41) & 1) != 0;
                from_host_.erase(from_host_.begin(), from_host_.begin() + 16);
                motors = wanted;
                ++frames;
                const Vec3 force = force_on_hand_n();
                largest_force_n = std::max(largest_force_n, std::sqrt(glm::dot(force, force)));
                if (homed_legs_ != 7 && motors != std::array<int, 3>{}) ++frames_before_homed_with_force;
                move_hand();
                answer();
                if (after_frame) after_frame(*this);
                continue;
            }
        }
    }
}

void FalconEmulator::move_hand() {
    if (!held) {
        velocity_m_per_s += (force_on_hand_n() + push_n - damping_ns_per_m * velocity_m_per_s) * (kFrameMs / mass_kg);
        grip_m += velocity_m_per_s * kFrameMs;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = axis == 2 ? 0.09 : -0.04, high = axis == 2 ? 0.165 : 0.04;
            if (grip_m[axis] < low || grip_m[axis] > high) velocity_m_per_s[axis] = 0.0;
            grip_m[axis] = std::clamp(grip_m[axis], low, high);
        }
    }
    if (homes_by_moving) {
        if (homing_requested_ && grip_m.z > 0.155) homed_legs_ |= 3;
        if (homing_requested_ && homed_legs_ == 3 && grip_m.z < 0.115) homed_legs_ = 7;
    } else if (homing_requested_ && static_cast<int>(frames) > frames_until_homed) homed_legs_ = 7;
    else if (homing_requested_ && static_cast<int>(frames) > frames_until_homed / 2) homed_legs_ |= 1;
    const Vec3 angles = leg_angles_at(grip_m);
    for (int leg = 0; leg < 3; ++leg) {
        const auto i = static_cast<std::size_t>(leg);
        const double counts = (angles[leg] - radians_from_degrees(35.0)) * 1280.0 / (2.0 * kPi) * 110.0 / 14.25;
        encoders_[i] = static_cast<int>(std::lround(counts)) + (homed_legs_ >> leg & 1 ? 0 : unknown_zero_[i]);
        if (leg != stuck_leg) continue;
        if (!is_stuck_) stuck_at_ = encoders_[i];
        is_stuck_ = true;
        encoders_[i] = stuck_at_;
    }
}

void FalconEmulator::answer() {
    const auto every = [this](int n) { return n > 0 && frames % static_cast<std::uint64_t>(n) == 0; };
    if (!late_.empty()) {
        to_host_.insert(to_host_.end(), late_.begin(), late_.end());
        late_.clear();
    }
    if (every(garbage_before_every_nth))
        for (int i = 0; i < 5; ++i) to_host_.push_back(low_byte(static_cast<int>(random_())));
    if (every(lose_every_nth_answer)) return;
    std::vector<std::uint8_t> frame(16, 0x41);
    frame[0] = '<';
    frame[15] = '>';
    for (std::size_t leg = 0; leg < 3; ++leg)
        for (std::size_t i = 0; i < 4; ++i)
            frame[1 + 4 * leg + i] =
                static_cast<std::uint8_t>(0x41 + ((static_cast<std::uint16_t>(encoders_[leg]) >> (4 * i)) & 15));
    frame[13] = static_cast<std::uint8_t>(0x41 + (buttons & 15) + (homed_legs_ << 4));
    if (every(torn_every_nth_answer)) frame.resize(8);
    if (every(late_every_nth_answer)) late_ = frame;
    else to_host_.insert(to_host_.end(), frame.begin(), frame.end());
}

bool DirectFalconLink::control(std::uint8_t request, std::uint16_t value) noexcept {
    return !unplugged && falcon_.control(request, value);
}

int DirectFalconLink::write(std::span<const std::uint8_t> bytes, double) noexcept {
    if (unplugged) return kLost;
    falcon_.out(bytes.data(), bytes.size());
    return static_cast<int>(bytes.size());
}

int DirectFalconLink::read(std::span<std::uint8_t> room, double timeout_s) noexcept {
    if (unplugged) return kLost;
    ++packets;
    std::size_t most = room.size();
    if (in_fragments) most = std::min<std::size_t>(most, 2 + random_() % 8);
    const bool nothing = !falcon_.has_payload() || most == 2;
    clock_.advance_s(nothing        ? std::min(std::max(timeout_s, 1e-5), falcon_.latency_ms * 1e-3)
                     : in_fragments ? 1e-5
                                    : 0.5e-3);
    return static_cast<int>(falcon_.in(room.data(), nothing ? 2 : most));
}

}  // namespace handrail::test
