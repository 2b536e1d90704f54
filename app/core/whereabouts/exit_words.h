// The exits of a room, each in as few words as possible for what it is and where: "Door to kitchen, 5 steps, half
// left". Functions of what the context contains; app thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// Clockwise from straight ahead, or nearest first. `told`: only exits to rooms for which it returns true; empty: all.
// Each ends with a full stop.
enum class ExitOrder { Clockwise, Nearest };
std::vector<std::string> exit_sentences(const SessionContext& context, const navigation::RoomGraph& graph,
                                        std::uint32_t room, ExitOrder order,
                                        const std::function<bool(std::uint32_t)>& told = {});

// Exits for an answer: clockwise, or, of more than eight, the nearest eight and then the number of the others of each
// kind. Otherwise a large hall would take a minute.
struct ListedExits {
    std::size_t count = 0;  // total number
    std::vector<std::string> sentences;
};
ListedExits listed_exits(const SessionContext& context, const navigation::RoomGraph& graph, std::uint32_t room,
                         const std::function<bool(std::uint32_t)>& told);

}  // namespace handrail::core
