#include "app/core/world/questions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/core/dialogue/brief_words.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kQuarter_rad = kPi / 2.0;
constexpr double kSixteenth_rad = kPi / 8.0;
constexpr std::size_t kMostLooked = 24;  // number of things examined for a question
constexpr std::size_t kMostTowards = 2;  // number of things named in one direction
// A solid within this distance of a sound does not hide the sound, because a clock may hang inside a thing.
constexpr double kSoundSize_m = 0.3;
constexpr double kSamePlace_m = 0.05, kSameTurn_rad = 0.02;
constexpr double kRoof_m = 30.0, kDeepestFloor_m = 100.0;
constexpr double kBarOutdoors_m = 25.0;
constexpr int kBarSteps = 5;

bool is_surface(FeatureKind kind) {
    return kind == FeatureKind::Wall || kind == FeatureKind::Floor || kind == FeatureKind::Ceiling ||
           kind == FeatureKind::Slope;
}

Sight sight_of(const Scene& scene, const Seen& seen) {
    Sight sight{seen, {}, {}, false};
    if (const Feature* feature = scene.find(seen.feature)) {
        sight.name = spoken_name(*feature);
        sight.material = spoken_material(scene.material(feature->material).name);
        sight.surface = is_surface(feature->kind);
    }
    if (sight.name.empty())
        sight.name = sight.material.empty() ? spoken_kind("wall") : std::exchange(sight.material, {});
    return sight;
}

double off_rad(double bearing_rad, double from_rad) { return std::abs(wrap_angle(bearing_rad - from_rad)); }

// Gives a door the place of its doorway instead of its leaf, so that every answer uses the same place.
void use_doorway(const Viewpoint& viewpoint, Seen& seen) {
    for (const Doorway& doorway : viewpoint.doorways) {
        const Vec3 way = doorway.place_m - viewpoint.feet_m;
        const double distance_m = std::hypot(way.x, way.y);
        if (doorway.door != seen.feature || distance_m < 1e-6) continue;
        seen.distance_m = distance_m;
        seen.bearing_rad = std::atan2(way.x, way.y);
    }
}

// Returns true if the sound comes from a thing, which may be hollow or a little smaller than its sound.
bool sounds_from(const Scene& scene, const Sight& thing, const SoundSource& sound) {
    const Feature* feature = thing.surface ? nullptr : scene.find(thing.seen.feature);
    if (!feature || feature->bounds_m.empty()) return false;
    return glm::length(nearest_place(feature->bounds_m, sound.position_m) - sound.position_m) <= kSoundSize_m;
}

void sort_by_distance(std::vector<Sight>& sights) {
    std::stable_sort(sights.begin(), sights.end(),
                     [](const Sight& a, const Sight& b) { return a.seen.distance_m < b.seen.distance_m; });
}

}  // namespace

std::vector<Sight> in_sight(const Viewpoint& viewpoint, std::size_t most) {
    const Scene& scene = viewpoint.world.scene();
    std::vector<Sight> all;
    for (Seen seen : things_in_sight(viewpoint.world, viewpoint.feet_m, kLookHeight_m, kMostLooked)) {
        use_doorway(viewpoint, seen);
        all.push_back(sight_of(scene, seen));
    }
    const Vec3 eye = viewpoint.feet_m + Vec3(0.0, 0.0, kLookHeight_m);
    for (const SoundSource& sound : scene.sounds) {
        const Vec3 way = sound.position_m - eye;
        const double distance_m = glm::length(way);
        const std::string name = spoken_name(sound);
        if (name.empty() || distance_m < 1e-6 || distance_m > kSightRange_m) continue;
        const TraceHit hit = viewpoint.world.trace(eye, sound.position_m, WalkerShape{}, true);
        if (hit.hit && (1.0 - hit.fraction) * distance_m > kSoundSize_m) continue;
        // A person who hears of the grandfather clock needs no second entry for its ticking.
        if (std::any_of(all.begin(), all.end(), [&](const Sight& sight) { return sounds_from(scene, sight, sound); }))
            continue;
        all.push_back(
            {{std::atan2(way.x, way.y), std::hypot(way.x, way.y), kNoFeature, sound.position_m}, name, {}, false});
    }
    sort_by_distance(all);
    std::vector<Sight> described;
    for (Sight& sight : all) {
        if (described.size() == most) break;
        if (std::none_of(described.begin(), described.end(), [&](const Sight& t) { return t.name == sight.name; }))
            described.push_back(std::move(sight));
    }
    return described;
}

std::optional<Sight> sight_along(const Viewpoint& viewpoint, double bearing_rad) {
    const auto seen = walker_meets(viewpoint.world, viewpoint.feet_m, viewpoint.size, bearing_rad);
    if (!seen) return std::nullopt;
    return sight_of(viewpoint.world.scene(), *seen);
}

