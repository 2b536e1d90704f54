#include "app/wizard/wizard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr std::array kParts{
    WizardPartInfo{WizardPart::Headphones, "headphones", false},
    WizardPartInfo{WizardPart::Find, "find", false},
    WizardPartInfo{WizardPart::Home, "home", true},
    WizardPartInfo{WizardPart::Hand, "hand", true},
    WizardPartInfo{WizardPart::Gentlest, "gentlest", true},
    WizardPartInfo{WizardPart::Strongest, "strongest", true},
    WizardPartInfo{WizardPart::Reach, "reach", true},
    WizardPartInfo{WizardPart::Step, "step", false},
};

constexpr double kBellEvery_s = 2.5;
constexpr double kBellAside_m = 1.5;
constexpr double kFirstAnswer_s = 0.2;   // a device that was opened needs a moment to say where it is
constexpr double kLongestTick_s = 0.05;  // a frame that came late is not made up for by more force
constexpr double kPressAfter_s = 1.5;    // at the earliest; never before the question is over
constexpr double kLetGoAfter_s = 5.0;    // at the gentlest part's most
constexpr double kNoticed_n = 0.05;      // an answer to less is no answer to the force
constexpr double kLeastCeiling_n = 0.5;
constexpr double kFineCeiling_n = 0.1;
constexpr double kMovedShare = 0.4;       // of the device's radius, that counts as pulled, pushed or moved aside
constexpr double kSideShare = 0.3;        // that counts as one side of the sweep
constexpr double kLeastReachShare = 0.3;  // of the device's width: less was no sweep
constexpr double kAheadShare = 0.125;     // the middle of the reach lies this share of its depth ahead of the body: 5 parts ahead, 3 behind
constexpr double kStepStep_m = 0.05, kShortestStep_m = 0.2, kLongestStep_m = 1.5;
constexpr std::array kScales{7.5, 15.0, 30.0, 60.0, 120.0, 240.0};

// 9 or 7.5.
double rounded(double value) { return value < 10.0 ? std::round(value * 10.0) / 10.0 : std::round(value); }
std::string newtons(double force_n) { return phrase("wizard.force", {{"force", std::round(force_n * 100.0) / 100.0}}); }

// Everything a hand can reach, pushing it towards the person; how strongly, the ceiling says.
std::shared_ptr<const HapticScene> pressing_scene() {
    EffectVolume push;
    push.region = SphereRegion{Vec3(0.0), 1.0};
    push.law = ForceLaw{{0.0, -1.0, 0.0}, Wizard::kGentlestMost_n};
    HapticSceneBuilder builder;
    builder.add_effect(push);
    return builder.build();
}

std::shared_ptr<const HapticScene> wall_scene(double face_y_m) {
    HapticSceneBuilder builder;
    builder.add_box({{-1.0, face_y_m, -1.0}, {1.0, face_y_m + 1.0, 1.0}});
    return builder.build();
}

}  // namespace

std::span<const WizardPartInfo> wizard_parts() { return kParts; }

Result<std::vector<WizardPart>> parse_wizard_parts(std::string_view words) {
    std::vector<std::string> known;
    for (const WizardPartInfo& part : kParts) known.emplace_back(part.word);
    std::vector<bool> chosen(kParts.size(), words.empty());
    while (!words.empty()) {
        const std::size_t comma = std::min(words.find(','), words.size());
        const std::string word = lower_ascii(words.substr(0, comma));
        words.remove_prefix(std::min(comma + 1, words.size()));
        const auto row = std::find(known.begin(), known.end(), word);
        if (row == known.end()) return fail(phrase("wizard.no_part", {{"word", word}, {"nearest", nearest_name(word, known)}}));
        chosen[static_cast<std::size_t>(row - known.begin())] = true;
    }
    std::vector<WizardPart> parts;
    for (const WizardPartInfo& part : kParts)
        if (chosen[static_cast<std::size_t>(part.part)]) parts.push_back(part.part);
    return parts;
}

