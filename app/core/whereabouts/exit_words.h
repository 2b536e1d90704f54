// Puts the exits of a room into words. Each exit is described with as few words as possible for what and where it is:
// "Door to kitchen, 5 steps, half left". Functions of the context, for the app thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// Returns the exits clockwise from straight ahead, or the nearest first. Each sentence ends with a full stop. If
// `included` is not empty, only exits to rooms for which `included` returns true are included.
enum class ExitOrder { Clockwise, Nearest };
std::vector<std::string> exit_sentences(const SessionContext& context, const navigation::RoomGraph& graph,
                                        std::uint32_t room, ExitOrder order,
                                        const std::function<bool(std::uint32_t)>& included = {});

// The exits for an answer, clockwise. If there are more than eight exits, `sentences` has only the nearest eight, and
// then the number of the others of each kind. Otherwise it would take a minute to announce the exits of a large hall.
struct ListedExits {
    std::size_t count = 0;  // number of all exits
    std::vector<std::string> sentences;
};
ListedExits listed_exits(const SessionContext& context, const navigation::RoomGraph& graph, std::uint32_t room,
                         const std::function<bool(std::uint32_t)>& included);

}  // namespace handrail::core
