#include "audio-cues/plan/finger_planner.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"

namespace handrail::cues {
namespace {

constexpr double kFullForce_n = 1.5;  // force of a surface on the hand at which the trigger has its full stiffness
constexpr double kSlowest_m_per_s = 0.005;  // a slower movement of the hand is treated as tremor, not as sliding
constexpr double kFast_m_per_s = 0.1;       // speed of a fast slide, in hand metres per second
constexpr double kStairs = 0.6;             // slope of stairs (rise over run), at which the left trigger resists fully
// Greatest length of a step. Two footsteps farther apart do not belong to the same walk.
constexpr double kLongestStride_m = 2.0;
constexpr double kDefaultHardness = 0.8;

}  // namespace

double grain_hz(SoundClass sound) noexcept {
    switch (sound) {
        case SoundClass::Grass:
            return 20.0;
        case SoundClass::Carpet:
            return 25.0;
        case SoundClass::Earth:
            return 30.0;
        case SoundClass::Grille:
            return 35.0;
        case SoundClass::Stone:
            return 40.0;
        case SoundClass::Brick:
            return 45.0;
        case SoundClass::Tile:
            return 55.0;
        case SoundClass::Sand:
            return 60.0;
        case SoundClass::Concrete:
            return 70.0;
        case SoundClass::Cloth:
            return 80.0;
        case SoundClass::Wood:
            return 90.0;
        case SoundClass::Plaster:
        case SoundClass::Metal:
        case SoundClass::Glass:
        case SoundClass::Rubber:
        case SoundClass::Water:
        case SoundClass::Plastic:
        case SoundClass::Ice:
        case SoundClass::Generic:
            return 0.0;
    }
    return 0.0;
}

void FingerPlanner::enter_world(std::shared_ptr<const Scene> scene) {
    const settings::Settings::Pads kept = settings_;
    *this = FingerPlanner{};
    settings_ = kept;
    scene_ = std::move(scene);
}

FingerPlanner::Surface FingerPlanner::surface_of(MaterialId material) const {
    Surface surface{.hardness = kDefaultHardness};
    if (!scene_ || scene_->materials.empty()) return surface;
    const Material& given = scene_->material(material);
    const MaterialSpec* spec = find_material(given.name);
    surface.hardness = given.stiffness_fraction.value_or(spec ? spec->stiffness_fraction : kDefaultHardness);
    surface.sound = given.sound;
    const TextureWave* wave = given.wave ? &*given.wave : spec ? &spec->wave : nullptr;
    if (wave && wave->shape != WaveShape::Level && wave->depth_hand_m > 0.0)
        surface.period_hand_m = wave->period_hand_m;
    return surface;
}

void FingerPlanner::on_request(const CueRequest& request) {
    switch (request.kind) {
        case CueRequestKind::Bump: {
            const Feature* feature = scene_ ? scene_->find(request.feature) : nullptr;
            bumped_s_ = request.time_s;
            bumped_ = surface_of(feature ? feature->material : kDefaultMaterial);
            if (feature && feature->kind == FeatureKind::Door) clicked_s_ = request.time_s;
            return;
        }
        case CueRequestKind::Footstep: {
            stepped_s_ = request.time_s;
            stepped_on_.sound = request.material;
            slope_ = 0.0;
            if (last_step_m_) {
                const Vec3 way = request.position_m - *last_step_m_;
                const double run_m = std::sqrt(way.x * way.x + way.y * way.y);
                if (run_m > 0.0 && run_m < kLongestStride_m) slope_ = std::min(1.0, std::abs(way.z) / run_m / kStairs);
            }
            last_step_m_ = request.position_m;
            return;
        }
        case CueRequestKind::WallTone:
            wall_nearness_ = std::clamp(request.loudness, 0.0, 1.0);
            return;
        case CueRequestKind::SilenceAll:
            wall_nearness_ = slope_ = 0.0;
            bumped_s_ = clicked_s_ = stepped_s_ = -1e9;
            return;
        default:
            return;
    }
}

void FingerPlanner::on_passage(double width_m, double now_s) {
    const bool open = width_m <= 0.0;
    if (!open && width_m <= kDoorWidth_m) {
        if (was_wide_) clicked_s_ = now_s;
        was_wide_ = false;
    } else if (open || width_m >= kWide_m) {
        was_wide_ = true;
    }
}

void FingerPlanner::on_hand(const FingerInputs& inputs, device::FingerCue& cue) {
    const servo::ToolState& tool = *inputs.tool;
    const double since_s = inputs.now_s - last_hand_s_;
    const double speed = last_hand_m_ && since_s > 0.0 ? glm::length(tool.hand_m - *last_hand_m_) / since_s : 0.0;
    last_hand_m_ = tool.hand_m;
    last_hand_s_ = inputs.now_s;
    if (tool.contacts.count == 0) {
        touched_door_ = kNoFeature;
        return;
    }
    const render::Contact& met = tool.contacts.contacts[tool.contacts.strongest];
    const Surface surface = surface_of(met.material);
    cue.nearness = std::max(cue.nearness, 0.4 + 0.6 * std::min(1.0, glm::length(tool.force_n) / kFullForce_n));
    cue.hardness = surface.hardness;
    const Feature* feature = scene_ ? scene_->find(met.feature) : nullptr;
    if (feature && feature->kind == FeatureKind::Door) {
        if (touched_door_ != met.feature) clicked_s_ = inputs.now_s;
        touched_door_ = met.feature;
    } else {
        touched_door_ = kNoFeature;
    }
    if (speed < kSlowest_m_per_s) return;
    const double pace = std::min(1.0, speed / kFast_m_per_s);
    cue.material_hz = surface.period_hand_m > 0.0 ? speed / surface.period_hand_m : grain_hz(surface.sound);
    if (cue.material_hz > 0.0) cue.grain = 0.2 + 0.4 * pace;
}

device::FingerCue FingerPlanner::tick(const FingerInputs& inputs) {
    contract_pre(std::isfinite(inputs.now_s));
    for (const CueRequest& request : inputs.requests) on_request(request);
    on_passage(inputs.passage_width_m, inputs.now_s);
    device::FingerCue cue;
    const auto within = [&](double since_s, double for_s) { return inputs.now_s - since_s < for_s; };
    cue.nearness = 0.5 * wall_nearness_;  // Halved, because only a touched surface makes the trigger fully stiff.
    cue.hardness = 1.0;
    if (within(bumped_s_, kBumpHolds_s)) {
        cue.nearness = 1.0;
        cue.hardness = bumped_.hardness;
    }
    if (within(bumped_s_, kKnock_s)) cue.knock = 0.4 + 0.6 * bumped_.hardness;
    if (within(stepped_s_, kStepGrain_s) && grain_hz(stepped_on_.sound) > 0.0) cue.grain = 0.3;
    if (within(stepped_s_, kSlopeHolds_s)) cue.slope = slope_;
    if (inputs.tool) on_hand(inputs, cue);
    cue.doorway = within(clicked_s_, kClick_s);
    if (!settings_.triggers) {
        cue.nearness = cue.slope = cue.material_hz = 0.0;
        cue.doorway = false;
    }
    if (!settings_.rumble) cue.knock = cue.grain = 0.0;
    for (double* share : {&cue.nearness, &cue.slope, &cue.knock, &cue.grain}) *share *= settings_.strength;
    return cue;
}

}  // namespace handrail::cues
