// Rooms in words as a plan: sentences become rooms, doors and things, and these are placed against each other. What
// cannot be placed is assumed and told with its line. One thread.
#pragma once

#include <map>
#include <optional>

#include "worlds/base/language.h"
#include "worlds/base/result.h"
#include "worlds/drawn/floor_plan.h"
#include "worlds/words/word_patterns.h"

namespace handrail {

// East and north of a side of the compass; diagonal ones go one metre both ways. Of left, right, front and back as on a
// page with north above.
Vec2 side_direction(int side);
// What "2 metres east and 3 metres north" says.
Vec2 offset_of(const SaidPart& part);

class WordsPlan {
public:
    explicit WordsPlan(std::string file_name) : file_(std::move(file_name)) {}
    // Fails where there is no room in it, or too much.
    Result<FloorPlan> build(std::string_view bytes);

    const std::vector<Diagnostic>& warnings() const { return warnings_; }  // at most 20
    int warnings_in_all() const { return warnings_in_all_; }

private:
    struct Storey {
        std::string name;
        std::optional<double> height_m, floor_m;
        int line = 0;
    };
    struct Said {
        SaidSentence words;
        int line = 0;
    };
    struct WordRoom {
        Said said;
        std::size_t storey = 0;
        std::vector<Said> doors, windows, things;
        std::vector<Ring> rings;  // empty: not yet placed
        Vec2 least{0.0}, most{0.0}, size_m{4.0};
        std::optional<double> raised_m;   // its floor, over that of its storey
        std::vector<std::size_t> levels;  // places in FloorPlan::levels
    };
    // A straight part of an outline: a wall, or what two rooms share.
    struct Border {
        Vec2 from{0.0}, to{0.0};
        double length() const { return glm::length(to - from); }
        Vec2 at(double along_m) const { return from + (to - from) * (along_m / std::max(length(), 1e-9)); }
    };
    struct Placed {
        Vec2 least{0.0}, most{0.0};
    };
    struct InWall {
        Border wall;
        int side = 0;
        double along_m = 0.0;
    };
    struct Opening {  // that things stand by
        Vec2 at{0.0};
        double width_m = 1.0;
        int side = 0;
        std::string to;  // folded
    };

    void take(SaidSentence said, int line);
    void lay_storeys();
    void set_sizes();
    void place_rooms();
    bool place_against(WordRoom& room, const SaidPart& where, const WordRoom& other);
    void place_by_assumption(std::size_t room);
    void set_box(WordRoom& room, const Vec2& least);
    void find_overlaps();
    void add_spaces();
    void add_doors(std::size_t room);
    void add_door(std::size_t room, const Said& said);
    void add_lift(std::size_t room, const Said& said);
    void add_flight(std::size_t room, const Said& said);
    // The room of that name on another storey that has the place in it, else the nearest; kNoRoom without any.
    std::size_t room_over(std::size_t room, const std::string& name, const Vec2& place) const;
    void set_raises();
    std::size_t room_from(std::size_t room, const Said& said) const;
    bool told_before(const PlanDoor& door, bool placed) const;
    InWall place_of_window(const Said& said, const WordRoom& room);
    void add_windows(std::size_t room);
    void add_things(std::size_t room);
    void add_start(const Said& said);

    std::size_t room_named(const std::string& name, std::size_t but = kNoRoom) const;
    std::size_t beside(std::size_t room, const std::string& name, const SaidPart* at, Border& border);
    std::optional<Border> shared(const WordRoom& a, const WordRoom& b);
    static Border wall_of(const WordRoom& room, int side);
    static int wall_side(const WordRoom& room, int side);  // of the compass: 0, 2, 4, 6
    // Where along a wall: as the sentence says it, its middle without. `placed`: the sentence says it.
    double along_wall(const Said& said, const WordRoom& room, const Border& wall, bool& placed);
    Vec2 free_corner(const WordRoom& room, const Vec3& size_m) const;
    // Within the room, off what was placed before, and not before a door; `doors_alone`: the last is enough.
    bool stands_free(const WordRoom& room, const Vec2& at, const Vec2& half, bool doors_alone = false) const;
    // The nearest place round that one that is free; the same where there is none.
    Vec2 nearest_free(const WordRoom& room, const Vec2& at, const Vec2& half) const;
    Vec2 place_next_to(const Placed& other, const WordRoom& room, const Vec2& half) const;
    void add_thing(const WordRoom& room, const Said& said, bool first);
    Vec2 place_of_thing(const Said& said, const WordRoom& room, Vec3& size_m, bool usual);
    std::size_t level_for(const WordRoom& a, const WordRoom* b) const;

    void warn(int line, const std::string& message, const std::string& action);
    std::string nearest_room(const std::string& name) const;
    std::string room_words(const WordRoom& room) const;

    static constexpr std::size_t kNoRoom = static_cast<std::size_t>(-1);
    std::string file_;
    FloorPlan plan_;
    SpeakersOf speaker_;
    std::vector<Storey> storeys_;
    std::vector<std::size_t> level_of_;  // of each storey
    std::vector<WordRoom> rooms_;
    std::map<std::string, std::vector<std::size_t>> by_name_;
    std::vector<Said> starts_;
    std::vector<std::size_t> start_rooms_;
    std::map<std::string, Placed> placed_things_;  // of the room at hand, folded
    std::vector<Placed> placed_here_;              // all of them
    std::vector<Opening> windows_here_, doors_here_;
    std::vector<std::vector<Opening>> doors_of_;  // of each room
    std::vector<Diagnostic> warnings_;
    int warnings_in_all_ = 0, usual_sizes_ = 0, without_place_ = 0, middle_doors_ = 0;
    bool steps_ = false, left_and_right_ = false;
    std::size_t work_ = 0;
};

}  // namespace handrail
