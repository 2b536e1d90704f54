#include "settings/presets.h"

#include <fmt/format.h>

#include <array>

namespace handrail::settings {

std::vector<std::pair<std::string_view, std::string>> Preset::values() const {
    return {{"walk.step_length_m", fmt::format("{}", step_length_m)},
            {"walk.speed_m_per_s", fmt::format("{}", speed_m_per_s)},
            {"speech.verbosity", fmt::format("{}", verbosity)}};
}

bool Preset::is_set(const Settings& settings) const {
    return settings.walk.step_length_m == step_length_m && settings.walk.speed_m_per_s == speed_m_per_s &&
           settings.speech.verbosity == verbosity;
}

std::span<const Preset> presets() {
    static constexpr std::array kPresets{
        Preset{"calm", "preset_name.calm", 0.5, 0.6, 3},
        Preset{"usual", "preset_name.usual", 0.7, 1.0, 2},
        Preset{"brisk", "preset_name.brisk", 0.8, 1.5, 1},
    };
    return kPresets;
}

}  // namespace handrail::settings
