// The ways out of a room, each in as few words as tell which it is and where: "Door to kitchen, 5 steps, half left".
// Functions of what the context holds; app thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "worlds/navigation/rooms.h"

namespace handrail {

// Clockwise from straight ahead, or the nearest first. `told`: those that lead into a room for which it holds; none:
// all. Each ends with a stop.
enum class ExitOrder { Clockwise, Nearest };
std::vector<std::string> exit_sentences(const SessionContext& context, const RoomGraph& graph, std::uint32_t room,
                                        ExitOrder order, const std::function<bool(std::uint32_t)>& told = {});

// As an answer lists them: clockwise, or of more than eight the nearest eight and then how many more there are of each
// kind, so that a large hall is no speech of a minute.
struct ListedExits {
    std::size_t count = 0;  // of all
    std::vector<std::string> sentences;
};
ListedExits listed_exits(const SessionContext& context, const RoomGraph& graph, std::uint32_t room,
                         const std::function<bool(std::uint32_t)>& told);

}  // namespace handrail
