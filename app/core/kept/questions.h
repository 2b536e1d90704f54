// Stores the questions of a quiz, which a person sets at places of a world. They are in the list `question` of the side
// file. Pure functions over plain values, for the app thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/kept/side_file.h"

namespace handrail::core {

struct PlaceQuestion {
    std::string text;    // the question, which the person also sees under the key "name"
    std::string answer;  // the right answer
    Vec3 place_m{0.0};   // where the soles of the person stand who is asked
    double heading_rad = 0.0;
    SideEntry kept = {};  // keys of the side file that this version does not know
};

// Returns the questions in the order of the file. Entries without a text, an answer or a place stay in the file but are
// not returned. `faults` receives an error for each of them.
std::vector<PlaceQuestion> read_questions(const SideFile& file, std::vector<Error>& faults);
void write_questions(SideFile& file, const std::vector<PlaceQuestion>& questions);

// Returns true if the typed text has all the words of the right answer. Case, punctuation and words such as "the" do
// not matter. Depends on the language spoken.
bool is_right(const PlaceQuestion& question, std::string_view typed);

}  // namespace handrail::core
