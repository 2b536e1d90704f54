// The parts of the voice-led set-up (wizard.h), by their names. Plain data.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::wizard {

enum class WizardPart : std::uint8_t { Headphones, Find, Home, Hand, Gentlest, Strongest, Reach, Step };

struct WizardPartInfo {
    WizardPart part;
    std::string_view word;  // "headphones", as --only takes it
    bool needs_device;
};
std::span<const WizardPartInfo> wizard_parts();
// Converts "headphones,reach" to parts in their order; an empty text means all of them. Fails with the nearest known
// word.
Result<std::vector<WizardPart>> parse_wizard_parts(std::string_view words);

}  // namespace handrail::wizard
