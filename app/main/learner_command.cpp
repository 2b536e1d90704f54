#include <algorithm>
#include <array>
#include <string>

#include "app/core/kept/last_place.h"
#include "app/core/kept/side_file.h"
#include "app/core/learning/diary.h"
#include "app/learners/export_gate.h"
#include "app/learners/forget.h"
#include "app/learners/learners.h"
#include "app/main/commands.h"
#include "settings/settings.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestSideFile_bytes = std::size_t{16} << 20;

std::string purpose_words(learners::Purpose purpose) {
    if (purpose == learners::Purpose::Remember) return phrase("learner.remember");
    return phrase(purpose == learners::Purpose::Record ? "learner.record" : "learner.share");
}

// Runs the command once. The object has the list of learners, the person who is asked, and the answers.
class LearnerCommand {
public:
    LearnerCommand(const LearnerArguments& arguments, const LongWork& progress, std::istream& in, std::ostream& out,
                   std::ostream& err)
        : arguments_(arguments),
          progress_(progress),
          learners_(core::user_data_folder()),
          in_(in),
          out_(out),
          err_(err) {}

    int run() {
        const std::string& action = arguments_.action;
        if (action == "list") return list();
        if (action == "new") return make();
        constexpr std::array<const char*, 6> kActions = {"list", "new", "show", "consent", "diary", "delete"};
        if (std::find(kActions.begin(), kActions.end(), action) == kActions.end()) {
            const std::vector<std::string> actions(kActions.begin(), kActions.end());
            return refuse(phrase("learner.no_action", {{"word", action}, {"nearest", nearest_name(action, actions)}}),
                          2);
        }
        if (arguments_.name.empty()) return refuse(phrase("learner.needs_name", {{"action", action}}), 2);
        if (action == "diary") return diary();
        return action == "show" ? show() : action == "consent" ? consent() : remove();
    }

private:
    int refuse(const std::string& sentence, int status) {
        err_ << one_line(sentence) << '\n';
        return status;
    }
    int refuse(const Error& error, int status = 1) { return refuse(error.sentence(), status); }

    // Asks a question. Returns false if the answer is no or nobody answers.
    bool agreed(const std::string& question) {
        if (arguments_.yes) return true;
        out_ << question << ' ' << phrase("learner.yes_or_no") << std::endl;
        std::string line;
        std::getline(in_, line);
        const auto answer = core::good_name(line);
        return answer && lower_ascii(*answer) == phrase("learner.yes");
    }

    int list() {
        const learners::Learners::Found found = learners_.all();
        for (const Error& fault : found.faults) err_ << fault.sentence() << '\n';
        if (found.learners.empty()) out_ << phrase("learner.none") << '\n';
        for (const learners::Learner& one : found.learners)
            out_ << phrase("learner.listed",
                           {{"name", one.name},
                            {"purposes", learners::agreed_words(one, learners::today())},
                            {"recordings", learners::holdings_of(learners_.folder_of(one.id)).recordings}})
                 << '\n';
        return found.faults.empty() ? 0 : 1;
    }

    int make() {
        if (arguments_.name.empty()) {
            out_ << phrase("learner.offered", {{"name", learners_.offer()}}) << '\n';
            return 0;
        }
        if (!purposes(arguments_.give)) return 2;
        if (learners::may_be_real(arguments_.name) &&
            !agreed(phrase("learner.real_name", {{"name", arguments_.name}, {"offer", learners_.offer()}})))
            return refuse(phrase("learner.not_made"), 1);
        // The new learner's settings begin as a copy of the user's own settings, because the learner uses the same
        // device and voice.
        std::error_code ec;
        std::string settings;
        if (const fs::path own = settings::user_settings_path(); fs::exists(own, ec))
            if (const auto text = read_whole_file(own)) settings = *text;
        const auto made = learners_.make(arguments_.name, settings);
        if (!made) return refuse(made.error());
        if (!arguments_.give.empty()) return consent();
        out_ << phrase("learner.made", {{"name", made->name}}) << '\n';
        return 0;
    }

