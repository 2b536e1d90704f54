// The exits of a room in words. Each has as few words as possible for what and where it is: "Door to kitchen, 5 steps,
// half left". Functions of the context; app thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// Returns the exits clockwise from straight ahead, or the nearest first. Each sentence ends with a full stop. If `told`
// is not empty, only exits to rooms for which it returns true are included.
enum class ExitOrder { Clockwise, Nearest };
std::vector<std::string> exit_sentences(const SessionContext& context, const navigation::RoomGraph& graph,
                                        std::uint32_t room, ExitOrder order,
                                        const std::function<bool(std::uint32_t)>& told = {});

// The exits for an answer, clockwise. If there are more than eight, only the nearest eight, and then the number of the
// others of each kind. Otherwise the exits of a large hall would take a minute to say.
struct ListedExits {
    std::size_t count = 0;  // number of all exits
    std::vector<std::string> sentences;
};
ListedExits listed_exits(const SessionContext& context, const navigation::RoomGraph& graph, std::uint32_t room,
                         const std::function<bool(std::uint32_t)>& told);

}  // namespace handrail::core