namespace {

// Adds what a walker would bump into in this direction, and what a straight ray at kLookHeight_m hits.
void add_straight(const Viewpoint& viewpoint, double bearing_rad, std::vector<Sight>& sights) {
    std::optional<Sight> beyond;
    if (const auto seen = look(viewpoint.world, viewpoint.feet_m, kLookHeight_m, bearing_rad))
        beyond = sight_of(viewpoint.world.scene(), *seen);
    for (const std::optional<Sight>& straight : {sight_along(viewpoint, bearing_rad), beyond})
        if (straight && std::none_of(sights.begin(), sights.end(),
                                     [&](const Sight& sight) { return sight.name == straight->name; }))
            sights.push_back(*straight);
}

}  // namespace

std::array<std::optional<Sight>, 4> around(const Viewpoint& viewpoint) {
    std::array<std::optional<Sight>, 4> quarters;
    for (Sight& sight : in_sight(viewpoint, kMostLooked)) {
        const long quarter =
            (std::lround(wrap_angle(sight.seen.bearing_rad - viewpoint.heading_rad) / kQuarter_rad) + 4) % 4;
        auto& place = quarters[static_cast<std::size_t>(quarter)];
        if (!place) place = std::move(sight);
    }
    for (std::size_t i = 0; i < 4; ++i)
        if (!quarters[i])
            quarters[i] = sight_along(viewpoint, viewpoint.heading_rad + static_cast<double>(i) * kQuarter_rad);
    return quarters;
}

std::vector<Sight> ahead(const Viewpoint& viewpoint) {
    std::vector<Sight> sights = in_sight(viewpoint, kMostLooked);
    std::erase_if(sights, [&](const Sight& sight) {
        return off_rad(sight.seen.bearing_rad, viewpoint.heading_rad) > kQuarter_rad / 2.0 + 1e-9;
    });
    add_straight(viewpoint, viewpoint.heading_rad, sights);
    sort_by_distance(sights);
    if (sights.size() > kMostAhead) sights.resize(kMostAhead);
    return sights;
}

std::vector<Sight> look_towards(const Viewpoint& viewpoint, double bearing_rad) {
    std::vector<Sight> sights = in_sight(viewpoint, kMostLooked);
    std::erase_if(sights, [&](const Sight& sight) {
        return off_rad(sight.seen.bearing_rad, bearing_rad) > kSixteenth_rad / 2.0 + 1e-9;
    });
    if (sights.size() > kMostTowards) sights.resize(kMostTowards);
    add_straight(viewpoint, bearing_rad, sights);
    sort_by_distance(sights);
    return sights;
}

std::string sides_of_door(const Feature& door, double bearing_rad) {
    static const std::map<std::string, double, std::less<>> kSides{
        {"north", 0.0}, {"east", kQuarter_rad}, {"south", kPi}, {"west", -kQuarter_rad}};
    const auto side = [&](const std::string& compass, const char* left, const char* right) -> std::string {
        const auto found = kSides.find(compass);
        if (found == kSides.end()) return {};
        const double turn = wrap_angle(found->second - bearing_rad);
        // If the person looks along the leaf, the two sides of the leaf cannot be distinguished as left and right.
        if (std::abs(std::sin(turn)) < 0.3) return {};
        return phrase(turn > 0.0 ? right : left);
    };
    return joined(side(door.hinge, "questions.hinged_left", "questions.hinged_right"),
                  side(door.handle, "questions.handle_left", "questions.handle_right"));
}

std::string describe(const Sight& sight, const std::string& state, const DescriptionStyle& how) {
    std::string name = sentence_case(sight.name);
    // Uses the same words as for exits, in sixteenths of a circle. A person who wants degrees also gets exact
    // distances.
    const bool in_sixteenths = how.distances.rounded && how.directions == settings::DirectionChoice::Sides;
    const auto words = in_sixteenths ? brief_place_words : place_words;
    const std::string place =
        words(sight.seen.distance_m, sight.seen.bearing_rad, how.heading_rad, how.directions, how.distances);
    if (how.verbosity <= 1) return name;
    if (how.verbosity >= 4) {
        std::string text = phrase("questions.it_is_there", {{"name", name}, {"place", place}});
        if (!sight.material.empty()) text += " " + phrase("questions.made_of", {{"material", sight.material}});
        if (!state.empty()) text += " " + phrase("questions.in_state", {{"state", state}});
        return text;
    }
    std::string text = name;
    if (sight.surface || how.verbosity == 3) text = joined(text, sight.material);
    if (how.verbosity == 3) text = joined(text, state);
    return joined(text, place);
}

