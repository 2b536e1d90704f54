#include "app/wizard/wizard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::wizard {
namespace {

// Greatest time step of a tick. After a late frame, the wizard uses this step instead of a longer one, so that the
// force does not rise faster.
constexpr double kLongestTick_s = 0.05;

}  // namespace

Wizard::Wizard(const settings::Settings& settings, std::span<const WizardPart> parts)
    : settings_(settings),
      plan_(plan_of(parts)),
      home_wanted_(std::find(parts.begin(), parts.end(), WizardPart::Home) != parts.end()) {
    found_.step_length_m = settings.walk.step_length_m;
    felt_.tuning.forces_on = false;
    felt_.tuning.force_ceiling_n = 0.0;
    felt_.tuning.touch.radius_m = 0.002;
    felt_.tuning.touch.damping_ns_per_m = settings.haptic.damping_ns_per_m;
}

servo::WorkspacePose Wizard::pose() const {
    servo::WorkspacePose pose;  // in the set-up, a metre of the device is a metre of the world
    pose.time_s = now_s_;
    pose.jump = kFirstJump + felt_.jump;
    return pose;
}

bool Wizard::homed() const { return sense_.tool.ticks > 0 && sense_.tool.fault != servo::Fault::Unhomed; }
double Wizard::radius_m() const { return sense_.hand.spec.workspace_radius_m; }

std::string Wizard::newtons(double force_n) {
    return phrase("wizard.force", {{"force", std::round(force_n * 100.0) / 100.0}});
}

void Wizard::say(std::string text) {
    cues::CueRequest request;
    request.kind = cues::CueRequestKind::Say;
    request.time_s = reply_s_;
    request.text = std::move(text);
    request.repeatable = true;
    cues_.push_back(std::move(request));
}

void Wizard::play(cues::SoundKind kind, const Vec3& position_m) {
    cues::CueRequest request;
    request.kind = cues::CueRequestKind::Play;
    request.sound = kind;
    request.time_s = now_s_;
    request.position_m = position_m;
    cues_.push_back(std::move(request));
}

void Wizard::click() { play(cues::SoundKind::TurnTick, sense_.listener.ears_m); }

void Wizard::change_profile(std::string_view field, std::string value) {
    change(fmt::format("profile.{}.{}", settings::profile_key(sense_.hand.spec.name, sense_.hand.serial), field),
           std::move(value));
}

// ---- the order of the questions ----

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
    question_.step = plan_[index];
    paused_ = false;
    felt_.tuning.panic = false;
    felt_.tuning.forces_on = false;
    question_.typed.clear();
    question_.hand_m = reach_.least_m = reach_.most_m = sense_.tool.hand_m;
    homing_.newly_homed = false;
    homing_.legs_at_start = sense_.tool.homed_legs;
    if (const auto begin = row(question_.step).begin) (this->*begin)();
    if (question_.step == Step::Done) return finish();
    pose_question();
}

void Wizard::finish() {
    play(cues::SoundKind::Arrived, sense_.listener.ears_m);
    say(phrase("wizard.done"));
    finished_ = true;
}

void Wizard::go_back() {
    std::size_t before = index_;
    while (before > 0 && (is_skipped(plan_[before - 1]) || plan_[before - 1] == Step::Search)) --before;
    if (before == 0) say(phrase("wizard.first"));
    enter(before == 0 ? index_ : before - 1);
}

void Wizard::pose_question() {
    question_.text = (this->*row(question_.step).question)();
    say(question_.text);
}

settings::DeviceProfile Wizard::own_profile() const {
    const auto found = settings_.profiles.find(settings::profile_key(sense_.hand.spec.name, sense_.hand.serial));
    return found == settings_.profiles.end() ? settings::DeviceProfile{} : found->second;
}

// ---- the person's answers ----

