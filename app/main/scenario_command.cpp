#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>

#include "app/core/kept/side_file.h"
#include "app/core/scenario/scenario_run.h"
#include "app/core/session/headless_session.h"
#include "app/learners/export_gate.h"
#include "app/main/commands.h"
#include "app/main/transcript.h"
#include "app/main/world_files.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/markup.h"

namespace handrail::program {
namespace {

namespace fs = std::filesystem;

struct Outcome {
    std::string name;  // name of the scenario file
    std::string title;
    std::vector<std::string> failures;  // expectations that were not met; empty: all were met
    double virtual_s = 0.0;
};

// Returns the scenario files to run, sorted by name. Folders are searched, but not their subfolders. Fails if a path is
// neither a file nor a folder.
Result<std::vector<fs::path>> scenario_files(const std::vector<fs::path>& paths) {
    std::vector<fs::path> files;
    for (const fs::path& path : paths) {
        std::error_code ec;
        if (fs::is_directory(path, ec)) {
            std::vector<fs::path> inside;
            for (const auto& entry : fs::directory_iterator(path, ec))
                if (entry.path().extension() == ".toml") inside.push_back(entry.path());
            if (inside.empty()) return fail(phrase("program.no_scenarios"), path.filename().string());
            std::sort(inside.begin(), inside.end());
            files.insert(files.end(), inside.begin(), inside.end());
        } else if (fs::is_regular_file(path, ec)) {
            files.push_back(path);
        } else {
            return fail(phrase("program.no_such_scenario"), path.string());
        }
    }
    return files;
}

// Adds the sounds and sentences that the recording sinks received to `log`. The expectations are compared with `log`.
void note_heard(const sinks::RecordingAudio& audio, const sinks::RecordingSpeech& speech, core::SessionLog& log) {
    for (const sinks::HeardSound& sound : audio.sounds()) log.sounds.push_back({sound.time_s, sound.cue, false});
    for (const sinks::HeardSound& change : audio.loop_changes())
        log.sounds.push_back({change.time_s, change.cue, true});
    std::stable_sort(log.sounds.begin(), log.sounds.end(),
                     [](const core::LoggedSound& a, const core::LoggedSound& b) { return a.time_s < b.time_s; });
    for (const sinks::HeardSpeech& line : speech.lines()) log.lines.push_back({line.time_s, line.utterance.text});
}

// Writes the transcript to FOLDER/NAME.txt, in which NAME is the name of the scenario file.
Result<void> write_transcript(const fs::path& folder, const core::Scenario& scenario,
                              const learners::ExportGate& export_gate, const core::SessionLog& log) {
    const fs::path file = folder / scenario.file.filename().replace_extension(".txt");
    return export_gate.write(file, transcript(log), write_file_atomically);
}

Outcome run_one(const core::Scenario& scenario, const learners::ExportGate& export_gate,
                const ScenarioArguments& arguments) {
    Outcome outcome{scenario.file.filename().string(), scenario.title, {}, 0.0};
    core::WorldRequest request = scenario.world;
    const CommonArguments& common = arguments.common;
    if (!request.unit_m) request.unit_m = common.unit_m;
    if (!request.map_scale_m_per_unit) request.map_scale_m_per_unit = common.map_scale_m_per_unit;
    if (request.building.empty()) request.building = common.building;
    auto scene = imported_scene(request);
    if (!scene) {
        outcome.failures.push_back(scene.error().sentence());
        return outcome;
    }
    const auto shared = std::make_shared<const Scene>(std::move(*scene));
    sinks::RecordingAudio audio;
    sinks::RecordingSpeech speech;
    auto log = core::run_scenario(scenario, shared, audio, speech, {imported_scene, toml_next_to_worlds()});
    if (!log) {
        outcome.failures.push_back(log.error().sentence());
        return outcome;
    }
    note_heard(audio, speech, *log);
    outcome.virtual_s = log->end_s;
    outcome.failures = core::failures(scenario, *log, *log->scene);
    if (arguments.transcripts) {
        if (const auto written = write_transcript(*arguments.transcripts, scenario, export_gate, *log); !written)
            outcome.failures.push_back(written.error().sentence());
    }
    return outcome;
}

std::string junit_xml(const std::vector<Outcome>& outcomes) {
    const auto failed =
        std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return !o.failures.empty(); });
    std::string xml = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"handrail scenarios\" tests=\"{}\" "
        "failures=\"{}\">\n",
        outcomes.size(), failed);
    for (const Outcome& o : outcomes) {
        xml += fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", markup_text(o.name),
                           markup_text(o.title), o.virtual_s);
        if (o.failures.empty()) {
            xml += "/>\n";
            continue;
        }
        xml += ">\n";
        for (const std::string& failure : o.failures)
            xml += fmt::format("    <failure message=\"{}\"/>\n", markup_text(failure));
        xml += "  </testcase>\n";
    }
    return xml + "</testsuite>\n";
}

