// What is kept of learning the places of a world from session to session: lists of the world's side file. `learnt` has
// one entry, which is there where the person wants to be remembered: touched stretches of wall and walked floor,
// thinned out; `learnt_room` has one for each room. Pure functions; app thread; world metres, seconds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "app/core/learning/learning.h"

namespace handrail {

struct KeptRoom {
    std::string name;  // as the room graph has it
    double spent_s = 0.0;
    std::optional<Vec3> base_m;
    bool walls_done = false;
    int lanes_told = 0;
};
struct KeptLearning {
    int sessions = 0;  // in which something was learnt here
    double spent_s = 0.0;
    std::vector<TouchNote> touches;
    std::vector<Vec3> steps_m;
    std::vector<KeptRoom> rooms;
};

// Whether what is learnt in this world is to be kept.
bool remembers(const SideFile& file);
// From now on it is, or no longer: what was kept is taken away then. In memory until it is saved.
void set_remembers(SideFile& file, bool on);
// Fails with file and line where something stands there that was never written so.
Result<KeptLearning> read_learnt(const SideFile& file);
// Keys of the entries that nobody here knows stay.
void write_learnt(SideFile& file, const KeptLearning& kept);

// The same stretches of wall and places of floor, as few as say it: overlapping touches of one plane become stretches
// of at most a metre, steps one for each 10 cm. Walls are as known by it as before within 1 cm, floor within 7 cm;
// doing it again changes nothing more.
void thin_out(const LearningNotes& notes, KeptLearning& kept);

}  // namespace handrail
