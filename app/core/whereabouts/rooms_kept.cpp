#include "app/core/whereabouts/rooms_kept.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "worlds/base/language.h"

namespace handrail {
namespace {

auto sizes_of(const WalkBody& body) {
    return std::tie(body.radius_m, body.height_m, body.step_up_m, body.most_drop_m, body.cell_m);
}

}  // namespace

const RoomsKept::Found* RoomsKept::of(const std::shared_ptr<const Scene>& scene, const WalkBody& body) const {
    const std::string language = spoken_language();
    const auto found = std::find_if(found_.begin(), found_.end(), [&](const Found& one) {
        return one.scene == scene && sizes_of(one.body) == sizes_of(body) && one.language == language;
    });
    return found == found_.end() ? nullptr : &*found;
}

void RoomsKept::keep(Found found) {
    if (most_ == 0) return;
    if (found_.size() == most_) found_.pop_front();
    found_.push_back(std::move(found));
}

}  // namespace handrail
