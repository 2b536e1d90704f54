#include "app/main/world_visits.h"

#include <sstream>
#include <utility>
#include <variant>

#include "app/core/kept/kept_unit.h"
#include "app/core/kept/side_file.h"
#include "app/core/learning/learnt_file.h"
#include "app/main/world_files.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {

namespace {

// Returns a word for the input, for a crash report. Returns an empty text if the input does not help to explain a
// crash, or only says something about the person.
std::string_view act_word(const core::SessionInput& input) {
    if (const auto* down = std::get_if<core::CommandDown>(&input)) return core::info(down->command).word;
    if (std::holds_alternative<core::LineTyped>(input)) return "line-typed";
    if (std::holds_alternative<core::TextTyped>(input)) return "text-typed";
    if (std::holds_alternative<core::ItemActed>(input)) return "list-item";
    if (std::holds_alternative<core::WorldEntered>(input)) return "world-entered";
    if (std::holds_alternative<core::HandChanged>(input)) return "hand-changed";
    if (std::holds_alternative<core::LeftHandChanged>(input)) return "left-hand-changed";
    if (std::holds_alternative<core::SettingsChanged>(input) || std::holds_alternative<core::SettingSet>(input))
        return "settings-changed";
    if (std::holds_alternative<core::WentOnAt>(input)) return "went-on";
    return {};
}

}  // namespace

std::string settings_faults_words(const std::vector<std::string>& faults) {
    if (faults.size() == 1) return faults.front();
    return phrase("program.settings_faults", {{"count", faults.size()}, {"first", faults.front()}});
}

std::vector<std::string> sentences_of(const std::vector<Diagnostic>& problems) {
    std::vector<std::string> sentences;
    for (const Diagnostic& problem : problems) sentences.push_back(problem.sentence());
    return sentences;
}

void WorldVisits::begin_notes(double now_s) {
    std::vector<std::string> lines{
        phrase("crash_report.program", {{"version", arguments_.program_version}, {"language", spoken_language()}})};
    for (const settings::SettingRow& row : settings_.explain())
        if (row.source != settings::SettingSource::Default)
            lines.push_back(
                phrase("crash_report.setting", {{"key", row.key},
                                                {"value", row.value},
                                                {"told", core::may_be_reported(row.value, row.range) ? "yes" : "no"}}));
    notes_.emplace(std::move(lines));
    crash_signal_.emplace(trace_.signal_file());
    app_.add_input_listener({[this](const core::SessionInput& input, double at_s) {
                                 if (const std::string_view word = act_word(input); !word.empty())
                                     notes_->note(word, at_s);
                             },
                             {}});
    keep_notes(now_s);
}

void WorldVisits::keep_notes(double now_s) {
    if (notes_ && notes_->changes() != notes_kept_ && trace_.note_report(notes_->text(), now_s))
        notes_kept_ = notes_->changes();
}

std::string WorldVisits::crash_words(bool with_window, double now_s) {
    if (!trace_.crashed()) return {};
    std::string report;
    if (const auto text = read_whole_file(trace_.report(), 256 * 1024); text && !trace_.report().empty()) {
        std::vector<std::string> lines;
        std::istringstream in(*text);
        for (std::string line; std::getline(in, line);)
            if (!line.empty()) lines.push_back(std::move(line));
        app_.apply(core::CrashReportKnown{trace_.report().string(), std::move(lines)}, now_s);
        report = " " + phrase("crash_report.lies", {{"file", trace_.report().string()}});
    }
    const auto& last = trace_.left_at();
    std::error_code ec;
    if (!last || !std::filesystem::exists(last->world.file, ec)) return phrase("last_place.crashed") + report;
    app_.apply(core::LastPlaceKnown{*last}, now_s);
    return phrase("last_place.crashed_offer", {{"world", core::name_of_file(last->world.file)},
                                               {"window", with_window ? "yes" : "no"},
                                               {"keys", app_.keys().keys_of(core::Command::LastPlace)}}) +
           report;
}

core::WorldRequest WorldVisits::first() const {
    core::WorldRequest request = arguments_.common.request(arguments_.world.value_or(first_world()));
    request.settings = arguments_.lesson_settings;
    return request;
}

// Replaces the settings of the previous world by those of the new one.
void WorldVisits::take_settings(settings::SettingsStore settings, const std::vector<Diagnostic>& problems,
                                double requested_s) {
    settings_.take_layer(settings::SettingSource::World, std::move(settings));
    new_settings_ = true;
    std::vector<std::string> faults = sentences_of(problems);
    if (!faults.empty()) say_(settings_faults_words(faults), requested_s);
    for (std::string& sentence : sentences_of(arguments_.settings_problems)) faults.push_back(std::move(sentence));
    app_.apply(core::SettingsFaultsKnown{std::move(faults)}, requested_s);
}

