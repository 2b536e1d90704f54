#include "app/record/compute_again.h"

#include <unistd.h>

#include <algorithm>
#include <limits>
#include <set>

#include "app/core/kept/kept_groups.h"
#include "app/core/kept/labels.h"
#include "app/core/kept/made_doors.h"
#include "app/core/kept/side_file.h"
#include "app/core/session/session_driver.h"
#include "app/core/world/entering.h"
#include "app/record/json_fields.h"
#include "app/record/played_ears.h"
#include "app/record/played_hand.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/typist.h"

namespace handrail::record {
namespace {

namespace fs = std::filesystem;

// The last part of a file, of up to this length, may be missing if a recording was cut off.
constexpr double kLost_s = 0.6;

// A temporary folder for the files that the computed session saves. The destructor deletes it.
class Aside {
public:
    Aside() {
        std::string name = (fs::temp_directory_path() / "handrail-replay-XXXXXX").string();
        if (::mkdtemp(name.data())) path_ = name;
    }
    ~Aside() {
        std::error_code ec;
        if (!path_.empty()) fs::remove_all(path_, ec);
    }
    Aside(const Aside&) = delete;
    Aside& operator=(const Aside&) = delete;
    const fs::path& path() const { return path_; }

    // Makes a folder with a link to the world. If the person had made additions to the world, writes them to a file
    // next to the link.
    core::SideFile additions_of(const RecordedWorld& world) {
        const fs::path folder = path_ / std::to_string(++worlds_);
        std::error_code ec;
        fs::create_directories(folder, ec);
        const fs::path link = folder / world.request.file.filename();
        fs::create_symlink(world.request.file, link, ec);
        fs::path file = link;
        file += ".handrail.toml";
        if (!world.additions.empty()) (void)write_file_atomically(file, world.additions);
        return core::SideFile::of_world(link, {});
    }

private:
    fs::path path_;
    int worlds_ = 0;
};

template <class T>
T field(const Json& json, const char* key, T otherwise) {
    const auto at = json.find(key);
    if (at == json.end()) return otherwise;
    if constexpr (std::is_same_v<T, std::string>) return at->is_string() ? at->get<T>() : otherwise;
    else return at->is_number_unsigned() ? at->get<T>() : otherwise;
}

std::set<std::uint64_t> numbers_that_came(const Recording& recording) {
    std::set<std::uint64_t> came;
    for (const RecordedLine& line : recording.lines)
        if (line.is == "came") came.insert(field<std::uint64_t>(Json::parse(line.json, nullptr, false), "number", 0));
    return came;
}

class Player {
public:
    Player(const Recording& recording, const core::WorldReader& read)
        : recording_(recording),
          read_(read),
          arrivals_(numbers_that_came(recording)),
          bodies_(recording, [this](std::size_t which) { return (which == 0 ? right_ : left_).step(); }),
          app_(recording.head.settings, core::HandFacts{}, options()),
          right_(recording.hands[0], 0, bodies_),
          left_(recording.hands[1], 1, bodies_),
          ears_(recording.head.settings, recording.head.begun_s) {
        for (const RecordedLine& line : recording.lines) {
            if (line.is != "sink_news") continue;
            const Json json = Json::parse(line.json, nullptr, false);
            ears_.hear_of(field<std::uint64_t>(json, "step", 0), field<std::string>(json, "from", "") == "voice",
                          field<std::string>(json, "text", ""));
        }
    }

    ~Player() {
        bodies_.close();
        speak_to(spoken_to_);
    }
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    Result<ComputedAgain> play() {
        for (const RecordedLine& line : recording_.lines) {
            auto goes_on = take(line);
            if (!goes_on) return tl::unexpected(goes_on.error());
            if (!*goes_on) break;
        }
        if (!stopped_)
            while (frames_ < recording_.frames.size() && frame()) hear();
        if (bodies_.failed() && !stopped_) stop();
        flush();
        hear();
        if (recording_.ended && !stopped_) ears_.finish();
        again_.said = ears_.said();
        again_.cut = again_.cut || !recording_.ended;
        again_.until_s = until_s_;
        again_.ticks = right_.ticks() + left_.ticks();
        again_.other_forces = right_.other_forces() + left_.other_forces();
        return std::move(again_);
    }

private:
    Result<core::EnteringWorld> ready_world(const RecordedWorld& world) const {
        const auto scene = read_recorded_scene(world, read_);
        if (!scene) return tl::unexpected(scene.error());
        return core::make_ready_to_touch(*scene);
    }

