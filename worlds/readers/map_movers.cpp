#include "worlds/readers/map_movers.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/human_measures.h"
#include "worlds/base/text.h"

namespace handrail::readers {
namespace {

// Default speeds of the game of 1996, in map units.
constexpr double kDoorSpeed_units_per_s = 100.0, kLiftSpeed_units_per_s = 150.0, kButtonSpeed_units_per_s = 40.0,
                 kTrainSpeed_units_per_s = 100.0;
constexpr double kTurn_deg_per_s = 100.0, kMostTurn_deg_per_s = 720.0;
constexpr double kDoorLip_units = 8.0, kButtonLip_units = 4.0, kLiftLip_units = 8.0;
// Distances at which a door opens automatically for a person: next to the door, and above it.
constexpr double kNearDoor_units = 60.0, kAboveDoor_units = 8.0;
constexpr double kButtonWait_s = 1.0, kLiftWait_s = 3.0;
constexpr double kLeastTravel_s = 0.1, kMostTravel_s = 60.0;
// Defaults for doors in buildings, which swing.
constexpr double kLeafTravel_s = 1.2;
constexpr double kQuarterTurn_rad = kPi / 2.0;
constexpr int kStartsOpen = 1, kDoNotLink = 4, kStays = 32;           // bits of a door's `spawnflags`
constexpr int kStartsOn = 1, kReverse = 2, kAboutX = 4, kAboutY = 8;  // bits of a turning part's `spawnflags`
// Defaults for buildings: 24 units per second are three quarters of a metre per second. A button is kHandAbove_m above
// its floor.
constexpr double kLiftSpeedInBuilding_units_per_s = 24.0, kHandAbove_m = 1.1;
constexpr std::size_t kMostStops = 1000;

std::string name_of_key(const MapEntity& entity, std::string_view key) {
    return lower_ascii(trimmed(entity.value(key)).substr(0, 256));
}

int flags_of(const MapEntity& entity) {
    double flags = 0.0;
    parse_finite(trimmed(entity.value("spawnflags")), flags);
    return std::abs(flags) < 1e6 ? static_cast<int>(flags) : 0;
}

// Returns the direction for an angle of the editor: -1 is up, -2 is down, others are counter-clockwise from east.
Vec3 direction_of_angle(double angle_deg) {
    if (angle_deg == -1.0) return {0.0, 0.0, 1.0};
    if (angle_deg == -2.0) return {0.0, 0.0, -1.0};
    const auto clean = [](double v) { return std::round(v * 1e9) / 1e9; };
    return {clean(std::cos(radians_from_degrees(angle_deg))), clean(std::sin(radians_from_degrees(angle_deg))), 0.0};
}

double travel_s(double way_m, double speed_m_per_s) {
    return std::clamp(way_m / std::max(speed_m_per_s, 1e-6), kLeastTravel_s, kMostTravel_s);
}

// Returns the distance that a box must slide along `direction` to leave its opening, except for the lip that remains in
// the opening.
Vec3 slide_of(const Aabb& bounds_m, const Vec3& direction, double lip_m) {
    const double way = glm::dot(glm::abs(direction), bounds_m.size_m()) - lip_m;
    return way > 0.0 ? direction * way : Vec3(0.0);
}

Aabb grown_by(Aabb box, const Vec3& by) {
    box.min_m -= by;
    box.max_m += by;
    return box;
}

// Hangs a door leaf on one of its vertical edges. Chooses that edge, and the side to which the door opens. By default
// the door opens to the north or east.
void hang(ReadMover& read, const std::string& hinge) {
    const Aabb& box = read.bounds_m;
    const Vec3 size = box.size_m();
    const bool along_x = size.x >= size.y;  // true if the closed leaf runs along x
    const bool at_far_end = along_x ? hinge.find("east") != std::string::npos || hinge == "right"
                                    : hinge.find("north") != std::string::npos || hinge == "left";
    const bool to_far_side = read.direction.empty() || read.direction == (along_x ? "north" : "east");
    Mover& mover = read.mover;
    mover.pivot_m = box.min_m;
    if (along_x) {
        mover.pivot_m.x = at_far_end ? box.max_m.x : box.min_m.x;
        mover.pivot_m.y = to_far_side ? box.max_m.y : box.min_m.y;
    } else {
        mover.pivot_m.x = to_far_side ? box.max_m.x : box.min_m.x;
        mover.pivot_m.y = at_far_end ? box.max_m.y : box.min_m.y;
    }
    // The leaf points from its hinge to its other end, and turns towards the side to which the door opens.
    const bool counter_clockwise = along_x ? at_far_end != to_far_side : at_far_end == to_far_side;
    mover.swing_rad = counter_clockwise ? kQuarterTurn_rad : -kQuarterTurn_rad;
    mover.travel_s = kLeafTravel_s;
}

// Returns the height of the lift's top at `part` of its travel.
double top_m(const ReadMover& lift, double part) { return lift.bounds_m.max_m.z + lift.mover.slide_m.z * part; }
// Returns the end of the lift's travel, 0 or 1, at which the lift's top is nearer to `floor_m`.
double end_near(const ReadMover& lift, double floor_m) {
    return std::abs(top_m(lift, 0.0) - floor_m) <= std::abs(top_m(lift, 1.0) - floor_m) ? 0.0 : 1.0;
}

// Collects the stops of a train from path_corner to path_corner, until a stop repeats or has no successor. At each
// stop, the corner of the train's box with the least coordinates is at the path_corner.
void lay_track(ReadMover& read, const std::vector<ReadCorner>& corners, double unit_m, Diagnostics& diagnostics) {
    std::vector<std::size_t> seen;
    std::string next = read.target;
    Mover& mover = read.mover;
    while (!next.empty() && seen.size() < kMostStops) {
        const auto corner =
            std::find_if(corners.begin(), corners.end(), [&](const ReadCorner& c) { return c.name == next; });
        if (corner == corners.end()) break;
        const auto index = static_cast<std::size_t>(corner - corners.begin());
        if (const auto again = std::find(seen.begin(), seen.end(), index); again != seen.end()) {
            mover.after_last = static_cast<int>(again - seen.begin());
            break;
        }
        seen.push_back(index);
        mover.stops.push_back({corner->at_units * unit_m, corner->wait_s});
        next = corner->target;
    }
    if (mover.stops.size() > 1) {
        mover.pivot_m = read.bounds_m.min_m;
        mover.speed_m_per_s = std::max(read.speed_units, 1.0) * unit_m;
        return;
    }
    mover.stops.clear();
    mover.after_last = -1;
    diagnostics.warn(read.target_place, "map.then_stands", "map.train_target");
}

// Connects movers, switches and their targets, and adds them to the scene. Call the public functions in the order in
// which attach_movers() calls them.
class MoverLinks {
public:
    MoverLinks(ReadMovers& found, Scene& scene, Diagnostics& diagnostics)
        : found_(found),
          movers_(found.movers),
          scene_(scene),
          diagnostics_(diagnostics),
          unit_m_(scene.metres_per_unit),
          wanted_(movers_.size(), false) {}

