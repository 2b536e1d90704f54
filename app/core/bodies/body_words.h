// Puts movable things into words. These are functions of the context. Call them on the app thread.
#pragma once

#include <string>

#include "app/core/context/session_context.h"

namespace handrail::core {

// Returns the name without the material, with a capital letter for the start of a sentence: "Crate".
std::string body_name(const SessionContext& context, FeatureId feature);
// Returns the mass in words with two significant digits: "12 kilograms".
std::string mass_words(double mass_kg);
// Returns the announcement of a thing that is too heavy: "Safe. Heavy, 400 kilograms."
std::string heavy_words(const SessionContext& context, FeatureId feature, double mass_kg);

}  // namespace handrail::core
