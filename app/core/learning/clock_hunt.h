// The hunt as a game: hides a ticking clock, gives directions to it, notices when the hand or the walker has found it,
// and keeps the best time for each world. App thread only. hunt.h computes the ground.
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

    // Folder for best times; without it, they last as long as the session.
    void keep_records_in(const std::filesystem::path& folder) { best_.keep_in(folder); }
    // The next world that is entered begins with a hunt.
    void await_world() { awaits_ = true; }
    void enter_world();
    // Begins the awaited hunt, after the world has been announced.
    void begin_awaited(double now_s);
    // Handles the Hunt command. Returns false for any other command.
    bool act(Command command, double now_s);
    void tick(double now_s);

private:
    struct Hidden {
        HuntGround ground;
        std::unique_ptr<WalkerWorld> open_world;  // the world without its doors
        Vec3 clock_m{0.0};                        // where a person at the clock would stand
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