std::string describe_there(const Sight& sight, const std::string& state, const DescriptionStyle& how) {
    std::string text = sight.name;
    if (how.verbosity <= 1) return text;
    if (sight.surface || how.verbosity >= 3) text = joined(text, sight.material);
    if (how.verbosity >= 3) text = joined(text, state);
    return joined(text, distance_words(sight.seen.distance_m, how.distances));
}

std::string steps_of_size(const Feature& feature, const DistanceWords& how) {
    const Vec3 size = feature.bounds_m.empty() ? Vec3(0.0) : feature.bounds_m.size_m();
    const auto steps = [&](double m) { return std::round(10.0 * m / how.step_length_m) / 10.0; };
    const double wide = steps(std::max(size.x, size.y)), deep = steps(std::min(size.x, size.y));
    const bool upright = feature.kind == FeatureKind::Wall || feature.kind == FeatureKind::Door || deep == 0.0;
    return upright ? phrase("questions.steps_wide", {{"steps", wide}})
                   : phrase("questions.steps_by_steps", {{"wide", wide}, {"deep", deep}});
}

double LookRound::step(int by, const Vec3& feet_m, double heading_rad, std::optional<double> hand_rad) {
    const bool walker_moved =
        !begun_ || glm::length(feet_m - feet_m_) > kSamePlace_m || off_rad(heading_rad, heading_rad_) > kSameTurn_rad;
    const bool hand_moved = hand_rad && (!hand_rad_ || off_rad(*hand_rad, *hand_rad_) > kSixteenth_rad / 2.0);
    begun_ = true;
    feet_m_ = feet_m;
    heading_rad_ = heading_rad;
    if (hand_moved || walker_moved) hand_rad_ = hand_rad;
    if (hand_moved) bearing_rad_ = *hand_rad;
    else if (walker_moved) bearing_rad_ = heading_rad;
    else bearing_rad_ += by * kSixteenth_rad;
    return bearing_rad_ = wrap_angle(bearing_rad_);
}

std::string scale_bar_words(bool outdoors, const DescriptionStyle& how, double hand_scale,
                            double workspace_heading_rad) {
    const double bar_m = outdoors ? kBarOutdoors_m : kBarSteps * how.distances.step_length_m;
    const long steps = outdoors ? std::lround(bar_m / how.distances.step_length_m) : kBarSteps;
    // In compass words, the direction of north would be "north", so it is announced as a side of the person.
    const settings::DirectionChoice choice =
        how.directions == settings::DirectionChoice::Compass ? settings::DirectionChoice::Sides : how.directions;
    const std::string north = direction_words(0.0, how.heading_rad, choice, how.distances.rounded);
    if (!(hand_scale > 0.0)) {
        const std::string bar =
            phrase(outdoors ? "questions.bar_outdoors" : "questions.bar", {{"steps", steps}, {"metres", bar_m}});
        return bar + " " + phrase("questions.north", {{"direction", north}});
    }
    const double turn_deg = std::abs(spoken_turn_deg(0.0, workspace_heading_rad, how.distances.rounded));
    const bool clock = choice == settings::DirectionChoice::Clock;
    const std::string under_hand = !clock && turn_deg == 0.0 ? phrase("questions.away_from_you")
                                   : !clock && turn_deg == 180.0
                                       ? phrase("questions.towards_you")
                                       : direction_words(0.0, workspace_heading_rad, choice, how.distances.rounded);
    return phrase(outdoors ? "questions.bar_outdoors_under_hand" : "questions.bar_under_hand",
                  {{"steps", steps}, {"metres", bar_m}, {"centimetres", 100.0 * bar_m / hand_scale}}) +
           " " + phrase("questions.north_under_hand", {{"hand", under_hand}, {"feet", north}});
}

std::string coordinates_words(const Vec3& place_m) {
    contract_pre(is_finite(place_m));
    return phrase("questions.coordinates", {{"x", std::abs(place_m.x)},
                                            {"east", place_m.x >= -0.05 ? "yes" : "no"},
                                            {"y", std::abs(place_m.y)},
                                            {"north", place_m.y >= -0.05 ? "yes" : "no"},
                                            {"height", std::abs(place_m.z) < 0.05 ? 0.0 : place_m.z}});
}

std::optional<double> above_floor_m(const WalkerWorld& world, const Vec3& place_m) {
    contract_pre(is_finite(place_m));
    const TraceHit hit = world.trace(place_m, place_m - Vec3(0.0, 0.0, kDeepestFloor_m), WalkerShape{}, true);
    if (!hit.hit) return std::nullopt;
    return hit.fraction * kDeepestFloor_m;
}

bool under_roof(const WalkerWorld& world, const Vec3& feet_m) {
    const Vec3 eye = feet_m + Vec3(0.0, 0.0, kLookHeight_m);
    return world.trace(eye, eye + Vec3(0.0, 0.0, kRoof_m), WalkerShape{}, true).hit;
}

}  // namespace handrail::core
