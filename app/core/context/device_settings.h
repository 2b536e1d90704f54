// What the settings say of one device: what the person wrote for it, what was measured with it. Pure functions; any
// thread.
#pragma once

#include "app/core/context/hands_state.h"
#include "settings/settings.h"

namespace handrail {

// What was measured with that very device; null: nothing, or there is no hand.
const DeviceProfile* profile_of(const Settings& settings, const HandFacts& hand);
// On top of the general workspace lies what the person wrote for devices of this name, on top of that what was measured
// with this very one.
void lay_device_overrides(Settings& settings, const HandFacts& hand);
// Newtons: the lowest of what the person chose for all devices and what was found comfortable with this one.
double ceiling_n(const Settings& settings, const HandFacts& hand);

}  // namespace handrail
