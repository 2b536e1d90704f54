// Writes a world as a text that describes its rooms, in English or German. The reader of room descriptions makes the
// same rooms and doors from the text. Pure functions; any thread may call them.
#pragma once

#include <optional>
#include <string>

#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"
#include "worlds/scene/stated_building.h"
#include "worlds/words/word_patterns.h"

namespace handrail::exports {

// The contents of the text. Its rooms are stated by a file or were found in the walkable space. World metres.
struct WordsHouse {
    struct Storey {
        std::string name;
        double floor_m = 0.0, height_m = 3.0;
    };
    enum class Kind { Room, Stairs, Lift };
    struct Room {
        Kind kind = Kind::Room;
        std::string name, floor_material;
        // Index of the storey; `to_storey` is the highest storey that stairs or a lift reach.
        std::size_t storey = 0, to_storey = 0;
        double height_m = 0.0;  // height of the room; 0: it has the height of the storey
        double raised_m = 0.0;  // height of the room's floor above that of its storey
        std::vector<std::vector<Vec2>> rings;
    };
    struct Door {
        bool opening = false, sliding = false, by_itself = false;
        std::string name;
        std::vector<std::size_t> rooms;  // the rooms on both sides; a single one: the door leads outside
        Vec2 at_m{0.0};
        double width_m = 0.9;
        double drop_m = 0.0;  // height of the first room's floor above that of the second room, at an opening
    };
    // A lift platform without a shaft.
    struct Lift {
        std::string name;
        std::size_t from = 0, to = 0;  // indices of rooms, the lower first
        Vec2 at_m{0.0}, size_m{1.4};
    };
    // Stairs inside a room that are not a room themselves.
    struct Flight {
        std::string name;
        std::size_t from = 0, to = 0;  // indices of rooms, the lower first
        Vec2 at_m{0.0}, size_m{1.0};
        int side = 0;       // direction of the climb in eighths of the compass: 0, 2, 4 or 6
        bool back = false;  // the flight turns back at a landing
    };
    // A window, or an object in a room.
    struct Thing {
        std::string name;  // empty for a window without a name
        std::size_t room = 0;
        Aabb box_m;
        std::string material;  // material in the scene, for which the text may have no word
        bool landmark = false, clue = false;
        bool window = false;
        bool fixture = false;  // part of the building, not furniture
    };
    std::string name;
    double wall_m = 0.0;        // thickness of most walls; 0: unknown
    std::string wall_material;  // material of most of the wall area; may be empty
    std::vector<Storey> storeys;
    std::vector<Room> rooms;
    std::vector<Door> doors;
    std::vector<Lift> lifts;
    std::vector<Flight> flights;
    std::vector<Thing> things;
    std::vector<std::string> lost;  // sentences about parts that the text cannot describe, in the language of the text
};

// Describes a world whose file states its rooms.
WordsHouse stated_house(const Scene& scene, words::WordLanguage language);
// Describes a world whose file states no rooms. The outlines come from the walkable floor, extended to the middle of
// the walls. `space` must still contain its floor without furniture. The time is proportional to the number of spans.
WordsHouse found_house(const Scene& scene, const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                       words::WordLanguage language);

// Returns the place of stairs and the direction in which they climb, determined from their treads. Returns nothing if
// the stairs have no treads.
std::optional<WordsHouse::Flight> flight_of(const Scene& scene, FeatureId stairs);

// Looks up the material of the floor at a place.
class FloorMaterials {
public:
    explicit FloorMaterials(const Scene& scene);
    // Returns the material's name in the text; empty if it is unknown. Considers only surfaces at the height of
    // `place`.
    std::string at(const Vec3& place) const;

private:
    struct Piece {
        Aabb box_m;
        std::vector<std::vector<Vec2>> rings;
        std::string material;
    };
    std::vector<Piece> pieces_;  // surfaces, sorted by height
};
// Returns the material that most of the wall area has; empty if it is unknown.
std::string wall_material(const Scene& scene);

// Adds the windows and objects to the rooms of `house`. `stated_house` and `found_house` call this already.
void furnish(WordsHouse& house, const Scene& scene, words::WordLanguage language);

// Returns the text. Its base is the base of `scene`.
std::string text_of(const WordsHouse& house, const Scene& scene, words::WordLanguage language);

}  // namespace handrail::exports