    core::SessionOptions options() {
        const bool threads = !recording_.head.virtual_time;
        core::SessionOptions options{.executor = threads ? on_threads() : at_once(),
                                     .records_in = aside_.path(),
                                     .languages_in = {},
                                     .bodies = {},
                                     .arrivals = threads ? &arrivals_ : nullptr};
        if (bodies_.recorded())
            options.bodies.played = [this](std::shared_ptr<const render::DynamicsScene> scene, double begin_s) {
                return bodies_.make(std::move(scene), begin_s);
            };
        return options;
    }

    // Applies the next line of the recording to the computed session. Returns false if the computation cannot continue.
    Result<bool> take(const RecordedLine& line) {
        const bool of_ears = line.is == "ears_settings" || line.is == "ears_two_hands" || line.is == "ears_stand_in";
        const bool is_one =
            is_input(line.is) || of_ears || line.is == "handed_over" || line.is == "set_up" || line.is == "left_off";
        if (line.is == "acts_by") {
            const auto who = field<std::uint64_t>(Json::parse(line.json, nullptr, false), "number", 0);
            speak_to(who == 1 ? ActsBy::TerminalKeys : who == 2 ? ActsBy::Lines : ActsBy::WindowKeys);
        }
        if (line.is == "lost_rows") again_.remarks.push_back(phrase("replay.lost_rows"));
        if (!is_one) return true;
        const Json json = Json::parse(line.json, nullptr, false);
        const auto before = field<std::uint64_t>(json, "frame", 0);
        while (frames_ < before) {
            if (!frame()) return stop();
            hear();
        }
        if (line.is == "set_up" || line.is == "left_off") {
            if (line.is == "set_up") again_.remarks.push_back(phrase("replay.set_up"));
            again_.cut = true;
            stopped_ = true;
            return false;
        }
        if (line.is == "ears_settings") ears_.set_settings(app_.settings());
        else flush();
        const bool yes = field<std::uint64_t>(json, "number", 0) != 0;
        if (line.is == "ears_two_hands") ears_.set_two_hands(yes);
        if (line.is == "ears_stand_in") ears_.set_hand_stands_in(yes);
        if (line.is == "handed_over") driver_.hand_over();
        if (is_input(line.is))
            if (auto taken = take_input(line); !taken) return tl::unexpected(taken.error());
        if (bodies_.failed()) return stop();
        hear();
        return true;
    }

    // Stops the computation. If the recording was ended properly, adds a remark that rows are missing. Always returns
    // false.
    bool stop() {
        if (recording_.ended) again_.remarks.push_back(phrase("replay.rows_missing"));
        stopped_ = true;
        return false;
    }

    Result<void> take_input(const RecordedLine& line) {
        auto input = read_input_line(line.json);
        if (!input) return fail(input.error().message, "events.jsonl", line.line);
        if (auto* entered = std::get_if<core::WorldEntered>(&input->input)) {
            auto world = ready_world(input->world);
            if (!world) return tl::unexpected(world.error());
            if (world->moves_freely && !bodies_.recorded()) again_.remarks.push_back(phrase("replay.free_bodies"));
            entered->world = std::move(*world);
            if (input->world.has_additions) entered->additions = aside_.additions_of(input->world);
        }
        if (const auto* hand = std::get_if<core::HandChanged>(&input->input))
            driver_.drive(0, right_.change(hand->hand));
        if (const auto* hand = std::get_if<core::LeftHandChanged>(&input->input))
            driver_.drive(1, left_.change(hand->hand));
        app_.apply(std::move(input->input), input->now_s);
        return {};
    }

