// The game of a labyrinth: a ball is to be rolled past holes to a goal. It keeps the clock and the best time, lets
// holes hum and the goal ring, tells how things stand, begins anew, and notices who gets no nearer. It is there where
// the world says so (worlds/scene/labyrinth.h), and nothing of it anywhere else. App thread only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/core/bodies/bodies.h"
#include "app/core/context/session_part.h"
#include "app/core/context/soundscape.h"
#include "app/core/labyrinth/corridors.h"
#include "app/core/learning/best_times.h"

namespace handrail {

class Labyrinth : SessionPart {
public:
    Labyrinth(const SessionContext& context, Bodies& bodies, Soundscape& soundscape);

    // Where best times are kept; until told, they last as long as the session.
    void keep_records_in(const std::filesystem::path& folder) { best_.keep_in(folder); }
    // After the world and its bodies.
    void enter_world(double now_s);
    // What is to be done here; empty: no labyrinth.
    std::string opening_words() const;
    // How things stand, and starting anew. False: it is another's, or this is no labyrinth.
    bool act(Command command, double now_s);
    void tick(double now_s);

private:
    const LabyrinthPlan& plan() const { return context_.world.scene->labyrinth; }
    bool there() const { return context_.world.scene && plan().there() && ball_ < context_.world.scene->placed.size(); }
    std::size_t thing_of(FeatureId feature) const;
    Vec3 at(FeatureId feature) const;
    Vec3 ball_m() const;
    double roll_m() const { return 4.0 * radius_m_; }  // as far as a key rolls it
    double to_goal_m() const;
    std::string off_words(const Vec3& to_m) const;
    std::string free_words() const;
    std::string state_words() const;
    std::string corridor_words(const Corridor& corridor) const;
    void list_corridors(double now_s);
    void meet_border(FeatureId thing, FeatureId met, double now_s);
    bool covered(std::size_t which) const;
    void begin(double now_s);
    void look_at_holes(double now_s, bool tell);
    void sound();

    Bodies& bodies_;
    Soundscape& soundscape_;
    BestTimes best_{"labyrinth"};
    std::size_t ball_ = 0;  // among the placed things of the world
    double radius_m_ = 0.05;
    Vec3 start_m_{0.0};
    std::vector<bool> covered_;
    std::vector<AddedSound> sounds_;  // as the soundscape has them
    double began_s_ = -1.0;           // when the ball first moved; below 0: it has not
    double fallen_s_ = -1.0;          // when it fell into a hole; below 0: it has not
    bool over_ = false;
    double thud_s_ = -1e9;
    double nearest_m_ = 0.0, nearer_s_ = 0.0;  // to the goal so far, and when
    bool hint_told_ = false;
};

}  // namespace handrail
