// The hunt as it is played: hides a clock that ticks, says where to go next, notices that hand or body has found it,
// and keeps the best time for each world. App thread only; hunt.h knows the ground.
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

namespace handrail {

class ClockHunt : SessionPart {
public:
    ClockHunt(const SessionContext& context, Rooms& rooms, Soundscape& soundscape);

    // Where best times are kept; until told, they last as long as the session.
    void keep_records_in(const std::filesystem::path& folder) { best_.keep_in(folder); }
    // A hunt begins in the world that is entered next.
    void await_world() { awaits_ = true; }
    void enter_world();
    // Once that world has been told of.
    void begin_awaited(double now_s);
    // Hunt. False: it is another's.
    bool act(Command command, double now_s);
    void tick(double now_s);

private:
    struct Hidden {
        HuntGround ground;
        std::unique_ptr<BodyWorld> open_world;  // without doors
        Vec3 clock_m{0.0};                      // where one stands at it
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

}  // namespace handrail
