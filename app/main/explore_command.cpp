#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "app/companions/companion_session.h"
#include "app/core/kept/spoken_language.h"
#include "app/core/session/session.h"
#include "app/core/session/session_driver.h"
#include "app/learners/learner.h"
#include "app/main/commands.h"
#include "app/main/device_facts.h"
#include "app/main/ears.h"
#include "app/main/end_signals.h"
#include "app/main/guided_set_up.h"
#include "app/main/hand_in_use.h"
#include "app/main/kept_settings.h"
#include "app/main/learners_here.h"
#include "app/main/left_hand.h"
#include "app/main/lesson_here.h"
#include "app/main/session_recording.h"
#include "app/main/session_voice.h"
#include "app/main/typed_keys.h"
#include "app/main/typed_lines.h"
#include "app/main/window_input.h"
#include "app/main/world_files.h"
#include "app/main/world_loading.h"
#include "app/main/world_visits.h"
#include "app/window/window.h"
#include "haptic/servo/servo_loop.h"
#include "worlds/base/clock.h"
#include "worlds/base/language.h"
#include "worlds/base/typist.h"

namespace handrail::program {
namespace {

// Longest time that the program waits at the end for the current sentence; "Goodbye." needs this long. Together with
// kAfterLastWord_s, the program waits at most a second.
constexpr double kLastWords_s = 0.6;
// The process ends this long after the last word, even if other threads are still busy.
constexpr double kAfterLastWord_s = 0.3;

bool a_display_is_there() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"})
        if (const char* display = std::getenv(name); display && *display) return true;
    return false;
}

std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) {
        if (sentence.empty()) continue;
        if (!text.empty()) text += ' ';
        text += sentence;
    }
    return text;
}

// Runs one session with a person. The object owns every part and passes values between the parts about sixty times a
// second.
class Exploration {
public:
    Exploration(const ExploreArguments& arguments, settings::SettingsStore& settings)
        : arguments_(arguments),
          settings_(settings),
          recording_(arguments, settings.values(), clock_, news_),
          ears_(settings.values(), !arguments.no_window, clock_, left_.contacts(), recording_, news_),
          app_(settings.values(), core::HandFacts{},
               {.executor = on_threads(),
                .records_in = arguments.common.data_folder(),
                .day = learners::today(),
                .languages_in = core::user_languages_folder(),
                .bodies = {.clock = &clock_, .recording = recording_.bodies(), .played = {}},
                .arrivals = recording_.arrivals()}) {
        recording_.listen_to(app_);
    }

    // Runs the session. Problems that prevent the start are also written to `err`.
    ExploreEnd run(std::ostream& err, const LongWork& progress) {
        const double requested_s = begin();
        if (arguments_.calibrate) {
            set_up_.begin(*arguments_.calibrate);
            calibrate();
            finish(err, 0, progress);
            return {};
        }
        hand_.begin(requested_s);
        if (settings_.values().pads.use) companions_.emplace(clock_);
        left_.look_for(arguments_.left_device.value_or(settings_.values().haptic.left_device));
        const std::optional<int> not_entered = load_world(err);
        const int status = not_entered ? *not_entered : explore(err);
        finish(err, status, progress);
        ExploreEnd end{status, learners_.next(), worlds_.here(), {}};
        if (lines_) end.lines = lines_->take_rest();
        return end;
    }

private:
    // ---- the start ----

