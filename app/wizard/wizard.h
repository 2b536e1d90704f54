// Leads a person by voice through the set-up of headphones, device, workspace and force, as a state machine. It
// receives the time, the state of the hand and the person's answers. It returns what the person is to hear and feel,
// and which settings to store. It has no thread, clock, device or sound, so the same machine runs in the program and in
// tests. App thread, about 60 times a second.
//
// Every question waits until the person answers. Enter accepts the current value. Space repeats the question word for
// word. Backspace goes back by one question, and so does Up if it changes no value. Escape explains how to leave and
// removes the force. Pressed again, Escape leaves the set-up and keeps what was found until then. As always, each force
// passes through the servo's ForceLimiter. In the set-up only the ceiling of the limiter rises, in steps of a few
// hundredths of a newton.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/core/session/session.h"
#include "app/wizard/wizard_part.h"
#include "audio-cues/plan/cue_planner.h"
#include "haptic/servo/servo_tick.h"
#include "settings/settings.h"

namespace handrail::wizard {

// `Forces` switches the force on again after a fault, as the announcement of a fault suggests.
enum class WizardKey : std::uint8_t { Enter, Repeat, Back, Leave, Left, Right, Up, Down, Stop, Forces };
// A key, or figures that the person has typed.
using WizardEvent = std::variant<WizardKey, std::string>;

enum class WizardSearch : std::uint8_t { NotBegun, Looking, Ready, Nothing };

// The inputs of the wizard in each tick.
struct WizardSense {
    double now_s = 0.0;     // time; above zero, never decreases
    bool audible = true;    // true if there is a sound device
    bool speaking = false;  // true while a sentence is being spoken
    cues::Listener listener;
    WizardSearch search = WizardSearch::NotBegun;
    std::vector<std::string> news;  // sentences about the search since the last tick
    core::HandFacts hand;           // facts about the found hand; valid once `search` is Ready
    servo::ToolState tool;          // newest state of the hand
};

class Wizard {
public:
    // Greatest force during the search for the smallest force that the person notices. It is below every force ceiling.
    static constexpr double kGentlestMost_n = 1.0;
    static constexpr double kGentlestRise_n_per_s = 0.2;
    // Rate at which the wall's force changes when the person chooses another ceiling.
    static constexpr double kCeilingRise_n_per_s = 1.0;

    // `parts` must be in the order of WizardPart, and none may occur twice. If one of them uses a device, the wizard
    // adds the search for the device, and homing if the device needs it.
    Wizard(const settings::Settings& settings, std::span<const WizardPart> parts);

    void answer(const WizardEvent& event, double now_s);
    void tick(const WizardSense& sense);

    // Results that the program reads after each tick.
    bool wants_search() const { return wants_search_; }  // true: the program must search for a device now
    std::vector<cues::CueRequest> take_cues() { return std::exchange(cues_, {}); }
    std::vector<std::pair<std::string, std::string>> take_setting_changes() { return std::exchange(changes_, {}); }
    const servo::ServoTuning& tuning() const { return felt_.tuning; }
    // The scene that the hand touches; null: the hand touches nothing.
    std::shared_ptr<const render::HapticScene> haptic_scene() const { return felt_.scene; }
    servo::WorkspacePose pose() const;
    bool waits_for_person() const { return question_.step != Step::Search && !finished_; }
    bool finished() const { return finished_; }
    std::string_view question() const { return question_.text; }  // the question as Space repeats it

private:
    enum class Step : std::uint8_t {
        BellLeft,
        BellRight,
        Search,
        Pull,
        Push,
        WhichHand,
        Press,
        Wall,
        Sweep,
        Scale,
        Beyond,
        StepLength,
        Done
    };
    // First value of the jump count. It is far from the jump counts of a world, so that the servo notices a jump when
    // the set-up begins and when it ends.
    static constexpr std::uint32_t kFirstJump = 0x40000000;
    // If the hand has moved by this fraction of the device's radius, it has been pulled, pushed or moved aside.
    static constexpr double kMovedShare = 0.4;
    // The functions of one question. If a function is null, the question has only the common behaviour.
    struct Row {
        WizardPart part;
        void (Wizard::*begin)();  // called when the question begins, before it is spoken
        std::string (Wizard::*question)() const;
        void (Wizard::*accept)();  // called for Enter; null: Enter continues
        // Called for an arrow key. Returns false if the arrow changes nothing, so that Up goes back.
        bool (Wizard::*adjust)(WizardKey key);
        void (Wizard::*frame)();  // called in each tick, for questions that need no hand
        // Called in each tick in which a hand is present. Returns true if the hand's button must be ignored now.
        bool (Wizard::*watch)(double dt_s);
    };
    static const Row& row(Step step);
    static const WizardPartInfo& part_of(Step step);
    static std::vector<Step> plan_of(std::span<const WizardPart> parts);
    static bool is_across(WizardKey key) { return key == WizardKey::Left || key == WizardKey::Right; }
    static bool is_upward(WizardKey key) { return key == WizardKey::Up || key == WizardKey::Right; }
    static std::string newtons(double force_n);

