#include "app/main/transcript.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

namespace handrail::program {
namespace {

// The checksum FNV-1a with 64 bits (Fowler, Noll and Vo; RFC 9923). It uses the bits of numbers, so 0.0 and -0.0
// differ.
class Checksum {
public:
    void take(double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        for (int i = 0; i < 8; ++i) sum_ = (sum_ ^ (bits >> (8 * i) & 0xff)) * 0x100000001b3U;
    }
    void take(const Vec3& value) {
        for (int i = 0; i < 3; ++i) take(value[i]);
    }
    std::uint64_t value() const { return sum_; }

private:
    std::uint64_t sum_ = 0xcbf29ce484222325U;
};

void take(const core::LoggedTick& tick, Checksum& sum) {
    for (const Vec3& place : {tick.force_n, tick.hip_m, tick.proxy_m, tick.feet_m}) sum.take(place);
    for (const double value : {tick.time_s, tick.radius_m, tick.scale, tick.heading_rad,
                               static_cast<double>(tick.touched.value), tick.contact ? 1.0 : 0.0})
        sum.take(value);
}

std::string place(const Vec3& at) { return fmt::format("{} {} {}", at.x, at.y, at.z); }

std::string words_of(const core::LoggedSound& sound) {
    const cues::SoundCue& cue = sound.cue;
    return fmt::format("{} {} of {} at {} loudness {} pitch {} since {} pulses {} muffled {} source {}",
                       sound.loop ? "loop" : "play", static_cast<int>(cue.kind), static_cast<int>(cue.material),
                       place(cue.position_m), cue.loudness, cue.pitch, cue.event_time_s, cue.pulses_per_s,
                       cue.muffled_db, cue.source);
}

using Line = std::pair<double, std::string>;

void add_ticks(std::string_view whose, const std::vector<core::LoggedTick>& ticks, std::vector<Line>& lines) {
    constexpr std::size_t kEvery = 100;
    Checksum sum;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const core::LoggedTick& tick = ticks[i];
        take(tick, sum);
        if ((i + 1) % kEvery != 0 && i + 1 != ticks.size()) continue;
        lines.emplace_back(tick.time_s,
                           fmt::format("{} force {} hip {} ball {} touched {} feet {} heading {} sum {:016x}", whose,
                                       place(tick.force_n), place(tick.hip_m), place(tick.proxy_m),
                                       tick.contact ? static_cast<long>(tick.touched.value) : -1L, place(tick.feet_m),
                                       tick.heading_rad, sum.value()));
    }
}

}  // namespace

std::string transcript(const core::SessionLog& log) {
    std::vector<Line> lines;
    for (const core::LoggedLine& line : log.lines) lines.emplace_back(line.time_s, "say " + line.text);
    for (const core::LoggedSound& sound : log.sounds) lines.emplace_back(sound.time_s, words_of(sound));
    add_ticks("hand", log.ticks, lines);
    add_ticks("left", log.left_ticks, lines);
    std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.first < b.first; });
    std::string text;
    for (const auto& [time_s, words] : lines) text += fmt::format("{:8.3f} {}\n", time_s, words);
    return text;
}

}  // namespace handrail::program
