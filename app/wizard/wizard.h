// The voice-led set-up of headphones, device, workspace and force, as a state machine: it is told what time it is, what
// the hand does and what the person answers, and says what is to be heard, felt and stored. No thread, clock, device or
// sound of its own, so that the same machine runs in the program and in tests. App thread, about 60 times a second.
// Every question waits as long as it takes. Enter accepts what stands, Space says the question again word for word,
// Backspace (and Up where it changes no value) goes back one, Escape explains, takes the force away and at the second
// press leaves; what was found until then is kept. Force leaves through the servo's ForceLimiter as ever; here only its
// ceiling rises, in steps of a few hundredths of a newton.
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

namespace handrail {

// Forces brings the force back after a fault, as the fault's own sentence says.
enum class WizardKey : std::uint8_t { Enter, Repeat, Back, Leave, Left, Right, Up, Down, Stop, Forces };
// A key, or figures as they are typed.
using WizardEvent = std::variant<WizardKey, std::string>;

enum class WizardSearch : std::uint8_t { NotBegun, Looking, Ready, Nothing };

// What the wizard may know, given on every tick.
struct WizardSense {
    double now_s = 0.0;     // above zero, never goes back
    bool audible = true;    // there is a sound device
    bool speaking = false;  // something is being said
    Listener listener;
    WizardSearch search = WizardSearch::NotBegun;
    std::vector<std::string> news;  // of the search, since the last tick
    HandFacts hand;                 // once the search is Ready
    ToolState tool;                 // the newest
};

class Wizard {
public:
    // What presses while the least noticed force is sought; below every ceiling.
    static constexpr double kGentlestMost_n = 1.0;
    static constexpr double kGentlestRise_n_per_s = 0.2;
    static constexpr double kCeilingRise_n_per_s = 1.0;  // of the wall's force when another ceiling is chosen

    // parts: in their order, no part twice; with a device's part the device is sought, and homed where it must be.
    Wizard(const Settings& settings, std::span<const WizardPart> parts);

    void answer(const WizardEvent& event, double now_s);
    void tick(const WizardSense& sense);

    // What others take after each tick.
    bool wants_search() const { return wants_search_; }  // the host is to look for a device now
    std::vector<CueRequest> take_cues() { return std::exchange(cues_, {}); }
    std::vector<std::pair<std::string, std::string>> take_setting_changes() { return std::exchange(changes_, {}); }
    const ServoTuning& tuning() const { return felt_.tuning; }
    std::shared_ptr<const HapticScene> haptic_scene() const { return felt_.scene; }  // null: nothing to be felt
    WorkspacePose pose() const;
    bool waits_for_person() const { return asked_.step != Step::Search && !finished_; }
    bool finished() const { return finished_; }
    std::string_view question() const { return asked_.text; }  // as Space says it

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
    // So that coming from a world and going back to one is a jump for the servo.
    static constexpr std::uint32_t kFirstJump = 0x40000000;
    static constexpr double kMovedShare = 0.4;  // of the device's radius, that counts as pulled, pushed or moved aside
    // What one question does. Null: nothing beyond what all do.
    struct Row {
        WizardPart part;
        void (Wizard::*begin)();  // when it is come to, before it is asked
        std::string (Wizard::*question)() const;
        void (Wizard::*accept)();               // Enter; null: goes on
        bool (Wizard::*adjust)(WizardKey key);  // an arrow; false: it means nothing here, so up goes back
        void (Wizard::*frame)();                // on every tick, where no hand is needed
        bool (Wizard::*watch)(
            double dt_s);  // on every tick in which the hand is there; true: its button means nothing now
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
    void ask();
    void repeat_question() { say(asked_.text); }
    void say(std::string text);
    void play(SoundKind kind, const Vec3& position_m);
    void click();
    void change(std::string_view key, std::string value) { changes_.emplace_back(key, std::move(value)); }
    void change_profile(std::string_view field, std::string value);

