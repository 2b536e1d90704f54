#include "tests/unit/wizard/wizard_rig.h"
#include "tests/support/names.h"

namespace handrail::test {
namespace {

constexpr double kFrame_s = 1.0 / 60.0, kCue_s = 0.005;

std::vector<WizardPart> parts_of(std::string_view only) {
    auto parts = parse_wizard_parts(only);
    EXPECT_TRUE(parts);
    return parts ? *parts : std::vector<WizardPart>{};
}

}  // namespace

HeldFalcon::HeldFalcon(VirtualClock& clock) : clock_(clock) {
    const auto image = boot_image(4000);
    emulator.firmware_wanted = image.size();
    emulator.wrong_echo_at_byte = 700;
    emulator.homes_by_moving = true;
    FalconOptions options;
    options.firmware_files = {folder_.write("nvent_firmware.bin", std::string(image.begin(), image.end()))};
    options.report = [this](const std::string& sentence) { report_(sentence); };
    device_ = std::make_unique<FalconDevice>(std::make_unique<DirectFalconLink>(emulator, clock_), clock_, options);
    aim(Vec3(0.0));
}

Result<void> HeldFalcon::open(const std::function<void(const std::string&)>& report) {
    report_ = report;
    return device_->open();
}

WizardRig::WizardRig(std::string_view only, HeldDevice* held, VirtualClock* clock)
    : session(store.values(), parts_of(only)), clock_(clock ? *clock : own_clock_), held_(held) {
    clock_.advance_s(1.0);
    if (held_) {
        servo_ = std::make_unique<ServoState>(held_->facts().spec);
        sense.hand = held_->facts();
    }
}

void WizardRig::advance() {
    const double begun_s = now_s();
    if (servo_ && sense.search == WizardSearch::Ready) {
        const DeviceSample sample = held_->device().read(now_s());
        held_->device().write(servo_tick(*servo_, {session.wizard().haptic_scene().get(), session.wizard().tuning(),
                                                   session.wizard().pose(), sample, now_s()}));
        sense.tool = servo_->tool();
        for (const ContactEvent& event : servo_->events()) contacts_.push_back(event);
        const Vec3 force_n = held_->force_on_hand_n();
        largest_force_n = std::max(largest_force_n, glm::length(force_n));
        largest_step_n = std::max(largest_step_n, glm::length(force_n - last_force_n_));
        last_force_n_ = force_n;
    }
    if (now_s() >= next_frame_s_) {
        next_frame_s_ = now_s() + kFrame_s;
        if (session.wizard().wants_search() && sense.search == WizardSearch::NotBegun) {
            sense.search = WizardSearch::Nothing;
            if (held_) {
                const auto opened =
                    held_->open([this](const std::string& sentence) { sense.news.push_back(sentence); });
                if (opened) sense.search = WizardSearch::Ready;
                else sense.news.push_back(opened.error().sentence());
            }
        }
        sense.now_s = now_s();
        sense.speaking = speech.speaking();
        session.tick(sense);
        sense.news.clear();
        for (const auto& [key, value] : session.wizard().take_setting_changes()) {
            const auto set = store.set(key, value, SettingSource::Live);
            EXPECT_TRUE(set) << key << " = " << value << ": " << (set ? "" : set.error().sentence());
        }
        for (CueRequest& cue : session.take_cues()) requests_.push_back(std::move(cue));
    }
    if (now_s() >= next_cue_s_) {
        next_cue_s_ = now_s() + kCue_s;
        planner_.tick({.now_s = now_s(), .contacts = contacts_, .requests = requests_, .listener = {}}, audio, speech);
        requests_.clear();
        contacts_.clear();
    }
    if (now_s() < begun_s + 1e-3) clock_.advance_s(begun_s + 1e-3 - now_s());
}

std::vector<std::string> WizardRig::said() const {
    std::vector<std::string> lines;
    for (const HeardSpeech& line : speech.lines()) lines.push_back(line.utterance.text);
    return lines;
}

bool WizardRig::has_said(std::string_view words) const {
    const auto lines = said();
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

DeviceProfile WizardRig::profile() const {
    if (!held_) return {};
    const auto found = store.values().profiles.find(profile_key(held_->facts().spec.name, held_->facts().serial));
    return found == store.values().profiles.end() ? DeviceProfile{} : found->second;
}

int WizardRig::clicks() const {
    return static_cast<int>(std::count_if(audio.sounds().begin(), audio.sounds().end(),
                                          [](const HeardSound& s) { return s.cue.kind == SoundKind::TurnTick; }));
}

void BriskPerson::advance() {
    if (held_) held_->aim(at_m_);
    rig_.advance();
}

void BriskPerson::wait(double for_s) {
    for (const double end_s = rig_.now_s() + for_s; rig_.now_s() < end_s;) advance();
}

void BriskPerson::go(const Vec3& to_share) {
    constexpr double kSpeed_m_per_s = 0.25;
    const Vec3 to_m = to_share * held_->facts().spec.workspace_radius_m;
    double before_s = rig_.now_s();
    while (glm::length(to_m - at_m_) > 1e-6) {
        const double most_m = kSpeed_m_per_s * (rig_.now_s() - before_s), left_m = glm::length(to_m - at_m_);
        before_s = rig_.now_s();
        at_m_ = left_m <= most_m ? to_m : at_m_ + (to_m - at_m_) * (most_m / left_m);
        advance();
    }
}

void BriskPerson::answer_one() {
    if (rig_.question_begins("Headphones?")) return rig_.key("Left");
    if (rig_.question_begins("Is the bell on your right now")) return rig_.key("Right");
    if (rig_.question_begins("Rest your arm")) return go({0.0, -0.9, 0.0});
    if (rig_.question_begins("Push the grip in")) return go({0.0, 0.6, 0.0});
    if (rig_.question_begins("Which hand")) return go({-0.6, 0.0, 0.0});
    if (rig_.question_begins("I will press")) {
        while (rig_.force_n() < felt_n && rig_.question_begins("I will press")) advance();
        wait(0.2);
        held_->button(true);
        wait(0.1);
        return held_->button(false);
    }
    if (rig_.question_begins("Now you will feel a wall")) {
        go({-0.2, -0.3, 0.0});
        go({-0.2, 0.6, 0.0});
        wait(1.0);
        rig_.key("Up");
        wait(2.0);
        return rig_.key("Enter");
    }
    if (rig_.question_begins("Move the grip as far")) {
        for (const Vec3& side : {Vec3(0.8, 0.0, 0.0), Vec3(-0.6, 0.0, 0.0), Vec3(0.0, 0.6, 0.0), Vec3(0.0, -0.7, 0.0),
                                 Vec3(0.0, 0.0, 0.6), Vec3(0.0, 0.0, -0.4)})
            go(side), wait(0.3);
        return rig_.key("Enter");
    }
    if (rig_.question_begins("Your step is"))
        for (const char* key : {"6", "5"}) rig_.key(key);
    rig_.key("Enter");
}

bool BriskPerson::answer_all(double most_s) {
    const double end_s = rig_.now_s() + most_s;
    double silent_since_s = rig_.now_s();
    while (rig_.now_s() < end_s) {
        if (rig_.wizard().finished()) {
            wait(0.1);
            return rig_.run_until([this] { return !rig_.speech.speaking(); });
        }
        advance();
        if (rig_.speech.speaking() || !rig_.wizard().waits_for_person() || rig_.wizard().question().empty())
            silent_since_s = rig_.now_s();
        else if (rig_.now_s() - silent_since_s >= 0.3) {
            answer_one();
            silent_since_s = rig_.now_s();
        }
    }
    return false;
}

}  // namespace handrail::test
