// Runs the labyrinth game, in which the person rolls a ball past holes to a goal. This class keeps the clock and the
// best time, makes holes hum and the goal ring, announces the state and restarts the game. While no thing is held, the
// arrow keys move a camera over the table, which the plan follows. It gives a hint if the ball
// gets no nearer to the goal. It is active only in worlds that declare a labyrinth (worlds/scene/labyrinth.h). Use it
// on the app thread only.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/core/bodies/bodies.h"
#include "app/core/context/session_part.h"
#include "app/core/context/soundscape.h"
#include "app/core/labyrinth/corridors.h"
#include "app/core/learning/best_times.h"

namespace handrail::core {

class Labyrinth : SessionPart {
public:
    Labyrinth(const SessionContext& context, Bodies& bodies, Soundscape& soundscape);

    // Sets the folder for best times. Without a folder, best times are lost when the session ends.
    void keep_records_in(const std::filesystem::path& folder) { best_.keep_in(folder); }
    // Begins the game if the world is a labyrinth. Call it after the world and its bodies have been entered.
    void enter_world(double now_s);
    // Returns the announcement of the game's aim, or an empty text if the world is not a labyrinth.
    std::string opening_words() const;
    // Announces the state of the game, restarts it, or moves the camera by `times` rolls. Returns false if the command
    // belongs to another feature or the world is not a labyrinth.
    bool act(Command command, double now_s, int times = 1);
    // Returns true if the key of this command moves the camera instead of the walker.
    bool keeps(Command command) const;
    // Returns the place over which the camera is: the ball, or where the person has moved the camera since the ball
    // last moved. Returns no value if the world is not a labyrinth.
    std::optional<Vec3> camera_m() const;
    void tick(double now_s);

private:
    const LabyrinthPlan& plan() const { return context_.world.scene->labyrinth; }
    bool there() const { return context_.world.scene && plan().there() && ball_ < context_.world.scene->placed.size(); }
    std::size_t thing_of(FeatureId feature) const;
    Vec3 at(FeatureId feature) const;
    Vec3 ball_m() const;
    double roll_m() const { return 4.0 * radius_m_; }  // how far one press of a key rolls the ball
    double to_goal_m() const;
    std::string off_words(const Vec3& to_m) const;
    std::string free_words() const;
    std::string state_words() const;
    std::string corridor_words(const Corridor& corridor) const;
    void list_corridors(double now_s);
    void meet_border(FeatureId thing, FeatureId met, double now_s);
    bool covered(std::size_t which) const;
    void begin(double now_s);
    void look_at_holes(double now_s, bool announces);
    void sound();
    void pan(const Vec3& by_m, const char* edge, double now_s);
    std::string under_camera_words() const;

    Bodies& bodies_;
    Soundscape& soundscape_;
    BestTimes best_{"labyrinth"};
    std::size_t ball_ = 0;  // index of the ball among the placed things
    double radius_m_ = 0.05;
    Vec3 start_m_{0.0}, last_m_{0.0};  // where the game began, and where the ball was in the last tick
    std::vector<bool> covered_;
    Aabb table_m_;
    std::optional<Vec3> panned_m_;    // where the person has moved the camera; no value: it follows the ball
    std::vector<AddedSound> sounds_;  // sounds that were sent to the soundscape last
    double began_s_ = -1.0;           // time when the ball first moved; negative: it has not moved yet
    double fallen_s_ = -1.0;          // time when the ball fell into a hole; negative: it has not fallen
    bool over_ = false;
    double thud_s_ = -1e9;
    // Shortest distance of the ball to the goal until now, and the time when the ball got there.
    double nearest_m_ = 0.0, nearer_s_ = 0.0;
    bool hint_announced_ = false;
};

}  // namespace handrail::core
