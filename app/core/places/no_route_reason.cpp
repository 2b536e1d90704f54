#include "app/core/places/no_route_reason.h"

#include "worlds/base/contract.h"
#include "worlds/check/faults.h"

namespace handrail::core {

void NoRouteReason::look(std::uint32_t room) {
    contract_pre(rooms_.found() && room < rooms_.graph().rooms.size());
    looking_.begin([scene = rooms_.file_scene(), navigation = rooms_.navigation_kept(), graph = rooms_.graph(),
                    room](const std::stop_token& stop) {
        const std::optional<check::WorldFault> fault =
            check::why_out_of_reach(*scene, navigation->space(), graph, room, stop);
        if (!fault) return std::string();
        // It has already been announced that there is no route.
        const bool known = fault->lack != check::Lack::Nothing || !fault->other.empty();
        return (known ? check::fault_words(*scene, *fault) + " " : std::string()) + check::fault_advice(*scene, *fault);
    });
}

void NoRouteReason::tick(double now_s) {
    if (auto why = looking_.take(); why && !why->empty())
        context_.say(std::move(*why), cues::SpeechClass::Answer, now_s);
}

}  // namespace handrail::core
