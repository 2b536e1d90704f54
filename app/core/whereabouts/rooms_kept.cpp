#include "app/core/whereabouts/rooms_kept.h"

#include <algorithm>
#include <utility>

#include "worlds/base/language.h"

namespace handrail::core {

const RoomsKept::Found* RoomsKept::of(const std::shared_ptr<const Scene>& scene,
                                      const navigation::WalkerMeasures& body) const {
    const std::string language = spoken_language();
    const auto found = std::find_if(found_.begin(), found_.end(), [&](const Found& one) {
        return one.scene == scene && one.body == body && one.language == language;
    });
    return found == found_.end() ? nullptr : &*found;
}

void RoomsKept::keep(Found found) {
    if (most_ == 0) return;
    if (found_.size() == most_) found_.pop_front();
    found_.push_back(std::move(found));
}

}  // namespace handrail::core
