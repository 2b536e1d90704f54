// Lists everything with a name, the nearest first. Things with the same name form a group, and each thing has its
// place, room and storey. The list shows everything or only one kind. Use it on the app thread only.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/wayfinding/stops.h"

namespace handrail::core {

// The kinds that the list can show.
enum class FindKind { Everything, Doors, Landmarks, Things, Marks };
inline constexpr int kFindKinds = 5;

// A goal in the list. The room and the distance on foot are set only if the goal is in another room than the walker and
// both rooms are known.
struct Found {
    Goal goal;
    std::uint32_t room = navigation::kNothing;
    std::optional<double> on_foot_m;  // none: the goal is in the walker's room, or no route is known
};
// All goals with the same name, the nearest first.
struct FindGroup {
    std::string name;
    std::vector<Found> found;
};
// Returns the groups in the order of their nearest goals. For a goal in another room, the distance is the length of the
// route on foot.
std::vector<FindGroup> find_groups(const SessionContext& context, const Rooms& rooms, FindKind kind);

// Returns the place of a goal in words: "3 steps on foot, left, one storey above, Kitchen".
std::string find_words(const SessionContext& context, const Rooms& rooms, const Found& found);

// Opens the list. If only one thing has the chosen name, that thing is the choice. Otherwise a second list of all
// things with the name opens.
void open_find_list(const SessionContext& context, const Rooms& rooms,
                    std::function<void(const Goal& goal, double now_s)> chosen, double now_s);

}  // namespace handrail::core
