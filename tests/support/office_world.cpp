#include "tests/support/office_world.h"
#include "tests/support/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <vector>

namespace handrail::test {
namespace {

constexpr double kUnitsPerMetre = 32.0;
constexpr double kRoom = 5.0, kCorridor = 2.0, kHall = 2.5,
                 kLane = 1.5;                       // sizes in metres; a lane is the strip for a flight of stairs
constexpr double kPitch = 2.0 * kRoom + kCorridor;  // distance from one corridor to the next
constexpr double kWall = 0.1, kSlab = 0.2, kStorey = 3.2, kHigh = kStorey - kSlab;
constexpr double kDoorWidth = 1.0, kDoorHeight = 2.1, kDoorThick = 0.05;
constexpr int kSteps = 20;
// kFlightFrom is the distance of the flight from the southern edge of the corridors.
constexpr double kTread = 0.28, kFlight = kSteps * kTread, kFlightFrom = 3.0;
constexpr int kLeastThing = 1, kDesk = 5, kChair = 6, kShelf = 7;  // numbers of brushes per piece of furniture

struct Box {
    double x0, y0, z0, x1, y1, z1;  // two opposite corners, in metres
};

// Positions for furniture in a room, relative to its middle: x to the right and y ahead for a person who enters by the
// door.
constexpr double kSlots[][2] = {{-1.7, 2.0}, {0.0, 2.0},   {1.7, 2.0}, {-2.0, 0.5},
                                {2.0, 0.5},  {-2.0, -1.4}, {2.0, -1.4}};
constexpr int kSlotCount = 7;

class Office {
public:
    explicit Office(const OfficeSize& size) : size_(size), random_(size.seed) {}

    OfficeWorld make() {
        for (int storey = 0; storey < size_.storeys; ++storey) build_storey(storey);
        roof();
        // The brushes that the building itself does not need are divided equally between the rooms; their numbers
        // differ by at most one.
        const int doors = static_cast<int>(rooms_.size()), left = std::max(0, size_.brushes - made_.brushes - doors);
        for (int r = 0; r < doors; ++r) furnish(r, part(left, r + 1, doors) - part(left, r, doors));
        made_.rooms = made_.doors = doors;
        made_.floor_m2 = size_.storeys * width() * depth();
        made_.map = fmt::format(
                        "// An office building of {} rooms on {} storeys, made by a program.\n{{\n\"classname\" "
                        "\"worldspawn\"\n",
                        doors, size_.storeys) +
                    "\"message\" \"Office building\"\n\"building\" \"1\"\n" + building_ + "}\n" + start() + entities_;
        return std::move(made_);
    }

private:
    struct RoomPlace {
        double x, y, z;  // middle of the room's floor
        bool south;      // the room is south of its corridor, so its door is in the north
        int number;
    };
    static int part(int of, int some, int all) { return static_cast<int>(static_cast<std::int64_t>(of) * some / all); }
    double along() const { return size_.rooms_along_corridor * kRoom; }
    double width() const { return along() + kHall + kLane; }
    double depth() const { return size_.corridors * kPitch; }
    static bool has_stairs(int corridor) { return corridor % 3 == 0; }
    // Returns a random number below `count`. Unlike std::uniform_int_distribution, it is the same with every standard
    // library.
    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint32_t>(count)); }

