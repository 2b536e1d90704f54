// Applies the settings for one device: the person's overrides, and the values that were measured with the device. Pure
// functions, which any thread may call.
#pragma once

#include "app/core/context/hands_state.h"
#include "settings/settings.h"

namespace handrail::core {

// Returns the values measured with exactly this device. Returns null if nothing was measured or there is no hand.
const settings::DeviceProfile* profile_of(const settings::Settings& settings, const HandFacts& hand);
// Overrides the general workspace settings in `settings` with those for devices of this name. Then overrides them with
// the values measured with exactly this device.
void lay_device_overrides(settings::Settings& settings, const HandFacts& hand);
// Returns the force limit in newtons. It is the lower of two limits: the person's choice for all devices, and the force
// found comfortable with this device.
double ceiling_n(const settings::Settings& settings, const HandFacts& hand);

}  // namespace handrail::core
