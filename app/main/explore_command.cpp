#include <fmt/format.h>
#include <fmt/ostream.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <deque>
#include <future>

#include "app/core/app_core.h"
#include "app/main/commands.h"
#include "app/main/world_files.h"
#include "app/terminal/terminal.h"
#include "app/window/window.h"
#include "audio-cues/sinks/audio_thread.h"
#include "audio-cues/sinks/sound_outputs.h"
#include "haptic/device/simulated_device.h"
#include "haptic/drivers/found_device.h"
#include "haptic/drivers/guarded_device.h"
#include "haptic/servo/servo_loop.h"
#include "worlds/base/clock.h"
#include "worlds/base/text.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;
constexpr double kProgressEvery_s = 2.0;
constexpr double kSettles_s = 0.2;
constexpr double kLastWords_s = 3.0;  // how long the end waits for what is being said

// Set by SIGINT, SIGTERM and SIGHUP; the loop looks at it each frame. A plain flag is all that a signal handler may touch.
std::atomic<bool> end_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

// Catches the ending signals for as long as it lives.
class EndSignals {
public:
    EndSignals() {
        end_asked = false;
        struct sigaction action {};
        action.sa_handler = [](int) { end_asked.store(true, std::memory_order_relaxed); };
        for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &action, &before_[i]);
    }
    ~EndSignals() {
        for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
    }
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

private:
    static constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, 3> before_{};
};

// Which hand there is, and for a real one how the guard finds it.
struct Hand {
    HandFacts facts;
    std::vector<std::string> guard_arguments;  // empty: no real device
};

Hand simulated_hand(std::string_view name) { return {HandFacts{true, true, *find_device_spec(name)}, {}}; }

Hand real_hand(const FoundDevice& device) {
    Hand hand{HandFacts{true, false, *device.spec}, {device.name}};
    if (!device.serial.empty()) hand.guard_arguments.push_back(device.serial);
    return hand;
}

// By name or serial number, none, or auto: what is plugged in, else a simulated hand.
Result<Hand> choose_hand(const std::string& wanted, std::vector<std::string>& news) {
    if (wanted == "none") {
        news.push_back("No touch device, as you asked. Everything works with keyboard and sound.");
        return Hand{};
    }
    const DeviceSpec* spec = find_device_spec(wanted);
    if (spec && spec->name.starts_with("sim-")) return simulated_hand(spec->name);
    const std::vector<FoundDevice> found = find_devices();
    if (wanted == "auto") {
        for (const FoundDevice& device : found) {
            if (device.kind != DeviceKind::Kinesthetic) continue;
            news.push_back(fmt::format("I found a {}.", device.model));
            if (device.usable) return real_hand(device);
            news.push_back(device.problem);
        }
        if (news.empty()) news.push_back("No touch device was found. A simulated hand follows the mouse and the keys.");
        else news.push_back("A simulated hand follows the mouse and the keys instead.");
        return simulated_hand("sim-t");
    }
    for (const FoundDevice& device : found) {
        if (!is_meant(device, wanted)) continue;
        if (device.kind != DeviceKind::Kinesthetic) return fail(fmt::format("The {} cannot push a hand in space. Use sim-t, sim-f or none.", device.model));
        if (!device.usable) return fail(fmt::format("The {} cannot be used yet. {}", device.model, device.problem));
        return real_hand(device);
    }
    if (!spec) {
        std::vector<std::string> names = device_names();
        for (const FoundDevice& device : found) names.push_back(device.name);
        return fail(fmt::format("There is no device \"{}\". Did you mean \"{}\"?", wanted, nearest_name(wanted, names)));
    }
    const std::vector<std::string> drivable = openable_device_names();
    if (std::find(drivable.begin(), drivable.end(), spec->name) == drivable.end())
        return fail(fmt::format("The {} cannot be driven yet. Use sim-t, sim-f or none.", spec->spoken_name));
    if (is_found_only_by_opening(spec->name)) return Hand{HandFacts{true, false, *spec}, {std::string(spec->name)}};
    return fail(fmt::format("The {} is not plugged in. Use sim-t, sim-f or none.", spec->spoken_name));
}

// Reads the world on a thread of its own, while its progress is said every two seconds.
class WorldLoading {
public:
    WorldLoading(const std::filesystem::path& path, const CommonArguments& common)
        : result_(std::async(std::launch::async, [this, path, common] {
              ReadOptions options = common.read_options();
              options.progress = [this](double fraction) { percent_.store(static_cast<int>(fraction * 100.0), std::memory_order_relaxed); };
              return read_world(path, options);
          })) {}
    bool ready() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
    int percent() const { return percent_.load(std::memory_order_relaxed); }
    Result<Scene> take() { return result_.get(); }

private:
    std::atomic<int> percent_{0};
    std::future<Result<Scene>> result_;
};

// One session with a person: owns every part, carries values between them about sixty times a second.
class Exploration {
public:
    Exploration(const ExploreArguments& arguments, SettingsStore& settings) : arguments_(arguments), settings_(settings) {}