void Wizard::answer(const WizardEvent& event, double now_s) {
    if (!begun_ || finished_) return;
    now_s_ = std::max(now_s_, now_s);
    reply_s_ = now_s_;
    const WizardKey* key = std::get_if<WizardKey>(&event);
    if (key && *key == WizardKey::Stop) {
        cues::CueRequest silence;
        silence.kind = cues::CueRequestKind::SilenceAll;
        silence.time_s = now_s_;
        cues_.push_back(std::move(silence));
        pause(phrase("wizard.stopped"));
        felt_.tuning.panic = true;
        return;
    }
    cues::CueRequest quiet;  // any key interrupts the sentence that is being spoken
    quiet.kind = cues::CueRequestKind::StopSpeech;
    quiet.time_s = now_s_;
    cues_.push_back(std::move(quiet));
    if (paused_ && !(key && *key == WizardKey::Leave)) return resume();
    if (!key) {
        if (question_.step != Step::StepLength) return play(cues::SoundKind::Denied, sense_.listener.ears_m);
        const std::string& figures = std::get<std::string>(event);
        question_.typed += figures;
        return say(figures);
    }
    switch (*key) {
        case WizardKey::Enter:
            return accept();
        case WizardKey::Forces:  // the force is on already, so this key only repeats the question
            return repeat_question();
        case WizardKey::Repeat:
            if (question_.step == Step::Press) begin_force(felt_.scene);
            begin_bell();
            return repeat_question();
        case WizardKey::Back:
            if (!question_.typed.empty()) {  // if a number has been typed, Back only deletes that number
                question_.typed.clear();
                return pose_question();
            }
            return go_back();
        case WizardKey::Leave:
            if (paused_) {
                say(phrase("wizard.leaving"));
                felt_.tuning.forces_on = false;
                finished_ = true;
                return;
            }
            return pause(phrase("wizard.explain",
                                {{"part", phrase("wizard_part." + std::string(part_of(question_.step).word))}}));
        default:
            return adjust(*key);
    }
}

void Wizard::pause(std::string words) {
    paused_ = true;
    felt_.tuning.forces_on = false;
    say(std::move(words));
}

// Continues after a pause: repeats the question from its beginning. Also confirms a fault that was announced.
void Wizard::resume() {
    ++felt_.tuning.confirm;
    enter(index_);
}

void Wizard::accept() {
    if (const auto accept = row(question_.step).accept) (this->*accept)();
    else go_on();
}

void Wizard::adjust(WizardKey key) {
    if (const auto adjust = row(question_.step).adjust; adjust && (this->*adjust)(key)) return;
    if (key == WizardKey::Up) return go_back();
    play(cues::SoundKind::Denied, sense_.listener.ears_m);
}

// ---- what happens on each tick ----

void Wizard::tick(const WizardSense& sense) {
    contract_pre(std::isfinite(sense.now_s));
    const double dt_s = std::clamp(sense.now_s - now_s_, 0.0, kLongestTick_s);
    sense_ = sense;
    now_s_ = std::max(now_s_, sense.now_s);
    if (finished_) return;
    if (!begun_) {
        begun_ = true;
        reply_s_ = now_s_;
        enter(0);
    }
    if (const auto frame = row(question_.step).frame) return (this->*frame)();
    if (part_of(question_.step).needs_device) watch_hand(dt_s);
}

void Wizard::watch_hand(double dt_s) {
    const servo::ToolState& tool = sense_.tool;
    if (servo::is_lost(tool.fault) && !lost_device_) {
        lost_device_ = true;
        reply_s_ = now_s_;
        say(phrase(tool.fault == servo::Fault::Unplugged ? "wizard.unplugged"
                                                         // If a device is lost without being unplugged, its own alarm
                                                         // has already said what happened.
                                                         : "wizard.lost"));
        return go_on();
    }
    // Ignore a fault if this question needs no force.
    if (tool.fault_latched && felt_.tuning.forces_on && !paused_) {
        reply_s_ = now_s_;
        return pause(phrase("wizard.fault"));  // the session announces the cause of the fault, as it does in a world
    }
    const bool pressed = tool.buttons != 0 && !std::exchange(button_was_down_, tool.buttons != 0);
    if (tool.buttons == 0) button_was_down_ = false;
    if (paused_) return;
    if (const auto watch = row(question_.step).watch; watch && (this->*watch)(dt_s)) return;
    if (pressed) answer(WizardKey::Enter, now_s_);
}

void Wizard::begin_force(std::shared_ptr<const render::HapticScene> scene) {
    felt_.scene = std::move(scene);
    felt_.tuning.forces_on = true;
    felt_.tuning.force_ceiling_n = 0.0;
    held_top_s_ = 0.0;
    question_.begun_s = now_s_;
    ++felt_.jump;
}

}  // namespace handrail::wizard
