#include "worlds/navigation/open_leaves.h"

#include <algorithm>
#include <cmath>

namespace handrail::navigation {

std::vector<std::uint8_t> mark_leaves(const WalkSpace& space, std::span<const OpenLeaf> leaves) {
    std::vector<std::uint8_t> marks;
    for (const OpenLeaf& leaf : leaves) {
        if (leaf.own_m.empty() || space.width == 0) continue;
        const PlacedFrame frame(leaf.at);
        Aabb stands;
        for (int corner = 0; corner < 8; ++corner)
            stands.include(frame.to_world({(corner & 1) ? leaf.own_m.max_m.x : leaf.own_m.min_m.x,
                                           (corner & 2) ? leaf.own_m.max_m.y : leaf.own_m.min_m.y,
                                           (corner & 4) ? leaf.own_m.max_m.z : leaf.own_m.min_m.z}));
        const double reach_m = space.body.radius_m + kLeafRoom_m;
        const auto cell = [&](double world, double origin, std::uint32_t count) {
            return static_cast<std::uint32_t>(
                std::clamp(std::floor((world - origin) / space.cell_m), 0.0, static_cast<double>(count - 1)));
        };
        const std::uint32_t x0 = cell(stands.min_m.x - reach_m, space.origin_m.x, space.width),
                            x1 = cell(stands.max_m.x + reach_m, space.origin_m.x, space.width);
        const std::uint32_t y0 = cell(stands.min_m.y - reach_m, space.origin_m.y, space.depth),
                            y1 = cell(stands.max_m.y + reach_m, space.origin_m.y, space.depth);
        for (std::uint32_t y = y0; y <= y1; ++y)
            for (std::uint32_t s = space.first[static_cast<std::size_t>(y) * space.width + x0];
                 s < space.first[static_cast<std::size_t>(y) * space.width + x1 + 1]; ++s) {
                const Vec3 place = space.place_m(s);
                if (place.z >= stands.max_m.z || place.z + space.body.height_m <= stands.min_m.z) continue;
                const Vec3 own = frame.to_own(place), inside = glm::clamp(own, leaf.own_m.min_m, leaf.own_m.max_m);
                const double level_m = std::hypot(own.x - inside.x, own.y - inside.y) * leaf.at.scale;
                if (level_m >= reach_m) continue;
                if (marks.empty()) marks.assign(space.spans.size(), kNoLeaf);
                marks[s] = std::max<std::uint8_t>(marks[s], level_m < space.body.radius_m ? kInLeaf : kNextToLeaf);
            }
    }
    return marks;
}

}  // namespace handrail::navigation