const WizardPartInfo& Wizard::part_of(Step step) {
    switch (step) {
        case Step::BellLeft:
        case Step::BellRight:
            return kParts[0];
        case Step::Search:
            return kParts[1];
        case Step::Pull:
        case Step::Push:
            return kParts[2];
        case Step::WhichHand:
            return kParts[3];
        case Step::Press:
            return kParts[4];
        case Step::Wall:
            return kParts[5];
        case Step::Sweep:
        case Step::Scale:
        case Step::Beyond:
            return kParts[6];
        case Step::StepLength:
        case Step::Done:
            break;
    }
    return kParts[7];
}

Wizard::Wizard(const Settings& settings, std::span<const WizardPart> parts) : settings_(settings) {
    const auto wanted = [&](WizardPart part) { return std::find(parts.begin(), parts.end(), part) != parts.end(); };
    const bool device = std::any_of(parts.begin(), parts.end(), [](WizardPart part) { return kParts[static_cast<std::size_t>(part)].needs_device; });
    home_wanted_ = wanted(WizardPart::Home);
    const auto add = [&](bool when, std::initializer_list<Step> steps) {
        if (when) plan_.insert(plan_.end(), steps);
    };
    add(wanted(WizardPart::Headphones), {Step::BellLeft, Step::BellRight});
    add(wanted(WizardPart::Find) || device, {Step::Search});
    add(device, {Step::Pull, Step::Push});
    add(wanted(WizardPart::Hand), {Step::WhichHand});
    add(wanted(WizardPart::Gentlest), {Step::Press});
    add(wanted(WizardPart::Strongest), {Step::Wall});
    add(wanted(WizardPart::Reach), {Step::Sweep, Step::Scale, Step::Beyond});
    add(wanted(WizardPart::Step), {Step::StepLength});
    plan_.push_back(Step::Done);
    step_length_m_ = settings.walk.step_length_m;
    tuning_.forces_on = false;
    tuning_.force_ceiling_n = 0.0;
    tuning_.touch.radius_m = 0.002;
    tuning_.touch.damping_ns_per_m = settings.haptic.damping_ns_per_m;
}

WorkspacePose Wizard::pose() const {
    WorkspacePose pose;  // device metres are world metres here
    pose.time_s = now_s_;
    pose.jump = kFirstJump + jump_;
    return pose;
}

bool Wizard::homed() const { return sense_.tool.ticks > 0 && sense_.tool.fault != Fault::Unhomed; }
double Wizard::radius_m() const { return sense_.hand.spec.workspace_radius_m; }
double Wizard::strongest_n() const { return std::min(sense_.hand.spec.peak_force_n, 40.0); }
double Wizard::weakest_ceiling_n() const { return std::min(strongest_n(), std::max(kLeastCeiling_n, 2.0 * gentlest_n_)); }

void Wizard::say(std::string text) {
    CueRequest request;
    request.kind = CueRequestKind::Say;
    request.time_s = reply_s_;
    request.text = std::move(text);
    request.repeatable = true;
    cues_.push_back(std::move(request));
}

void Wizard::play(SoundKind kind, const Vec3& position_m) {
    CueRequest request;
    request.kind = CueRequestKind::Play;
    request.sound = kind;
    request.time_s = now_s_;
    request.position_m = position_m;
    cues_.push_back(std::move(request));
}

void Wizard::click() { play(SoundKind::TurnTick, sense_.listener.ears_m); }

void Wizard::change_profile(std::string_view field, std::string value) {
    change(fmt::format("profile.{}.{}", profile_key(sense_.hand.spec.name, sense_.hand.serial), field), std::move(value));
}

// ---- the way through the questions ----

bool Wizard::is_skipped(Step step) const {
    if (part_of(step).needs_device && (lost_device_ || sense_.search == WizardSearch::Nothing)) return true;
    if (step == Step::BellLeft || step == Step::BellRight) return !sense_.audible;
    if (step == Step::Pull || step == Step::Push) return !home_wanted_ && homed();
    return false;
}

