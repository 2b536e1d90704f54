// Defines the parts of the voice-led set-up (wizard.h), and their names. Plain data.
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
    std::string_view word;  // name of the part in the option --only, such as "headphones"
    bool needs_device;
};
std::span<const WizardPartInfo> wizard_parts();
// Converts a text such as "headphones,reach" to parts in the order of WizardPart. An empty text means all parts. Fails
// if a word is unknown, and suggests the nearest known word.
Result<std::vector<WizardPart>> parse_wizard_parts(std::string_view words);

}  // namespace handrail::wizard
