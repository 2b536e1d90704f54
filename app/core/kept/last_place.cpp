#include "app/core/kept/last_place.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ctime>
#include <limits>
#include <sstream>
#include <vector>

#include "app/core/kept/background_writer.h"
#include "app/core/kept/crash_notes.h"
#include "app/core/kept/folder_lock.h"
#include "app/core/kept/world_shelf.h"
#include "settings/parse_toml.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLongest_bytes = 64 * 1024;
constexpr std::string_view kLock = ".lock", kPlace = ".toml", kReport = ".report", kSignal = ".signal";
constexpr std::size_t kMostReports = 5;
constexpr double kMoved_m = 0.05, kTurned_rad = 0.02;
constexpr std::size_t kMostLooked = 1000;
constexpr double kLockWait_s = 1.0;

bool lock(const Descriptor& file) { return file.get() >= 0 && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0; }

fs::path with(fs::path base, std::string_view ending) {
    base += ending;
    return base;
}

}  // namespace

std::string text_of(const LastPlace& place) {
    toml::table table{{"world", place.world.file.string()},
                      {"feet_m", toml::array{place.feet_m.x, place.feet_m.y, place.feet_m.z}},
                      {"heading_rad", place.heading_rad}};
    if (!place.world.building.empty()) table.insert("building", place.world.building);
    if (place.world.map_scale_m_per_unit) table.insert("map_scale_m_per_unit", *place.world.map_scale_m_per_unit);
    if (place.world.unit_m) table.insert("unit_m", *place.world.unit_m);
    std::ostringstream out;
    out.exceptions(std::ios::badbit);
    out << toml::toml_formatter{table, toml::format_flags::none} << "\n";
    return out.str();
}

Result<LastPlace> read_last_place(const std::string& text) {
    toml::table table;
    try {
        table = settings::parse_toml(text);
    } catch (const toml::parse_error&) {
        return fail(phrase("last_place.damaged"));
    }
    LastPlace place;
    place.world.file = table["world"].value_or(std::string());
    place.world.building = table["building"].value_or(std::string());
    place.world.map_scale_m_per_unit = table["map_scale_m_per_unit"].value<double>();
    place.world.unit_m = table["unit_m"].value<double>();
    place.heading_rad = table["heading_rad"].value_or(std::numeric_limits<double>::quiet_NaN());
    const toml::array* feet = table["feet_m"].as_array();
    const auto is_unit = [](const std::optional<double>& m) { return !m || (std::isfinite(*m) && *m > 0.0); };
    bool good = place.world.file.is_absolute() && is_unit(place.world.map_scale_m_per_unit) &&
                is_unit(place.world.unit_m) && std::isfinite(place.heading_rad) && feet && feet->size() == 3;
    for (glm::length_t i = 0; good && i < 3; ++i) {
        place.feet_m[i] = (*feet)[static_cast<std::size_t>(i)].value_or(std::numeric_limits<double>::quiet_NaN());
        good = std::isfinite(place.feet_m[i]);
    }
    if (!good) return fail(phrase("last_place.damaged"));
    return place;
}

struct SessionTrace::State {
    fs::path own;  // path of this session's files, without extension; empty: nothing is saved
    std::optional<Descriptor> held;
    BackgroundWriter writer{on_threads()}, report_writer{on_threads()};
    fs::path report;
    double next_report_s = -std::numeric_limits<double>::infinity();
    bool crashed = false;
    std::optional<LastPlace> left_at, kept;
    double next_s = -std::numeric_limits<double>::infinity();

    // Removes all files of a session, including a temporary file that the session was writing when it crashed.
    static void clear(const fs::path& lock_file) {
        const std::string stem = lock_file.stem().string() + ".";
        std::error_code ec;
        std::vector<fs::path> files;
        for (fs::directory_iterator it(lock_file.parent_path(), ec), end; !ec && it != end; it.increment(ec))
            if (it->path().filename().string().starts_with(stem)) files.push_back(it->path());
        for (const fs::path& file : files) fs::remove(file, ec);
    }