    // Starts the session, up to and including the welcome. Returns the time of the reply to which the welcome belongs.
    double begin() {
        news_.insert(news_.begin(), arguments_.news.begin(), arguments_.news.end());
        if (std::vector<std::string> faults = sentences_of(arguments_.settings_problems); !faults.empty()) {
            news_.push_back(settings_faults_words(faults));
            app_.apply(core::SettingsFaultsKnown{std::move(faults)}, clock_.now_s());
        }
        open_window();
        // If the terminal supports it, each key acts as soon as it is pressed. The first sentence says so.
        if (!window_) keys_ = TypedKeys::open(app_, worlds_, switches_, clock_);
        if (keys_) {
            speak_to(ActsBy::TerminalKeys);
            news_.insert(news_.begin(), phrase("terminal.keys_act"));
        }
        recording_.note("acts_by", static_cast<std::uint64_t>(spoken_to()));
        if (hand_.wanted() == "none") news_.push_back(phrase("program.no_device_as_asked"));
        ears_.sound().start();
        worlds_.begin_notes(clock_.now_s());
        const bool first = !settings_.values().welcome.done && !arguments_.world && !arguments_.calibrate;
        const std::string voice = first ? ears_.voice_that_speaks() : std::string{};
        const double requested_s = clock_.now_s();
        if (first)
            // The set-up is part of the first minutes only if there is a sound device.
            app_.apply(core::FirstMinutesBegun{voice, ears_.has_sound()}, requested_s);
        news_.push_back(worlds_.take_news());
        news_.push_back(worlds_.crash_words(!speaks_to_typist(), requested_s));
        say_(first ? joined(news_) : phrase("program.welcome", {{"news", joined(news_)}}), requested_s);
        return requested_s;
    }

    void open_window() {
        speak_to_typist(true);
        if (arguments_.no_window) return;
        auto opened = window::Window::open({.place = window::window_place(settings_.values().display.place),
                                            .full_screen = settings_.values().display.full_screen});
        if (!opened) {
            ears_.close_accessible();
            // If there is no display, do not announce that no window opened, because the person expects none.
            if (a_display_is_there()) news_.push_back(opened.error().message);
            return;
        }
        window_.emplace(std::move(*opened), app_, worlds_, ears_, switches_, clock_);
        speak_to_typist(false);
    }

    void watch_lines() {
        if (!window_ && !keys_) lines_.emplace(app_, worlds_, switches_, arguments_.lines);
    }

    // ---- the three loops: while the first world is read, in a world, and in a set-up without a world ----

    // Reads the first world while the person waits, and enters it. If it is not entered, returns the exit status: the
    // person has left, the world cannot be read, or it has no place with the name that was given.
    std::optional<int> load_world(std::ostream& err) {
        WorldLoading loading(worlds_.first(), arguments_.common,
                             {arguments_.at, settings_.values().walk.body_radius_m});
        watch_lines();
        while (!loading.ready()) {
            clock_.sleep_until_s(clock_.now_s() + core::kFrame_s);
            if (window_) window_->take(set_up_.session());
            if (keys_) keys_->take(clock_.now_s(), set_up_.session());
            if (lines_) lines_->take(clock_.now_s(), set_up_.session(), true);
            if (ended()) return 0;
            if (!hand_.look(err)) return 1;
            kept_.keep_saved(clock_.now_s());
            worlds_.keep_notes(clock_.now_s());
            loading.report(clock_.now_s(), [this](const std::string& words) { say_(words); });
            hand_over();  // passes the replies to keys and lines to the ears
            draw_words();
        }
        auto world = loading.take();
        const auto refused = [&](const Error& why, int status) {
            say_(why.sentence());
            fmt::print(err, "{}\n", why.sentence());
            return status;
        };
        if (!world) return refused(world.error(), 1);
        if (world->begins_at && !*world->begins_at) return refused(world->begins_at->error(), 2);
        if (ended()) return 0;
        // The announcement of the world is part of the greeting's reply, so it waits for the greeting instead of
        // interrupting it.
        worlds_.enter(std::move(*world), hand_.requested_s());
        return std::nullopt;
    }