    int show() {
        const auto learner = learners_.find(arguments_.name);
        if (!learner) return refuse(learner.error());
        print_facts(*learner);
        const learners::Holdings holdings = learners::holdings_of(learners_.folder_of(learner->id));
        for (const Error& fault : holdings.faults) err_ << fault.sentence() << '\n';
        out_ << phrase("learner.holds", {{"recordings", holdings.recordings},
                                         {"worlds", holdings.worlds},
                                         {"files", holdings.exported.size() + holdings.exported_other.size()}})
             << '\n'
             << phrase("learner.id", {{"folder", learners_.folder_of(learner->id).string()}}) << '\n';
        return 0;
    }

    void print_facts(const learners::Learner& learner) {
        if (!learner.created.empty())
            out_ << phrase("learner.created", {{"name", learner.name}, {"day", learner.created}}) << '\n';
        for (const learners::Purpose purpose : learners::kPurposes) {
            const auto& given = learner.consent(purpose);
            const TextValue name{"name", learner.name};
            const std::string what = purpose_words(purpose);
            const TextValue is{"purpose", what};
            if (!given) out_ << phrase("learner.consent_not", {name, is}) << '\n';
            else if (!learner.allows(purpose, learners::today()))
                out_ << phrase("learner.consent_over", {name, is, {"until", given->until}}) << '\n';
            else
                out_ << phrase("learner.consents",
                               {name,
                                is,
                                {"day", given->given},
                                {"by", given->by.empty() ? std::string("none") : given->by},
                                {"until", given->until.empty() ? std::string("none") : given->until}})
                     << '\n';
        }
    }

    // Parses purposes such as "remember,record". If one of them is unknown, reports wrong usage and returns nothing.
    std::optional<std::vector<learners::Purpose>> purposes(const std::string& words) {
        std::vector<learners::Purpose> all;
        for (std::size_t at = 0; at < words.size();) {
            const std::size_t end = std::min(words.find(',', at), words.size());
            const auto purpose = learners::purpose_named(std::string_view(words).substr(at, end - at));
            if (!purpose) {
                refuse(phrase("learner.no_purpose", {{"word", one_line(words.substr(at, end - at))}}), 2);
                return std::nullopt;
            }
            all.push_back(*purpose);
            at = end + 1;
        }
        return all;
    }

    int consent() {
        const auto given = purposes(arguments_.give), withdrawn = purposes(arguments_.withdraw);
        if (!given || !withdrawn) return 2;
        if (given->empty() && withdrawn->empty()) return refuse(phrase("learner.consent_nothing"), 2);
        if (!arguments_.until.empty() && !learners::is_day(arguments_.until))
            return refuse(phrase("learner.bad_day", {{"word", one_line(arguments_.until)}}), 2);
        if (!arguments_.until.empty() && arguments_.until < learners::today())
            return refuse(phrase("learner.until_over", {{"day", arguments_.until}}), 2);
        const auto learner = learners_.find(arguments_.name);
        if (!learner) return refuse(learner.error());
        const auto changed = learners_.change(learner->id, [&](learners::Learner& one) {
            for (const learners::Purpose purpose : *given)
                one.consent(purpose) = learners::Consent{learners::today(), one_line(arguments_.by), arguments_.until};
            for (const learners::Purpose purpose : *withdrawn) one.consent(purpose).reset();
        });
        if (!changed) return refuse(changed.error());
        print_facts(*changed);
        return 0;
    }

