#include "app/main/lesson_here.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/core/kept/side_file.h"
#include "app/learners/export_gate.h"
#include "app/learners/kept_results.h"
#include "app/learners/lesson_progress.h"
#include "app/main/world_files.h"
#include "app/teaching/run_words.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {
namespace {

namespace fs = std::filesystem;

constexpr double kTurn_s = 0.1;
constexpr std::size_t kMostLooked = 50;  // greatest number of lessons that are offered from one folder
constexpr std::string_view kEnding = ".lesson.toml";

// Returns the lesson files in a folder, sorted by name.
std::vector<fs::path> lessons_in(const fs::path& folder) {
    std::error_code ec;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, ec))
        if (entry.path().string().ends_with(kEnding)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// Returns the lesson files next to the world and in the person's own folder, each once.
std::vector<fs::path> lessons_near(const fs::path& world) {
    std::vector<fs::path> files;
    for (const fs::path& folder : {world.parent_path(), lessons_folder()}) {
        std::vector<fs::path> here = lessons_in(folder);
        if (here.size() > kMostLooked) here.resize(kMostLooked);
        for (fs::path& file : here)
            if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(std::move(file));
    }
    return files;
}

}  // namespace

void read_lessons_ahead(const fs::path& world, const std::stop_token& stop) {
    for (const fs::path& file : lessons_near(world))
        if (!stop.stop_requested()) (void)teaching::read_lesson(file, {world_folder()}, toml_next_to_worlds());
}

fs::path lessons_folder() { return core::user_data_folder("lessons"); }

Result<fs::path> lesson_given(const fs::path& word) {
    std::error_code ec;
    if (fs::exists(word, ec)) return word;
    std::string names;
    for (const fs::path& folder : {lessons_folder(), world_folder()})
        for (const fs::path& file : lessons_in(folder)) {
            const std::string full = file.filename().string(), name = full.substr(0, full.size() - kEnding.size());
            if (word == full || word == name) return file;
            names += names.empty() ? name : ", " + name;
        }
    if (names.empty()) return fail(phrase("teaching.no_lesson_at_all", {{"word", word.string()}}));
    return fail(phrase("teaching.no_lesson", {{"word", word.string()}, {"names", names}}));
}

Result<std::shared_ptr<teaching::TaughtWorld>> read_taught_world(const fs::path& file, core::RoomsKept* rooms_kept) {
    auto lesson = teaching::read_lesson(file, {world_folder()}, toml_next_to_worlds());
    if (!lesson) return tl::unexpected(lesson.error());
    auto scene = imported_scene({.file = lesson->world});
    if (!scene) return tl::unexpected(scene.error());
    const std::string checksum =
        lesson->world_checksum.empty() ? std::string() : core::SideFile::checksum_of_world(lesson->world);
    return teaching::TaughtWorld::find(std::move(*lesson), std::make_shared<const Scene>(std::move(*scene)), checksum,
                                       rooms_kept);
}

// Offers the lessons that can be taught in the current world.
void LessonHere::offer(double now_s) {
    const fs::path& world = worlds_.path();
    offered_.clear();
    core::TeacherActed act{core::TeacherActed::Kind::Offer, {}, {}, {}, 0.0};
    for (const fs::path& file : lessons_near(world)) {
        std::error_code ec;
        const auto lesson = teaching::read_lesson(file, {world_folder()}, toml_next_to_worlds());
        if (!lesson || !fs::equivalent(lesson->world, world, ec)) continue;
        offered_.push_back(file);
        std::vector<std::string> news;
        std::string title = lesson->title.spoken();
        if (arguments_.remember)
            title = phrase("teaching.offer_goes_on", {{"title", title},
                                                      {"number", next_session(arguments_, *lesson, news) + 1},
                                                      {"count", lesson->sessions.size()}});
        for (std::string& words : news) say_(std::move(words));
        act.items.push_back(std::move(title));
    }
    app_.apply(std::move(act), now_s);
}

std::size_t next_session(const ExploreArguments& arguments, const teaching::LessonFile& lesson,
                         std::vector<std::string>& news) {
    if (!arguments.remember || arguments.common.data_in.empty()) return 0;
    const auto taught = learners::session_taught(arguments.common.data_in, lesson.file);
    if (!taught) news.push_back(taught.error().sentence());
    return taught ? learners::session_behind(*taught, lesson.sessions.size()) : 0;
}

void LessonHere::begin(const LessonToTeach& lesson, double now_s) {
    close(now_s);
    taught_ = lesson;
    begun_s_ = now_s;
    begun_utc_ = learners::now_utc();
    worlds_.set_lesson_settings(teaching::conditions_of(lesson.world->lesson(), lesson.session), now_s);
    run_.emplace(teaching::begin_lesson(lesson.world, lesson.session, lesson.learner, app_));
    const teaching::LessonFile& file = lesson.world->lesson();
    const std::string title = teaching::one_after(
        phrase("desk_order.title", {{"lesson", file.title.spoken()},
                                    {"session", file.sessions[lesson.session].name},
                                    {"world", spoken_name(*lesson.world->scene())}}),
        lesson.learner.name.empty() ? std::string() : phrase("desk_order.learner", {{"name", lesson.learner.name}}));
    if (auto desk = teaching::DeskServer::open(teaching::desk_folder(), title)) desk_ = std::move(*desk);
    else say_(desk.error().sentence());
}

