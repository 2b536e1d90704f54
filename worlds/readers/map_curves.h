// Curved patches of a map, gathered while it is read and cut into triangles at its end, when it is known how many there
// are. One reading thread.
#pragma once

#include <stop_token>
#include <vector>

#include "worlds/geometry/bezier_patch.h"
#include "worlds/scene/scene.h"

namespace handrail {

// In world metres, before it is cut.
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

    // All become triangles of the scene and its features, nowhere further from the curve than chord_m; coarser ones
    // where they would be too many.
    void bend(Scene& scene, double chord_m, const std::stop_token& stop);

private:
    std::vector<MapCurve> bent_;
    int left_out_ = 0;
};

}  // namespace handrail