void Wizard::enter(std::size_t index) {
    while (is_skipped(plan_[index])) {
        if (plan_[index] == Step::BellLeft) say(phrase("wizard.no_ears"));
        ++index;
    }
    index_ = index;
    step_ = plan_[index];
    paused_ = false;
    tuning_.panic = false;
    tuning_.forces_on = false;
    typed_.clear();
    hand_at_start_m_ = least_m_ = most_m_ = sense_.tool.hand_m;
    newly_homed_ = false;
    legs_at_start_ = sense_.tool.homed_legs;
    switch (step_) {
        case Step::BellLeft:
        case Step::BellRight:
            bell_due_s_ = now_s_;
            break;
        case Step::Search:
            wants_search_ = true;
            search_begun_s_ = -1.0;
            break;
        case Step::Press:
            begin_force(pressing_scene());
            break;
        case Step::Wall:
            wanted_ceiling_n_ = std::clamp(first_ceiling_n(), weakest_ceiling_n(), strongest_n());
            begin_force(wall_scene(std::clamp(hand_at_start_m_.y + 0.005, -kMovedShare * radius_m(), 0.3 * radius_m())));
            break;
        case Step::Sweep:
            sides_seen_ = 0;
            break;
        case Step::Scale:
            scale_ = own_profile().scale.value_or(settings_.workspace.scale);
            break;
        case Step::Done:
            play(SoundKind::Arrived, sense_.listener.ears_m);
            say(phrase("wizard.done"));
            finished_ = true;
            return;
        default:
            break;
    }
    ask();
}

void Wizard::go_back() {
    std::size_t before = index_;
    while (before > 0 && (is_skipped(plan_[before - 1]) || plan_[before - 1] == Step::Search)) --before;
    if (before == 0) say(phrase("wizard.first"));
    enter(before == 0 ? index_ : before - 1);
}

void Wizard::ask() {
    question_ = question_now();
    say(question_);
}

std::string Wizard::question_now() const {
    switch (step_) {
        case Step::BellLeft:
            return phrase("wizard.bell_left");
        case Step::BellRight:
            return phrase("wizard.bell_right");
        case Step::Search:
            return phrase("wizard.search");
        case Step::Pull:
            return phrase("wizard.pull");
        case Step::Push:
            return phrase("wizard.push");
        case Step::WhichHand:
            return phrase("wizard.which_hand");
        case Step::Press:
            return sense_.tool.waiting_for_hand ? phrase("wizard.press_waiting") : phrase("wizard.press");
        case Step::Wall:
            return phrase("wizard.wall", {{"force", ceiling_words()}});
        case Step::Sweep:
            return phrase("wizard.sweep");
        case Step::Scale:
            return phrase("wizard.scale", {{"span", span_words()}});
        case Step::Beyond:
            return settings_.workspace.rim ? phrase("wizard.beyond_on") : phrase("wizard.beyond_off");
        case Step::StepLength:
            return phrase("wizard.step_length", {{"length", step_length_m_ * 100.0}});
        case Step::Done:
            break;
    }
    return {};
}

std::string Wizard::ceiling_words() const {
    const auto is = [this](double level_n) { return std::abs(wanted_ceiling_n_ - level_n) < 1e-6; };
    const std::string force = newtons(wanted_ceiling_n_);
    if (is(kLightCeiling_n)) return phrase("wizard.light", {{"force", force}});
    if (is(kNormalCeiling_n)) return phrase("wizard.normal", {{"force", force}});
    return is(strongest_n()) ? phrase("wizard.full", {{"force", force}}) : force;
}

std::string Wizard::span_words() const {
    const DeviceProfile own = own_profile();
    const double width_m = measured_m_.x > 0.0 ? measured_m_.x : own.width_m.value_or(2.0 * radius_m());
    const double depth_m = measured_m_.y > 0.0 ? measured_m_.y : own.depth_m.value_or(2.0 * radius_m());
    return phrase("wizard.span", {{"width", rounded(width_m * scale_)}, {"depth", rounded(depth_m * scale_)}});
}

DeviceProfile Wizard::own_profile() const {
    const auto found = settings_.profiles.find(profile_key(sense_.hand.spec.name, sense_.hand.serial));
    return found == settings_.profiles.end() ? DeviceProfile{} : found->second;
}