    void brush(std::string& to, const Box& box, const char* texture) {
        const double x0 = box.x0 * kUnitsPerMetre, y0 = box.y0 * kUnitsPerMetre, z0 = box.z0 * kUnitsPerMetre;
        const double x1 = box.x1 * kUnitsPerMetre, y1 = box.y1 * kUnitsPerMetre, z1 = box.z1 * kUnitsPerMetre;
        const auto face = [&](double ax, double ay, double az, double bx, double by, double bz, double cx, double cy,
                              double cz) {
            fmt::format_to(std::back_inserter(to),
                           "( {:.6g} {:.6g} {:.6g} ) ( {:.6g} {:.6g} {:.6g} ) ( {:.6g} {:.6g} {:.6g} ) {} 0 0 0 1 1\n",
                           ax, ay, az, bx, by, bz, cx, cy, cz, texture);
        };
        to += "{\n";
        face(x0, y0, z0, x0, y1, z0, x0, y0, z1);
        face(x1, y0, z0, x1, y0, z1, x1, y1, z0);
        face(x0, y0, z0, x0, y0, z1, x1, y0, z0);
        face(x0, y1, z0, x1, y1, z0, x0, y1, z1);
        face(x0, y0, z0, x1, y0, z0, x0, y1, z0);
        face(x0, y0, z1, x0, y1, z1, x1, y0, z1);
        to += "}\n";
        ++made_.brushes;
    }
    void wall(double x0, double y0, double x1, double y1, double z, double from = 0.0, double to = kHigh) {
        brush(building_, {x0, y0, z + from, x1, y1, z + to}, "plaster");
    }

    void build_storey(int storey) {
        const double z = storey * kStorey, hall = along(), lane = hall + kHall;
        floor(storey);
        wall(-kWall, -kWall, 0.0, depth() + kWall, z);
        wall(width(), -kWall, width() + kWall, depth() + kWall, z);
        wall(0.0, -kWall, width(), 0.0, z);
        wall(0.0, depth(), width(), depth() + kWall, z);
        for (int corridor = 0; corridor < size_.corridors; ++corridor) {
            const double south = corridor * kPitch;
            for (const bool is_south : {true, false}) {
                const double wall_y = is_south ? south + kRoom - 0.5 * kWall : south + kRoom + kCorridor - 0.5 * kWall;
                // The wall to the corridor consists of pieces between the doorways, and one piece above each doorway.
                double from = 0.0;
                for (int r = 0; r < size_.rooms_along_corridor; ++r) {
                    const double door = (r + 0.5) * kRoom - 0.5 * kDoorWidth;
                    wall(from, wall_y, door, wall_y + kWall, z);
                    wall(door, wall_y, door + kDoorWidth, wall_y + kWall, z, kDoorHeight);
                    from = door + kDoorWidth;
                    const double back = is_south ? south : south + kPitch, front = is_south ? wall_y : wall_y + kWall;
                    // The x coordinate of the wall to the next room, or to the hall.
                    const double side = (r + 1) * kRoom - 0.5 * kWall;
                    wall(side, std::min(back, front), side + kWall, std::max(back, front), z);
                    rooms_.push_back({(r + 0.5) * kRoom, is_south ? south + 0.5 * kRoom : south + kPitch - 0.5 * kRoom,
                                      z, is_south,
                                      100 * (storey + 1) * (size_.corridors > 9 ? 10 : 1) +
                                          static_cast<int>(rooms_on_storey(corridor, is_south, r))});
                }
                wall(from, wall_y, hall - 0.5 * kWall, wall_y + kWall, z);
            }
            if (corridor > 0) wall(0.0, south - 0.5 * kWall, hall, south + 0.5 * kWall, z);
            if (corridor > 0) wall(lane + kWall, south - 0.5 * kWall, width(), south + 0.5 * kWall, z);
            if (!has_stairs(corridor)) {
                // A wall at the end, because there is nothing behind the lane.
                wall(lane, south, lane + kWall, south + kPitch, z);
                continue;
            }
            const double from = south + kFlightFrom, to = from + kFlight;
            wall(lane, south, lane + kWall, south + 1.0, z);
            wall(lane, from, lane + kWall, to, z);
            wall(lane, to + 2.0, lane + kWall, south + kPitch, z);
            if (storey + 1 < size_.storeys) flight(lane + kWall, from, z);
            // A parapet prevents the walker from falling down the stairs.
            else wall(lane + kWall, from - kWall, width(), from, z, 0.0, 1.1);
        }
    }
    int rooms_on_storey(int corridor, bool south, int r) const {
        return (2 * corridor + (south ? 0 : 1)) * size_.rooms_along_corridor + r + 1;
    }