void WorldVisits::set_lesson_settings(std::vector<std::pair<std::string, std::string>> settings, double now_s) {
    if (settings == here_.settings) return;
    here_.settings = std::move(settings);
    std::vector<Diagnostic> problems;
    settings::SettingsStore layer = settings_of(here_, problems);
    take_settings(std::move(layer), problems, now_s);
    app_.apply(core::SettingsChanged{settings_.values()}, now_s);
}

void WorldVisits::enter(LoadedWorld world, double requested_s) {
    const std::shared_ptr<const Scene> file = world.entering.file;
    core::SideFile side_file =
        world.additions ? std::move(*world.additions) : additions_to(world.request.file, arguments_.common);
    // If the command line states a unit, store it. Later sessions without that option use the stored unit.
    if (world.requested.unit_m) {
        core::keep_unit(side_file, *world.requested.unit_m);
        if (const auto saved = side_file.save(); !saved) say_(saved.error().sentence(), requested_s);
    }
    // For a learner, delete progress that was stored without consent, or before the consent was withdrawn.
    if (!arguments_.common.data_in.empty()) {
        core::set_remembers(side_file, arguments_.remember);
        if (const auto saved = side_file.save(); !saved) say_(saved.error().sentence(), requested_s);
    }
    std::error_code ec;
    here_ = std::move(world.requested);
    here_.file = std::filesystem::absolute(here_.file, ec);
    here_.unit_m.reset();
    world.request.file = here_.file;
    watch_.begin(here_.file, requested_s);
    take_settings(std::move(world.settings), world.settings_problems, requested_s);
    app_.apply(core::WorldEntered{std::move(world.entering), std::move(side_file), std::move(world.request),
                                  settings_.values(),
                                  world.begins_at ? std::optional(world.begins_at->value()) : std::nullopt},
               requested_s);
    // The problems of the file come after the name of the building.
    if (const ReadReport& report = file->report; report.warnings_in_all > 0)
        say_(phrase("program.problems",
                    {{"count", report.warnings_in_all}, {"first", report.warnings.front().sentence()}}),
             requested_s);
    recent_.add(here_.file);
    app_.apply(core::WorldsKnown{{world_folder(), recent_.worlds()}}, requested_s);
}

void WorldVisits::begin_reading(core::WorldRequest request) {
    requested_ = std::move(request);
    next_ = std::make_unique<WorldLoading>(requested_, arguments_.common);
}

// Leads the person to `last`. If that place is in another world, reads that world first.
void WorldVisits::go_on_at(core::LastPlace last, double now_s) {
    std::error_code ec;
    if (std::filesystem::equivalent(last.world.file, here_.file, ec) && last.world.building == here_.building)
        return void(app_.apply(core::WentOnAt{std::move(last)}, now_s));
    begin_reading(last.world);
    next_place_ = std::move(last);
}

void WorldVisits::change(double now_s) {
    if (auto wanted = app_.requests().take_world()) {
        if (next_) return say_(phrase("program.still_read", {{"world", core::name_of_file(requested_.file)}}));
        // The scale from the command line applies to every map.
        wanted->map_scale_m_per_unit = arguments_.common.map_scale_m_per_unit;
        begin_reading(std::move(*wanted));
    }
    if (app_.requests().take_read_again() && !next_ && !here_.file.empty()) {
        if (!app_.requests().take_begin_anew()) next_place_ = core::LastPlace{here_, app_.feet_m(), app_.heading_rad()};
        begin_reading(here_);
    }
    if (auto last = app_.requests().take_last_place(); last && !next_) go_on_at(std::move(*last), now_s);
    if (!next_) return watch_file(now_s);
    if (!next_->ready()) return next_->report(now_s, [this](const std::string& words) { say_(words); });
    auto world = next_->take();
    next_.reset();
    const auto place = std::exchange(next_place_, std::nullopt);
    if (!world)
        return say_(phrase("program.stay_in", {{"problem", world.error().sentence()}, {"world", app_.scene()->name}}),
                    now_s);
    enter(std::move(*world), now_s);
    if (place) app_.apply(core::WentOnAt{*place}, now_s);
}

// Announces a change or the removal of the current world's file. The world in the session does not change until the
// person reloads it.
void WorldVisits::watch_file(double now_s) {
    const WorldWatch::News news = watch_.look(now_s);
    if (news == WorldWatch::News::None) return;
    say_(phrase(news == WorldWatch::News::Removed ? "program.world_gone" : "program.world_changed",
                {{"file", here_.file.filename().string()}}),
         now_s);
}

bool WorldVisits::give_up_reading(double now_s) {
    if (!next_) return false;
    next_.reset();  // waits for the loading thread, which checks the stop request many times a second
    next_place_.reset();
    say_(phrase("program.given_up", {{"left", core::name_of_file(requested_.file)}, {"world", app_.scene()->name}}),
         now_s);
    return true;
}

void WorldVisits::note_place(double now_s) {
    if (app_.avatar().walker->state().on_ground) trace_.note({here_, app_.feet_m(), app_.heading_rad()}, now_s);
}

}  // namespace handrail::program
