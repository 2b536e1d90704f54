// Identifies features and materials across modules without pointers. To get a feature's name, look it up in the Scene,
// off the real-time path.
#pragma once

#include <cstdint>

namespace handrail {

// An index into Scene::features, or kNoFeature.
struct FeatureId {
    std::uint32_t value = 0xffffffffU;
    friend bool operator==(FeatureId, FeatureId) = default;
    explicit operator bool() const noexcept { return value != 0xffffffffU; }
};
inline constexpr FeatureId kNoFeature{};

// An index into Scene::materials and HapticScene::materials, which have the same order. Index 0 is the default
// material, that of walls.
using MaterialId = std::uint16_t;
inline constexpr MaterialId kDefaultMaterial = 0;

}  // namespace handrail