// Whoever never chose begins with light force, so that nobody is startled.
double Wizard::first_ceiling_n() const { return own_profile().ceiling_n.value_or(kLightCeiling_n); }

// ---- what the person answers ----

void Wizard::answer(const WizardEvent& event, double now_s) {
    if (!begun_ || finished_) return;
    now_s_ = std::max(now_s_, now_s);
    reply_s_ = now_s_;
    const WizardKey* key = std::get_if<WizardKey>(&event);
    if (key && *key == WizardKey::Stop) {
        CueRequest silence;
        silence.kind = CueRequestKind::SilenceAll;
        silence.time_s = now_s_;
        cues_.push_back(std::move(silence));
        pause(phrase("wizard.stopped"));
        tuning_.panic = true;
        return;
    }
    CueRequest quiet;  // any key interrupts what is being said
    quiet.kind = CueRequestKind::StopSpeech;
    quiet.time_s = now_s_;
    cues_.push_back(std::move(quiet));
    if (paused_ && !(key && *key == WizardKey::Leave)) return resume();
    if (!key) {
        if (step_ != Step::StepLength) return play(SoundKind::Denied, sense_.listener.ears_m);
        const std::string& figures = std::get<std::string>(event);
        typed_ += figures;
        return say(figures);
    }
    switch (*key) {
        case WizardKey::Enter:
            return accept();
        case WizardKey::Repeat:
            if (step_ == Step::Press) begin_force(scene_);
            bell_due_s_ = now_s_;
            return say(question_);
        case WizardKey::Back:
            if (!typed_.empty()) {  // first what was mistyped
                typed_.clear();
                return ask();
            }
            return go_back();
        case WizardKey::Leave:
            if (paused_) {
                say(phrase("wizard.leaving"));
                tuning_.forces_on = false;
                finished_ = true;
                return;
            }
            return pause(phrase("wizard.explain", {{"part", phrase("wizard_part." + std::string(part_of(step_).word))}}));
        default:
            return adjust(*key);
    }
}

void Wizard::pause(std::string words) {
    paused_ = true;
    tuning_.forces_on = false;
    say(std::move(words));
}

// The same question again, from its beginning; a fault that was told is confirmed with it.
void Wizard::resume() {
    ++tuning_.confirm;
    enter(index_);
}

void Wizard::accept() {
    switch (step_) {
        case Step::Pull:
        case Step::Push:
            if (homed()) return go_on();
            say(phrase("wizard.not_homed", {{"legs", std::popcount(static_cast<unsigned>(sense_.tool.homed_legs))}}));
            return;
        case Step::WhichHand:
            return keep_hand(own_profile().hand.value_or(HoldingHand::Right));
        case Step::Press:
            return keep_gentlest(glm::length(sense_.tool.force_n));
        case Step::Wall:
            return keep_ceiling();
        case Step::Sweep:
            return keep_reach();
        case Step::Scale:
            change_profile("scale", fmt::format("{}", scale_));
            settings_.workspace.scale = scale_;
            return go_on();
        case Step::Beyond:
            change("workspace.rim", settings_.workspace.rim ? "true" : "false");
            return go_on();
        case Step::StepLength:
            return keep_step_length();
        case Step::Search:
            return say(question_);
        default:
            return go_on();
    }
}

