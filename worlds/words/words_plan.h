// Turns a room description into a plan: sentences become rooms, doors and things, which are then placed relative to
// each other. If a position is missing, the class assumes one and reports the assumption with its line. Used on one
// thread.
#pragma once

#include <map>
#include <optional>

#include "worlds/base/language.h"
#include "worlds/base/result.h"
#include "worlds/floorplan/floor_plan.h"
#include "worlds/words/word_patterns.h"

namespace handrail::words {

// Returns a side as a vector east and north. A diagonal direction has one metre both ways. Left, right, front and back
// are those of a page with north at the top.
Vec2 side_direction(int side);
// Returns the vector of a position such as "2 metres east and 3 metres north".
Vec2 offset_of(const SaidPart& part);

class WordsPlan {
public:
    explicit WordsPlan(std::string file_name) : file_(std::move(file_name)) {}
    // Builds the plan. Fails if the text describes no room, or too many parts.
    Result<floorplan::FloorPlan> build(std::string_view bytes);

    const std::vector<Diagnostic>& warnings() const { return warnings_; }  // the first warnings, at most 20
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
        std::vector<Ring> rings;  // outlines of the room; empty if the room has not been placed yet
        Vec2 least{0.0}, most{0.0}, size_m{4.0};
        std::optional<double> raised_m;   // height of the room's floor above that of its storey
        std::vector<std::size_t> levels;  // levels of the room, as indices into FloorPlan::levels
    };
    // A straight part of an outline: a wall, or the border that two rooms share.
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
    struct Opening {  // a door or window, next to which things may be placed
        Vec2 at{0.0};
        double width_m = 1.0;
        int side = 0;
        std::string to;  // the folded name of the room beyond the door
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
    std::optional<Border> first_outer_wall(const WordRoom& room);
    void add_lift(std::size_t room, const Said& said);
    void add_flight(std::size_t room, const Said& said);
    // Returns the room of that name on another storey that contains the place, or else the nearest such room. Returns
    // kNoRoom if there is none.
    std::size_t room_over(std::size_t room, const std::string& name, const Vec2& place) const;
    void set_raises();
    std::size_t room_from(std::size_t room, const Said& said) const;
    bool stated_before(const floorplan::PlanDoor& door, bool placed) const;
    InWall place_of_window(const Said& said, const WordRoom& room);
    void add_windows(std::size_t room);
    void add_things(std::size_t room);
    void add_start(const Said& said);

    std::size_t room_named(const std::string& name, std::size_t but = kNoRoom) const;
    std::size_t beside(std::size_t room, const std::string& name, const SaidPart* at, Border& border);
    std::optional<Border> shared(const WordRoom& a, const WordRoom& b);
    static Border wall_of(const WordRoom& room, int side);
    static int wall_side(const WordRoom& room, int side);  // returns a compass direction: 0, 2, 4 or 6
    // Returns the position along a wall that the sentence states, or else the middle of the wall. Sets `placed` to true
    // if the sentence states one.
    double along_wall(const Said& said, const WordRoom& room, const Border& wall, bool& placed);
    Vec2 free_corner(const WordRoom& room, const Vec3& size_m) const;
    // True if the thing would be inside the room, clear of the things placed before, and not in front of a door. With
    // `doors_alone`, only the doors are considered.
    bool stands_free(const WordRoom& room, const Vec2& at, const Vec2& half, bool doors_alone = false) const;
    // Returns the free place nearest to `at`, or `at` itself if there is no free place.
    Vec2 nearest_free(const WordRoom& room, const Vec2& at, const Vec2& half) const;
    Vec2 place_next_to(const Placed& other, const WordRoom& room, const Vec2& half) const;
    void add_thing(const WordRoom& room, const Said& said, bool first);
    int stated_side(const Said& said, const WordRoom& room);
    std::optional<Vec2> place_from_walls(const Said& said, const WordRoom& room, const Vec3& size_m);
    Vec2 place_of_thing(const Said& said, const WordRoom& room, Vec3& size_m, bool usual);
    std::size_t level_for(const WordRoom& a, const WordRoom* b) const;

    void warn(int line, const std::string& message, const std::string& action);
    std::string nearest_room(const std::string& name) const;
    std::string room_words(const WordRoom& room) const;

    static constexpr std::size_t kNoRoom = static_cast<std::size_t>(-1);
    std::string file_;
    floorplan::FloorPlan plan_;
    SpeakersOf speaker_;
    std::vector<Storey> storeys_;
    std::vector<std::size_t> level_of_;  // indexed by storey: its index in FloorPlan::levels
    std::vector<WordRoom> rooms_;
    std::map<std::string, std::vector<std::size_t>> by_name_;
    std::vector<Said> starts_;
    std::vector<std::size_t> start_rooms_;
    std::map<std::string, Placed> placed_things_;  // things in the current room, by their folded names
    std::vector<Placed> placed_here_;              // all things in the current room, with or without a name
    std::vector<Opening> windows_here_, doors_here_;
    std::vector<std::vector<Opening>> doors_of_;  // doors of each room, indexed by room
    std::vector<Diagnostic> warnings_;
    int warnings_in_all_ = 0, usual_sizes_ = 0, without_place_ = 0, middle_doors_ = 0;
    bool steps_ = false, left_and_right_ = false;
    std::size_t work_ = 0;
};

}  // namespace handrail::words