    void lay_ways();
    void group_leaves();
    void aim_switches();
    void aim_movers();
    void set_approaches();
    void hand_over();

private:
    void lay_way(ReadMover& read);
    void lay_lift(ReadMover& read, bool called) const;
    void lay_slide(ReadMover& read) const;
    void take_a_known_direction(ReadMover& read);
    bool swings(const ReadMover& read, const Feature& feature) const;
    std::vector<std::uint32_t> want(const std::string& target);
    void send_lift(ReadMover& read) const;
    void join_lift(ReadMover& read);

    ReadMovers& found_;
    std::vector<ReadMover>& movers_;
    Scene& scene_;
    Diagnostics& diagnostics_;
    const double unit_m_;
    std::vector<bool> wanted_;  // indexed by mover; true if a switch or another mover starts this mover
};

void MoverLinks::lay_ways() {
    for (std::size_t i = 0; i < movers_.size(); ++i) {
        ReadMover& read = movers_[i];
        read.bounds_m = scene_.features[read.mover.feature.value].bounds_m;
        read.mover.group = static_cast<std::uint32_t>(i);
        if (read.bounds_m.empty()) {
            read.mover.turn_rad_per_s = 0.0;
            continue;
        }
        read.mover.pivot_m = read.bounds_m.centre_m();
        if (read.train) lay_track(read, found_.corners, unit_m_, diagnostics_);
        else if (!read.turns) lay_way(read);
        else if (read.turns_about_units) read.mover.pivot_m = *read.turns_about_units * unit_m_;
    }
}

void MoverLinks::lay_way(ReadMover& read) {
    // In a building, a button calls a lift with a name, and the lift stays at the storey to which it was sent.
    const bool called = read.lift && !scene_.game_map && !read.name.empty();
    if (called && !read.has_wait) read.mover.wait_s = -1.0;
    if (called && !read.has_speed) read.speed_units = kLiftSpeedInBuilding_units_per_s;
    take_a_known_direction(read);
    const Feature& feature = scene_.features[read.mover.feature.value];
    if (swings(read, feature)) {
        hang(read, feature.hinge);
        if (!read.has_wait) read.mover.wait_s = -1.0;  // the door stays open until the person closes it
    } else if (read.lift) {
        lay_lift(read, called);
    } else {
        lay_slide(read);
    }
}

void MoverLinks::take_a_known_direction(ReadMover& read) {
    static const std::vector<std::string> kDirections{"north", "east", "south", "west", "up", "down", "slide"};
    if (read.direction.empty() ||
        std::find(kDirections.begin(), kDirections.end(), read.direction) != kDirections.end())
        return;
    const std::string nearest = nearest_name(read.direction, kDirections);
    diagnostics_.warn(read.direction_place, "map.then_word", "map.door_wish", {{"taken", nearest}});
    read.direction = nearest;
}

bool MoverLinks::swings(const ReadMover& read, const Feature& feature) const {
    const Vec3 size = read.bounds_m.size_m();
    const bool flat = size.z < 0.5 * std::min(size.x, size.y);
    return read.door && !flat && !scene_.game_map && !read.has_angle && read.direction != "up" &&
           read.direction != "down" && read.direction != "slide" && feature.hinge != "top" && feature.hinge != "bottom";
}

void MoverLinks::lay_lift(ReadMover& read, bool called) const {
    const double way_m =
        read.height_units > 0.0 ? read.height_units * unit_m_ : read.bounds_m.size_m().z - read.lip_units * unit_m_;
    if (way_m > 0.0) read.mover.slide_m = {0.0, 0.0, -way_m};
    // The lift waits at the bottom until somebody steps on it or calls it.
    read.mover.rests_far = read.name.empty() || called;
    read.mover.travel_s = travel_s(way_m, read.speed_units * unit_m_);
}

void MoverLinks::lay_slide(ReadMover& read) const {
    Vec3 direction = direction_of_angle(read.angle_deg);
    if (read.direction == "up") direction = {0.0, 0.0, 1.0};
    if (read.direction == "down") direction = {0.0, 0.0, -1.0};
    if (!read.has_angle && read.direction == "slide" && read.bounds_m.size_m().y > read.bounds_m.size_m().x)
        direction = {0.0, 1.0, 0.0};
    read.mover.slide_m = slide_of(read.bounds_m, direction, read.lip_units * unit_m_);
    read.mover.travel_s = travel_s(glm::length(read.mover.slide_m), read.speed_units * unit_m_);
    if (!scene_.game_map && !read.has_wait) read.mover.wait_s = -1.0;
}

// In a game map, doors that touch each other are leaves of one door.
void MoverLinks::group_leaves() {
    const auto leaf = [](const ReadMover& read) { return read.door && read.linked && read.mover.swing_rad == 0.0; };
    for (std::size_t i = 0; i < movers_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const ReadMover &a = movers_[i], &b = movers_[j];
            if (!leaf(a) || !leaf(b)) continue;
            const Aabb near = grown_by(a.bounds_m, Vec3(unit_m_));
            const Vec3 gap = glm::max(near.min_m - b.bounds_m.max_m, b.bounds_m.min_m - near.max_m);
            if (std::max({gap.x, gap.y, gap.z}) > 0.0) continue;
            const std::uint32_t from = std::max(a.mover.group, b.mover.group),
                                to = std::min(a.mover.group, b.mover.group);
            for (ReadMover& other : movers_)
                if (other.mover.group == from) other.mover.group = to;
        }
}

// Returns the movers with the name `target`, and marks them as started by a switch or another mover.
std::vector<std::uint32_t> MoverLinks::want(const std::string& target) {
    std::vector<std::uint32_t> all;
    for (std::size_t i = 0; i < movers_.size(); ++i) {
        if (target.empty() || movers_[i].name != target) continue;
        all.push_back(static_cast<std::uint32_t>(i));
        wanted_[i] = true;
    }
    return all;
}

void MoverLinks::aim_switches() {
    for (ReadSwitch& read : found_.switches) {
        read.act.sets_going = want(read.target);
        if (!read.teleports) continue;
        const auto to = std::find_if(found_.destinations.begin(), found_.destinations.end(),
                                     [&](const ReadDestination& d) { return d.name == read.target; });
        if (to == found_.destinations.end()) {
            if (!found_.names.contains(read.target))
                diagnostics_.warn(read.place, "map.then_nowhere", "map.teleporter_target",
                                  {{"target", excerpt(read.target)}});
            continue;
        }
        read.act.leads_elsewhere = true;
        read.act.feet_m = to->feet_m;
        read.act.heading_rad = to->heading_rad;
    }
}

void MoverLinks::aim_movers() {
    for (ReadMover& read : movers_) read.mover.sets_going = want(read.target);
    for (std::size_t i = 0; i < movers_.size(); ++i) {
        ReadMover& read = movers_[i];
        // Movers with the same name are meant to move together, even if their paths cross.
        for (std::size_t j = 0; j <= i && !read.name.empty() && read.mover.passes == kNoMover; ++j)
            if (movers_[j].name == read.name) read.mover.passes = static_cast<std::uint32_t>(j);
        if (read.train || read.turns) read.mover.starts_going = read.starts_on || !wanted_[i];
        send_lift(read);
        if (!read.of_lift.empty()) join_lift(read);
    }
}

// In a building, a button calls the lift to the button's storey.
void MoverLinks::send_lift(ReadMover& read) const {
    if (read.door || scene_.game_map || read.bounds_m.empty()) return;
    for (const std::uint32_t other : read.mover.sets_going)
        if (movers_[other].lift && movers_[other].mover.moves())
            read.mover.sends_to = end_near(movers_[other], read.bounds_m.centre_m().z - kHandAbove_m);
}

// Makes the mover a door of the lift that it names.
void MoverLinks::join_lift(ReadMover& read) {
    const auto lift = std::find_if(movers_.begin(), movers_.end(),
                                   [&](const ReadMover& other) { return other.lift && other.name == read.of_lift; });
    if (lift == movers_.end() || !lift->mover.moves())
        return diagnostics_.warn(read.of_lift_place, "map.then_any_door", "map.lift_name",
                                 {{"name", excerpt(read.of_lift)}});
    read.mover.lift = static_cast<std::uint32_t>(lift - movers_.begin());
    read.mover.lift_part = end_near(*lift, read.bounds_m.min_m.z);
    if (!read.has_wait) read.mover.wait_s = kLiftDoorWait_s;
    // The door also opens for a person in the lift, so that nobody is trapped in the lift.
    read.mover.approach_m = lift->bounds_m;
    read.mover.approach_m.min_m.z = top_m(*lift, read.mover.lift_part);
    read.mover.approach_m.max_m.z = read.mover.approach_m.min_m.z + kStandingRoom_m;
}

// In a game map, a door without a name opens automatically, with all its leaves, when a person comes near. A door with
// a name waits for its button.
void MoverLinks::set_approaches() {
    for (ReadMover& read : movers_) {
        if (read.mover.moves() && read.lift && read.name.empty()) {
            // A person who stands in the shaft below the lift starts it.
            Aabb shaft = read.bounds_m;
            shaft.max_m.z = read.bounds_m.max_m.z + read.mover.slide_m.z + kAboveDoor_units * unit_m_;
            shaft.min_m.z = read.bounds_m.min_m.z + read.mover.slide_m.z;
            read.mover.approach_m = shaft;
        }
        if (!read.door || !scene_.game_map || read.mover.rests_far || read.mover.lift != kNoMover) continue;
        Aabb all;
        bool alone = true;
        for (const ReadMover& other : movers_) {
            if (other.mover.group != read.mover.group) continue;
            all.include(other.bounds_m);
            alone = alone && other.name.empty();
        }
        if (alone)
            read.mover.approach_m = grown_by(all, Vec3(kNearDoor_units, kNearDoor_units, kAboveDoor_units) * unit_m_);
    }
}

void MoverLinks::hand_over() {
    for (std::size_t i = 0; i < movers_.size(); ++i) {
        // In a game map, a door that a button or switch opens cannot be opened by hand.
        if (movers_[i].door && scene_.game_map && wanted_[i] && movers_[i].mover.lift == kNoMover)
            movers_[i].mover.by_hand = false;
        scene_.movers.push_back(movers_[i].mover);
    }
    for (const ReadSwitch& read : found_.switches)
        if (read.act.leads_elsewhere || !read.act.sets_going.empty()) scene_.switches.push_back(read.act);
}

}  // namespace

void note_name(ReadMovers& found, const MapEntity& entity) {
    if (std::string name = name_of_key(entity, "targetname"); !name.empty()) found.names.insert(std::move(name));
}

void note_corner(ReadMovers& found, const MapEntity& entity, const MapKeys& keys) {
    const std::optional<Vec3> at = keys.vector_of(entity, "origin");
    ReadCorner corner{name_of_key(entity, "targetname"), name_of_key(entity, "target"), at.value_or(Vec3(0.0)),
                      keys.number_of(entity, "wait", -1.0, 3600.0, "map.range_wait").value_or(0.0)};
    if (at && !corner.name.empty()) found.corners.push_back(std::move(corner));
}

void note_mover(ReadMovers& found, const MapEntity& entity, std::string_view class_name, FeatureId feature,
                const MapKeys& keys, const std::optional<Vec3>& origin_units) {
    const bool door = class_name.starts_with("func_door"), lift = class_name.starts_with("func_plat"),
               button = class_name == "func_button";
    const bool train = class_name == "func_train", turns = class_name == "func_rotating";
    if (!door && !lift && !button && !train && !turns) return;
    ReadMover read;
    read.train = train;
    read.turns = turns;
    read.turns_about_units = origin_units;
    read.target_place = entity.place;
    if (turns) {
        const int flags = flags_of(entity);
        const double degrees =
            keys.number_of(entity, "speed", 0.0, kMostTurn_deg_per_s, "map.range_turn").value_or(kTurn_deg_per_s);
        read.mover.turn_rad_per_s = radians_from_degrees((flags & kReverse) != 0 ? -degrees : degrees);
        if ((flags & kAboutX) != 0) read.mover.turn_axis = {1.0, 0.0, 0.0};
        else if ((flags & kAboutY) != 0) read.mover.turn_axis = {0.0, 1.0, 0.0};
        read.starts_on = (flags & kStartsOn) != 0;
    }
    if (train || turns) read.mover.by_hand = false;
    if (const MapKey* key = entity.find("lift"); key && door) {
        read.of_lift = name_of_key(entity, "lift");
        read.of_lift_place = key->place;
    }
    read.mover.feature = feature;
    read.door = door;
    read.lift = lift;
    read.name = name_of_key(entity, "targetname");
    read.target = name_of_key(entity, "target");
    if (const MapKey* key = entity.find("target")) read.target_place = key->place;
    read.direction = name_of_key(entity, "opens");
    if (const MapKey* key = entity.find("opens")) read.direction_place = key->place;
    read.linked = (flags_of(entity) & kDoNotLink) == 0;
    read.has_angle = entity.find("angle") != nullptr;
    read.angle_deg = keys.number_of(entity, "angle", -360.0, 360.0, "map.range_door_angle").value_or(0.0);
    const double usual_speed_units = lift     ? kLiftSpeed_units_per_s
                                     : button ? kButtonSpeed_units_per_s
                                     : train  ? kTrainSpeed_units_per_s
                                              : kDoorSpeed_units_per_s;
    if (!turns) {
        const std::optional<double> speed_units = keys.number_of(entity, "speed", 0.0, 1e5, "map.range_speed");
        read.has_speed = speed_units.has_value();
        read.speed_units = speed_units.value_or(usual_speed_units);
    }
    // A speed of 0 in the file means the usual speed, as in the game.
    if (read.speed_units <= 0.0) read.speed_units = kButtonSpeed_units_per_s;
    read.lip_units = keys.number_of(entity, "lip", -1e5, 1e5, "map.range_units")
                         .value_or(lift     ? kLiftLip_units
                                   : button ? kButtonLip_units
                                            : kDoorLip_units);
    read.height_units = keys.number_of(entity, "height", 0.0, 1e5, "map.range_units").value_or(0.0);
    const std::optional<double> wait_s = keys.number_of(entity, "wait", -1.0, 3600.0, "map.range_wait");
    read.has_wait = wait_s.has_value();
    read.mover.wait_s = wait_s.value_or(lift ? kLiftWait_s : button ? kButtonWait_s : kDoorWait_s);
    if (door && (flags_of(entity) & kStays) != 0) read.mover.wait_s = -1.0;
    read.mover.rests_far = door && (flags_of(entity) & kStartsOpen) != 0;
    found.movers.push_back(std::move(read));
}

void note_switch(ReadMovers& found, const MapEntity& entity, std::string_view class_name, FeatureId feature) {
    if (!class_name.starts_with("trigger_") || class_name == "trigger_changelevel") return;
    ReadSwitch read;
    read.act.volume = feature;
    read.act.once = class_name == "trigger_once" || class_name == "trigger_secret";
    read.teleports = class_name == "trigger_teleport";
    read.target = name_of_key(entity, "target");
    read.place = entity.find("target") ? entity.find("target")->place : entity.place;
    if (!read.target.empty()) found.switches.push_back(std::move(read));
}

void note_destination(ReadMovers& found, const MapEntity& entity, const Vec3& feet_m, double heading_rad) {
    if (std::string name = name_of_key(entity, "targetname"); !name.empty())
        found.destinations.push_back({std::move(name), feet_m, heading_rad});
}

void attach_movers(ReadMovers& found, Scene& scene, Diagnostics& diagnostics) {
    MoverLinks links(found, scene, diagnostics);
    links.lay_ways();
    links.group_leaves();
    links.aim_switches();
    links.aim_movers();
    links.set_approaches();
    links.hand_over();
}

}  // namespace handrail::readers
