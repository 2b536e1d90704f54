// Extracts the statements of a sentence from its words, with patterns for English and German. Pure functions; any
// thread may call them.
#pragma once

#include <optional>
#include <set>
#include <span>

#include "worlds/base/vec.h"
#include "worlds/words/words_text.h"

namespace handrail::words {

enum class WordLanguage { English, German };

// The statement that a part of a sentence makes. Numbers have already been converted to metres.
enum class Statement {
    Size2,       // numbers: the sizes from west to east and from south to north
    Size3,       // numbers: the sizes from west to east and from south to north, and the height
    High,        // numbers[0] is the height of the subject
    Wide,        // numbers[0] is the width of the subject
    AboveFloor,  // numbers[0] is the height above the floor
    SideOf,      // next to room `name`, on its side sides[0]; numbers[0], if given, is the distance
    Above,       // above or below room `name`, on another storey
    Further,     // position moved by numbers[0] towards sides[0]
    Flush,       // aligned with the end of the other room at sides[0]
    // Position of the south-west corner: numbers[0] towards sides[0] and numbers[1] towards sides[1], from the origin.
    CornerAt,
    At,      // position of the middle, in the form of CornerAt
    Offset,  // position of the middle in the form of CornerAt, but from the south-west corner of the room
    // Corners of the outline, as pairs of metres east and north of the origin; one such part for each piece of the
    // outline.
    CornerList,
    Hole,      // pairs of metres as in CornerList, for a hole in the outline; holes that touch are joined
    Along,     // numbers[0] along the wall at sides[0], if the sentence names one
    FromWall,  // at a distance of numbers[0] from the wall or end at sides[0]
    InWall,    // position in the wall at sides[0]
    MiddleOf,  // in the middle of the wall at sides[0]
    Middle,    // in the middle of the room
    InCorner,  // in the corner at sides[0]
    ByWindow,
    ByDoor,  // next to a door; if `name` is given, next to the door to that room
    NextTo,  // position next to `name`
    To,      // leads to room `name`
    Outside,
    In,      // position in room `name`
    Stairs,  // stairs to room `name`
    Lift,    // a lift to room `name`
    UpTo,    // subject reaches up to `name`
    Landmark,
    Clue,
    Called,    // a name for the subject: `name`
    MadeOf,    // made of the library's material `name`
    Floor,     // the floor of the subject is made of the library's material `name`
    Walls,     // the walls of the subject are made of the library's material `name`
    Thick,     // numbers[0] is the thickness of the walls
    Facing,    // subject faces sides[0]
    ByItself,  // a door that opens automatically when somebody comes near
    Raised,    // subject is a door that opens automatically when somebody comes near
    Sunk,      // the floor of the room is numbers[0] lower than that of its storey
    FromRoom,  // a lift, stairs or a drop begins in room `name`
    DropOf,    // numbers[0] is the height of the drop
    Railing,   // a railing around the room, numbers[0] high
    UpSide,    // stairs rise towards sides[0]
    UpAndBack  // stairs rise towards sides[0] and turn back there
};

// Sides 0 to 7 are compass directions: 0 north, 1 north-east, ... 7 north-west. These four sides are relative to the
// direction in which a person looks or walks.
inline constexpr int kLeftSide = 8, kRightSide = 9, kFrontSide = 10, kBackSide = 11;

struct SaidPart {
    Statement says = Statement::Size2;
    std::vector<double> numbers;
    std::vector<int> sides;
    std::string name;  // spelled as in the text
};

// The kinds of sentence.
enum class SentenceKind {
    Room,
    Door,
    SlidingDoor,
    Opening,
    Lift,    // a platform that moves from one room to another
    Flight,  // stairs from one room to another, where the stairs are not a room themselves
    Drop,    // an open edge where people step down from one room to another
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
    bool explicit_kind = false;  // the sentence states its kind at the beginning: "Room: ..."
    bool fixture = false;        // the sentence begins with "Fixture:", so the thing is not furniture
    std::string name;            // the subject, spelled as in the text; for several things, the name of one of them
    int count = 1;               // number of things, as in "Two chairs"
    std::vector<SaidPart> parts;
    std::vector<std::string> not_understood;  // the parts of the sentence that were not understood
    bool in_steps = false;

    const SaidPart* find(Statement says) const;
};

// Returns the language to which most of the words belong.
WordLanguage language_of(std::span<const WordSentence> sentences);

struct SpeakersOf {
    WordLanguage language = WordLanguage::English;
    double step_m = 0.7;
    std::set<std::string> names;  // folded names of rooms, storeys and things, to which sentences may refer
};

// Reads only the beginning of a sentence, to get its kind and subject quickly.
SaidSentence head_of(const WordSentence& sentence, const SpeakersOf& speaker);
// Reads the whole sentence, but at most 120 words and 4,000 numbers.
SaidSentence understood(const WordSentence& sentence, const SpeakersOf& speaker);

// Returns the form in which names are compared: folded, and without an article at the front.
std::string name_key(std::string_view name, WordLanguage language);
// True if a name must be written in quotation marks to be read back unchanged.
bool needs_quotation_marks(std::string_view name, WordLanguage language);
// Returns the name in the material library for a word that means a material. Empty for any other word.
std::string material_of_word(std::string_view word);
// Returns the word for a material of the library in that language.
std::string word_of_material(std::string_view name, WordLanguage language);

// Returns the usual size of a thing with that name: west to east, south to north, height.
Vec3 usual_size_m(std::string_view name);
// Returns the singular of a known plural ("chairs", "Stühle"). Empty if the plural is not known.
std::optional<std::string> one_of_several(std::string_view names);
// True if the usual size of things with that name is known.
bool usually_known(std::string_view name);

}  // namespace handrail::words
