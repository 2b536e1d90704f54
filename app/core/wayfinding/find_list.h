// The list of everything with a name, nearest first. Things of one name are grouped, and each has its place, room and
// storey. The list shows everything or only one kind. App thread only.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/wayfinding/stops.h"

namespace handrail::core {

// What the list can show.
enum class FindKind { Everything, Doors, Landmarks, Things, Marks };
inline constexpr int kFindKinds = 5;

// A goal. The room and the distance on foot are set only if it is in another room than the walker and both rooms are
// known.
struct Found {
    Goal goal;
    std::uint32_t room = navigation::kNothing;
    std::optional<double> on_foot_m;  // none: in the same room, or no route is known
};
// All goals with one name, nearest first.
struct FindGroup {
    std::string name;
    std::vector<Found> found;
};
// Groups in the order of their nearest goals; for other rooms, the distance is the length of the route on foot.
std::vector<FindGroup> find_groups(const SessionContext& context, const Rooms& rooms, FindKind kind);

// "3 steps on foot, left, one storey above, Kitchen".
std::string find_words(const SessionContext& context, const Rooms& rooms, const Found& found);

// Choosing a name that only one thing has chooses that thing; otherwise a list of all with that name opens.
void open_find_list(const SessionContext& context, const Rooms& rooms,
                    std::function<void(const Goal& goal, double now_s)> chosen, double now_s);

}  // namespace handrail::core
