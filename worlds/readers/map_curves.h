// Collects the curved patches of a map while the map is read. They are turned into triangles at the end, when the
// number of patches is known. Used on the reading thread only.
#pragma once

#include <stop_token>
#include <vector>

#include "worlds/geometry/bezier_patch.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

// A patch in world metres, before it is turned into triangles.
struct MapCurve {
    PatchGrid grid;
    FeatureId feature;
    MaterialId material = kDefaultMaterial;
    TouchSide side = TouchSide::Both;
};

class MapCurves {
public:
    void add(MapCurve curve) { bent_.push_back(std::move(curve)); }
    void leave_out() { ++left_out_; }
    int left_out() const { return left_out_; }

    // Turns all patches into triangles of the scene and its features. No triangle is farther than chord_m from its
    // curve. If this accuracy needs too many triangles, the patches get fewer and larger ones.
    void bend(Scene& scene, double chord_m, const std::stop_token& stop);

private:
    std::vector<MapCurve> bent_;
    int left_out_ = 0;
};

}  // namespace handrail::readers