void Wizard::adjust(WizardKey key) {
    const double sign = key == WizardKey::Up || key == WizardKey::Right ? 1.0 : -1.0;
    const bool across = key == WizardKey::Left || key == WizardKey::Right;
    switch (step_) {
        case Step::BellLeft:
            if (!across) break;
            if (key == WizardKey::Left) return go_on();
            settings_.sound.swap_sides = !settings_.sound.swap_sides;
            change("sound.swap_sides", settings_.sound.swap_sides ? "true" : "false");
            say(phrase("wizard.swapped"));
            return enter(index_);
        case Step::BellRight:
            if (!across) break;
            if (key == WizardKey::Left) say(phrase("wizard.one_side"));
            return go_on();
        case Step::WhichHand:
            if (!across) break;
            return keep_hand(key == WizardKey::Left ? HoldingHand::Left : HoldingHand::Right);
        case Step::Wall: {
            double wanted_n = wanted_ceiling_n_ + sign * kFineCeiling_n;
            if (!across) {  // to the next of the three steps
                const std::array levels{kLightCeiling_n, kNormalCeiling_n, strongest_n()};
                wanted_n = sign > 0.0 ? strongest_n() : weakest_ceiling_n();
                for (const double level_n : levels)
                    if ((level_n - wanted_ceiling_n_) * sign > 1e-6 && std::abs(level_n - wanted_ceiling_n_) < std::abs(wanted_n - wanted_ceiling_n_))
                        wanted_n = level_n;
            }
            const double before_n = std::exchange(wanted_ceiling_n_, std::clamp(wanted_n, weakest_ceiling_n(), strongest_n()));
            question_ = question_now();
            if (before_n == wanted_ceiling_n_) play(SoundKind::Denied, sense_.listener.ears_m);
            return say(sentence_case(phrase("wizard.said", {{"words", ceiling_words()}})));
        }
        case Step::Scale: {
            if (across) break;
            const double before = scale_;
            if (sign > 0.0) {
                const auto next = std::upper_bound(kScales.begin(), kScales.end(), scale_ + 1e-9);
                if (next != kScales.end()) scale_ = *next;
            } else {
                const auto next = std::lower_bound(kScales.begin(), kScales.end(), scale_ - 1e-9);
                if (next != kScales.begin()) scale_ = *(next - 1);
            }
            question_ = question_now();
            if (before == scale_) play(SoundKind::Denied, sense_.listener.ears_m);
            return say(sentence_case(phrase("wizard.said", {{"words", span_words()}})));
        }
        case Step::Beyond:
            if (across) break;
            settings_.workspace.rim = !settings_.workspace.rim;
            question_ = question_now();
            return say(settings_.workspace.rim ? phrase("wizard.on") : phrase("wizard.off"));
        case Step::StepLength:
            if (across) break;
            step_length_m_ = std::clamp(step_length_m_ + sign * kStepStep_m, kShortestStep_m, kLongestStep_m);
            typed_.clear();
            question_ = question_now();
            return say(phrase("wizard.centimetres", {{"length", step_length_m_ * 100.0}}));
        default:
            break;
    }
    if (key == WizardKey::Up) return go_back();
    play(SoundKind::Denied, sense_.listener.ears_m);
}

void Wizard::keep_hand(HoldingHand hand) {
    change_profile("hand", hand == HoldingHand::Left ? "left" : "right");
    say(hand == HoldingHand::Left ? phrase("wizard.left_hand") : phrase("wizard.right_hand"));
    go_on();
}

void Wizard::keep_gentlest(double felt_n) {
    if (held_top_s_ > kLetGoAfter_s) gentlest_n_ = kGentlestMost_n;
    else if (felt_n >= kNoticed_n) gentlest_n_ = std::clamp(std::round(felt_n * 100.0) / 100.0, kNoticed_n, kGentlestMost_n);
    else gentlest_n_ = own_profile().gentlest_n.value_or(gentlest_n_);
    change_profile("gentlest_n", fmt::format("{}", gentlest_n_));
    say(phrase("wizard.felt", {{"force", newtons(gentlest_n_)}}));
    go_on();
}

void Wizard::keep_ceiling() {
    change_profile("ceiling_n", fmt::format("{:.1f}", wanted_ceiling_n_));
    // The step that all devices share is raised where it would stand in the way, and never lowered for the sake of one device.
    const bool above_normal = wanted_ceiling_n_ > kNormalCeiling_n, above_light = wanted_ceiling_n_ > kLightCeiling_n;
    if (above_normal && settings_.haptic.ceiling != ForceCeiling::Full) change("haptic.ceiling", "full");
    else if (above_light && settings_.haptic.ceiling == ForceCeiling::Light) change("haptic.ceiling", "normal");
    say(phrase("wizard.ceiling", {{"force", newtons(wanted_ceiling_n_)}}));
    go_on();
}