    // Computes one tick of the session; `flush` later hands over the results of that tick. Returns false if the
    // recording has no such tick, or if the tick read something that cannot be computed.
    bool frame() {
        flush();
        if (frames_ >= recording_.frames.size()) return false;
        const FrameRow& row = recording_.frames[frames_];
        if (!right_.run_to(row.tick) || !left_.run_to(row.left_tick)) return false;
        ++frames_;
        bodies_.session_reads(row);
        app_.tick(row.now_s, right_.tool(), left_.tool());
        if (bodies_.failed()) return false;
        until_s_ = row.now_s - recording_.head.begun_s;
        to_hand_over_ = true;
        return true;
    }

    void flush() {
        if (std::exchange(to_hand_over_, false)) driver_.hand_over();
    }

    // Computes the next steps of the ears, until one lacks an item or a contact that it read during the recording.
    void hear() {
        while (cues_ < recording_.cues.size()) {
            const CueRow& row = recording_.cues[cues_];
            if (row.posts > ears_.posted() || !right_.run_to_events(row.contacts) ||
                !left_.run_to_events(row.left_contacts))
                return;
            std::vector<servo::ContactEvent> contacts = right_.take_events(row.contacts);
            for (const servo::ContactEvent& event : left_.take_events(row.left_contacts)) contacts.push_back(event);
            ears_.step(row, std::move(contacts));
            ++cues_;
        }
    }

    const ActsBy spoken_to_ = spoken_to();
    const Recording& recording_;
    const core::WorldReader& read_;
    Aside aside_;
    Arrivals arrivals_;
    PlayedBodies bodies_;
    core::Session app_;
    PlayedHand right_, left_;
    PlayedEars ears_;
    // `take_settings` does nothing here: lines of the recording say when the ears received the settings, and take()
    // applies them.
    core::SessionDriver driver_{
        app_, ears_, {.ticked = {}, .take_settings = [](auto) { return false; }, .hands_over = {}, .look_at_cues = {}}};
    ComputedAgain again_;
    std::size_t frames_ = 0, cues_ = 0;
    bool to_hand_over_ = false, stopped_ = false;
    double until_s_ = 0.0;
};

}  // namespace

Result<std::shared_ptr<const Scene>> read_recorded_scene(const RecordedWorld& world, const core::WorldReader& read) {
    auto scene = read.scene(world.request);
    if (!scene) return tl::unexpected(scene.error());
    if (!world.checksum.empty() && core::SideFile::checksum_of_world(world.request.file) != world.checksum)
        return fail(phrase("replay.other_world"), world.request.file.string());
    return std::make_shared<const Scene>(
        core::with_labels(core::with_groups(with_made_doors(std::move(*scene), core::made_doors_in(world.additions)),
                                            core::groups_in(world.additions)),
                          core::labels_in(world.additions)));
}

Result<ComputedAgain> compute_again(const Recording& recording, const core::WorldReader& read) {
    if (recording.head.language != spoken_language())
        return fail(phrase("replay.other_language", {{"language", recording.head.language}}));
    return Player(recording, read).play();
}

std::optional<LineDifference> first_difference(const Recording& recording, const ComputedAgain& again) {
    const std::vector<SaidLine> said = said_lines(recording);
    const double sure_s = again.cut ? again.until_s - kLost_s : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::max(said.size(), again.said.size()); ++i) {
        const bool both = i < said.size() && i < again.said.size();
        if (both && said[i].text == again.said[i].text && said[i].speech_class == again.said[i].speech_class &&
            said[i].voiced == again.said[i].voiced)
            continue;
        // If a recording was cut off, one of its files may contain later times than another. So do not compare the
        // lines near the end of the recording.
        if ((i < said.size() ? said[i].t_s : again.said[i].t_s) > sure_s) break;
        return LineDifference{i, i < said.size() ? said[i].text : "", i < again.said.size() ? again.said[i].text : ""};
    }
    return std::nullopt;
}

}  // namespace handrail::record
