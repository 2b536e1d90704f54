// What the settings contain for one device: the person's overrides and what was measured with it. Pure functions; any
// thread.
#pragma once

#include "app/core/context/hands_state.h"
#include "settings/settings.h"

namespace handrail::core {

// What was measured with exactly this device; null: nothing was measured, or there is no hand.
const settings::DeviceProfile* profile_of(const settings::Settings& settings, const HandFacts& hand);
// Overrides the general workspace settings with those for devices of this name, and these with what was measured with
// exactly this device.
void lay_device_overrides(settings::Settings& settings, const HandFacts& hand);
// Newtons; the lower of two limits: the person's choice for all devices, and what was found comfortable with this one.
double ceiling_n(const settings::Settings& settings, const HandFacts& hand);

}  // namespace handrail::core
