// A world as a text that describes its rooms in words, English or German, which the reader of such texts takes again:
// the same rooms and doors. Pure functions; any thread.
#pragma once

#include <optional>
#include <string>

#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"
#include "worlds/scene/stated_building.h"
#include "worlds/words/word_patterns.h"

namespace handrail {

// What is to be written: rooms as a file states them, or as they were found. World metres.
struct WordsHouse {
    struct Storey {
        std::string name;
        double floor_m = 0.0, height_m = 3.0;
    };
    enum class Kind { Room, Stairs, Lift };
    struct Room {
        Kind kind = Kind::Room;
        std::string name, floor_material;
        std::size_t storey = 0, to_storey = 0;  // of stairs and lifts the highest
        double height_m = 0.0;                  // 0: as the storey is
        double raised_m = 0.0;                  // its floor, over that of its storey
        std::vector<std::vector<Vec2>> rings;
    };
    struct Door {
        bool opening = false, sliding = false, by_itself = false;
        std::string name;
        std::vector<std::size_t> rooms;  // one: it leads outside
        Vec2 at_m{0.0};
        double width_m = 0.9;
        double drop_m = 0.0;  // of an opening: so far down from the first room to the second
    };
    // A platform without a shaft.
    struct Lift {
        std::string name;
        std::size_t from = 0, to = 0;  // rooms, the lower first
        Vec2 at_m{0.0}, size_m{1.4};
    };
    // Stairs without a room of their own.
    struct Flight {
        std::string name;
        std::size_t from = 0, to = 0;  // rooms, the lower first
        Vec2 at_m{0.0}, size_m{1.0};
        int side = 0;       // of the compass, 0, 2, 4 or 6: where they climb to
        bool back = false;  // with a landing there, from which they come back
    };
    // A window, or what stands in a room.
    struct Thing {
        std::string name;  // of a window that has none of its own: empty
        std::size_t room = 0;
        Aabb box_m;
        std::string material;  // of the scene; may be none that words know
        bool landmark = false, clue = false;
        bool window = false;
        bool fixture = false;  // part of the building, no furniture
    };
    std::string name;
    double wall_m = 0.0;        // 0: not known
    std::string wall_material;  // most of its walls are made of it; may be empty
    std::vector<Storey> storeys;
    std::vector<Room> rooms;
    std::vector<Door> doors;
    std::vector<Lift> lifts;
    std::vector<Flight> flights;
    std::vector<Thing> things;
    std::vector<std::string> lost;  // sentences on what words cannot say, in the language written
};

// Of a world that states its rooms.
WordsHouse stated_house(const Scene& scene, WordLanguage language);
// Of any other: outlines by the floor that is free to walk on, as far as the middle of walls. `space` still has its
// walls. Time goes with its spans.
WordsHouse found_house(const Scene& scene, const RoomGraph& graph, const WalkSpace& space, WordLanguage language);

// Which way stairs go, by their treads; nothing for what has none.
std::optional<WordsHouse::Flight> flight_of(const Scene& scene, FeatureId stairs);

// What the surfaces that one stands on are made of, by place.
class FloorMaterials {
public:
    explicit FloorMaterials(const Scene& scene);
    // As words know it; empty: not known. Looks at the surfaces of that height.
    std::string at(const Vec3& place) const;

private:
    struct Piece {
        Aabb box_m;
        std::vector<std::vector<Vec2>> rings;
        std::string material;
    };
    std::vector<Piece> pieces_;  // by height
};
// What most of the walls are made of, by area; empty: not known.
std::string wall_material(const Scene& scene);

// Puts windows and things into the rooms; the two above have done so.
void furnish(WordsHouse& house, const Scene& scene, WordLanguage language);

// The text. The base is taken from the scene.
std::string text_of(const WordsHouse& house, const Scene& scene, WordLanguage language);

}  // namespace handrail
