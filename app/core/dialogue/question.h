// Finds the question in a typed line: which fact a person wants to know, and about which room, door or thing. The line
// need not be a known sentence. The names of the world are found in it first, and the other words are compared with
// the words of each question in settings/languages, question_word. Pure functions of the language spoken, which any
// thread except the servo's may call.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace handrail::core {

enum class QuestionKind : std::uint8_t {
    WhereIs,      // where a room or thing is
    HowFar,       // how far away it is
    WayTo,        // a route to it
    WhatIsIn,     // what is in a room
    RoomOf,       // in which room a thing is
    SizeOf,       // how large a room is, and how a corridor runs; without a name, the present one
    IsOpen,       // whether a door is open; without a name, the one nearby
    WhichDoor,    // which door is nearby and where it leads
    Nearest,      // the nearest door, window or flight of stairs
    HowMany,      // how many rooms, doors, windows, flights of stairs or storeys there are
    Rooms,        // the names of the rooms
    StoreyAbove,  // which rooms the next storey has
    StoreyBelow,
    Above,  // which rooms are above a room; without a name, above the person
    Below,
    GoUp,  // a route to the next storey
    GoDown,
    OwnStorey,  // on which storey the person is
    OwnPart,    // in which wing or other part of the building the person is
    Behind,     // what is on a side of the person
    Left,
    Right,
    Home,  // a wish to return to the base
    Here,  // where the person is
    // The following kinds concern what guides the person at present, and need no rooms.
    EndRoute,  // a wish to end it
    EndBeacon,
    EndWarmer,
    EndLines,
    EndLearning,
    OwnRoute,   // which route the person is following, and how much of it is left
    OwnBeacon,  // what the beacon is on
};

// What a question may ask about without a name of the world.
enum class CommonNoun : std::uint8_t { None, Room, Door, Window, Stairs, Storey };

enum class NamedKind : std::uint8_t { Room, Door, Thing };

// A name that a question may contain.
struct NameInWorld {
    std::string name;  // as it is spoken
    NamedKind kind = NamedKind::Thing;
};

struct Question {
    QuestionKind kind = QuestionKind::Here;
    std::optional<std::size_t> name = {};  // index in the names of the world
    CommonNoun noun = CommonNoun::None;
    bool operator==(const Question&) const = default;
};

// Returns the question in the line. Returns no value if the line is no question about these facts, or if too many of
// its words are unknown. Case, punctuation, polite words and small typing mistakes do not matter, and umlauts may be
// written out.
std::optional<Question> question_in(std::string_view line, std::span<const NameInWorld> names);

// Returns true if a word of the name is this noun, as in "Garden door".
bool has_noun(std::string_view name, CommonNoun noun);
// Returns the word by which settings/languages selects texts about this noun: "room", "door" and so on.
std::string_view noun_key(CommonNoun noun);

// Returns the longest name of the world in the line, or no value if it contains none.
std::optional<std::size_t> name_in(std::string_view line, std::span<const NameInWorld> names);

}  // namespace handrail::core
