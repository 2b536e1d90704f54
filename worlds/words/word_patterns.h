// What the words of a sentence say, by patterns of English and German. Pure functions; any thread.
#pragma once

#include <optional>
#include <set>
#include <span>

#include "worlds/base/vec.h"
#include "worlds/words/words_text.h"

namespace handrail {

enum class WordLanguage { English, German };

// What a part of a sentence says. Numbers are metres by then.
enum class Says {
    Size2,       // west to east by south to north
    Size3,       // and height
    High,        // numbers[0]
    Wide,        // numbers[0]
    AboveFloor,  // numbers[0]
    SideOf,      // on side `sides[0]` of `name`, numbers[0] away where there is one
    Above,       // `name`
    Further,     // numbers[0] further to sides[0]
    Flush,       // with the end on sides[0]
    CornerAt,    // its south-west corner, numbers[0] to sides[0] and numbers[1] to sides[1] of the zero
    At,          // its middle, likewise
    Offset,      // its middle, likewise, from the south-west corner of the room
    CornerList,  // numbers: pairs, metres east and north of the zero; of each piece one
    Hole,        // likewise; where pieces lie against each other they are one
    Along,       // numbers[0] along wall sides[0], where it is said
    FromWall,    // numbers[0] from wall or end sides[0]
    InWall,      // sides[0]
    MiddleOf,    // wall sides[0]
    Middle,      // of the room
    InCorner,    // sides[0]
    ByWindow,
    ByDoor,  // to `name`, where there is one
    NextTo,  // `name`
    To,      // `name`
    Outside,
    In,      // `name`
    Stairs,  // to `name`
    Lift,    // to `name`
    UpTo,    // `name`
    Landmark,
    Clue,
    Called,    // `name`
    MadeOf,    // `name` is a material of the library
    Floor,     // likewise
    Walls,     // likewise
    Thick,     // numbers[0]
    Facing,    // sides[0]
    ByItself,  // a door that opens as one comes near
    Raised,    // the floor of a room by numbers[0] over that of its storey
    Sunk,      // or under it
    FromRoom,  // `name`, where a lift or drop begins
    DropOf,    // numbers[0] down
    Railing,   // numbers[0] high, round a room
    UpSide,    // stairs climb to sides[0]
    UpAndBack  // to sides[0], where they turn
};

// Sides: 0 north, 1 north-east, ... 7 north-west; and as one looks or goes.
inline constexpr int kLeftSide = 8, kRightSide = 9, kFrontSide = 10, kBackSide = 11;

struct SaidPart {
    Says says = Says::Size2;
    std::vector<double> numbers;
    std::vector<int> sides;
    std::string name;  // as written
};

// What kind of sentence it is.
enum class SentenceKind {
    Room,
    Door,
    SlidingDoor,
    Opening,
    Lift,    // a platform from one room to another
    Flight,  // stairs without a room, from one room to another
    Drop,    // an open place to step down from one room to another
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
    bool explicit_kind = false;  // "Room: ..."
    bool fixture = false;        // "Fixture: ...": a thing that is no furniture
    std::string name;            // its subject, as written; one of them where there are several
    int count = 1;               // "Two chairs"
    std::vector<SaidPart> parts;
    std::vector<std::string> not_understood;  // words, as written
    bool in_steps = false;

    const SaidPart* find(Says says) const;
};

// The language that most of the words are of.
WordLanguage language_of(std::span<const WordSentence> sentences);

struct SpeakersOf {
    WordLanguage language = WordLanguage::English;
    double step_m = 0.7;
    std::set<std::string> names;  // folded; of rooms, storeys and things, which are found in sentences by them
};

// The kind and the subject alone, quickly.
SaidSentence head_of(const WordSentence& sentence, const SpeakersOf& speaker);
// All of it. At most 120 words and 4,000 numbers are looked at.
SaidSentence understood(const WordSentence& sentence, const SpeakersOf& speaker);

// Folded, without an article in front: what names are compared by.
std::string name_key(std::string_view name, WordLanguage language);
// Whether a name has to stand in quotation marks to be read back as it is.
bool needs_quotation_marks(std::string_view name, WordLanguage language);
// A name of the material library; empty: the words are none of it.
std::string material_of_word(std::string_view word);
// How it is written in that language.
std::string word_of_material(std::string_view name, WordLanguage language);

// How large a thing of that name usually is: west to east, south to north, height.
Vec3 usual_size_m(std::string_view name);
// Of several things that are known ("chairs", "Stühle") what one of them is called; nothing: it is no such plural.
std::optional<std::string> one_of_several(std::string_view names);
// Whether things of that name are known.
bool usually_known(std::string_view name);

}  // namespace handrail