    // Exit status. Problems that keep it from starting go to `err` too.
    int run(std::ostream& err) {
        std::vector<std::string> news;
        auto hand = choose_hand(arguments_.device.value_or(settings_.values().haptic.device), news);
        if (!hand) {
            fmt::print(err, "{}\n", hand.error().sentence());
            return 1;
        }
        open_hand(*hand, news);
        open_ears(news);
        app_ = std::make_unique<AppCore>(settings_.values(), hand->facts);
        for (const Diagnostic& problem : arguments_.settings_problems) news.push_back(problem.sentence());
        open_window(news);
        say("Handrail. " + joined(news));
        ears_->start();
        if (servo_) servo_->start();

        const int status = load_world(err) ? explore() : 1;
        finish(err);
        return status;
    }

private:
    static std::string joined(const std::vector<std::string>& sentences) {
        std::string text;
        for (const std::string& sentence : sentences) {
            if (sentence.empty()) continue;
            if (!text.empty()) text += ' ';
            text += sentence;
        }
        return text;
    }

    // Becomes no hand, with a sentence, when it cannot be opened.
    void open_hand(Hand& hand, std::vector<std::string>& news) {
        if (!hand.facts.present) return;
        std::unique_ptr<HapticDevice> device;
        if (hand.facts.simulated) {
            simulated_ = std::make_shared<SimulatedHand>();
            device = std::make_unique<SimulatedDevice>(hand.facts.spec, simulated_);
        } else {
            auto guarded = std::make_unique<GuardedDevice>(hand.facts.spec, find_guard_program(), hand.guard_arguments);
            guarded_ = guarded.get();
            device = std::move(guarded);
        }
        servo_ = std::make_unique<ServoLoop>(std::move(device), clock_);
        const auto opened = servo_->open();
        if (guarded_)
            for (std::string& sentence : guarded_->take_news()) news.push_back(std::move(sentence));
        if (opened) return;
        news.push_back(opened.error().sentence());
        guarded_ = nullptr;
        servo_.reset();
        hand.facts = {};
    }

    void say(std::string text) {
        app_->say(std::move(text), SpeechClass::Answer, clock_.now_s());
        hand_over();
    }

    void open_ears(std::vector<std::string>& news) {
        SoundOutputs outputs = open_sound_outputs(settings_.values(), STDOUT_FILENO);
        audible_ = outputs.audible;
        news.push_back(std::move(outputs.description));
        ears_ = std::make_unique<AudioThread>(std::move(outputs.audio), std::move(outputs.speech), clock_, servo_ ? &servo_->events() : nullptr,
                                              settings_.values());
    }

    void open_window(std::vector<std::string>& news) {
        if (arguments_.no_window) return;
        if (auto opened = Window::open(); opened) window_ = std::move(*opened);
        else news.push_back(opened.error().message);
    }

    bool ended() const { return end_asked.load(std::memory_order_relaxed) || closed_; }

    // False when the world cannot be read or the person left meanwhile.
    bool load_world(std::ostream& err) {
        const std::filesystem::path path = arguments_.world.value_or(first_world());
        WorldLoading loading(path, arguments_.common);
        double told_s = clock_.now_s();
        while (!loading.ready()) {
            clock_.sleep_until_s(clock_.now_s() + kFrame_s);
            if (window_) look_at_window();
            if (clock_.now_s() - told_s >= kProgressEvery_s) {
                told_s = clock_.now_s();
                say(fmt::format("Loading, {} percent.", loading.percent()));
            }
        }
        auto scene = loading.take();
        if (!scene) {
            say(scene.error().sentence());
            fmt::print(err, "{}\n", scene.error().sentence());
            return false;
        }
        if (ended()) return false;
        const ReadReport& report = scene->report;
        if (report.warnings_in_all > 0)
            say(fmt::format("{} {} in this file; the first: {}", report.warnings_in_all, report.warnings_in_all == 1 ? "problem" : "problems",
                            report.warnings.front().sentence()));
        app_->enter_world(std::make_shared<const Scene>(std::move(*scene)), clock_.now_s());
        return true;
    }

    int explore() {
        double next_s = clock_.now_s();
        while (!ended() && !app_->wants_to_leave()) {
            const double now_s = clock_.now_s();
            if (window_) look_at_window();
            else take_lines(now_s);
            if (servo_) tool_ = servo_->tool();
            if (guarded_)
                for (std::string& sentence : guarded_->take_news()) say(std::move(sentence));
            app_->tick(now_s, tool_);
            hand_over();
            for (SpokenLine& line : ears_->take_spoken()) last_spoken_ = std::move(line.text);
            if (window_) window_->draw(app_->view(tool_, last_spoken_));
            next_s = std::max(next_s + kFrame_s, now_s);
            clock_.sleep_until_s(next_s);
        }
        return 0;
    }

