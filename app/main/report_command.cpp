#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "app/core/kept/side_file.h"
#include "app/core/whereabouts/rooms_kept.h"
#include "app/learners/export_gate.h"
#include "app/main/commands.h"
#include "app/main/session_report.h"
#include "app/main/world_files.h"
#include "app/record/compute_again.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"

namespace handrail::program {
namespace {

namespace fs = std::filesystem;

// Keeps the world of the previous recording. Most sessions of a learner are in the same world. So its file is read, and
// its rooms are found, only once.
class WorldBefore {
public:
    Result<std::shared_ptr<const Scene>> read(const record::RecordedWorld& world) {
        if (scene_ && is_same(world)) return scene_;
        scene_.reset();
        auto scene = record::read_recorded_scene(world, {imported_scene, toml_next_to_worlds()});
        if (!scene) return scene;
        world_ = world;
        return scene_ = *scene;
    }
    core::RoomsKept* rooms_kept() { return &rooms_kept_; }

private:
    bool is_same(const record::RecordedWorld& other) const {
        const auto what = [](const record::RecordedWorld& of) {
            return std::tie(of.request, of.checksum, of.has_additions, of.additions);
        };
        return !other.checksum.empty() && what(world_) == what(other);
    }

    core::RoomsKept rooms_kept_;
    record::RecordedWorld world_;
    std::shared_ptr<const Scene> scene_;
};

// Makes the report of one recording. Prints sentences about damage to the recording, and a sentence if the session
// continued in other worlds.
Result<report::SessionReport> report_of_folder(const fs::path& folder, WorldBefore& before, const LongWork& progress,
                                               std::ostream& out, std::ostream& err) {
    progress.at(phrase("progress.recording"));
    const auto recording = record::read_recording(folder);
    progress.done();
    if (!recording) return tl::unexpected(recording.error());
    for (const Error& problem : recording->problems) err << problem.sentence() << '\n';
    const record::RecordedEvents events = record::events_of(*recording);
    if (!events.world) return fail(phrase("report.no_world"), folder.string());
    if (events.more_worlds) out << phrase("report.first_world") << '\n';
    progress.at(phrase("progress.measures"));
    const auto scene = before.read(*events.world);
    auto report = scene ? report_of(*recording, events, *scene, before.rooms_kept()) : tl::unexpected(scene.error());
    progress.done();
    return report;
}

std::vector<fs::path> folders_in(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code ec;
    for (fs::directory_iterator at(folder, ec), end; !ec && at != end; at.increment(ec))
        if (std::error_code other; at->is_directory(other)) found.push_back(at->path());
    std::sort(found.begin(), found.end());  // oldest first, because the names of folders begin with the time
    return found;
}

// Runs the command once.
class ReportCommand {
public:
    ReportCommand(const ReportArguments& arguments, const LongWork& progress, std::ostream& out, std::ostream& err)
        : arguments_(arguments), progress_(progress), out_(out), err_(err) {}

    int run() {
        if (!arguments_.html && !arguments_.csv && !arguments_.json)
            return refuse({{}, 0, 0, phrase("report.nothing_asked")}, 2);
        // Check the output files first, because reading and measuring take long.
        std::error_code ec;
        for (const auto& file : {arguments_.html, arguments_.csv, arguments_.json})
            if (file && !arguments_.force && fs::exists(fs::symlink_status(*file, ec)))
                return refuse({{}, 0, 0, phrase("export.exists", {{"file", file->string()}})});
        return arguments_.learner.empty() || arguments_.folder ? of_session() : of_learner();
    }

private:
    int refuse(const Error& error, int status = 1) {
        err_ << error.sentence() << '\n';
        return status;
    }

    int of_session() {
        const fs::path folder = arguments_.folder.value_or(newest_in(core::user_data_folder("recordings")));
        if (folder.empty()) return refuse({{}, 0, 0, phrase("replay.none")});
        if (auto way = export_gate_of(folder); way) export_gate_ = std::move(*way);
        else return refuse(way.error());
        if (const auto allowed = allowed_all(); !allowed) return refuse(allowed.error());
        WorldBefore none;
        auto report = report_of_folder(folder, none, progress_, out_, err_);
        if (!report) return refuse(report.error());
        report->learner = export_gate_.learner() ? export_gate_.learner()->name : arguments_.learner;
        const std::span<const report::SessionReport> one(&*report, 1);
        if (const int status = write(arguments_.html ? report::report_page(*report) : std::string(), one); status != 0)
            return status;
        for (const std::string& sentence : report::report_words(*report)) out_ << sentence << '\n';
        return 0;
    }

