#include "app/core/context/device_settings.h"

#include <algorithm>
#include <string>

namespace handrail::core {

const settings::DeviceProfile* profile_of(const settings::Settings& settings, const HandFacts& hand) {
    const auto found = settings.profiles.find(settings::profile_key(hand.spec.name, hand.serial));
    return hand.present && found != settings.profiles.end() ? &found->second : nullptr;
}

void lay_device_overrides(settings::Settings& settings, const HandFacts& hand) {
    settings::Settings::Workspace& workspace = settings.workspace;
    const auto found = workspace.devices.find(std::string(hand.spec.name));
    if (hand.present && found != workspace.devices.end()) {
        const settings::Settings::Workspace::Override& own = found->second;
        workspace.scale = own.scale.value_or(workspace.scale);
        workspace.offset_ahead_m = own.offset_ahead_m.value_or(workspace.offset_ahead_m);
        workspace.offset_up_m = own.offset_up_m.value_or(workspace.offset_up_m);
        workspace.hand_height_m = own.hand_height_m.value_or(workspace.hand_height_m);
    }
    if (const settings::DeviceProfile* own = profile_of(settings, hand)) {
        workspace.scale = own->scale.value_or(workspace.scale);
        workspace.offset_ahead_m = own->offset_ahead_m.value_or(workspace.offset_ahead_m);
        workspace.offset_up_m = own->offset_up_m.value_or(workspace.offset_up_m);
    }
}

double ceiling_n(const settings::Settings& settings, const HandFacts& hand) {
    double ceiling = hand.spec.peak_force_n;
    if (settings.haptic.ceiling == settings::ForceCeiling::Light) ceiling = settings::kLightCeiling_n;
    if (settings.haptic.ceiling == settings::ForceCeiling::Normal) ceiling = settings::kNormalCeiling_n;
    if (const settings::DeviceProfile* own = profile_of(settings, hand); own && own->ceiling_n)
        ceiling = std::min(ceiling, *own->ceiling_n);
    if (settings.damaged_profiles.contains(settings::profile_key(hand.spec.name, hand.serial)))
        ceiling = std::min(ceiling, settings::kLightCeiling_n);
    return ceiling;
}

}  // namespace handrail::core