    int explore(std::ostream& err) {
        double next_s = clock_.now_s();
        while (!ended() && !app_.requests().leave && !learners_.next()) {
            const double now_s = servo::in_whole_microseconds(clock_.now_s());
            app_.apply(core::Stopped{switches_.stops}, now_s);
            take_input(now_s);
            if (!hand_.look(err)) return 1;
            if (companions_)
                for (std::string& sentence : companions_->guide(app_, now_s, set_up_.under_way()))
                    say_(std::move(sentence));
            hand_.read();
            hand_.report_scheduling();
            notice_left_hand(now_s);
            hand_.watch_sleep(left_.real() ? &left_.tool() : nullptr);
            set_up_.begin_if_requested();
            recording_.set_up(set_up_.under_way());
            if (auto ended = recording_.take_problem()) say_(std::move(*ended));
            // Before another world brings settings, which would override the person's changes.
            driver_.hand_over_settings();
            worlds_.change(now_s);
            learners_.turn(now_s);
            if (set_up_.under_way()) {
                guide(now_s);
            } else {
                lesson_.turn(ears_.sound().speaking(), now_s);
                driver_.tick(now_s, hand_.tool(), left_.tool());
                worlds_.note_place(now_s);
            }
            kept_.keep_saved(now_s);
            worlds_.keep_notes(now_s);
            device_facts_.answer(app_, now_s);
            ears_.note_spoken();
            hold_more_sound();
            draw_view();
            next_s = end_frame(next_s, now_s);
        }
        return 0;
    }

    void calibrate() {
        watch_lines();
        double next_s = clock_.now_s();
        while (!ended() && set_up_.under_way()) {
            const double now_s = clock_.now_s();
            take_input(now_s);
            set_up_.look_for_hand();
            hand_.read();
            hand_.watch_sleep(left_.real() ? &left_.tool() : nullptr);
            guide(now_s);
            kept_.keep_saved(now_s);
            draw_words();
            next_s = end_frame(next_s, now_s);
        }
    }

    // ---- parts of the three loops ----

    bool ended() const {
        return signals_.requested() || (window_ && window_->closed()) || (keys_ && keys_->closed()) ||
               (lines_ && lines_->closed());
    }

    void take_input(double now_s) {
        if (window_) window_->take(set_up_.session());
        else if (keys_) keys_->take(now_s, set_up_.session());
        else lines_->take(now_s, set_up_.session(), hand_.looking());
    }

    void guide(double now_s) {
        set_up_.sense(now_s);
        hand_over();
        ears_.note_spoken();
        set_up_.end_if_finished(now_s);
    }

    // Draws the last spoken words in large letters. Without a world, the window has nothing else to show.
    void draw_words() {
        ears_.note_spoken();
        if (!window_) return;
        core::ViewState view;
        view.display = app_.settings().display;
        view.texts.messages = ears_.messages();
        window_->draw(view);
    }

    void draw_view() {
        if (!window_) return;
        core::ViewState view = app_.view(hand_.tool());
        view.texts.messages = ears_.messages();
        window_->draw(view);
    }

    // Adds a second hand to the session once the search has found it.
    void notice_left_hand(double now_s) {
        std::vector<std::string> news;
        if (left_.take_change(news)) {
            driver_.drive(1, left_.servo());
            app_.apply(core::LeftHandChanged{left_.facts()}, now_s);
        }
        ears_.follow_hands(app_.two_hands(), hand_.stands_in());
        for (std::string& sentence : news) say_(std::move(sentence));
    }

    void hand_over() {
        driver_.hand_over();
        if (set_up_.under_way()) set_up_.hand_over();
    }

    // Returns the functions that the session driver calls before and after it hands over results.
    core::SessionDriver::Steps steps() {
        return {.ticked =
                    [this](double now_s, const servo::ToolState& tool, const servo::ToolState& left_tool) {
                        lesson_.see(recording_.ticked(app_, now_s, tool, left_tool));
                    },
                .take_settings =
                    [this](const std::vector<std::pair<std::string, std::string>>& changes) {
                        const bool changed = kept_.take(changes);
                        if (!worlds_.take_new_settings() && !changed) return false;
                        recording_.note("ears_settings");
                        return true;
                    },
                .hands_over =
                    [this] {
                        if (!set_up_.under_way()) recording_.handed_over();
                        ears_.show(app_);
                    },
                .look_at_cues =
                    [this](const std::vector<cues::CueRequest>& cues) {
                        if (companions_)
                            companions_->follow(app_, cues, hand_.driven() ? &hand_.tool() : nullptr, clock_.now_s());
                    }};
    }

