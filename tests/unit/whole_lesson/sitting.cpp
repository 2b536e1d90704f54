#include "tests/unit/whole_lesson/sitting.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "app/core/kept/spoken_language.h"
#include "tests/support/names.h"
#include "worlds/readers/reader.h"

namespace handrail::test {
namespace {

constexpr double kStep_s = 0.005, kTurn_s = 0.1, kBegun_s = 100.0;

EnteringWorld world_of(const std::filesystem::path& file) {
    auto scene = read_world(file);
    EXPECT_TRUE(scene) << scene.error().sentence();
    return make_ready_to_touch(std::make_shared<const Scene>(std::move(*scene)));
}

}  // namespace

double Sway::next_m() {
    // Fraction of the sway that remains from one frame to the next; a tenth of a second keeps 0.95 of the sway.
    constexpr double kStays = 0.9915;
    now_m_ = kStays * now_m_ + std::sqrt(1.0 - kStays * kStays) * size_m_ * normal_(draw_);
    return now_m_;
}

Sitting::Sitting(ExploreArguments arguments)
    : arguments_(std::move(arguments)),
      recording_(
          (clock_.advance_s(kBegun_s), std::make_unique<SessionRecording>(arguments_, settings_, clock_, news_))),
      app_(settings_, HandFacts{},
           {.executor = on_threads(),
            .records_in = arguments_.common.data_folder(),
            .arrivals = recording_->arrivals()}),
      say_(clock_, [this](std::string text, double requested_s) {
          app_.apply(Announcement{std::move(text), SpeechClass::Answer}, requested_s);
          driver_->hand_over();
      }) {
    SoundOutputs outputs;
    outputs.audio = std::make_unique<RecordingAudio>();
    auto speech = std::make_unique<RecordingSpeech>(kWordsPerMinute);
    speech_ = speech.get();
    outputs.speech = std::move(speech);
    outputs = recording_->noted(std::move(outputs));
    sound_ =
        std::make_unique<AudioThread>(std::move(outputs.audio), std::move(outputs.speech), clock_, nullptr, settings_);
    recording_->listen_to(*sound_);
    recording_->listen_to(app_);
    driver_ = std::make_unique<SessionDriver>(
        app_, *sound_,
        SessionDriver::Steps{.ticked =
                                 [this](double now_s, const ToolState&, const ToolState&) {
                                     const auto events = recording_->ticked(app_, now_s, {}, {});
                                     lesson_->see(events);
                                     if (second_run_)
                                         second_events_.insert(second_events_.end(), events.begin(), events.end());
                                 },
                             .take_settings =
                                 [this](const auto& changes) {
                                     if (!changes.empty()) recording_->note("ears_settings");
                                     return !changes.empty();
                                 },
                             .hands_over = [this] { recording_->handed_over(); },
                             .look_at_cues = {}});
    worlds_ = std::make_unique<WorldVisits>(arguments_, store_, app_, say_);
    lesson_ = std::make_unique<LessonHere>(arguments_, app_, *worlds_, say_);
    begun_s_ = clock_.now_s();
    for (std::string& words : news_) say_(std::move(words), begun_s_);
    LoadedWorld loaded;
    loaded.entering = world_of(*arguments_.world);
    loaded.requested = loaded.request = worlds_->first();
    worlds_->enter(std::move(loaded), begun_s_);
}

Sitting::~Sitting() { end(); }

void Sitting::end() {
    if (std::exchange(ended_, true)) return;
    lesson_->end(clock_.now_s());
    app_.keep_learnt(in_whole_microseconds(clock_.now_s()));
    driver_->hand_over();
    sound_->stop(3.0);
    recording_->end();
    worlds_->end();
}

// Does the work of a frame in the same order as app/main/explore_command.
void Sitting::frame() {
    const double due_s = begun_s_ + static_cast<double>(++frames_) * kFrame_s;
    for (double step_s = begun_s_ + static_cast<double>(steps_ + 1) * kStep_s; step_s < due_s;
         step_s = begun_s_ + static_cast<double>(++steps_ + 1) * kStep_s) {
        clock_.sleep_until_s(step_s);
        sound_->step();
    }
    clock_.sleep_until_s(due_s);
    if (!hurries_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const double now_s = in_whole_microseconds(clock_.now_s());
    worlds_->change(now_s);
    lesson_->turn(sound_->speaking(), now_s);
    if (second_run_ && now_s - taught_s_ >= kTurn_s - 1e-6) {
        taught_s_ = now_s;
        teach_on(*second_run_, app_, std::exchange(second_events_, {}), now_s);
    }
    driver_->tick(now_s, {});
    worlds_->note_place(now_s);
}

void Sitting::live(double seconds) {
    for (const double until_s = clock_.now_s() + seconds; clock_.now_s() < until_s - 1e-9;) frame();
}

bool Sitting::know_rooms() {
    for (int i = 0; i < 60'000 && !app_.lesson_view().rooms_known; ++i) {
        frame();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return app_.lesson_view().rooms_known;
}

void Sitting::key(const std::string& name) {
    ++keys_;
    const double now_s = clock_.now_s();
    if (!app_.apply(KeyTapped{name}, now_s)) {
        const auto command = app_.keys().find(name);
        EXPECT_TRUE(command) << name;
        if (!command) return;
        app_.apply(CommandDown{*command}, now_s);
        app_.apply(CommandUp{*command}, now_s);
    }
    live(0.5);
}

void Sitting::type(const std::string& text) {
    for (const char c : text) {
        ++keys_;
        EXPECT_TRUE(app_.apply(TextTyped{std::string(1, c)}, clock_.now_s())) << text;
        live(0.2);
    }
}

void Sitting::hold(Command command, double seconds) {
    app_.apply(CommandDown{command}, clock_.now_s());
    live(seconds);
    app_.apply(CommandUp{command}, clock_.now_s());
}

void Sitting::face(const Vec3& at) {
    for (int i = 0; i < 600; ++i) {
        const Vec3 way = at - app_.feet_m();
        const double off = wrap_angle(std::atan2(way.x, way.y) - app_.heading_rad());
        if (std::abs(off) < 0.01) break;
        app_.apply(Steered{{0.0, 0.0, std::clamp(3.0 * off, -1.0, 1.0)}}, clock_.now_s());
        frame();
    }
    app_.apply(Steered{}, clock_.now_s());
    frame();
}

// Walks straight from `from` to `to`.
Sitting::Came Sitting::leg(const Vec3& from, const Vec3& to, Sway* sway) {
    constexpr double kNear_m = 0.2, kLookAhead_m = 0.6, kPut_m = 1.0;
    const Vec3 whole = to - from;
    const double long_m = std::hypot(whole.x, whole.y);
    if (long_m < 1e-6) return Came::There;
    const Vec3 along = Vec3(whole.x, whole.y, 0.0) / long_m, right(along.y, -along.x, 0.0);
    double stuck_s = 0.0;
    for (const double until_s = clock_.now_s() + 60.0 + 4.0 * long_m; clock_.now_s() < until_s;) {
        const Vec3 feet = app_.feet_m(), gone = feet - from;
        const double gone_m = glm::dot(gone, along), aside_m = glm::dot(gone, right);
        if (gone_m > long_m - kNear_m && (sway || std::abs(aside_m) < kNear_m)) return Came::There;
        const double wanted_m = sway ? sway->next_m() : 0.0;
        const Vec3 aim = from + along * std::min(long_m, gone_m + kLookAhead_m) + right * wanted_m - feet;
        const double off = wrap_angle(std::atan2(aim.x, aim.y) - app_.heading_rad());
        const bool goes = std::abs(off) < 0.4;
        // A swaying person steps to the side instead of turning.
        const double side = sway && goes ? std::clamp(6.0 * (wanted_m - aside_m), -0.7, 0.7) : 0.0;
        app_.apply(Steered{{goes ? 1.0 : 0.0, side, std::clamp(3.0 * off, -1.0, 1.0)}}, clock_.now_s());
        frame();
        if (sway && frames_ % 6 == 0) aside_m_.push_back(aside_m);
        const double moved_m = glm::length(app_.feet_m() - feet);
        if (moved_m > kPut_m) return Came::PutElsewhere;
        stuck_s = goes && moved_m < 1e-3 ? stuck_s + kFrame_s : 0.0;
        if (stuck_s < 0.5) continue;
        stuck_s = 0.0;
        app_.apply(Steered{}, clock_.now_s());
        hold(Command::Use, 0.1);
        live(3.0);
    }
    return Came::Stuck;
}

bool Sitting::walk(const std::vector<Vec3>& places, Sway* sway) {
    Vec3 from = app_.feet_m();
    Came came = Came::There;
    for (const Vec3& to : places) {
        came = leg(from, to, sway);
        if (came != Came::There) break;
        from = to;
    }
    app_.apply(Steered{}, clock_.now_s());
    frame();
    return came != Came::Stuck;
}

bool Sitting::hears(const std::string& words, double within_s) {
    double until_s = clock_.now_s() + within_s;
    const double longest_s = clock_.now_s() + 600.0;  // a voice that never falls silent
    for (;;) {
        if (sound_->speaking() && clock_.now_s() < longest_s) until_s = clock_.now_s() + within_s;
        for (; heard_ < speech_->lines().size(); ++heard_)
            if (speech_->lines()[heard_].utterance.text.find(words) != std::string::npos) return ++heard_, true;
        if (clock_.now_s() >= until_s) return false;
        live(0.1);
    }
}

std::string Sitting::all() const {
    std::string text;
    for (const HeardSpeech& line : speech_->lines()) text += line.utterance.text + "\n";
    return text;
}

}  // namespace handrail::test