    // Returns the ExportGate through which the results are written. A recording in a learner's folder belongs to that
    // learner. For any other recording, --learner says to whom it belongs.
    Result<learners::ExportGate> export_gate_of(const fs::path& folder) const {
        auto way = learners::ExportGate::of(learners_, folder);
        if (!way || arguments_.learner.empty()) return way;
        auto named = learners_.find(arguments_.learner);
        if (!way->learner()) return named ? learners::ExportGate::of(learners_, std::move(*named)) : way;
        if (named && named->id == way->learner()->id) return way;
        return fail(phrase("report.of_another", {{"name", way->learner()->name}}));
    }

    Result<void> allowed_all() const {
        for (const auto& file : {arguments_.html, arguments_.csv, arguments_.json})
            if (file)
                if (auto allowed = export_gate_.allows(*file); !allowed) return allowed;
        return {};
    }

    // Reports all sessions of a learner that can be read. Prints the names of the others and leaves them out.
    int of_learner() {
        const auto learner = learners_.find(arguments_.learner);
        if (!learner) return refuse(learner.error());
        export_gate_ = learners::ExportGate::of(learners_, *learner);
        if (const auto allowed = allowed_all(); !allowed) return refuse(allowed.error());
        std::vector<report::SessionReport> reports;
        WorldBefore before;
        for (const fs::path& folder : folders_in(learners_.recordings_of(learner->id))) {
            auto report = report_of_folder(folder, before, progress_, out_, err_);
            if (!report) {
                err_ << report.error().sentence() << '\n';
                continue;
            }
            reports.push_back(std::move(*report));
        }
        // Add the sessions whose results, but no recordings, were stored with the learner's consent.
        std::vector<Error> faults;
        for (const learners::KeptResults& kept : learners::kept_results(learners_.folder_of(learner->id), faults))
            reports.push_back(report_of(kept));
        for (const Error& fault : faults) err_ << fault.sentence() << '\n';
        std::stable_sort(reports.begin(), reports.end(),
                         [](const report::SessionReport& a, const report::SessionReport& b) {
                             return a.started_utc < b.started_utc;
                         });
        for (std::size_t i = 0; i < reports.size(); ++i) {
            reports[i].learner = learner->name;
            reports[i].learner_id = learner->id;
            reports[i].session = fmt::format("{}", i + 1);
        }
        if (reports.empty()) return refuse({{}, 0, 0, phrase("learner.no_sessions", {{"name", learner->name}})});
        if (const int status = write(arguments_.html ? report::learner_page(reports) : std::string(), reports);
            status != 0)
            return status;
        for (const std::string& sentence : report::learner_words(reports)) out_ << sentence << '\n';
        return 0;
    }

    int write(std::string page, std::span<const report::SessionReport> reports) {
        const std::vector<report::ResultRow> rows = report::result_rows(reports);
        struct Made {
            fs::path path;
            std::string content;
            bool named = true;  // true if the person gave this name
        };
        std::vector<Made> files;
        if (arguments_.html) files.push_back({*arguments_.html, std::move(page)});
        if (arguments_.csv) {
            files.push_back({*arguments_.csv, report::results_csv(rows)});
            files.push_back({arguments_.csv->string() + "-metadata.json",
                             report::results_metadata(arguments_.csv->filename().string()), false});
        }
        if (arguments_.json) files.push_back({*arguments_.json, report::results_json(rows)});
        std::error_code ec;
        for (const Made& made : files)
            if (!arguments_.force && fs::exists(fs::symlink_status(made.path, ec)))
                return refuse({{}, 0, 0, phrase("export.exists", {{"file", made.path.string()}})});
        for (const Made& made : files) {
            const auto how = made.named ? write_named_file_atomically : write_file_atomically;
            if (const auto written = export_gate_.write(made.path, made.content, how); !written)
                return refuse(written.error());
            out_ << phrase("report.wrote", {{"file", made.path.string()}}) << '\n';
        }
        return 0;
    }

    const ReportArguments& arguments_;
    const LongWork& progress_;
    const learners::Learners learners_{core::user_data_folder()};
    learners::ExportGate export_gate_;
    std::ostream& out_;
    std::ostream& err_;
};

}  // namespace

int run_report(const ReportArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress) {
    return ReportCommand(arguments, progress, out, err).run();
}

}  // namespace handrail::program
