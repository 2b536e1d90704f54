#include "app/core/bodies/body_words.h"

#include <cmath>

#include "app/core/dialogue/words.h"
#include "worlds/base/language.h"

namespace handrail::core {

std::string body_name(const SessionContext& context, FeatureId feature) {
    return sentence_case(spoken_name(context.world.scene->features[feature.value]));
}

std::string mass_words(double mass_kg) {
    const double digit = std::pow(10.0, std::floor(std::log10(mass_kg)) - 1.0);
    return phrase("bodies.mass", {{"mass", std::round(mass_kg / digit) * digit}});
}

std::string heavy_words(const SessionContext& context, FeatureId feature, double mass_kg) {
    return phrase("bodies.heavy", {{"name", body_name(context, feature)}, {"mass", mass_words(mass_kg)}});
}

}  // namespace handrail::core
