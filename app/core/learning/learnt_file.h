// How the progress of learning a world's places is stored between sessions, as lists in the world's side file. If the
// person wants progress to be remembered, `learnt` has one entry: a reduced set of touched stretches of wall and walked
// floor. `learnt_room` has one entry for each room. Pure functions; app thread; world metres, seconds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "app/core/learning/learning.h"

namespace handrail::core {

struct KeptRoom {
    std::string name;  // as in the room graph
    double spent_s = 0.0;
    std::optional<Vec3> base_m;
    bool walls_done = false;
    int lanes_told = 0;
};
struct KeptLearning {
    int sessions = 0;  // number of sessions in which something was learnt here
    double spent_s = 0.0;
    std::vector<TouchNote> touches;
    std::vector<Vec3> steps_m;
    std::vector<KeptRoom> rooms;
};

// True if progress in this world is to be stored.
bool remembers(const SideFile& file);
// Starts or stops storing; stopping deletes what was stored. In memory until the file is saved.
void set_remembers(SideFile& file, bool on);
// Fails with file and line if an entry has a form that is never written.
Result<KeptLearning> read_learnt(const SideFile& file);
// Unknown keys of the entries are kept.
void write_learnt(SideFile& file, const KeptLearning& kept);

// Reduces the notes to few stretches and places. Overlapping touches of one plane become stretches of at most a metre,
// and steps become one for each 10 cm. What counts as known changes by at most 1 cm along walls and 7 cm on floors. A
// second application changes nothing.
void thin_out(const LearningNotes& notes, KeptLearning& kept);

}  // namespace handrail::core
