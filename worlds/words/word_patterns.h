// Finds out what the words of a sentence say, by patterns for English and German. Pure functions; any thread.
#pragma once

#include <optional>
#include <set>
#include <span>

#include "worlds/base/vec.h"
#include "worlds/words/words_text.h"

namespace handrail::words {

enum class WordLanguage { English, German };

// What a part of a sentence says. All numbers are in metres already.
enum class Statement {
    Size2,       // numbers: west to east, south to north
    Size3,       // the same and height
    High,        // numbers[0] is the height
    Wide,        // numbers[0] is the width
    AboveFloor,  // numbers[0] above the floor
    SideOf,      // on side sides[0] of room `name`; numbers[0], if given, is the distance
    Above,       // above or below room `name`
    Further,     // numbers[0] farther towards sides[0]
    Flush,       // aligned with the end at sides[0]
    // Position of the south-west corner: numbers[0] towards sides[0] and numbers[1] towards sides[1], from the origin.
    CornerAt,
    At,          // position of the middle, in the same form
    Offset,      // the same, but from the south-west corner of the room
    CornerList,  // numbers: pairs of metres east and north of the origin; one such part for each piece of the outline
    Hole,        // the same for a hole; pieces that touch are joined
    Along,       // numbers[0] along the wall sides[0], if it is given
    FromWall,    // numbers[0] away from the wall or end at sides[0]
    InWall,      // in the wall at sides[0]
    MiddleOf,    // of the wall at sides[0]
    Middle,      // in the middle of the room
    InCorner,    // in the corner at sides[0]
    ByWindow,
    ByDoor,  // the door to room `name`, if given
    NextTo,  // next to `name`
    To,      // to room `name`
    Outside,
    In,      // in `name`
    Stairs,  // to room `name`
    Lift,    // to room `name`
    UpTo,    // up to `name`
    Landmark,
    Clue,
    Called,    // called `name`
    MadeOf,    // made of the library's material `name`
    Floor,     // its floor is made of the library's material `name`
    Walls,     // its walls are made of the library's material `name`
    Thick,     // numbers[0] is the thickness of the walls
    Facing,    // towards sides[0]
    ByItself,  // a door that opens automatically when somebody comes near
    Raised,    // the floor of the room is numbers[0] higher than that of its storey
    Sunk,      // the same, but lower
    FromRoom,  // room `name`, where a lift, stairs or a drop begins
    DropOf,    // numbers[0] is the height of the drop
    Railing,   // numbers[0] high, around a room
    UpSide,    // stairs rise towards sides[0]
    UpAndBack  // stairs rise towards sides[0] and turn back there
};

// Sides: 0 north, 1 north-east, ... 7 north-west. These four are relative to the direction of view or of walking.
inline constexpr int kLeftSide = 8, kRightSide = 9, kFrontSide = 10, kBackSide = 11;

struct SaidPart {
    Statement says = Statement::Size2;
    std::vector<double> numbers;
    std::vector<int> sides;
    std::string name;  // as written in the text
};

// The kinds of sentences.
enum class SentenceKind {
    Room,
    Door,
    SlidingDoor,
    Opening,
    Lift,    // a platform that moves from one room to another
    Flight,  // stairs from one room to another that are not a room themselves
    Drop,    // an open edge to step down from one room to another
    Window,
    Start,
    Thing,
    Building,
    Storey,
    Step,
    Walls,
    Language
};

struct SaidSentence {
    SentenceKind kind = SentenceKind::Thing;
    bool explicit_kind = false;  // the sentence begins with its kind: "Room: ..."
    bool fixture = false;        // the sentence begins with "Fixture:"; the thing is no furniture
    std::string name;            // the subject as written; for several things the name of one
    int count = 1;               // number of things, as in "Two chairs"
    std::vector<SaidPart> parts;
    std::vector<std::string> not_understood;  // words as written
    bool in_steps = false;

    const SaidPart* find(Statement says) const;
};

// The language that most of the words belong to.
WordLanguage language_of(std::span<const WordSentence> sentences);

struct SpeakersOf {
    WordLanguage language = WordLanguage::English;
    double step_m = 0.7;
    std::set<std::string> names;  // folded names of rooms, storeys and things, so that sentences can refer to them
};

// Reads only the beginning, for the kind and the subject; fast.
SaidSentence head_of(const WordSentence& sentence, const SpeakersOf& speaker);
// Reads the whole sentence, up to 120 words and 4,000 numbers.
SaidSentence understood(const WordSentence& sentence, const SpeakersOf& speaker);

// The form in which names are compared: folded, without an article in front.
std::string name_key(std::string_view name, WordLanguage language);
// True if a name must be in quotation marks to be read back unchanged.
bool needs_quotation_marks(std::string_view name, WordLanguage language);
// The name in the material library; empty if the word is no material.
std::string material_of_word(std::string_view word);
// The word for a material in that language.
std::string word_of_material(std::string_view name, WordLanguage language);

// The usual size of a thing with that name: west to east, south to north, height.
Vec3 usual_size_m(std::string_view name);
// The singular of a known plural ("chairs", "Stühle"); empty if it is no known plural.
std::optional<std::string> one_of_several(std::string_view names);
// True if the usual size of such things is known.
bool usually_known(std::string_view name);

}  // namespace handrail::words