    void accept();
    void adjust(WizardKey key);
    void pause(std::string words);
    void resume();
    void watch_hand(double dt_s);
    void begin_force(std::shared_ptr<const HapticScene> scene);

    // Each in the file of its part; the table says which question they belong to.
    void begin_bell();
    std::string ask_bell_left() const;
    std::string ask_bell_right() const;
    bool adjust_bell_left(WizardKey key);
    bool adjust_bell_right(WizardKey key);
    void hear_bell();

    void begin_search();
    std::string ask_search() const;
    void watch_search();

    std::string ask_pull() const;
    std::string ask_push() const;
    void accept_homing();
    bool watch_homing(double dt_s);

    std::string ask_hand() const;
    void accept_hand();
    bool adjust_hand(WizardKey key);
    bool watch_aside(double dt_s);
    void keep_hand(HoldingHand hand);

    void begin_press();
    std::string ask_press() const;
    void accept_press();
    bool watch_press(double dt_s);
    void keep_gentlest(double felt_n);

    void begin_wall();
    std::string ask_wall() const;
    std::string ceiling_words() const;
    bool adjust_wall(WizardKey key);
    bool watch_wall(double dt_s);
    void keep_ceiling();

    void begin_sweep();
    std::string ask_sweep() const;
    bool watch_sweep(double dt_s);
    void keep_reach();
    void begin_scale();
    std::string ask_scale() const;
    std::string span_words() const;
    bool adjust_scale(WizardKey key);
    void keep_scale();
    std::string ask_beyond() const;
    bool adjust_beyond(WizardKey key);
    void keep_beyond();

    std::string ask_step_length() const;
    bool adjust_step_length(WizardKey key);
    void keep_step_length();

    bool homed() const;
    double radius_m() const;
    double strongest_n() const;
    double weakest_ceiling_n() const;
    double first_ceiling_n() const;
    DeviceProfile own_profile() const;

    Settings settings_;
    std::vector<Step> plan_;
    bool home_wanted_ = false;  // else only where the device does not know its place
    std::size_t index_ = 0;
    WizardSense sense_;
    double now_s_ = 0.0;
    double reply_s_ = 0.0;  // what is said with the same reply time is said one after the other; a new one interrupts
    bool begun_ = false, finished_ = false, paused_ = false, wants_search_ = false, lost_device_ = false;

    struct Homing {
        std::uint8_t legs_seen = 0, legs_at_start = 0;
        bool was_homed = true, newly_homed = false;
    };
    struct Reach {
        Vec3 least_m{0.0}, most_m{0.0};  // of this question, device frame
        Vec3 measured_m{0.0};            // size of the reach; zero: not measured
        std::uint8_t sides_seen = 0;     // bit 2i: low side of axis i; 2i + 1: its high side
        double scale = 60.0;
    };

    // The question that stands, and what has been answered to it so far.
    struct Asked {
        Step step = Step::Search;
        std::string text;  // as Space says it
        double begun_s = 0.0;
        Vec3 hand_m{0.0};  // where the hand was when it was begun, device frame
        std::string typed;
    };
    // What the person is found to feel and to walk, until something else is.
    struct Found {
        double gentlest_n = 0.3;
        double ceiling_n = kLightCeiling_n;
        double step_length_m = 0.7;
    };
    // What the servo is given.
    struct Felt {
        ServoTuning tuning;
        std::shared_ptr<const HapticScene> scene;
        std::uint32_t jump = 0;
    };

    double bell_due_s_ = 0.0;
    double search_begun_s_ = -1.0;  // when the device was ready
    bool button_was_down_ = false;
    Homing homing_;
    Reach reach_;
    double held_top_s_ = 0.0;  // how long the gentlest part has pressed with its most
    Asked asked_;
    Found found_;
    Felt felt_;
    std::vector<CueRequest> cues_;
    std::vector<std::pair<std::string, std::string>> changes_;
};

}  // namespace handrail
