// Identifies things across modules without pointers. Names of a feature are looked up in the Scene, off the real-time
// path.
#pragma once

#include <cstdint>

namespace handrail {

// Index into Scene::features, or kNoFeature.
struct FeatureId {
    std::uint32_t value = 0xffffffffU;
    friend bool operator==(FeatureId, FeatureId) = default;
    explicit operator bool() const noexcept { return value != 0xffffffffU; }
};
inline constexpr FeatureId kNoFeature{};

// Index into Scene::materials and HapticScene::materials, which have the same order. 0 is the default wall.
using MaterialId = std::uint16_t;
inline constexpr MaterialId kDefaultMaterial = 0;

}  // namespace handrail