    // Writes the diaries of all worlds as one table. A learner who has not agreed to share gets no such file outside
    // the learner's own folder.
    int diary() {
        if (arguments_.to.empty()) return refuse(phrase("learner.diary_needs_file"), 2);
        const auto learner = learners_.find(arguments_.name);
        if (!learner) return refuse(learner.error());
        const auto gate = learners::ExportGate::of(learners_, *learner);
        if (const auto allowed = gate.allows(arguments_.to); !allowed) return refuse(allowed.error());
        std::error_code ec;
        if (fs::exists(fs::symlink_status(arguments_.to, ec)))
            return refuse(phrase("export.exists", {{"file", arguments_.to.string()}}), 1);
        std::vector<fs::path> files;
        for (fs::directory_iterator at(learners_.folder_of(learner->id) / "worlds", ec), end; !ec && at != end;
             at.increment(ec))
            files.push_back(at->path());
        std::sort(files.begin(), files.end());
        std::string table = "world,day,room,seconds,walls_percent,floor_percent\r\n";
        std::size_t visits = 0;
        for (const fs::path& file : files) {
            const auto text = read_whole_file(file, kLongestSideFile_bytes);
            if (!text) return refuse(text.error());
            const std::vector<core::DiaryEntry> entries = core::diary_in(*text);
            // The name of the file is that of the world with a checksum and an ending.
            const std::string name = file.filename().string();
            table += core::diary_csv(name.substr(0, name.rfind('-')), entries);
            visits += entries.size();
        }
        if (const auto written = gate.write(arguments_.to, table, write_named_file_atomically); !written)
            return refuse(written.error());
        out_ << phrase("learner.diary_written", {{"file", arguments_.to.string()}, {"count", visits}}) << '\n';
        return 0;
    }

    int remove() {
        const std::string id = learners_.id_of(arguments_.name);
        const auto learner = learners_.find(arguments_.name);
        if (id.empty()) return refuse(learner.error());
        if (!learner) err_ << learner.error().sentence() << '\n';
        const std::string name = learner ? learner->name : id;
        const fs::path folder = learners_.folder_of(id);
        const learners::Holdings holdings = learners::holdings_of(folder);
        for (const Error& fault : holdings.faults) err_ << fault.sentence() << '\n';
        out_ << phrase("learner.goes", {{"name", name},
                                        {"recordings", holdings.recordings},
                                        {"worlds", holdings.worlds},
                                        {"files", holdings.exported.size()}})
             << '\n';
        for (const fs::path& file : holdings.exported)
            out_ << phrase("learner.goes_file", {{"file", file.string()}}) << '\n';
        for (const fs::path& file : holdings.exported_other)
            out_ << phrase("learner.stays_file", {{"file", file.string()}}) << '\n';
        if (!agreed(phrase("learner.delete_asked", {{"name", name}}))) return refuse(phrase("learner.delete_not"), 1);
        if (const auto deleted = learners::delete_learner(folder, holdings); !deleted) return refuse(deleted.error());
        out_ << phrase("learner.deleted", {{"name", name}}) << '\n';
        return search({id, learner ? learner->name : std::string()}, holdings.exported_other);
    }

    // Searches for what is left of a deleted learner: files that contain the learner's name or id, and exported files
    // that somebody has changed since Handrail wrote them.
    int search(const std::array<std::string, 2>& words, const std::vector<fs::path>& changed) {
        std::vector<fs::path> folders = {core::user_data_folder(), settings::user_settings_path().parent_path()};
        if (const fs::path sessions = core::sessions_folder(); !sessions.empty())
            folders.push_back(sessions.parent_path());
        std::erase_if(folders, [](const fs::path& folder) { return folder.empty(); });
        progress_.at(phrase("progress.search"));
        learners::Search left = learners::search_for(words, folders);
        for (const fs::path& file : changed)
            if (std::find(left.hits.begin(), left.hits.end(), file) == left.hits.end()) left.hits.push_back(file);
        progress_.done();
        for (const fs::path& file : left.unread)
            err_ << one_line(phrase("learner.unread", {{"file", file.string()}})) << '\n';
        if (left.hits.empty()) {
            out_ << phrase("learner.nothing_left", {{"files", left.files}}) << '\n';
            return left.unread.empty() ? 0 : 1;
        }
        out_ << phrase("learner.left", {{"count", left.hits.size()}}) << '\n';
        for (const fs::path& file : left.hits) out_ << phrase("learner.left_in", {{"file", file.string()}}) << '\n';
        return 1;
    }

    const LearnerArguments& arguments_;
    const LongWork& progress_;
    const learners::Learners learners_;
    std::istream& in_;
    std::ostream& out_;
    std::ostream& err_;
};

}  // namespace

int run_learner(const LearnerArguments& arguments, std::istream& in, std::ostream& out, std::ostream& err,
                const LongWork& progress) {
    return LearnerCommand(arguments, progress, in, out, err).run();
}

}  // namespace handrail::program