void Wizard::keep_reach() {
    const Vec3 size_m = most_m_ - least_m_, middle_m = 0.5 * (most_m_ + least_m_);
    if (!(size_m.x >= kLeastReachShare * 2.0 * radius_m() && size_m.y >= kLeastReachShare * 2.0 * radius_m())) {
        say(phrase("wizard.reach_kept"));
        return go_on();
    }
    measured_m_ = size_m;
    const auto kept = [](double metres) { return fmt::format("{:.3f}", metres); };
    change_profile("width_m", kept(size_m.x));
    change_profile("depth_m", kept(size_m.y));
    change_profile("height_m", kept(std::max(size_m.z, 0.01)));
    // The middle of what the hand reaches lies a little ahead of the body, at the height that the workspace asks for.
    change_profile("offset_ahead_m", kept(std::clamp(kAheadShare * size_m.y - middle_m.y, -0.1, 0.1)));
    change_profile("offset_up_m", kept(std::clamp(-middle_m.z, -0.1, 0.1)));
    say(phrase("wizard.reach", {{"width", size_m.x * 100.0}, {"depth", size_m.y * 100.0}, {"height", size_m.z * 100.0}}));
    go_on();
}

// One number, of which the size says what it is: metres of a step, metres of ten steps, or centimetres of a step.
void Wizard::keep_step_length() {
    double typed = 0.0;
    if (!typed_.empty()) {
        double length_m = 0.0;
        if (parse_finite(typed_, typed)) length_m = typed <= kLongestStep_m ? typed : typed <= 10.0 * kLongestStep_m ? typed / 10.0 : typed / 100.0;
        if (!(length_m >= kShortestStep_m - 1e-9 && length_m <= kLongestStep_m + 1e-9)) {
            say(phrase("wizard.no_step", {{"typed", typed_}}));
            typed_.clear();
            return ask();
        }
        step_length_m_ = length_m;
    }
    change("walk.step_length_m", fmt::format("{:.2f}", step_length_m_));
    say(phrase("wizard.step", {{"length", step_length_m_ * 100.0}}));
    go_on();
}

// ---- what happens by itself ----

void Wizard::tick(const WizardSense& sense) {
    const double dt_s = std::clamp(sense.now_s - now_s_, 0.0, kLongestTick_s);
    sense_ = sense;
    now_s_ = std::max(now_s_, sense.now_s);
    if (finished_) return;
    if (!begun_) {
        begun_ = true;
        reply_s_ = now_s_;
        enter(0);
    }
    if (step_ == Step::Search) return watch_search();
    if (step_ == Step::BellLeft || step_ == Step::BellRight) return hear_bell();
    if (part_of(step_).needs_device) watch_hand(dt_s);
}

void Wizard::hear_bell() {
    if (paused_ || now_s_ < bell_due_s_) return;
    bell_due_s_ = now_s_ + kBellEvery_s;
    const Vec3 right = right_of_heading(sense_.listener.heading_rad);
    play(SoundKind::Bell, sense_.listener.ears_m + right * (step_ == Step::BellLeft ? -kBellAside_m : kBellAside_m));
}

void Wizard::watch_search() {
    for (const std::string& sentence : sense_.news)
        if (!sentence.empty()) say(sentence);
    if (sense_.search == WizardSearch::Nothing) {
        say(phrase("wizard.no_device"));
        return go_on();
    }
    if (sense_.search != WizardSearch::Ready || paused_) return;
    if (search_begun_s_ < 0.0) search_begun_s_ = now_s_;
    if (sense_.tool.ticks == 0 || now_s_ - search_begun_s_ < kFirstAnswer_s) return;
    tuning_.touch.rated_stiffness_n_per_m = sense_.hand.spec.rated_stiffness_n_per_m;
    say(phrase("wizard.ready", {{"device", sense_.hand.spec.spoken_name()}}));
    go_on();
}