// Writes a lesson draft to the person's folder under a new name, so that existing files do not change.
void LessonHere::write_draft(double now_s) {
    const auto draft = app_.requests().take_lesson_draft();
    if (!draft) return;
    const fs::path& world = worlds_.path();
    teaching::LessonFile lesson = teaching::three_sessions(*draft, world);
    std::error_code ec;
    const fs::path folder = lessons_folder();
    if (!fs::equivalent(world_folder() / world.filename(), world, ec))
        lesson.world_name = teaching::named_from(folder, world);
    std::string stem;
    for (const char c : lower_ascii(draft->title))
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) stem += c;
        else if (!stem.empty() && stem.back() != '-') stem += '-';
    while (stem.ends_with('-')) stem.pop_back();
    if (stem.empty()) stem = "lesson";
    fs::create_directories(folder, ec);  // ignore a failure: writing the file then fails, too, with the reason
    fs::path file = folder / (stem + ".lesson.toml");
    for (int number = 2; fs::exists(file, ec); ++number) file = folder / fmt::format("{}-{}.lesson.toml", stem, number);
    // The draft may contain a learner's own marks and routes, and this folder is outside the learner's folder. So write
    // the draft through an ExportGate, which checks that the learner agreed to share.
    const fs::path& data = arguments_.common.data_in;
    const auto export_gate =
        learners::ExportGate::of(learners::Learners(core::user_data_folder()), data.empty() ? folder : data);
    const auto written = folder.empty() ? fail(phrase("files.no_home"))
                         : export_gate  ? export_gate->write(file, teaching::lesson_text(lesson), write_file_atomically)
                                        : tl::unexpected(export_gate.error());
    app_.apply(core::Announcement{written ? phrase("prepare.saved", {{"title", draft->title}, {"file", file.string()}})
                                          : written.error().sentence(),
                                  cues::SpeechClass::Answer},
               now_s);
    if (written) offer(now_s);
}

// Reads the lesson that the person chose from the list, and its world. Then starts the lesson.
void LessonHere::begin_chosen(double now_s) {
    if (const auto chosen = app_.requests().take_lesson(); chosen && *chosen < offered_.size() && !looked_for_.busy())
        looked_for_.begin([lesson = offered_[*chosen]](const std::stop_token&) { return read_taught_world(lesson); });
    const auto looked = looked_for_.take();
    if (!looked) return;
    if (const Result<std::shared_ptr<teaching::TaughtWorld>>& found = *looked) {
        std::vector<std::string> news;  // unused, because these sentences were announced when the lesson was offered
        const std::size_t session = next_session(arguments_, (*found)->lesson(), news);
        begin({*found, session, teaching::learner_named(arguments_.learner)}, now_s);
    } else app_.apply(core::Announcement{found.error().sentence(), cues::SpeechClass::Answer}, now_s);
}

void LessonHere::listen_to_desk(double now_s) {
    if (!desk_) return;
    for (const std::string& order : desk_->take_orders()) desk_->send(teaching::carry_out_order(*run_, order, now_s));
    if (now_s - summary_sent_s_ < teaching::TeachingRun::kSummary_s) return;
    summary_sent_s_ = now_s;
    desk_->send(run_->summary());
}

void LessonHere::turn(bool speaking, double now_s) {
    if (app_.world().entered == 0) return;
    if (world_ != app_.world().entered) {
        world_ = app_.world().entered;
        close(now_s);
        offer(now_s);
        if (arguments_.lesson && !began_) begin(*arguments_.lesson, now_s);
        began_ = true;
    }
    write_draft(now_s);
    begin_chosen(now_s);
    if (!run_ || now_s - turned_s_ < kTurn_s) return;
    turned_s_ = now_s;
    listen_to_desk(now_s);
    teaching::teach_on(*run_, app_, std::exchange(events_, {}), now_s, speaking);
    if (!run_->over()) return;
    close(now_s);
    offer(now_s);
}

// If the learner agreed to be remembered, stores the learner's progress and the results of the lesson. Does not store
// the results if the session is recorded, because the recording contains them.
void LessonHere::close(double now_s) {
    if (run_ && arguments_.remember && !arguments_.common.data_in.empty()) {
        const std::filesystem::path& folder = arguments_.common.data_in;
        const teaching::LessonFile& lesson = taught_.world->lesson();
        if (run_->finished())
            if (const auto noted = learners::note_session_taught(folder, lesson.file, taught_.session + 1); !noted)
                say_(noted.error().sentence());
        if (!arguments_.record_in && !run_->results().empty()) {
            learners::KeptResults results{
                begun_utc_, lesson.title.spoken(), spoken_name(*taught_.world->scene()), now_s - begun_s_, {}};
            for (const teaching::TaskResult& one : run_->results())
                results.tasks.push_back({one.ended_s - begun_s_,
                                         teaching::kStepWords.at(static_cast<std::size_t>(one.kind)), one.name,
                                         one.measures});
            if (const auto kept = learners::keep_results(folder, results); !kept) say_(kept.error().sentence());
        }
    }
    if (run_) worlds_.set_lesson_settings({}, now_s);
    run_.reset();
    desk_.reset();
}

void LessonHere::end(double now_s) { close(now_s); }

void LessonHere::see(const std::vector<core::SessionEvent>& events) {
    if (run_) events_.insert(events_.end(), events.begin(), events.end());
}

}  // namespace handrail::program
