// The list of everything that has a name: the nearest first, several of one name together, each with where it is, in
// which room and on which storey; all of it or one kind alone. App thread only.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/wayfinding/stops.h"

namespace handrail {

// What one may look for alone.
enum class FindKind { Everything, Doors, Landmarks, Things, Marks };
inline constexpr int kFindKinds = 5;

// A goal, the room it is in where that is another than the body's and both are known, and how far it is on foot then.
struct Found {
    Goal goal;
    std::uint32_t room = kNothing;
    std::optional<double> on_foot_m;  // none: in the same room, or no way there is known
};
// Those of one name, the nearest first.
struct FindGroup {
    std::string name;
    std::vector<Found> found;
};
// In the order of the nearest of each; what is in other rooms is as far as the way to it on foot.
std::vector<FindGroup> find_groups(const SessionContext& context, const Rooms& rooms, FindKind kind);

// "3 steps on foot, left, one storey above, Kitchen".
std::string find_words(const SessionContext& context, const Rooms& rooms, const Found& found);

// A name stands for the one thing that has it, or opens the list of those that do.
void open_find_list(const SessionContext& context, const Rooms& rooms,
                    std::function<void(const Goal& goal, double now_s)> chosen, double now_s);

}  // namespace handrail