    void floor(int storey) {
        const double z = storey * kStorey, lane = along() + kHall;
        brush(building_, {-kWall, -kWall, z - kSlab, lane + kWall, depth() + kWall, z}, "carpet");
        double from = -kWall;
        for (int corridor = 0; corridor < size_.corridors && storey > 0; ++corridor) {
            if (!has_stairs(corridor)) continue;
            brush(building_, {lane + kWall, from, z - kSlab, width() + kWall, corridor * kPitch + kFlightFrom, z},
                  "stone");
            from = corridor * kPitch + kFlightFrom + kFlight;
        }
        brush(building_, {lane + kWall, from, z - kSlab, width() + kWall, depth() + kWall, z}, "stone");
    }
    void flight(double x, double y, double z) {
        ++made_.stairs;
        for (int step = 0; step < kSteps; ++step) {
            const double top = z + (step + 1) * kStorey / kSteps;
            brush(building_, {x, y + step * kTread, std::max(z, top - kSlab), width(), y + (step + 1) * kTread, top},
                  "stone");
        }
    }
    void roof() {
        const double z = size_.storeys * kStorey;
        brush(building_, {-kWall, -kWall, z - kSlab, width() + kWall, depth() + kWall, z}, "plaster");
    }

    std::string start() const {
        return fmt::format(
            "{{\n\"classname\" \"info_player_start\"\n\"origin\" \"{:.6g} {:.6g} 24\"\n\"angle\" \"180\"\n}}\n",
            (along() + 0.5 * kHall) * kUnitsPerMetre, (kRoom + 0.5 * kCorridor) * kUnitsPerMetre);
    }

    void entity(const char* class_name, const std::string& keys, const std::string& brushes) {
        fmt::format_to(std::back_inserter(entities_), "{{\n\"classname\" \"{}\"\n{}{}}}\n", class_name, keys, brushes);
    }

    // Returns a box of the building from a box relative to the middle of a room, as seen by a person who enters.
    static Box in_room(const RoomPlace& room, const Box& own) {
        const double turn = room.south ? -1.0 : 1.0;
        return {room.x + std::min(turn * own.x0, turn * own.x1),
                room.y + std::min(turn * own.y0, turn * own.y1),
                room.z + own.z0,
                room.x + std::max(turn * own.x0, turn * own.x1),
                room.y + std::max(turn * own.y0, turn * own.y1),
                room.z + own.z1};
    }

    void thing(const RoomPlace& room, const std::string& name, bool landmark, const std::vector<Box>& boxes,
               const char* texture) {
        std::string brushes;
        for (const Box& box : boxes) brush(brushes, in_room(room, box), texture);
        entity("func_wall", fmt::format("\"name\" \"{}\"\n{}", name, landmark ? "\"landmark\" \"1\"\n" : ""), brushes);
        ++made_.things;
    }
    static void legs(std::vector<Box>& to, double x, double y, double half_x, double half_y, double high) {
        for (const double sx : {-1.0, 1.0})
            for (const double sy : {-1.0, 1.0})
                to.push_back({x + sx * half_x - 0.025, y + sy * half_y - 0.025, 0.0, x + sx * half_x + 0.025,
                              y + sy * half_y + 0.025, high});
    }

