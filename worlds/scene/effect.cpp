#include "worlds/scene/effect.h"

#include <algorithm>
#include <array>

#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr std::array kEffects{
    EffectSpec{"magnet", EffectKind::Magnet, 2.0, -4.0, 4.0, 0.010, 0.001, 0.1, 0.010},
    EffectSpec{"detent", EffectKind::Detent, 1.5, 0.0, 4.0, 0.010, 0.002, 0.1, 0.010},
    EffectSpec{"button", EffectKind::Button, 1.0, 0.0, 4.0, 0.020, 0.002, 0.1, 0.010},
    EffectSpec{"fly-paper", EffectKind::FlyPaper, 3.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.010},
    EffectSpec{"inertia", EffectKind::Inertia, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.010},
    EffectSpec{"force", EffectKind::Force, 1.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.020},
    EffectSpec{"vibration", EffectKind::Vibration, 0.2, 0.0, 0.5, 0.0, 0.0, 0.0, 0.010},
};

}  // namespace

std::span<const EffectSpec> effect_table() { return kEffects; }

const EffectSpec* find_effect(std::string_view name) {
    const std::string wanted = lower_ascii(name);
    const auto found =
        std::find_if(kEffects.begin(), kEffects.end(), [&](const EffectSpec& row) { return row.name == wanted; });
    return found == kEffects.end() ? nullptr : &*found;
}

}  // namespace handrail
