// Makes the floor of the present world as it appears to a person who follows spoken directions, and the planner for
// routes on that floor. A background task makes both once the rooms are known. Use this class on the app thread only.
// The returned floor is immutable, so any thread may use it. Lengths are in world metres.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/rooms.h"
#include "worlds/base/background_task.h"
#include "worlds/navigation/directions_route.h"

namespace handrail::core {

struct DirectionsFloor {
    DirectionsFloor(std::shared_ptr<const navigation::Navigation> ways_known, std::vector<std::uint32_t> rooms,
                    std::vector<navigation::DirectionsDoor> doors, double step)
        : ways(std::move(ways_known)),
          room_of_span(std::move(rooms)),
          ground(ways->space(), std::move(doors)),
          planner(ground, step),
          step_m(step) {}
    DirectionsFloor(const DirectionsFloor&) = delete;  // not copyable, because its parts keep each other's addresses
    DirectionsFloor& operator=(const DirectionsFloor&) = delete;

    std::shared_ptr<const navigation::Navigation> ways;
    std::vector<std::uint32_t> room_of_span;
    navigation::BlindGround ground;
    navigation::DirectionsPlanner planner;
    double step_m;
};

class DirectionsGround : SessionPart {
public:
    DirectionsGround(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void enter_world();
    void tick();
    // Returns the floor, or null if it is not made yet or there are no rooms.
    std::shared_ptr<const DirectionsFloor> floor();
    // Returns true while the floor is being made or the rooms are being searched for.
    bool awaited() const { return rooms_.awaited() || making_.busy(); }
    // Returns which doors of the floor are open now or opening.
    navigation::DoorsOpen open_now(const DirectionsFloor& floor) const;
    // Returns BlindGround::line_up_m at `feet_m`, or no value if the floor is not known.
    std::optional<double> line_up_m(const Vec3& feet_m, double heading_rad);

private:
    Rooms& rooms_;
    std::shared_ptr<const DirectionsFloor> floor_;
    BackgroundTask<std::shared_ptr<const DirectionsFloor>> making_{context_.executor, "word-floor", context_.arrivals};
};

}  // namespace handrail::core