    void furnish(int r, int brushes) {
        const RoomPlace& room = rooms_[static_cast<std::size_t>(r)];
        const double sign = room.south ? 1.0 : -1.0, door_y = room.y + sign * 0.5 * kRoom;
        std::string leaf;
        brush(leaf,
              {room.x - 0.5 * kDoorWidth, door_y - 0.5 * kDoorThick, room.z, room.x + 0.5 * kDoorWidth,
               door_y + 0.5 * kDoorThick, room.z + kDoorHeight},
              "wood");
        entity("func_door",
               fmt::format("\"name\" \"Door {}\"\n\"material\" \"wood\"\n\"hinge\" \"west\"\n\"handle\" "
                           "\"east\"\n\"opens\" \"{}\"\n",
                           room.number, room.south ? "south" : "north"),
               leaf);
        // Every other room has a name of its own; the others are named after their contents.
        if (r % 2 == 0)
            entity("info_room",
                   fmt::format("\"name\" \"Office {}\"\n\"origin\" \"{:.6g} {:.6g} {:.6g}\"\n", room.number,
                               room.x * kUnitsPerMetre, room.y * kUnitsPerMetre, room.z * kUnitsPerMetre + 24.0),
                   {});
        if (r % 40 == 5)
            entity("ambient_fan",
                   fmt::format("\"name\" \"Fan {}\"\n\"origin\" \"{:.6g} {:.6g} {:.6g}\"\n", room.number,
                               room.x * kUnitsPerMetre, room.y * kUnitsPerMetre, (room.z + 2.5) * kUnitsPerMetre),
                   {});
        std::vector<int> slots(kSlotCount);
        for (int s = 0; s < kSlotCount; ++s) slots[static_cast<std::size_t>(s)] = s;
        for (int s = kSlotCount - 1; s > 0; --s)
            std::swap(slots[static_cast<std::size_t>(s)], slots[static_cast<std::size_t>(below(s + 1))]);
        for (int s = 0; s < kSlotCount && brushes > 0; ++s) {
            const double x = kSlots[slots[static_cast<std::size_t>(s)]][0],
                         y = kSlots[slots[static_cast<std::size_t>(s)]][1];
            const bool last = s + 1 == kSlotCount, landmark = s == 0;
            const std::string number = fmt::format(" {}", room.number);
            std::vector<Box> boxes;
            const int kind = below(4);
            if (!last && kind == 0 && brushes >= kDesk) {
                boxes.push_back({x - 0.35, y - 0.35, 0.7, x + 0.35, y + 0.35, 0.74});
                legs(boxes, x, y, 0.3, 0.3, 0.7);
                thing(room, "Desk" + number, landmark, boxes, "wood");
            } else if (!last && kind == 1 && brushes >= kChair) {
                boxes.push_back({x - 0.22, y - 0.22, 0.43, x + 0.22, y + 0.22, 0.47});
                boxes.push_back({x - 0.22, y + 0.18, 0.47, x + 0.22, y + 0.22, 0.9});
                legs(boxes, x, y, 0.18, 0.18, 0.43);
                thing(room, "Chair" + number, landmark, boxes, "wood");
            } else if (!last && kind == 2 && brushes >= kLeastThing) {
                boxes.push_back({x - 0.3, y - 0.3, 0.0, x + 0.3, y + 0.3, 0.4 + 0.1 * below(12)});
                thing(room, "Cupboard" + number, landmark, boxes, "metal");
            } else {
                // A shelf consists of boards one above the other. The furniture at the last free position gets all the
                // brushes that the room still needs.
                const int boards = last ? brushes : std::min(brushes, kShelf);
                const double step = 1.9 / boards;
                for (int b = 0; b < boards; ++b)
                    boxes.push_back({x - 0.35, y - 0.2, b * step, x + 0.35, y + 0.2, (b + 0.5) * step});
                thing(room, "Shelf" + number, landmark, boxes, "wood");
            }
            brushes -= static_cast<int>(boxes.size());
        }
    }

    OfficeSize size_;
    std::mt19937 random_;
    std::vector<RoomPlace> rooms_;
    std::string building_, entities_;
    OfficeWorld made_;
};

}  // namespace

OfficeSize office_size(int brushes, std::uint32_t seed) {
    OfficeSize size;
    size.brushes = brushes;
    size.seed = seed;
    size.storeys = std::clamp(brushes / 1'000, 1, 5);
    const double floor_m2 = static_cast<double>(brushes) / size.storeys;
    size.corridors = std::max(1, static_cast<int>(std::lround(std::sqrt(floor_m2) / kPitch)));
    size.rooms_along_corridor =
        std::max(1, static_cast<int>(std::lround((floor_m2 / (size.corridors * kPitch) - kHall - kLane) / kRoom)));
    return size;
}

OfficeWorld office_world(const OfficeSize& size) { return Office(size).make(); }

}  // namespace handrail::test
