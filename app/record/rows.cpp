#include "app/record/rows.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "worlds/base/language.h"

namespace handrail::record {
namespace {

constexpr std::string_view kHandHeader =
    "t_us,x_um,y_um,z_um,fx_mn,fy_mn,fz_mn,contact,buttons,state,gx_urad,gy_urad,gz_urad,servo,scene,tuning,pose,"
    "bodies,guidance,stops,switches,engine,engine_frame,refused";
constexpr std::string_view kFrameHeader =
    "t_us,tick,left_tick,x_mm,y_mm,z_mm,heading_cdeg,engine,engine_frame,engine_events";
constexpr std::string_view kCueHeader = "t_us,contacts,left_contacts,posts,speaking";
constexpr std::string_view kEngineHeader =
    "t_us,engine,step,skipped,orders,driven,right_us,left_us,right_pushes,left_pushes,events,published";

constexpr double kMillionths = 1e6;
constexpr double kThousandths = 1e3;
constexpr std::int64_t kAway = -1;  // number of a tick if there is no hand
constexpr double kLargest = 9e15;   // whole numbers up to this are exact as doubles
constexpr double kCentidegrees = 18000.0 / std::numbers::pi;

// The flags of a DeviceSample. Their sum is one column of the table.
enum StateBit : std::int64_t {
    kNotFresh = 1,
    kNotConnected = 2,
    kNotHomed = 4,
    kHot = 8,
    kFailed = 16,
    kNoPlace = 32,  // the position is not finite
    kNoGrip = 64,   // the gimbal angles are not finite
    kLossFrom = 128,
    kLegsFrom = 512,
};

std::int64_t whole(double value, double steps) {
    const double scaled = std::round(value * steps);
    return std::abs(scaled) < kLargest ? static_cast<std::int64_t>(scaled) : 0;
}
double part(std::int64_t number, double steps) { return static_cast<double>(number) / steps; }

void put(std::int64_t* to, const Vec3& v, double steps) {
    for (int axis = 0; axis < 3; ++axis) to[axis] = whole(v[axis], steps);
}
Vec3 taken(const std::int64_t* from, double steps) {
    return {part(from[0], steps), part(from[1], steps), part(from[2], steps)};
}

std::int64_t state_of(const device::DeviceSample& sample) {
    std::int64_t state = 0;
    if (!sample.fresh) state |= kNotFresh;
    if (!sample.connected) state |= kNotConnected;
    if (!sample.homed) state |= kNotHomed;
    if (sample.hot) state |= kHot;
    if (sample.failed) state |= kFailed;
    if (!is_finite(sample.position_m)) state |= kNoPlace;
    if (!is_finite(sample.gimbal_rad)) state |= kNoGrip;
    return state + static_cast<std::int64_t>(sample.loss) * kLossFrom + sample.homed_legs * std::int64_t{kLegsFrom};
}

// Reads a whole number. `text` contains exactly one column.
bool read_number(std::string_view text, std::int64_t& number) {
    number = 0;
    if (text.empty()) return true;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    return fault == std::errc() && end == text.data() + text.size();
}

// Reads one line of a table. Returns false if the line is not a valid row.
template <std::size_t N>
bool read_row(std::string_view line, bool first, const std::array<std::int64_t, N>& before,
              std::array<std::int64_t, N>& row) {
    const bool absolute = !line.empty() && line.front() == '=';
    if (absolute) line.remove_prefix(1);
    if (first && !absolute) return false;
    row = absolute ? std::array<std::int64_t, N>{} : before;
    for (std::size_t column = 0;; ++column) {
        const std::size_t end = line.find(',');
        std::int64_t number = 0;
        if (column >= N || !read_number(line.substr(0, end), number)) return false;
        if (__builtin_add_overflow(row[column], number, &row[column])) return false;
        if (end == std::string_view::npos) return true;
        line.remove_prefix(end + 1);
    }
}

// Returns true if the header begins with all of these columns. Returns false if `columns` is empty.
bool begins(std::string_view header, std::string_view columns) {
    return !columns.empty() && header.starts_with(columns) &&
           (columns.size() == header.size() || header[columns.size()] == ',');
}

}  // namespace

std::string_view hand_header() { return kHandHeader; }
std::string_view frame_header() { return kFrameHeader; }
std::string_view cue_header() { return kCueHeader; }
std::string_view engine_header() { return kEngineHeader; }

HandNumbers numbers_of(const servo::HandRow& row) {
    HandNumbers n{};
    n[0] = whole(row.time_s, kMillionths);
    put(&n[1], row.sample.position_m, kMillionths);
    put(&n[4], row.force_n, kThousandths);
    n[7] = row.contact ? std::int64_t{row.contact.value} : -1;
    n[8] = row.sample.buttons;
    n[9] = state_of(row.sample);
    put(&n[10], row.sample.gimbal_rad, kMillionths);
    n[13] = row.servo;
    n[14] = row.reads.scene;
    n[15] = row.reads.tuning;
    n[16] = row.reads.pose;
    n[17] = row.reads.bodies;
    n[18] = row.reads.guidance;
    n[19] = row.reads.stops;
    n[20] = (row.reads.focused ? 0 : 1) + (row.reads.stopping ? 2 : 0);
    n[21] = row.bodies.engine;
    n[22] = static_cast<std::int64_t>(row.bodies.frame);
    n[23] = row.bodies.refused;
    return n;
}

servo::HandRow row_of(const HandNumbers& n) {
    const auto count = [](std::int64_t number) { return static_cast<std::uint32_t>(number); };
    servo::HandRow row;
    row.time_s = part(n[0], kMillionths);
    row.sample.position_m = taken(&n[1], kMillionths);
    row.force_n = taken(&n[4], kThousandths);
    if (n[7] >= 0) row.contact = FeatureId{static_cast<std::uint32_t>(n[7])};
    row.sample.buttons = count(n[8]);
    const std::int64_t state = n[9];
    row.sample.fresh = !(state & kNotFresh);
    row.sample.connected = !(state & kNotConnected);
    row.sample.homed = !(state & kNotHomed);
    row.sample.hot = state & kHot;
    row.sample.failed = state & kFailed;
    row.sample.loss = static_cast<device::DeviceLoss>(std::min<std::int64_t>(state / kLossFrom % 4, 2));
    row.sample.homed_legs = static_cast<std::uint8_t>(state / kLegsFrom);
    row.sample.gimbal_rad = taken(&n[10], kMillionths);
    const Vec3 none(std::numeric_limits<double>::quiet_NaN());
    if (state & kNoPlace) row.sample.position_m = none;
    if (state & kNoGrip) row.sample.gimbal_rad = none;
    row.servo = count(n[13]);
    row.reads = {count(n[14]), count(n[15]), count(n[16]), count(n[17]),
                 count(n[18]), count(n[19]), !(n[20] & 1), (n[20] & 2) != 0};
    row.bodies = {count(n[21]), static_cast<std::uint64_t>(n[22]), count(n[23])};
    return row;
}

FrameNumbers numbers_of(const FrameRow& row) {
    FrameNumbers n{};
    n[0] = whole(row.now_s, kMillionths);
    n[1] = static_cast<std::int64_t>(row.tick);
    n[2] = static_cast<std::int64_t>(row.left_tick);
    put(&n[3], row.feet_m, kThousandths);
    n[6] = whole(row.heading_rad, kCentidegrees);
    n[7] = row.engine;
    n[8] = static_cast<std::int64_t>(row.engine_frame);
    n[9] = static_cast<std::int64_t>(row.engine_events);
    return n;
}

FrameRow row_of(const FrameNumbers& n) {
    const auto count = [](std::int64_t number) { return static_cast<std::uint64_t>(number); };
    return {part(n[0], kMillionths),
            count(n[1]),
            count(n[2]),
            taken(&n[3], kThousandths),
            part(n[6], kCentidegrees),
            static_cast<std::uint32_t>(n[7]),
            count(n[8]),
            count(n[9])};
}

CueNumbers numbers_of(const CueRow& row) {
    return {whole(row.now_s, kMillionths), row.contacts, row.left_contacts, row.posts,
            static_cast<std::int64_t>(row.speaking)};
}

CueRow row_of(const CueNumbers& n) {
    return {part(n[0], kMillionths), static_cast<std::uint32_t>(n[1]), static_cast<std::uint32_t>(n[2]),
            static_cast<std::uint32_t>(n[3]), static_cast<std::uint64_t>(n[4])};
}

EngineNumbers numbers_of(const dynamics::EngineRow& row) {
    const auto place = [](double time_s) { return time_s < 0.0 ? kAway : whole(time_s, kMillionths); };
    return {whole(row.time_s, kMillionths),
            row.engine,
            static_cast<std::int64_t>(row.step),
            static_cast<std::int64_t>(row.skipped),
            row.orders,
            row.driven,
            place(row.places_s[0]),
            place(row.places_s[1]),
            row.pushes[0],
            row.pushes[1],
            row.events,
            row.published ? 1 : 0};
}

dynamics::EngineRow row_of(const EngineNumbers& n) {
    const auto count = [](std::int64_t number) { return static_cast<std::uint32_t>(number); };
    const auto place = [](std::int64_t t_us) {
        return t_us < 0 ? dynamics::EngineRow::kNoHand_s : part(t_us, kMillionths);
    };
    dynamics::EngineRow row;
    row.time_s = part(n[0], kMillionths);
    row.engine = count(n[1]);
    row.step = static_cast<std::uint64_t>(n[2]);
    row.skipped = static_cast<std::uint64_t>(n[3]);
    row.orders = count(n[4]);
    row.driven = count(n[5]);
    row.places_s = {place(n[6]), place(n[7])};
    row.pushes = {count(n[8]), count(n[9])};
    row.events = count(n[10]);
    row.published = n[11] != 0;
    return row;
}

template <std::size_t N>
std::string row_text(const std::array<std::int64_t, N>& row, const std::array<std::int64_t, N>& before, bool absolute) {
    std::string text = absolute ? "=" : "";
    std::size_t ends = text.size();
    for (std::size_t column = 0; column < N; ++column) {
        if (column > 0) text += ',';
        const std::int64_t number = absolute ? row[column] : row[column] - before[column];
        if (number == 0) continue;
        fmt::format_to(std::back_inserter(text), "{}", number);
        ends = text.size();
    }
    text.resize(ends);
    return text += '\n';
}

template <std::size_t N>
TableRows<N> read_rows(std::string_view text, std::string_view header, const std::string& file) {
    TableRows<N> table;
    std::array<std::int64_t, N> row{};
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = text.find('\n');
        const auto refuse = [&](std::string_view why) { table.problem = Error{file, line, 0, phrase(why)}; };
        if (end == std::string_view::npos) {
            refuse("recording.cut_line");
            break;
        }
        const std::string_view one = text.substr(0, end);
        text.remove_prefix(end + 1);
        if (line == 1) {
            if (begins(header, one)) continue;
            refuse("recording.other_columns");
            break;
        }
        const std::array<std::int64_t, N> before = row;
        if (!read_row(one, line == 2, before, row)) {
            refuse("recording.no_row");
            break;
        }
        table.rows.push_back(row);
    }
    return table;
}

template std::string row_text(const HandNumbers&, const HandNumbers&, bool);
template std::string row_text(const FrameNumbers&, const FrameNumbers&, bool);
template std::string row_text(const CueNumbers&, const CueNumbers&, bool);
template std::string row_text(const EngineNumbers&, const EngineNumbers&, bool);
template TableRows<kHandColumns> read_rows(std::string_view, std::string_view, const std::string&);
template TableRows<kFrameColumns> read_rows(std::string_view, std::string_view, const std::string&);
template TableRows<kCueColumns> read_rows(std::string_view, std::string_view, const std::string&);
template TableRows<kEngineColumns> read_rows(std::string_view, std::string_view, const std::string&);

}  // namespace handrail::record