    // Turns the files of a crashed session into a permanent report. The name of the report is the time of the session's
    // last note, so that names sort by time. Only the newest few reports are kept.
    static fs::path keep_report(const fs::path& lock_file) {
        const auto beside = [&](std::string_view ending) {
            return with(fs::path(lock_file).replace_extension(), ending);
        };
        auto text = read_whole_file(beside(kReport), kLongest_bytes);
        if (!text) return {};
        const std::string signal = read_whole_file(beside(kSignal), kLongest_bytes).value_or("");
        int number = 0;
        std::from_chars(signal.data(), signal.data() + signal.size(), number);
        struct stat about {};
        if (::stat(beside(kReport).c_str(), &about) != 0) return {};
        std::tm local{};
        ::localtime_r(&about.st_mtime, &local);
        std::array<char, 32> name{};
        std::strftime(name.data(), name.size(), "%Y-%m-%d-%H%M%S.txt", &local);
        const fs::path folder = lock_file.parent_path().parent_path() / "crash-reports";
        std::error_code ec;
        fs::create_directories(folder, ec);
        fs::permissions(folder, fs::perms::owner_all, ec);
        *text = phrase("crash_report.title") + ".\n" + spoken_end(number) + "\n" + *text;
        if (const std::size_t places = signal.find('\n'); places != std::string::npos)
            *text += signal.substr(places + 1);
        if (ec || !write_file_atomically(folder / name.data(), *text)) return {};
        fs::permissions(folder / name.data(), fs::perms::owner_read | fs::perms::owner_write, ec);
        std::vector<fs::path> all;
        for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
            if (it->path().extension() == ".txt") all.push_back(it->path());
        std::sort(all.begin(), all.end());
        for (std::size_t i = 0; i + kMostReports < all.size(); ++i) fs::remove(all[i], ec);
        return folder / name.data();
    }

    // Examines and removes the files of sessions that are no longer running.
    void look(const fs::path& folder) {
        std::error_code ec;
        std::vector<fs::path> locks;
        for (fs::directory_iterator it(folder, ec), end; !ec && it != end && locks.size() < kMostLooked;
             it.increment(ec))
            if (it->path().extension() == kLock) locks.push_back(it->path());
        fs::file_time_type latest = fs::file_time_type::min();
        for (const fs::path& path : locks) {
            const Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
            if (!lock(file)) continue;  // This session is still running.
            crashed = true;
            if (fs::path kept_report = keep_report(path); kept_report > report) report = std::move(kept_report);
            fs::path place = path;
            place.replace_extension(kPlace);
            const auto written = fs::last_write_time(place, ec);
            if (const auto at = read_whole_file(place, kLongest_bytes).and_then(read_last_place);
                !ec && at && written >= latest) {
                left_at = *at;
                latest = written;
            }
            clear(path);
        }
    }

    void begin(const fs::path& folder) {
        std::string name = (folder / "session-XXXXXX").string() + std::string(kLock);
        const int file = ::mkostemps(name.data(), static_cast<int>(kLock.size()), O_CLOEXEC);
        if (file < 0) return;
        held.emplace(file);
        if (!lock(*held)) {
            ::unlink(name.c_str());
            held.reset();
            return;
        }
        own = fs::path(name).replace_extension();
        // Keeps the place of the crashed session until this session has a place of its own, so that another crash
        // before that does not lose it.
        if (left_at && write_file_atomically(with(own, kPlace), text_of(*left_at))) kept = left_at;
    }
};

SessionTrace::SessionTrace(const fs::path& folder) : state_(std::make_unique<State>()) {
    if (folder.empty()) return;
    std::error_code ec;
    fs::create_directories(folder, ec);
    // The lock prevents two sessions from starting at the same time. Otherwise one session could find a file of the
    // other before that file is locked, and take it for a crashed session.
    const FolderLock all(folder, kLockWait_s);
    if (!all.held()) return;
    state_->look(folder);
    state_->begin(folder);
}

SessionTrace::~SessionTrace() = default;

bool SessionTrace::crashed() const { return state_->crashed; }
const std::optional<LastPlace>& SessionTrace::left_at() const { return state_->left_at; }
const fs::path& SessionTrace::report() const { return state_->report; }

bool SessionTrace::note_report(const std::string& text, double now_s) {
    State& s = *state_;
    if (s.own.empty() || now_s < s.next_report_s || s.report_writer.busy()) return false;
    s.next_report_s = now_s + kEvery_s;
    s.report_writer.write(with(s.own, kReport), text);
    return true;
}

fs::path SessionTrace::signal_file() const { return state_->own.empty() ? fs::path() : with(state_->own, kSignal); }

void SessionTrace::note(const LastPlace& now, double now_s) {
    State& s = *state_;
    if (s.own.empty() || now_s < s.next_s || s.writer.busy()) return;
    const bool same = s.kept && s.kept->world == now.world && glm::length(s.kept->feet_m - now.feet_m) < kMoved_m &&
                      std::abs(s.kept->heading_rad - now.heading_rad) < kTurned_rad;
    if (same || !is_utf8(now.world.file.string())) return;
    s.next_s = now_s + kEvery_s;
    s.kept = now;
    s.writer.write(with(s.own, kPlace), text_of(now));
}

void SessionTrace::end() {
    State& s = *state_;
    s.writer.wait();
    s.report_writer.wait();
    if (s.own.empty()) return;
    std::error_code ec;
    for (const std::string_view ending : {kPlace, kReport, kSignal, kLock}) fs::remove(with(s.own, ending), ec);
    s.held.reset();
    s.own.clear();
}

fs::path sessions_folder() {
    const fs::path list = recent_worlds_path();
    return list.empty() ? fs::path() : list.parent_path() / "sessions";
}

}  // namespace handrail::core