    // To the servo and the ears, what this frame changed.
    void hand_over() {
        bool changed = false;
        for (const auto& [key, value] : app_->take_setting_changes()) changed |= settings_.set(key, value, SettingSource::Live).has_value();
        if (changed) ears_->set_settings(app_->settings());
        if (app_->scene() != handed_scene_) {
            handed_scene_ = app_->scene();
            if (std::exchange(handed_world_, app_->worlds_entered()) != app_->worlds_entered()) ears_->enter_world(handed_scene_);
            else ears_->follow_edit(handed_scene_);
        }
        for (CueRequest& cue : app_->take_cues()) ears_->post(std::move(cue));
        if (app_->scene()) ears_->set_listener(app_->listener());
        if (!servo_ || !app_->scene()) return;
        if (app_->haptic_scene() != handed_haptic_scene_) {
            handed_haptic_scene_ = app_->haptic_scene();
            servo_->set_scene(handed_haptic_scene_);
        }
        servo_->set_tuning(app_->tuning());
        servo_->set_pose(app_->pose());
        if (std::exchange(handed_bodies_, app_->bodies().number) != app_->bodies().number) servo_->set_bodies(app_->bodies());
        if (!simulated_) return;
        HandCommand command;
        command.target_m = app_->hand_target_m();
        simulated_->command.publish(command);
    }

    void look_at_window() {
        const double now_s = clock_.now_s();
        for (const WindowEvent& event : window_->poll()) {
            if (const auto* key = std::get_if<KeyEvent>(&event)) {
                const auto command = app_->keys().find(key->key);
                if (!command || !app_->scene()) continue;
                if (key->action == KeyAction::Press) app_->press(*command, now_s);
                else if (key->action == KeyAction::Release) app_->release(*command);
            } else if (const auto* motion = std::get_if<HandMotion>(&event)) {
                app_->move_hand(motion->by_m);
            } else if (const auto* focus = std::get_if<FocusChange>(&event)) {
                app_->set_focus(focus->focused);
            } else if (std::holds_alternative<CloseRequest>(event)) {
                closed_ = true;
            }
        }
    }

    // Lines are carried out one after the other, each when what the one before began is over, so that a script reads as it is lived.
    void take_lines(double now_s) {
        for (std::string& line : input_.take()) lines_.push_back(std::move(line));
        if (repeat_left_ == 0 && !app_->idle()) {
            settle_until_s_ = now_s + kSettles_s;  // what came of it wants to be said before the next line interrupts
            return;
        }
        if (now_s < settle_until_s_) return;
        if (repeat_left_ > 0) {
            --repeat_left_;
            tap(repeat_command_, now_s);
            return;
        }
        if (lines_.empty()) {
            closed_ = input_.ended();
            return;
        }
        const std::string line = std::move(lines_.front());
        lines_.pop_front();
        const auto parsed = parse_terminal_line(line);
        if (!parsed) return say(parsed.error().message);
        if (parsed->leave) {
            closed_ = true;
        } else if (parsed->command == Command::Help) {
            say(terminal_help());
        } else if (parsed->command) {
            repeat_command_ = *parsed->command;
            repeat_left_ = parsed->times - 1;
            tap(repeat_command_, now_s);
        }
    }

    void tap(Command command, double now_s) {
        app_->press(command, now_s);
        app_->release(command);
        // A hand that was told to move needs a moment to be there.
        if (command >= Command::HandForward && command <= Command::HandCentre) settle_until_s_ = now_s + kSettles_s;
    }

    // Forces down first, then the last words, then the settings.
    void finish(std::ostream& err) {
        if (servo_) servo_->stop();
        hand_over();
        ears_->stop(audible_ && !end_asked ? kLastWords_s : 0.0);
        if (const auto saved = settings_.save_user_file(); !saved) fmt::print(err, "{}\n", saved.error().sentence());
    }

    const ExploreArguments& arguments_;
    SettingsStore& settings_;
    EndSignals signals_;
    SteadyClock clock_;
    std::shared_ptr<SimulatedHand> simulated_;
    std::unique_ptr<ServoLoop> servo_;
    GuardedDevice* guarded_ = nullptr;  // servo_ owns it
    std::unique_ptr<AudioThread> ears_;
    bool audible_ = false;  // there is a sound device: last words are worth waiting for
    std::unique_ptr<AppCore> app_;
    std::unique_ptr<Window> window_;
    LineInput input_{STDIN_FILENO};
    std::deque<std::string> lines_;
    Command repeat_command_ = Command::Forward;
    int repeat_left_ = 0;
    double settle_until_s_ = 0.0;
    std::shared_ptr<const Scene> handed_scene_;  // what servo and ears were last given
    std::shared_ptr<const HapticScene> handed_haptic_scene_;
    int handed_world_ = 0;
    std::uint64_t handed_bodies_ = 0;
    ToolState tool_;
    std::string last_spoken_;
    bool closed_ = false;
};

}  // namespace

int run_explore(const ExploreArguments& arguments, SettingsStore& settings, std::ostream&, std::ostream& err) {
    return Exploration(arguments, settings).run(err);
}

}  // namespace handrail
