// Words for movable things. Functions of what the context contains; app thread.
#pragma once

#include <string>

#include "app/core/context/session_context.h"

namespace handrail::core {

// The name as a sentence begins with it, without the material: "Crate".
std::string body_name(const SessionContext& context, FeatureId feature);
// "12 kilograms", with two significant digits.
std::string mass_words(double mass_kg);
// "Safe. Heavy, 400 kilograms."
std::string heavy_words(const SessionContext& context, FeatureId feature, double mass_kg);

}  // namespace handrail::core
