// Writes a world as a text that describes its rooms in words, English or German. The reader of such texts makes the
// same rooms and doors from it. Pure functions; any thread.
#pragma once

#include <optional>
#include <string>

#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"
#include "worlds/scene/stated_building.h"
#include "worlds/words/word_patterns.h"

namespace handrail::exports {

// The contents of the text: rooms as a file states them, or as they were found. World metres.
struct WordsHouse {
    struct Storey {
        std::string name;
        double floor_m = 0.0, height_m = 3.0;
    };
    enum class Kind { Room, Stairs, Lift };
    struct Room {
        Kind kind = Kind::Room;
        std::string name, floor_material;
        std::size_t storey = 0, to_storey = 0;  // `to_storey`: the highest storey of stairs and lifts
        double height_m = 0.0;                  // 0: the height of the storey
        double raised_m = 0.0;                  // height of its floor above that of the storey
        std::vector<std::vector<Vec2>> rings;
    };
    struct Door {
        bool opening = false, sliding = false, by_itself = false;
        std::string name;
        std::vector<std::size_t> rooms;  // a single room: the door leads outside
        Vec2 at_m{0.0};
        double width_m = 0.9;
        double drop_m = 0.0;  // of an opening: how far the second room is below the first
    };
    // A lift platform without a shaft.
    struct Lift {
        std::string name;
        std::size_t from = 0, to = 0;  // indices of rooms, the lower first
        Vec2 at_m{0.0}, size_m{1.4};
    };
    // Stairs without a room of their own.
    struct Flight {
        std::string name;
        std::size_t from = 0, to = 0;  // indices of rooms, the lower first
        Vec2 at_m{0.0}, size_m{1.0};
        int side = 0;       // climbing direction, an eighth of the compass: 0, 2, 4 or 6
        bool back = false;  // turns back at a landing
    };
    // A window, or an object in a room.
    struct Thing {
        std::string name;  // empty for a window without a name
        std::size_t room = 0;
        Aabb box_m;
        std::string material;  // material of the scene; may be one that the text has no word for
        bool landmark = false, clue = false;
        bool window = false;
        bool fixture = false;  // part of the building, not furniture
    };
    std::string name;
    double wall_m = 0.0;        // 0: unknown
    std::string wall_material;  // material of most walls; may be empty
    std::vector<Storey> storeys;
    std::vector<Room> rooms;
    std::vector<Door> doors;
    std::vector<Lift> lifts;
    std::vector<Flight> flights;
    std::vector<Thing> things;
    std::vector<std::string> lost;  // sentences about what the text cannot express, in its language
};

// For a world whose file states its rooms.
WordsHouse stated_house(const Scene& scene, words::WordLanguage language);
// For any other world. The outlines come from the walkable floor, extended to the middle of the walls. `space` must
// still have its walls. The time is proportional to its spans.
WordsHouse found_house(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                       words::WordLanguage language);

// The climbing direction of stairs, judged by their treads; nothing if they have none.
std::optional<WordsHouse::Flight> flight_of(const Scene& scene, FeatureId stairs);

// The materials of walkable surfaces, by place.
class FloorMaterials {
public:
    explicit FloorMaterials(const Scene& scene);
    // The name used in the text; empty if unknown. Looks at the surfaces at that height.
    std::string at(const Vec3& place) const;

private:
    struct Piece {
        Aabb box_m;
        std::vector<std::vector<Vec2>> rings;
        std::string material;
    };
    std::vector<Piece> pieces_;  // sorted by height
};
// The material of most of the wall area; empty if unknown.
std::string wall_material(const Scene& scene);

// Puts windows and objects into the rooms. `stated_house` and `found_house` call this already.
void furnish(WordsHouse& house, const Scene& scene, words::WordLanguage language);

// Returns the text. The base is taken from the scene.
std::string text_of(const WordsHouse& house, const Scene& scene, words::WordLanguage language);

}  // namespace handrail::exports
