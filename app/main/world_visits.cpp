#include "app/main/world_visits.h"

#include <utility>

#include "app/core/kept/kept_unit.h"
#include "app/core/kept/side_file.h"
#include "app/main/world_files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {

std::string WorldVisits::crash_words(bool with_window, double now_s) {
    if (!trace_.crashed()) return {};
    const auto& last = trace_.left_at();
    std::error_code ec;
    if (!last || !std::filesystem::exists(last->world, ec)) return phrase("last_place.crashed");
    app_.apply(LastPlaceKnown{*last}, now_s);
    return phrase("last_place.crashed_offer", {{"world", name_of_file(last->world)},
                                               {"window", with_window ? "yes" : "no"},
                                               {"keys", app_.keys().keys_of(Command::LastPlace)}});
}

void WorldVisits::enter(EnteringWorld world, const std::filesystem::path& path, double asked_s) {
    const ReadReport& report = world.file->report;
    if (report.warnings_in_all > 0)
        say_(phrase("program.problems",
                    {{"count", report.warnings_in_all}, {"first", report.warnings.front().sentence()}}),
             asked_s);
    SideFile side_file = SideFile::of_world(kept_by(path), user_data_folder(), is_shipped(path));
    if (arguments_.common.unit_m && arguments_.world && path == *arguments_.world) {
        keep_unit(side_file, *arguments_.common.unit_m);
        if (const auto saved = side_file.save(); !saved) say_(saved.error().sentence(), asked_s);
    }
    app_.apply(WorldEntered{std::move(world), std::move(side_file)}, asked_s);
    recent_.add(path);
    std::error_code ec;
    path_ = std::filesystem::absolute(path, ec);
    app_.apply(WorldsKnown{{world_folder(), recent_.worlds()}}, asked_s);
}

void WorldVisits::begin_reading(const std::filesystem::path& path, const CommonArguments& common, double now_s) {
    next_path_ = path;
    next_told_s_ = now_s;
    next_ = std::make_unique<WorldLoading>(next_path_, common);
}

void WorldVisits::change(double now_s) {
    if (const auto wanted = app_.requests().take_world()) {
        if (next_) return say_(phrase("program.still_read", {{"world", name_of_file(next_path_)}}));
        CommonArguments common = arguments_.common;
        common.unit_m.reset();  // it was said of another world
        begin_reading(*wanted, common, now_s);
    }
    if (const auto last = app_.requests().take_last_place(); last && !next_) {
        std::error_code ec;
        if (std::filesystem::equivalent(last->world, path_, ec)) {
            app_.apply(WentOnAt{*last}, now_s);
        } else {
            next_place_ = *last;
            begin_reading(last->world, arguments_.common, now_s);
        }
    }
    if (!next_) return;
    if (!next_->ready()) {
        if (now_s - next_told_s_ < kLoadingToldEvery_s) return;
        next_told_s_ = now_s;
        return say_(phrase("program.loading", {{"percent", next_->percent()}}));
    }
    auto world = next_->take();
    next_.reset();
    const auto place = std::exchange(next_place_, std::nullopt);
    if (!world)
        return say_(phrase("program.stay_in", {{"problem", world.error().sentence()}, {"world", app_.scene()->name}}),
                    now_s);
    enter(std::move(*world), next_path_, now_s);
    if (place) app_.apply(WentOnAt{*place}, now_s);
}

bool WorldVisits::give_up_reading(double now_s) {
    if (!next_) return false;
    next_.reset();  // waits for what looks at the stop many times a second
    next_place_.reset();
    say_(phrase("program.given_up", {{"left", name_of_file(next_path_)}, {"world", app_.scene()->name}}), now_s);
    return true;
}

void WorldVisits::note_place(double now_s) {
    if (app_.standing()) trace_.note({path_, app_.feet_m(), app_.heading_rad()}, now_s);
}

}  // namespace handrail
