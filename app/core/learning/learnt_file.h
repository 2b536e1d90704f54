// Stores the progress of learning a world, as lists in the world's side file. If the person wants progress to be
// remembered, `learnt` has one entry. This entry is a reduced set of touched stretches of wall and walked floor.
// `learnt_room` has one entry for each room. Pure functions for the app thread, in world metres and seconds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "app/core/learning/learning.h"

namespace handrail::core {

struct KeptRoom {
    std::string name;  // name of the room in the room graph
    double spent_s = 0.0;
    std::optional<Vec3> base_m;
    bool walls_done = false;
    int lanes_announced = 0;
};
struct KeptLearning {
    int sessions = 0;  // number of sessions in which the person learnt something in this world
    double spent_s = 0.0;
    std::vector<TouchNote> touches;
    std::vector<Vec3> steps_m;
    std::vector<KeptRoom> rooms;
};

// Returns true if the person wants progress in this world to be stored.
bool remembers(const SideFile& file);
// Starts or stops storing progress. Stopping also deletes the stored progress. The function changes only the memory,
// and the owner saves `file` later.
void set_remembers(SideFile& file, bool on);
// Fails with file and line if an entry does not have the form that write_learnt() writes.
Result<KeptLearning> read_learnt(const SideFile& file);
// Writes the progress to `file` in memory. Unknown keys of the entries stay in the file.
void write_learnt(SideFile& file, const KeptLearning& kept);

// Reduces the notes to few stretches of wall and few places on the floor. Overlapping touches of one plane become
// stretches of at most a metre, and one step is left in each 10 cm. The border of what the person knows shifts by at
// most 1 cm along walls and 7 cm on floors. A second application changes nothing.
void thin_out(const LearningNotes& notes, KeptLearning& kept);

}  // namespace handrail::core
