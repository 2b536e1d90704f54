// Runs the hunt as a game. It hides a ticking clock, gives directions to the clock, notices when the hand or the walker
// has found it, and keeps the best time for each world. hunt.h finds the hiding places. Use this class on the app
// thread only.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/context/soundscape.h"
#include "app/core/learning/best_times.h"
#include "app/core/learning/hunt.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

class ClockHunt : SessionPart {
public:
    ClockHunt(const SessionContext& context, Rooms& rooms, Soundscape& soundscape);

    // Sets the folder for best times. Without a folder, best times are lost when the session ends.
    void keep_records_in(const std::filesystem::path& folder) { best_.keep_in(folder); }
    // Requests a hunt in the next world that is entered.
    void await_world() { awaits_ = true; }
    void enter_world();
    // Begins the requested hunt. Call it after the world has been announced.
    void begin_awaited(double now_s);
    // Carries out the Hunt command. Returns false for any other command.
    bool act(Command command, double now_s);
    void tick(double now_s);

private:
    struct Hidden {
        HuntGround ground;
        std::unique_ptr<WalkerWorld> open_world;  // the world with its doors removed
        Vec3 clock_m{0.0};                        // position of the feet of a person who stands at the clock
        double began_s = 0.0;
        int hints = 0;
    };
    void hide(double now_s);
    std::string hint_words() const;

    Rooms& rooms_;
    Soundscape& soundscape_;
    std::optional<Hidden> hidden_;
    std::uint64_t hunts_ = 0;
    BestTimes best_{"hunt"};
    bool awaits_ = false;
};

}  // namespace handrail::core