// Writes the JUnit file. Scenarios may come from recorded sessions, so the file belongs to all learners whose scenarios
// ran.
Result<void> write_junit(const fs::path& file, const std::string& xml,
                         const std::vector<learners::ExportGate>& export_gates) {
    Result<void> written = {};
    bool of_learners = false;
    for (const learners::ExportGate& export_gate : export_gates)
        if (written) written = export_gate.allows(file);
    for (const learners::ExportGate& export_gate : export_gates) {
        if (!written || !export_gate.learner()) continue;
        of_learners = true;
        written = export_gate.write(file, xml, write_named_file_atomically);
    }
    return of_learners || !written ? written : write_named_file_atomically(file, xml);
}

}  // namespace

int run_scenarios(const ScenarioArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress) {
    const auto files = scenario_files(arguments.paths);
    if (!files) {
        fmt::print(err, "{}\n", files.error().sentence());
        return 2;
    }
    // Read all files before running any scenario, so that no scenario has run if one of the files is bad.
    std::vector<core::Scenario> scenarios;
    std::vector<learners::ExportGate> export_gates;
    const learners::Learners learners(core::user_data_folder());
    for (const fs::path& file : *files) {
        auto scenario = core::read_scenario(file, {world_folder()});
        if (!scenario) {
            fmt::print(err, "{}\n", scenario.error().sentence());
            return 2;
        }
        auto export_gate = learners::ExportGate::of(learners, file);
        if (!export_gate) {
            fmt::print(err, "{}\n", export_gate.error().sentence());
            return 2;
        }
        scenarios.push_back(std::move(*scenario));
        export_gates.push_back(std::move(*export_gate));
    }
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        progress.at(phrase("progress.scenario", {{"title", scenarios[i].title}}));
        outcomes.push_back(run_one(scenarios[i], export_gates[i], arguments));
        progress.done();
        const Outcome& o = outcomes.back();
        fmt::print(out, "{}\n",
                   phrase(o.failures.empty() ? "program.scenario_holds" : "program.scenario_fails",
                          {{"title", o.title}, {"file", o.name}, {"seconds", o.virtual_s}}));
        for (const std::string& failure : o.failures) fmt::print(out, "  {}\n", failure);
        out.flush();
    }
    const auto failed =
        std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return !o.failures.empty(); });
    fmt::print(out, "{}\n",
               phrase("program.scenarios_hold",
                      {{"hold", outcomes.size() - static_cast<std::size_t>(failed)}, {"all", outcomes.size()}}));
    if (arguments.junit) {
        if (const auto written = write_junit(*arguments.junit, junit_xml(outcomes), export_gates); !written) {
            fmt::print(err, "{}\n", written.error().sentence());
            return 1;
        }
    }
    return failed == 0 ? 0 : 1;
}

}  // namespace handrail::program
