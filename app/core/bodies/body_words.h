// What is said of things that are free to move. Functions of what the context holds; app thread.
#pragma once

#include <string>

#include "app/core/context/session_context.h"

namespace handrail {

// As a sentence begins with it, without its material: "Crate".
std::string body_name(const SessionContext& context, FeatureId feature);
// "12 kilograms", with two digits that count.
std::string mass_words(double mass_kg);
// "Safe. Heavy, 400 kilograms."
std::string heavy_words(const SessionContext& context, FeatureId feature, double mass_kg);

}  // namespace handrail