void Wizard::watch_hand(double dt_s) {
    const ToolState& tool = sense_.tool;
    if (tool.fault == Fault::Unplugged && !lost_device_) {
        lost_device_ = true;
        reply_s_ = now_s_;
        say(phrase("wizard.unplugged"));
        return go_on();
    }
    if (tool.fault_latched && tuning_.forces_on && !paused_) {  // where no force is wanted, none is missed
        reply_s_ = now_s_;
        return pause(phrase("wizard.fault"));  // what happened is said as everywhere
    }
    const bool pressed = tool.buttons != 0 && !std::exchange(button_was_down_, tool.buttons != 0);
    if (tool.buttons == 0) button_was_down_ = false;
    if (paused_) return;
    switch (step_) {
        case Step::Pull:
        case Step::Push:
            return watch_homing();  // whoever takes the grip may squeeze its button
        case Step::WhichHand:
            if (const double aside_m = tool.hand_m.x - hand_at_start_m_.x; homed() && std::abs(aside_m) > kMovedShare * radius_m()) {
                reply_s_ = now_s_;
                return keep_hand(aside_m < 0.0 ? HoldingHand::Left : HoldingHand::Right);
            }
            break;
        case Step::Press:
            if (!tool.waiting_for_hand && tuning_.forces_on && !sense_.speaking && now_s_ - asked_s_ > kPressAfter_s)
                tuning_.force_ceiling_n = std::min(kGentlestMost_n, tuning_.force_ceiling_n + kGentlestRise_n_per_s * dt_s);
            if (tuning_.force_ceiling_n < kGentlestMost_n || !tuning_.forces_on) break;
            held_top_s_ += dt_s;
            if (held_top_s_ <= kLetGoAfter_s) break;
            tuning_.forces_on = false;
            say(phrase("wizard.let_go", {{"force", newtons(kGentlestMost_n)}}));
            break;
        case Step::Wall: {
            const double most_n = kCeilingRise_n_per_s * dt_s;
            tuning_.force_ceiling_n += std::clamp(wanted_ceiling_n_ - tuning_.force_ceiling_n, -most_n, most_n);
            break;
        }
        case Step::Sweep:
            watch_sweep();
            break;
        default:
            break;
    }
    if (pressed) answer(WizardKey::Enter, now_s_);
}

void Wizard::watch_homing() {
    const auto legs = [](std::uint8_t bits) { return std::popcount(static_cast<unsigned>(bits)); };
    const int fresh = legs(sense_.tool.homed_legs) - legs(legs_seen_);
    for (int i = 0; i < fresh; ++i) click();
    legs_seen_ = sense_.tool.homed_legs;
    newly_homed_ = newly_homed_ || (homed() && !was_homed_);
    was_homed_ = homed();
    const double away_m = sense_.tool.hand_m.y;
    const bool pulled = legs(sense_.tool.homed_legs) > legs(legs_at_start_) || (homed() && away_m < -kMovedShare * radius_m());
    const bool pushed = homed() && (newly_homed_ || away_m > kMovedShare * radius_m());
    if (!(step_ == Step::Pull ? pulled : pushed)) return;
    reply_s_ = now_s_;
    if (fresh <= 0) click();
    say(phrase("wizard.good"));
    go_on();
}

void Wizard::watch_sweep() {
    const Vec3& hand_m = sense_.tool.hand_m;
    if (!homed() || !is_finite(hand_m)) return;
    least_m_ = glm::min(least_m_, hand_m);
    most_m_ = glm::max(most_m_, hand_m);
    for (int axis = 0; axis < 3; ++axis)
        for (const int high : {0, 1}) {
            const bool there = high ? hand_m[axis] > kSideShare * radius_m() : hand_m[axis] < -kSideShare * radius_m();
            const auto bit = static_cast<std::uint8_t>(1U << (2 * axis + high));
            if (!there || (sides_seen_ & bit)) continue;
            sides_seen_ |= bit;
            click();
        }
}

void Wizard::begin_force(std::shared_ptr<const HapticScene> scene) {
    scene_ = std::move(scene);
    tuning_.forces_on = true;
    tuning_.force_ceiling_n = 0.0;
    held_top_s_ = 0.0;
    asked_s_ = now_s_;
    ++jump_;
}

}  // namespace handrail