    bool is_skipped(Step step) const;
    void enter(std::size_t index);
    void go_on() { enter(index_ + 1); }
    void go_back();
    void finish();
    void pose_question();
    void repeat_question() { say(question_.text); }
    void say(std::string text);
    void play(cues::SoundKind kind, const Vec3& position_m);
    void click();
    void change(std::string_view key, std::string value) { changes_.emplace_back(key, std::move(value)); }
    void change_profile(std::string_view field, std::string value);

    void accept();
    void adjust(WizardKey key);
    void pause(std::string words);
    void resume();
    void watch_hand(double dt_s);
    void begin_force(std::shared_ptr<const render::HapticScene> scene);

    // Functions of the questions. Each is defined in the file of its part. The table in wizard_table.cpp assigns them
    // to questions.
    void begin_bell();
    std::string bell_left_question() const;
    std::string bell_right_question() const;
    bool adjust_bell_left(WizardKey key);
    bool adjust_bell_right(WizardKey key);
    void hear_bell();

    void begin_search();
    std::string search_question() const;
    void watch_search();

    std::string pull_question() const;
    std::string push_question() const;
    void accept_homing();
    bool watch_homing(double dt_s);

    std::string hand_question() const;
    void accept_hand();
    bool adjust_hand(WizardKey key);
    bool watch_aside(double dt_s);
    void keep_hand(settings::HoldingHand hand);

    void begin_press();
    std::string press_question() const;
    void accept_press();
    bool watch_press(double dt_s);
    void keep_gentlest(double felt_n);

    void begin_wall();
    std::string wall_question() const;
    std::string ceiling_words() const;
    bool adjust_wall(WizardKey key);
    bool watch_wall(double dt_s);
    void keep_ceiling();

    void begin_sweep();
    std::string sweep_question() const;
    bool watch_sweep(double dt_s);
    void keep_reach();
    void begin_scale();
    std::string scale_question() const;
    std::string span_words() const;
    bool adjust_scale(WizardKey key);
    void keep_scale();
    std::string beyond_question() const;
    bool adjust_beyond(WizardKey key);
    void keep_beyond();

    std::string step_length_question() const;
    bool adjust_step_length(WizardKey key);
    void keep_step_length();

    bool homed() const;
    double radius_m() const;
    double strongest_n() const;
    double weakest_ceiling_n() const;
    double first_ceiling_n() const;
    settings::DeviceProfile own_profile() const;

    settings::Settings settings_;
    std::vector<Step> plan_;
    // True: the set-up includes homing in any case. False: only if the device does not know its position.
    bool home_wanted_ = false;
    std::size_t index_ = 0;
    WizardSense sense_;
    double now_s_ = 0.0;
    // Time of the current reply. Sentences with the same time wait for each other; a sentence with a new time
    // interrupts them.
    double reply_s_ = 0.0;
    bool begun_ = false, finished_ = false, paused_ = false, wants_search_ = false, lost_device_ = false;

    struct Homing {
        std::uint8_t legs_seen = 0, legs_at_start = 0;
        bool was_homed = true, newly_homed = false;
    };
    struct Reach {
        // Lowest and highest coordinates of the hand during this question, device frame.
        Vec3 least_m{0.0}, most_m{0.0};
        Vec3 measured_m{0.0};  // size of the workspace; zero: not measured yet
        // Which sides the hand has reached, as bits. Bit 2i: the low side of axis i; bit 2i + 1: its high side.
        std::uint8_t sides_seen = 0;
        double scale = 60.0;
    };

    // The current question and the answers to it until now.
    struct Question {
        Step step = Step::Search;
        std::string text;  // the question as Space repeats it
        double begun_s = 0.0;
        Vec3 hand_m{0.0};  // position of the hand when the question began, device frame
        std::string typed;
    };
    // What the wizard has found out about the person's touch and step. The initial values apply until then.
    struct Found {
        double gentlest_n = 0.3;
        double ceiling_n = settings::kLightCeiling_n;
        double step_length_m = 0.7;
    };
    // What the program must pass to the servo.
    struct Felt {
        servo::ServoTuning tuning;
        std::shared_ptr<const render::HapticScene> scene;
        std::uint32_t jump = 0;
    };

    double bell_due_s_ = 0.0;
    double search_begun_s_ = -1.0;  // time at which the search had found a device; negative: not yet
    bool button_was_down_ = false;
    Homing homing_;
    Reach reach_;
    double held_top_s_ = 0.0;  // how long the part `gentlest` has pressed with its greatest force
    Question question_;
    Found found_;
    Felt felt_;
    std::vector<cues::CueRequest> cues_;
    std::vector<std::pair<std::string, std::string>> changes_;
};

}  // namespace handrail::wizard
