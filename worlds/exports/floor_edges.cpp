#include "worlds/exports/floor_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "worlds/navigation/walk_space.h"

namespace handrail::exports {
namespace {

constexpr double kEdgeStep_mm = 0.5;  // distance along an edge between two places at which a line is tried
// Distance on either side of an edge at which the rooms are looked up. It is in addition to the distance by which the
// edge may deviate from the cells of the floor.
constexpr double kEdgeAside_mm = 0.4;
// Greatest distance, in cells of the floor, between an edge and the sides of these cells. An edge that is oblique to
// the grid has steps of one cell. Short lines along each of these steps would not show where the edge runs.
constexpr double kSteps_cells = 1.05;
// The stretch without lines at an exit extends this far beyond the width of the exit.
constexpr double kNextToExit_m = 0.6;

// Finds places on a closed line by their distance along the line.
class AlongLoop {
public:
    explicit AlongLoop(const std::vector<Vec2>& loop) : loop_(loop), from_(1, 0.0) {
        for (std::size_t i = 0; i < loop.size(); ++i)
            from_.push_back(from_.back() + glm::distance(loop[i], loop[(i + 1) % loop.size()]));
    }
    double length() const { return from_.back(); }
    Vec2 at(double far) const {
        const auto next = std::upper_bound(from_.begin(), from_.end() - 1, far);
        const auto i = static_cast<std::size_t>(next - from_.begin()) - 1;
        const double side = from_[i + 1] - from_[i];
        const double t = side > 0.0 ? (far - from_[i]) / side : 0.0;
        return loop_[i] + (loop_[(i + 1) % loop_.size()] - loop_[i]) * t;
    }

private:
    const std::vector<Vec2>& loop_;
    std::vector<double> from_;  // distance along the line of each corner, and at the end of the first corner again
};

class FloorEnds {
public:
    FloorEnds(const plan::Storey& storey, const OnPaper& on_paper, const plan::RoomGrid& rooms)
        : storey_(storey), on_paper_(on_paper), rooms_(rooms) {}

    double steps_mm() const { return kSteps_cells * storey_.floor.cell_m * on_paper_.mm_per_m; }

    // Returns the room whose floor ends along the line between the two points; nothing if no floor ends there.
    std::optional<std::uint32_t> ends_along(const Vec2& from, const Vec2& to) const {
        const Vec2 along = (to - from) / glm::distance(from, to);
        const Vec2 aside = Vec2(-along.y, along.x) * (kEdgeAside_mm + steps_mm());
        std::optional<std::uint32_t> room;
        for (const Vec2& at : {from, 0.5 * (from + to), to}) {
            const std::uint32_t left = room_at(at + aside), right = room_at(at - aside);
            const auto beyond = static_cast<std::uint32_t>(storey_.rooms.size());
            if ((left == beyond) == (right == beyond)) return std::nullopt;
            room = left == beyond ? right : left;
            if (*room == navigation::kNothing || leads_on(at) || !on_storey(at)) return std::nullopt;
            const plan::StoreyRoom& mine = storey_.rooms[*room];
            if (mine.outside || mine.elsewhere || mine.kind == navigation::RoomKind::Stairs) return std::nullopt;
        }
        return room;
    }

private:
    std::uint32_t room_at(const Vec2& mm) const {
        const int x = static_cast<int>(std::floor(mm.x / kInkPixel_mm)),
                  y = static_cast<int>(std::floor(mm.y / kInkPixel_mm));
        return rooms_.holds(x, y) ? rooms_.room[rooms_.at(x, y)] : navigation::kNothing;
    }
    // Returns whether the place is inside the storey's area. Outside that area, the grid says only which room is
    // nearest, not where there is floor.
    bool on_storey(const Vec2& mm) const {
        const Vec2 at = on_paper_.world(mm);
        return at.x > storey_.min_m.x && at.y > storey_.min_m.y && at.x < storey_.max_m.x && at.y < storey_.max_m.y;
    }
    bool leads_on(const Vec2& mm) const {
        const Vec2 at = on_paper_.world(mm);
        return std::any_of(storey_.exits.begin(), storey_.exits.end(), [&](const plan::StoreyExit& exit) {
            return glm::distance(exit.place_m, at) < 0.5 * exit.width_m + kNextToExit_m;
        });
    }

    const plan::Storey& storey_;
    const OnPaper& on_paper_;
    const plan::RoomGrid& rooms_;
};

}  // namespace

EdgeInk edge_lines(const plan::Storey& storey, const OnPaper& on_paper, const plan::RoomGrid& rooms, Places& places,
                   double line_mm, double clear_mm) {
    EdgeInk made;
    if (storey.floor.beyond.empty()) return made;
    Ink floors;
    floors.wide = rooms.wide, floors.high = rooms.high;
    floors.black.reserve(rooms.room.size());
    for (const std::uint32_t room : rooms.room) floors.black.push_back(room < storey.rooms.size() ? 1 : 0);
    const FloorEnds edges(storey, on_paper, rooms);
    std::set<std::uint32_t> drawn;
    for (const std::vector<Vec2>& loop : traced_mm(floors, edges.steps_mm())) {
        const AlongLoop along(loop);
        for (double far = 0.0; far + kEdgeLine_mm <= along.length();) {
            const Vec2 from = along.at(far), to = along.at(far + kEdgeLine_mm);
            const double length = glm::distance(from, to);
            // A line is not drawn if the edge bends so much that the ends of the stretch are closer than this fraction
            // of its length.
            constexpr double kBent = 0.9;
            const plan::PlanBox line{
                0.5 * (from + to), length > 0.0 ? (to - from) / length : Vec2(1.0, 0.0), {0.5 * length, 0.5 * line_mm}};
            const auto room = length > kBent * kEdgeLine_mm ? edges.ends_along(from, to) : std::nullopt;
            if (!room || !places.fits(line)) {
                far += kEdgeStep_mm;
                continue;
            }
            places.take(corners_of(line));
            made.lines.push_back(line);
            drawn.insert(*room);
            far += kEdgeLine_mm + clear_mm;
        }
    }
    made.rooms.assign(drawn.begin(), drawn.end());
    return made;
}

}  // namespace handrail::exports
