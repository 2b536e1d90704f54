#include <fmt/format.h>
#include <fmt/ostream.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <deque>
#include <future>

#include "app/accessible/accessible.h"
#include "app/companions/companion_session.h"
#include "app/core/app_core.h"
#include "app/core/side_file.h"
#include "app/core/spoken_language.h"
#include "app/main/commands.h"
#include "app/main/find_hand.h"
#include "app/main/left_hand.h"
#include "app/main/world_files.h"
#include "app/terminal/terminal.h"
#include "app/window/window.h"
#include "app/wizard/wizard_session.h"
#include "audio-cues/sinks/audio_thread.h"
#include "audio-cues/sinks/sound_outputs.h"
#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_loop.h"
#include "worlds/base/clock.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;
constexpr double kProgressEvery_s = 2.0;
constexpr double kSettles_s = 0.2;
constexpr double kServoPeriod_s = 1e-3;
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
        const std::string wanted = wanted_hand();
        const auto hand = hand_without_looking(wanted);
        open_ears(news);
        app_ = std::make_unique<AppCore>(settings_.values(), HandFacts{});
        app_->keep_records_in(user_data_folder());
        app_->find_languages_in(user_languages_folder());
        app_->find_rooms_beside();
        for (const Diagnostic& problem : arguments_.settings_problems) news.push_back(problem.sentence());
        open_window(news);
        if (wanted == "none") news.push_back(phrase("program.no_device_as_asked"));
        ears_->start();
        first_ = !settings_.values().welcome.done && !arguments_.world && !arguments_.calibrate;
        const std::string voice = first_ ? voice_that_speaks() : std::string{};
        asked_s_ = clock_.now_s();
        if (first_) app_->begin_first_minutes(voice, true, asked_s_);
        news.push_back(recent_.take_news());
        say(first_ ? joined(news) : phrase("program.welcome", {{"news", joined(news)}}), asked_s_);
        if (arguments_.calibrate) {
            begin_wizard(*arguments_.calibrate);
            calibrate();
            finish(err);
            return 0;
        }
        // Until a real hand is found, and where none is, a simulated one is there; who asked for a certain device waits for that.
        if (hand) use_hand(hand->facts, nullptr);
        else if (wanted == "auto") use_hand(simulated_hand("sim-t").facts, nullptr);
        if (!hand) search_.emplace(wanted);
        else if (wanted != "none") plug_watch_.emplace(std::nullopt);
        if (settings_.values().pads.use) companions_.emplace(clock_);

        left_.look_for(arguments_.left_device.value_or(settings_.values().haptic.left_device));

        const int status = load_world(err) ? explore(err) : 1;
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

    // Puts this hand in place of the one there was; `device` is open, or null for a simulated hand or none. Waits for a force that is still on to fade,
    // at most 76 ms.
    void use_hand(const HandFacts& facts, std::unique_ptr<GuardedDevice> device) {
        if (servo_) servo_->stop();
        servo_.reset();
        simulated_.reset();
        guarded_ = device.get();
        facts_ = facts;
        app_->set_keys_alone(facts.simulated && wanted_hand() == "auto");
        tool_ = {};
        told_how_it_runs_ = guard_missed_ = false;
        app_->set_hand(facts, settings_.values(), clock_.now_s());
        if (!facts.present) return;
        std::unique_ptr<HapticDevice> held = std::move(device);
        if (facts.simulated) {
            simulated_ = std::make_shared<SimulatedHand>();
            held = std::make_unique<SimulatedDevice>(facts.spec, simulated_);
        }
        servo_ = std::make_unique<ServoLoop>(std::move(held), clock_, kServoPeriod_s, ServoLoop::Links{&switches_, &contacts_});
        handed_haptic_scene_.reset();
        handed_desk_.reset();
        handed_bodies_ = 0;
        handed_guidance_ = 0;
        if (const auto opened = servo_->open(); opened) return servo_->start();
        // It was open a moment ago, so it went away meanwhile.
        servo_.reset();
        guarded_ = nullptr;
        facts_ = {};
        app_->set_hand({}, settings_.values(), clock_.now_s());
    }

    // Once that is decided: a better voice may still be opening. The welcome is due within two seconds.
    std::string voice_that_speaks() {
        constexpr double kPatience_s = 1.5;
        const double until_s = clock_.now_s() + kPatience_s;
        std::string voice = ears_->who_speaks();
        while (voice.empty() && clock_.now_s() < until_s) {
            clock_.sleep_until_s(clock_.now_s() + 0.01);
            voice = ears_->who_speaks();
        }
        return voice.empty() ? phrase("voice.text_alone") : voice;
    }

    // ---- the set-up by voice ----

    void begin_wizard(std::span<const WizardPart> parts) {
        wizard_ = std::make_unique<WizardSession>(settings_.values(), parts);
        wizard_stops_ = switches_.stops;
        wizard_let_go_ = app_->tuning().stops_let_go;
        handed_haptic_scene_.reset();
        if (servo_ && std::exchange(handed_guidance_, 0) != 0) servo_->set_guidance({});  // the wizard alone moves the hand
        CueRequest no_tone;
        no_tone.kind = CueRequestKind::WallTone;
        no_tone.loudness = 0.0;
        ears_->post(std::move(no_tone));
    }

    // Alone, without a world.
    void calibrate() {
        watch_lines();
        double next_s = clock_.now_s();
        while (!ended() && wizard_) {
            const double now_s = clock_.now_s();
            if (window_) look_at_window();
            else take_lines(now_s);
            look_for_hand_by_wizard();
            if (wizard_) guide(now_s);
            ViewState view;
            view.last_spoken = last_spoken_;
            if (window_) window_->draw(view);
            next_s = std::max(next_s + kFrame_s, now_s);
            clock_.sleep_until_s(next_s);
        }
    }

    // The search begins when the wizard comes to it, so that what it tells is heard in its place.
    void look_for_hand_by_wizard() {
        if (!wizard_searched_ && wizard_->wizard().wants_search()) {
            wizard_searched_ = true;
            const std::string wanted = wanted_hand();
            if (const auto hand = hand_without_looking(wanted)) use_hand(hand->facts, nullptr);
            else search_.emplace(wanted);
        }
        if (!search_) return;
        const bool ready = search_->ready();
        for (std::string& sentence : search_->take_news()) wizard_news_.push_back(std::move(sentence));
        if (!ready) return;
        auto found = search_->take();
        search_.reset();
        if (!found) wizard_news_.push_back(found.error().sentence());
        else if (found->device) use_hand(found->facts, std::move(found->device));
    }

    // A simulated hand counts only for who asked for one: nobody else wants to be asked to move its grip.
    WizardSearch wizard_search() const {
        if (search_) return WizardSearch::Looking;
        const bool simulated = simulated_ && hand_without_looking(wanted_hand());
        if (servo_ && (guarded_ || simulated)) return WizardSearch::Ready;
        return arguments_.calibrate && !wizard_searched_ ? WizardSearch::NotBegun : WizardSearch::Nothing;
    }

    void guide(double now_s) {
        const std::uint32_t stops = switches_.stops;
        if (std::exchange(wizard_stops_, stops) != stops) wizard_->press("F12", now_s);
        if (servo_) tool_ = servo_->tool();
        WizardSense sense;
        sense.now_s = now_s;
        sense.audible = has_sound_;
        sense.speaking = ears_->speaking();
        if (app_->scene()) sense.listener = app_->listener();
        sense.search = wizard_search();
        sense.news = std::exchange(wizard_news_, {});
        sense.hand = facts_;
        sense.tool = tool_;
        wizard_->tick(sense);
        hand_over();
        for (SpokenLine& line : ears_->take_spoken()) last_spoken_ = std::move(line.text);
        if (wizard_->finished()) end_wizard(now_s);
    }

    void end_wizard(double now_s) {
        const bool stopped = wizard_->wizard().tuning().panic;
        wizard_confirms_ += wizard_->wizard().tuning().confirm;
        wizard_.reset();
        handed_haptic_scene_.reset();
        handed_bodies_ = 0;
        app_->know_set_up_over();
        if (!app_->scene()) return;
        app_->change_settings(settings_.values(), now_s);
        app_->know_stops(wizard_stops_, now_s);
        if (app_->tuning().panic && !stopped) {  // stopped and gone on with in the wizard
            app_->press(Command::ToggleForces, now_s);
            app_->release(Command::ToggleForces);
        }
        say(phrase("program.back_in", {{"world", app_->scene()->name}}));
    }

    void hand_over_wizard() {
        bool changed = false;
        for (const auto& [key, value] : wizard_->wizard().take_setting_changes()) changed |= settings_.set(key, value, SettingSource::Live).has_value();
        if (changed) ears_->set_settings(settings_.values());
        for (CueRequest& cue : wizard_->take_cues()) ears_->post(std::move(cue));
        if (!servo_) return;
        if (const auto scene = wizard_->wizard().haptic_scene(); scene != handed_haptic_scene_) servo_->set_scene(handed_haptic_scene_ = scene);
        ServoTuning tuning = wizard_->wizard().tuning();
        if (!tuning.panic) wizard_let_go_ = wizard_stops_;
        tuning.stops_let_go = wizard_let_go_;
        tuning.focused = app_->tuning().focused;
        tuning.confirm += app_->tuning().confirm + wizard_confirms_;
        servo_->set_tuning(tuning);
        servo_->set_pose(wizard_->wizard().pose());
        if (simulated_) simulated_->command.publish(wizard_->simulated_hand());
    }

    // A device that nobody set up yet.
    void offer_calibration() {
        if (!settings_.values().profiles.contains(profile_key(facts_.spec.name, facts_.serial)))
            say(phrase("program.not_set_up", {{"device", facts_.spec.spoken_name()}, {"keys", app_->keys().keys_of(Command::Calibrate)}}), asked_s_);
    }

    std::string wanted_hand() const { return arguments_.device.value_or(settings_.values().haptic.device); }

    // What the search and the plugs have to tell; a hand that was found takes its place. False when a device that was asked for on the command line
    // cannot be had.
    bool look_for_hand(std::ostream& err) {
        if (plug_watch_) plug_watch_->rest(search_.has_value() || guarded_ != nullptr);
        if (search_) {
            const bool ready = search_->ready();
            for (std::string& sentence : search_->take_news()) say(std::move(sentence), asked_s_);
            if (ready) {
                auto found = search_->take();
                search_.reset();
                if (!plug_watch_) plug_watch_.emplace(found ? std::optional(std::move(found->plugged)) : std::nullopt);
                if (!found) {
                    say(found.error().sentence());
                    if (guarded_) use_hand(simulated_hand("sim-t").facts, nullptr);  // what it stood in for is gone for good
                    if (servo_) return true;                                         // the hand there was goes on
                    if (arguments_.device) {
                        fmt::print(err, "{}\n", found.error().sentence());
                        return false;
                    }
                    say(phrase("program.simulated_instead_plug"), clock_.now_s());
                    use_hand(simulated_hand("sim-t").facts, nullptr);
                    return true;
                }
                if (found->device) {
                    use_hand(found->facts, std::move(found->device));
                    offer_calibration();
                }
            }
            return true;
        }
        if (app_->offer_taken() && offer_) {
            asked_s_ = clock_.now_s();
            say(phrase("program.opening", {{"device", offer_->spoken_name}}), asked_s_);
            search_.emplace(offer_->name);
            return true;
        }
        if (guarded_ && !guard_missed_ && guarded_->guard_ended()) {
            guard_missed_ = true;
            const DeviceSpec& spec = servo_->device_spec();
            offer(PluggedHand{std::string(spec.name), spec.spoken_name(), {}, {}});
        }
        if (!plug_watch_) return true;
        for (PluggedHand& hand : plug_watch_->take_new()) {
            if (hand.problem.empty()) offer(std::move(hand));
            else say(found_words(hand.spoken_name) + " " + hand.problem);
        }
        return true;
    }

    void offer(PluggedHand hand) {
        app_->offer_hand(hand.spoken_name, clock_.now_s());
        offer_ = std::move(hand);
    }

    // Once, for a real device: what may make it uneven.
    void tell_how_it_runs() {
        if (told_how_it_runs_ || !guarded_) return;
        const ServoReport& report = servo_->report();
        if (report.scheduling == Scheduling::NotStarted) return;
        told_how_it_runs_ = true;
        if (report.scheduling == Scheduling::Ordinary) say(scheduling_sentence(report.scheduling));
        if (!report.memory_locked) say(memory_sentence(report.memory_locked));
    }

    void say(std::string text) { say(std::move(text), clock_.now_s()); }
    // Sentences of one asked_s are one reply and wait for each other; those of another one interrupt.
    void say(std::string text, double asked_s) {
        app_->say(std::move(text), SpeechClass::Answer, asked_s);
        hand_over();
    }

    void open_ears(std::vector<std::string>& news) {
        std::shared_ptr<ReaderChannel> reader;
        if (!arguments_.no_window) {
            reader = std::make_shared<ReaderChannel>();
            accessible_ = Accessible::start(reader);
            braille_ = std::make_shared<BrailleLink>();
        }
        SoundOutputs outputs = open_sound_outputs(settings_.values(), STDOUT_FILENO, std::move(reader), braille_);
        has_sound_ = !outputs.description.empty();
        news.push_back(std::move(outputs.description));
        ears_ = std::make_unique<AudioThread>(std::move(outputs.audio), std::move(outputs.speech), clock_, &contacts_, settings_.values(), &left_.contacts());
    }

    void open_window(std::vector<std::string>& news) {
        if (arguments_.no_window) return;
        auto opened = Window::open();
        if (!opened) {
            accessible_.reset();
            return news.push_back(opened.error().message);
        }
        window_ = std::move(*opened);
        braille_->window = window_->number();
        window_->offer_keys(
            {[this](const KeyStroke& stroke) { return accessible_->offer(stroke); }, [this](std::uint64_t ticket) { return accessible_->verdict(ticket); }},
            [keys = app_->keys()](const std::string& key) { return keys.find(key) == Command::StopEverything; });
        window_->watch_keys({[keys = app_->keys()](const std::string& key) { return keys.find(key) == Command::StopEverything; }, [this] { switches_.stop(); },
                             [this](bool focused) { switches_.focused = focused; }});
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
            if (!look_for_hand(err)) return false;
            if (clock_.now_s() - told_s >= kProgressEvery_s) {
                told_s = clock_.now_s();
                say(phrase("program.loading", {{"percent", loading.percent()}}));
            }
        }
        auto scene = loading.take();
        if (!scene) {
            say(scene.error().sentence());
            fmt::print(err, "{}\n", scene.error().sentence());
            return false;
        }
        if (ended()) return false;
        enter(std::move(*scene), path, asked_s_);  // goes on with the greeting instead of cutting it short
        return true;
    }

    void enter(Scene scene, const std::filesystem::path& path, double asked_s) {
        const ReadReport& report = scene.report;
        if (report.warnings_in_all > 0)
            say(phrase("program.problems", {{"count", report.warnings_in_all}, {"first", report.warnings.front().sentence()}}), asked_s);
        app_->use_side_file(SideFile::of_world(path, user_data_folder(), is_shipped(path)));
        app_->enter_world(std::make_shared<const Scene>(std::move(scene)), asked_s);
        recent_.add(path);
        app_->set_worlds({world_folder(), recent_.worlds()});
    }

    // Another world is read while this one goes on; one that cannot be read leaves everything as it is.
    void change_world(double now_s) {
        if (const auto wanted = app_->take_world_request()) {
            if (next_world_) return say(phrase("program.still_read", {{"world", name_of_file(next_path_)}}));
            next_path_ = *wanted;
            next_told_s_ = now_s;
            next_world_ = std::make_unique<WorldLoading>(next_path_, arguments_.common);
        }
        if (!next_world_) return;
        if (!next_world_->ready()) {
            if (now_s - next_told_s_ < kProgressEvery_s) return;
            next_told_s_ = now_s;
            return say(phrase("program.loading", {{"percent", next_world_->percent()}}));
        }
        auto scene = next_world_->take();
        next_world_.reset();
        if (!scene) return say(phrase("program.stay_in", {{"problem", scene.error().sentence()}, {"world", app_->scene()->name}}), now_s);
        enter(std::move(*scene), next_path_, now_s);
    }

    int explore(std::ostream& err) {
        double next_s = clock_.now_s();
        watch_lines();
        while (!ended() && !app_->wants_to_leave()) {
            const double now_s = clock_.now_s();
            app_->know_stops(switches_.stops, now_s);
            if (window_) look_at_window();
            else take_lines(now_s);
            if (!look_for_hand(err)) return 1;
            if (companions_)
                for (std::string& sentence : companions_->guide(*app_, now_s, wizard_ != nullptr)) say(std::move(sentence));
            if (servo_) tool_ = servo_->tool();
            tell_how_it_runs();
            if (guarded_)
                for (std::string& sentence : guarded_->take_news()) say(std::move(sentence));
            notice_left_hand(now_s);
            if (app_->take_calibration_request() && !wizard_) {
                std::vector<WizardPart> parts;
                const bool first = app_->take_first_set_up();
                for (const WizardPartInfo& part : wizard_parts())
                    if (!first || (part.part != WizardPart::Reach && part.part != WizardPart::Step)) parts.push_back(part.part);
                begin_wizard(parts);
            }
            change_world(now_s);
            if (wizard_) {
                guide(now_s);
            } else {
                app_->tick(now_s, tool_, left_.tool());
                hand_over();
            }
            for (SpokenLine& line : ears_->take_spoken()) last_spoken_ = std::move(line.text);
            hold_more_sound();
            if (window_) {
                const ViewState view = app_->view(tool_, last_spoken_);
                window_->draw(view);
            }
            next_s = std::max(next_s + kFrame_s, now_s);
            clock_.sleep_until_s(next_s);
        }
        return 0;
    }

    // A second hand beside the first, once it is found.
    void notice_left_hand(double now_s) {
        std::vector<std::string> news;
        if (left_.take_change(news)) app_->set_left_hand(left_.facts(), now_s);
        if (std::exchange(two_hands_told_, app_->two_hands()) != app_->two_hands()) ears_->set_two_hands(app_->two_hands());
        for (std::string& sentence : news) say(std::move(sentence));
    }

    // To whoever shows lists otherwise than in the picture, and before the words about them.
    void show_dialogue() {
        if (!accessible_ && !braille_) return;
        DialogueView view = app_->dialogue().view();
        if (view == shown_dialogue_) return;
        if (accessible_) accessible_->show(view);
        if (braille_) {
            BrailleLink::List list;
            if (view.kind == DialogueView::Kind::List) list = {view.where, {}, view.at};
            for (const ListItem& item : view.items) list.items.push_back(item.value.empty() ? item.name : item.name + ", " + item.value);
            braille_->set_list(std::move(list));
        }
        shown_dialogue_ = std::move(view);
    }

    // To the servos and the ears, what this frame changed.
    void hand_over() {
        bool changed = false;
        for (const auto& [key, value] : app_->take_setting_changes()) changed |= settings_.set(key, value, SettingSource::Live).has_value();
        if (changed) ears_->set_settings(app_->settings());
        if (app_->scene() != handed_scene_) {
            handed_scene_ = app_->scene();
            if (std::exchange(handed_world_, app_->worlds_entered()) != app_->worlds_entered()) ears_->enter_world(handed_scene_);
            else ears_->follow_edit(handed_scene_);
        }
        show_dialogue();
        std::vector<CueRequest> cues = app_->take_cues();
        if (companions_) companions_->follow(*app_, cues, servo_ ? &tool_ : nullptr, clock_.now_s());
        for (CueRequest& cue : cues) ears_->post(std::move(cue));
        if (app_->scene()) {
            const Listener listener = app_->listener();
            ears_->set_listener(listener);
            if (braille_) braille_->heading_rad = listener.heading_rad;
        }
        left_.hand_over(*app_);
        if (wizard_) return hand_over_wizard();
        if (!servo_ || !app_->scene()) return;
        if (app_->haptic_scene() != handed_haptic_scene_) {
            handed_haptic_scene_ = app_->haptic_scene();
            servo_->set_scene(handed_haptic_scene_);
        }
        if (app_->desk_scene() != handed_desk_) servo_->set_desk(handed_desk_ = app_->desk_scene());
        ServoTuning tuning = app_->tuning();
        tuning.confirm += wizard_confirms_;
        servo_->set_tuning(tuning);
        servo_->set_pose(app_->pose());
        if (std::exchange(handed_bodies_, app_->bodies().number) != app_->bodies().number) servo_->set_bodies(app_->bodies());
        if (std::exchange(handed_guidance_, app_->guidance().number) != app_->guidance().number) servo_->set_guidance(app_->guidance());
        if (!simulated_) return;
        HandCommand command;
        command.target_m = app_->hand_target_m();
        simulated_->command.publish(command);
    }

    // Where two periods of the sound device drop out it gets three, from the next start on.
    void hold_more_sound() {
        if (settings_.values().sound.periods >= 3 || !ears_->sound_drops_out() || !settings_.set("sound.periods", "3", SettingSource::Live)) return;
        say(phrase("program.drops_out"));
    }

    void look_at_window() {
        const double now_s = clock_.now_s();
        // A routing key of the braille display: more about this.
        if (braille_->more_asked.exchange(0) > 0 && !wizard_ && app_->scene()) {
            app_->press(Command::WhatIsThis, now_s);
            app_->release(Command::WhatIsThis);
        }
        for (const ItemAct& act : accessible_->take_acts())
            if (!wizard_) app_->take_act(act, now_s);
        for (const WindowEvent& event : window_->poll()) {
            if (const auto* key = std::get_if<KeyEvent>(&event)) {
                const auto command = app_->keys().find(key->key);
                if (wizard_) {  // the stop key has come by the switches
                    if (key->action != KeyAction::Release && command != Command::StopEverything) wizard_->press(key->key, now_s);
                    continue;
                }
                // The characters of a key belong to what was open before it.
                typing_ = app_->dialogue().is_open();
                if (key->action != KeyAction::Release && app_->take_key(key->key, now_s)) continue;
                if (!command || !app_->scene()) continue;
                if (key->action == KeyAction::Press) app_->press(*command, now_s);
                else if (key->action == KeyAction::Release) app_->release(*command);
            } else if (const auto* text = std::get_if<TextEvent>(&event)) {
                if (typing_ && !wizard_) app_->take_text(text->utf8, now_s);
            } else if (const auto* motion = std::get_if<HandMotion>(&event)) {
                app_->move_hand(motion->by_m);
            } else if (const auto* focus = std::get_if<FocusChange>(&event)) {
                app_->set_focus(focus->focused);
                accessible_->set_focus(focus->focused);
            } else if (std::holds_alternative<CloseRequest>(event)) {
                closed_ = true;
            }
        }
    }

    void watch_lines() {
        if (!window_) lines_watch_.emplace(STDIN_FILENO, [this](std::string_view line) { return stops_at_once(line); });
    }

    // The word for the stop key, typed at a terminal, does not wait for its turn. In a file or a pipe it does: there it is a line of a script.
    // On the line watch's thread.
    bool stops_at_once(std::string_view line) {
        if (!typed_) return false;
        const auto parsed = parse_terminal_line(line);
        if (!parsed || parsed->command != Command::StopEverything) return false;
        switches_.stop();
        return true;
    }

    // Lines are carried out one after the other, each when what the one before began is over, so that a script reads as it is lived.
    void take_lines(double now_s) {
        const bool ended = lines_watch_->ended();  // asked first: lines that came before the end are taken below
        bool emptied = false;
        std::vector<std::string> typed = lines_watch_->take(emptied);
        if (emptied) {
            lines_.clear();
            repeat_left_ = 0;
        }
        for (std::string& line : typed) lines_.push_back(std::move(line));
        if (wizard_) {
            if (!wizard_->wants_line(now_s)) return;
            if (lines_.empty()) {
                if (ended) wizard_->end_of_lines();
                return;
            }
            wizard_->type(std::move(lines_.front()));
            return lines_.pop_front();
        }
        if (next_world_) return;
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
            // Nobody will answer the welcome any more.
            if (ended && app_->greeting_waits()) return app_->leave_lesson(now_s);
            closed_ = ended && !search_ && !next_world_;
            return;
        }
        const std::string line = std::move(lines_.front());
        lines_.pop_front();
        if (app_->take_line(line, now_s)) return;
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
        companions_.reset();
        search_.reset();
        left_.stop();
        if (servo_) servo_->stop();
        hand_over();
        ears_->stop(end_asked ? 0.0 : kLastWords_s);
        if (const auto saved = settings_.save_user_file(); !saved) fmt::print(err, "{}\n", saved.error().sentence());
    }

    const ExploreArguments& arguments_;
    SettingsStore& settings_;
    EndSignals signals_;
    SteadyClock clock_;
    ServoSwitches switches_;
    ServoLoop::EventRing contacts_;  // of whichever device is in use
    std::shared_ptr<SimulatedHand> simulated_;
    std::unique_ptr<ServoLoop> servo_;
    GuardedDevice* guarded_ = nullptr;       // servo_ owns it
    HandFacts facts_;                        // of the hand in use
    std::unique_ptr<WizardSession> wizard_;  // while it leads through the set-up
    bool wizard_searched_ = false;
    std::vector<std::string> wizard_news_;
    std::uint32_t wizard_stops_ = 0, wizard_let_go_ = 0, wizard_confirms_ = 0;
    std::optional<HandSearch> search_;
    std::optional<PlugWatch> plug_watch_;
    std::optional<PluggedHand> offer_;  // the last one made
    double asked_s_ = 0.0;              // when the program or the person began the search
    bool told_how_it_runs_ = false;
    bool guard_missed_ = false;  // and the device offered anew
    LeftHand left_{clock_, switches_};
    bool two_hands_told_ = false;
    std::unique_ptr<Accessible> accessible_;  // with the window
    std::shared_ptr<BrailleLink> braille_;    // with the window
    DialogueView shown_dialogue_;             // as these two have it
    std::unique_ptr<AudioThread> ears_;
    bool has_sound_ = false;  // there is a sound device
    std::unique_ptr<AppCore> app_;
    std::unique_ptr<Window> window_;
    std::optional<CompanionSession> companions_;
    const bool typed_ = ::isatty(STDIN_FILENO) == 1;
    std::optional<LineWatch> lines_watch_;
    std::deque<std::string> lines_;
    RecentWorlds recent_{recent_worlds_path()};
    bool first_ = false;  // the first minutes begin this start
    std::unique_ptr<WorldLoading> next_world_;
    std::filesystem::path next_path_;
    double next_told_s_ = 0.0;
    bool typing_ = false;  // a list or question was open when the last key went down
    Command repeat_command_ = Command::Forward;
    int repeat_left_ = 0;
    double settle_until_s_ = 0.0;
    std::shared_ptr<const Scene> handed_scene_;  // what servo and ears were last given
    std::shared_ptr<const HapticScene> handed_haptic_scene_, handed_desk_;
    int handed_world_ = 0;
    std::uint64_t handed_bodies_ = 0;
    std::uint32_t handed_guidance_ = 0;
    ToolState tool_;
    std::string last_spoken_;
    bool closed_ = false;
};

}  // namespace

int run_explore(const ExploreArguments& arguments, SettingsStore& settings, std::ostream&, std::ostream& err) {
    return Exploration(arguments, settings).run(err);
}

}  // namespace handrail