    // If the sound device drops out although two periods are buffered, sets sound.periods to three, which becomes
    // effective at the next start.
    void hold_more_sound() {
        if (settings_.values().sound.periods >= 3 || !ears_.sound().sound_drops_out()) return;
        app_.apply(core::SettingSet{"sound.periods", "3"}, clock_.now_s());
        say_(phrase("program.drops_out"));
    }

    // Waits until the next frame is due, and returns that time.
    double end_frame(double due_s, double began_s) {
        const double next_s = std::max(due_s + core::kFrame_s, began_s);
        clock_.sleep_until_s(next_s);
        return next_s;
    }

    // Ends the session in this order: removes the forces, saves the settings, speaks the last words.
    void finish(std::ostream& err, int status, const LongWork& progress) {
        companions_.reset();
        hand_.stop_looking();
        left_.stop();
        hand_.let_go();
        lesson_.end(clock_.now_s());
        if (window_)
            if (const std::string place = window_->place(); !place.empty())
                app_.apply(core::SettingSet{"display.place", place}, clock_.now_s());
        if (!arguments_.calibrate) app_.keep_learnt(servo::in_whole_microseconds(clock_.now_s()));
        hand_over();
        kept_.save_at_the_end(err);
        ears_.sound().stop(signals_.requested() ? 0.0 : kLastWords_s);
        progress.at(phrase("progress.recording_end"));
        recording_.end();
        progress.done();
        // Everything is saved and spoken. If another learner follows, this process continues. Otherwise the process
        // ends in time, and does not wait for work on other threads.
        if (!learners_.next()) signals_.in_time.end_within(kAfterLastWord_s, status);
        worlds_.end();
    }

    const ExploreArguments& arguments_;
    settings::SettingsStore& settings_;
    EndSignals signals_;
    SteadyClock clock_;
    servo::ServoSwitches switches_;
    std::vector<std::string> news_;  // sentences that are announced with the welcome
    SessionRecording recording_;
    LeftHand left_{clock_, switches_, recording_.hand(1)};
    Ears ears_;
    core::Session app_;
    core::SessionDriver driver_{app_, ears_.sound(), steps()};
    const SessionVoice say_{clock_, [this](std::string text, double requested_s) {
                                app_.apply(core::Announcement{std::move(text), cues::SpeechClass::Answer}, requested_s);
                                hand_over();
                            }};
    KeptSettings kept_{settings_, clock_, say_};
    HandInUse hand_{
        {arguments_, settings_, clock_, switches_, ears_.contacts(), app_, driver_, say_, recording_.hand(0)}};
    GuidedSetUp set_up_{
        {settings_, switches_, app_, driver_, hand_, ears_, kept_, say_, arguments_.calibrate.has_value()}};
    WorldVisits worlds_{arguments_, settings_, app_, say_};
    DeviceFacts device_facts_;
    LessonHere lesson_{arguments_, app_, worlds_, say_};
    LearnersHere learners_{arguments_, app_, recording_, say_};
    std::optional<WindowInput> window_;  // how the person types: window_, keys_ or lines_; at most one of them is used
    std::unique_ptr<TypedKeys> keys_;
    std::optional<TypedLines> lines_;
    std::optional<companions::CompanionSession> companions_;
};

}  // namespace

ExploreEnd run_explore(const ExploreArguments& arguments, settings::SettingsStore& settings, std::ostream& err,
                       const LongWork& progress) {
    return Exploration(arguments, settings).run(err, progress);
}

}  // namespace handrail::program
