// The list of everything that has a name: the nearest first, several of one name together, each with where it is, in
// which room and on which storey; all of it or one kind alone. App thread only.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/core/wayfinding/stops.h"

namespace handrail {

// What one may look for alone.
enum class FindKind { Everything, Doors, Landmarks, Things, Marks };
inline constexpr int kFindKinds = 5;

// Goals of one name, the nearest first.
struct FindGroup {
    std::string name;
    std::vector<Goal> goals;
};
// In the order of the nearest of each.
std::vector<FindGroup> find_groups(const SessionContext& context, FindKind kind);

// "3 steps, left, Kitchen, one storey above": the room where that is another than the body's and both are known.
std::string find_words(const SessionContext& context, const Rooms& rooms, const Goal& goal);

// A name stands for the one thing that has it, or opens the list of those that do.
void open_find_list(const SessionContext& context, const Rooms& rooms,
                    std::function<void(const Goal& goal, double now_s)> chosen, double now_s);

}  // namespace handrail
