// Tests what a recording writes, and what can be read from it if it is whole or damaged.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "app/record/gzip_pieces.h"
#include "app/record/input_text.h"
#include "app/record/recording.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/files.h"
#include "worlds/base/text.h"

namespace handrail {
namespace recording_test {

namespace fs = std::filesystem;
using test::TemporaryFolder;

HandRow hand_row(std::mt19937_64& draw, double time_s) {
    std::uniform_real_distribution<double> place(-0.08, 0.08);
    HandRow row;
    row.time_s = in_whole_microseconds(time_s);
    row.sample.position_m = {place(draw), place(draw), place(draw)};
    row.sample.gimbal_rad = {place(draw), 0.0, place(draw)};
    row.sample.buttons = static_cast<std::uint32_t>(draw() % 4);
    row.sample.fresh = draw() % 3 != 0;
    row.sample.connected = draw() % 5 != 0;
    row.sample.homed = draw() % 7 != 0;
    row.sample.hot = draw() % 9 == 0;
    row.sample.failed = draw() % 9 == 0;
    row.sample.loss = static_cast<DeviceLoss>(draw() % 3);
    row.sample.homed_legs = static_cast<std::uint8_t>(draw() % 8);
    if (draw() % 20 == 0) row.sample.position_m.x = std::numeric_limits<double>::infinity();
    round_to_whole_steps(row.sample);
    row.force_n = {0.25, -1.5, 0.0};
    if (draw() % 2 == 0) row.contact = FeatureId{static_cast<std::uint32_t>(draw() % 100)};
    row.servo = 1;
    row.reads = {1, static_cast<std::uint32_t>(draw() % 100), 3, 0, 7, 2, draw() % 2 == 0, draw() % 2 == 0};
    row.bodies = {2, draw() % 1000, static_cast<std::uint32_t>(draw() % 16)};
    return row;
}

bool same(const Vec3& a, const Vec3& b) { return a == b || (!is_finite(a) && !is_finite(b)); }

void expect_same(const HandRow& a, const HandRow& b) {
    EXPECT_EQ(a.time_s, b.time_s);
    EXPECT_TRUE(same(a.sample.position_m, b.sample.position_m));
    EXPECT_TRUE(same(a.sample.gimbal_rad, b.sample.gimbal_rad));
    EXPECT_EQ(a.sample.buttons, b.sample.buttons);
    EXPECT_EQ(a.sample.fresh, b.sample.fresh);
    EXPECT_EQ(a.sample.connected, b.sample.connected);
    EXPECT_EQ(a.sample.homed, b.sample.homed);
    EXPECT_EQ(a.sample.hot, b.sample.hot);
    EXPECT_EQ(a.sample.failed, b.sample.failed);
    EXPECT_EQ(a.sample.loss, b.sample.loss);
    EXPECT_EQ(a.sample.homed_legs, b.sample.homed_legs);
    EXPECT_EQ(a.force_n, b.force_n);
    EXPECT_EQ(a.contact, b.contact);
    EXPECT_EQ(a.servo, b.servo);
    EXPECT_EQ(a.reads, b.reads);
    EXPECT_EQ(a.bodies, b.bodies);
}

// A recording of a second and a half with a hand, frames, steps and lines. `hand` contains the rows that the test
// recorded, for the comparison.
struct Made {
    fs::path folder;
    std::vector<HandRow> hand;
};
Made make_recording(const fs::path& in) {
    std::mt19937_64 draw(7);
    RecordingHead head;
    head.program = "1.0";
    head.language = "en";
    head.begun_s = 1000.0;
    head.settings.walk.turn_deg = 45.0;
    auto recorder = Recorder::begin(in, head);
    EXPECT_TRUE(recorder) << recorder.error().sentence();
    Made made{(*recorder)->folder(), {}};
    for (int ms = 0; ms < 1500; ++ms) {
        const double now_s = 1000.0 + ms * 1e-3;
        made.hand.push_back(hand_row(draw, now_s));
        (*recorder)->hand(0).push(made.hand.back());
        if (ms % 16 == 0)
            (*recorder)->frame({now_s, static_cast<std::uint64_t>(ms), 0, {ms * 1e-3, 2.0, 0.0}, ms * 1e-4});
        if (ms % 4 == 0) {
            const double knew_s = ms % 3 ? in_whole_microseconds(now_s) : EngineRow::kNoHand_s;
            (*recorder)->bodies().push(
                {1, static_cast<std::uint64_t>(ms / 4 + 1), now_s, 2, 3, 4, {knew_s, 0.0}, {5, 6}, 7, ms % 8 == 0});
        }
        if (ms % 5 == 0) (*recorder)->cue_step({now_s, 1, 0, 2, 0b101});
        if (ms % 100 == 0) {
            (*recorder)->input(CommandDown{Command::Forward}, now_s);
            (*recorder)->event({now_s, Arrived{"Kitchen", LedBy::Ear, false}}, nullptr);
            (*recorder)->said(now_s, {"Here is \"the\" wall.", SpeechClass::Contact}, true);
        }
    }
    (*recorder)->end(1001.5);
    return made;
}

TEST(Recording, is_read_back_unchanged) {
    const TemporaryFolder folder;
    const Made made = make_recording(folder.path() / "recordings");
    const auto read = read_recording(made.folder);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(read->problems.empty());
    EXPECT_TRUE(read->ended);
    EXPECT_EQ(read->head.begun_s, 1000.0);
    EXPECT_EQ(read->head.settings.walk.turn_deg, 45.0);
    ASSERT_EQ(read->hands[0].size(), made.hand.size());
    for (std::size_t i = 0; i < made.hand.size(); ++i) expect_same(read->hands[0][i], made.hand[i]);
    EXPECT_TRUE(read->hands[1].empty());
    ASSERT_EQ(read->frames.size(), 94U);
    EXPECT_EQ(read->frames[2].now_s, in_whole_microseconds(1000.032));
    EXPECT_EQ(read->frames[2].tick, 32U);
    EXPECT_NEAR(read->frames[2].feet_m.x, 0.032, 1e-9);
    ASSERT_EQ(read->cues.size(), 300U);
    EXPECT_EQ(read->cues[7].speaking, 0b101U);
    EXPECT_EQ(read->cues[7].posts, 2U);
    ASSERT_EQ(read->bodies.size(), 375U);
    const EngineRow& step = read->bodies[1];
    EXPECT_EQ(numbers_of(step), (EngineNumbers{1000'004'000, 1, 2, 2, 3, 4, 1000'004'000, 0, 5, 6, 7, 0}));
    EXPECT_EQ(step.places_s[0], in_whole_microseconds(1000.004));
    EXPECT_EQ(read->bodies[3].places_s[0], EngineRow::kNoHand_s);
    EXPECT_TRUE(read->bodies[2].published);
    const std::vector<SaidLine> said = said_lines(*read);
    ASSERT_EQ(said.size(), 15U);
    EXPECT_EQ(said[1].text, "Here is \"the\" wall.");
    EXPECT_EQ(said[1].speech_class, "contact");
    EXPECT_NEAR(said[1].t_s, 0.1, 1e-9);
}

TEST(Recording, is_readable_only_by_the_person) {
    const TemporaryFolder folder;
    const Made made = make_recording(folder.path() / "recordings");
    using fs::perms;
    EXPECT_EQ(fs::status(made.folder).permissions(), perms::owner_all);
    EXPECT_EQ(fs::status(made.folder.parent_path()).permissions(), perms::owner_all);
    int files = 0;
    for (const auto& file : fs::directory_iterator(made.folder)) {
        EXPECT_EQ(file.status().permissions(), perms::owner_read | perms::owner_write) << file.path();
        ++files;
    }
    EXPECT_EQ(files, 5);
}

TEST(Recording, cut_at_every_byte_is_read_up_to_its_last_complete_line) {
    const TemporaryFolder folder;
    const Made made = make_recording(folder.path() / "recordings");
    const std::string text = *read_whole_file(made.folder / "events.jsonl");
    const auto whole = read_events(text, "events.jsonl");
    ASSERT_TRUE(whole);
    for (std::size_t cut = 0; cut < text.size(); ++cut) {
        const auto read = read_events(std::string_view(text).substr(0, cut), "events.jsonl");
        const auto ends =
            static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(cut), '\n'));
        ASSERT_EQ(read.has_value(), ends > 0) << cut;
        if (!read) continue;
        ASSERT_EQ(read->lines.size(), ends - 1) << cut;
        const bool at_line_end = text[cut - 1] == '\n';
        ASSERT_EQ(read->problems.size(), at_line_end ? 0U : 1U) << cut;
        if (!at_line_end) {
            ASSERT_EQ(read->problems[0].line, static_cast<int>(ends) + 1);
        }
    }
    // If a compressed table is cut, the reader must return at least the rows of the undamaged pieces, and never a wrong
    // row.
    const std::string packed = *read_whole_file(made.folder / "hand.csv.gz");
    std::size_t rows = 0;
    for (std::size_t cut = 0; cut < packed.size(); cut += 41) {
        const GzipText unpacked = gunzip_pieces(std::string_view(packed).substr(0, cut), 1 << 26);
        const auto table = read_rows<kHandColumns>(unpacked.text, hand_header(), "hand.csv.gz");
        ASSERT_GE(table.rows.size(), rows) << cut;
        rows = table.rows.size();
        if (rows > 0) expect_same(row_of(table.rows.back()), made.hand[rows - 1]);
    }
    EXPECT_GT(rows, 1000U);
}

TEST(Recording, that_is_damaged_anywhere_gives_error_sentences_and_no_crash) {
    const TemporaryFolder folder;
    const Made made = make_recording(folder.path() / "recordings");
    const std::string text = *read_whole_file(made.folder / "events.jsonl");
    const std::string packed = *read_whole_file(made.folder / "hand.csv.gz");
    std::mt19937 draw(11);
    for (int round = 0; round < 300; ++round) {
        std::string events = text, table = packed;
        for (int change = 0; change < 3; ++change) {
            events[draw() % events.size()] = static_cast<char>(draw());
            table[draw() % table.size()] = static_cast<char>(draw());
        }
        const auto read = read_events(events, "events.jsonl");
        if (!read) {
            EXPECT_EQ(read.error().line, 1);
            EXPECT_FALSE(read.error().message.empty());
        } else {
            for (const Error& problem : read->problems) EXPECT_FALSE(problem.message.empty());
            for (const RecordedLine& line : read->lines)
                if (is_input(line.is)) (void)read_input_line(line.json);
        }
        const GzipText unpacked = gunzip_pieces(table, 1 << 26);
        for (const auto& row : read_rows<kHandColumns>(unpacked.text, hand_header(), "hand.csv.gz").rows)
            (void)row_of(row);
    }
}

TEST(Recording, of_another_kind_or_a_newer_version_is_refused_with_file_and_line) {
    const TemporaryFolder folder;
    EXPECT_EQ(read_recording(folder.path()).error().message,
              "This is not a recording: it contains no file events.jsonl.");
    for (const char* text : {"", "\n", "{}\n", "[1]\n", "{\"is\":\"recording\"}\n", "Not at all.\n"}) {
        const auto read = read_events(text, "events.jsonl");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().sentence(),
                  "events.jsonl, line 1: This file does not begin like a recording. A recording begins with a line "
                  "that says what it is.");
    }
    // If a number fits in no integer, converting it is undefined behaviour. So the reader must refuse such numbers
    // before it converts them.
    std::string head = test::content_of(test::project_root() / "tests/fuzz/inputs/recording/seeds/events.jsonl");
    ASSERT_TRUE(read_events(head, "events.jsonl"));
    for (const char* form : {"19223372036854775807", "-19223372036854775807", "4294967297", "1e300", "1.5"}) {
        std::string odd = head;
        odd.replace(odd.find("\"form\":1") + 7, 1, form);
        EXPECT_FALSE(read_events(odd, "events.jsonl")) << form;
    }
    for (const char* line : {R"({"t":1,"is":"stops","count":1e30,"frame":0,"now_s":1})",
                             R"({"t":1,"is":"stops","count":-1,"frame":0,"now_s":1})",
                             R"({"t":1,"is":"stops","count":1,"frame":1e300,"now_s":1})"})
        EXPECT_FALSE(read_input_line(line)) << line;
    EXPECT_TRUE(read_input_line(R"({"t":1,"is":"stops","count":1,"frame":0,"now_s":1})"));
    const auto newer = read_events("{\"is\":\"recording\",\"form\":3}\n", "events.jsonl");
    ASSERT_FALSE(newer);
    EXPECT_NE(newer.error().message.find("newer version"), std::string::npos);
}

TEST(RecordingRows, that_are_invalid_are_reported_with_file_and_line) {
    const std::string header = std::string(cue_header()) + "\n";
    const auto problem = [&](const std::string& rows) {
        const auto table = read_rows<kCueColumns>(header + rows, cue_header(), "cues.csv.gz");
        return table.problem ? table.problem->sentence() : std::string();
    };
    const std::string no_row = "This row must have one whole number for each column.";
    EXPECT_EQ(problem("=1,2\n,,3\n"), "");
    // This row contains differences from the previous row, but there is no previous row.
    EXPECT_EQ(problem("1,2\n"), "cues.csv.gz, line 2: " + no_row);
    EXPECT_EQ(problem("=1,2\n1.5\n"), "cues.csv.gz, line 3: " + no_row);
    EXPECT_EQ(problem("=1,2,3,4,5,6\n"), "cues.csv.gz, line 2: " + no_row);
    EXPECT_EQ(problem("=9223372036854775807\n1\n"), "cues.csv.gz, line 3: " + no_row);
    EXPECT_EQ(problem("=1,2"), "cues.csv.gz, line 2: The last line is not complete.");
    // Recordings of older versions have fewer columns.
    const auto older = read_rows<kFrameColumns>("t_us,tick,left_tick,x_mm,y_mm,z_mm,heading_cdeg\n=5,6\n1\n",
                                                frame_header(), "frames.csv.gz");
    EXPECT_FALSE(older.problem);
    ASSERT_EQ(older.rows.size(), 2U);
    EXPECT_EQ(older.rows[1], (FrameNumbers{6, 6}));
    EXPECT_EQ(read_rows<kCueColumns>("t_us,con\n", cue_header(), "cues.csv.gz").problem->line, 1);
    EXPECT_EQ(read_rows<kCueColumns>("t_s\n", cue_header(), "cues.csv.gz").problem->line, 1);
}

TEST(RecordedInput, of_every_kind_is_read_back_unchanged) {
    Settings settings;
    settings.walk.step_length_m = 0.65;
    settings.haptic.device = "falcon";
    settings.keys["where"] = "F5";
    settings.profiles["falcon a9001"].ceiling_n = 1.25;
    settings.profiles["falcon a9001"].hand = HoldingHand::Left;
    settings.workspace.devices["falcon"].scale = 30.0;
    HandFacts hand{true, false, *find_device_spec("falcon"), "A9001"};
    hand.spec.delay_s = 0.00125;
    std::vector<SessionInput> inputs;
    inputs.emplace_back(CommandDown{Command::Forward, 12});
    inputs.emplace_back(CommandUp{Command::Forward});
    inputs.emplace_back(KeyTapped{"Escape"});
    inputs.emplace_back(TextTyped{"äß"});
    inputs.emplace_back(LineTyped{"the \"kitchen\"\n"});
    inputs.emplace_back(ListsLeft{});
    inputs.emplace_back(ItemActed{{ItemAct::Kind::Put, 3, "Volume", 0.7}});
    inputs.emplace_back(Steered{{0.1, -0.2, 0.30000000000000004, -0.7}});
    inputs.emplace_back(FocusChanged{false});
    inputs.emplace_back(Stopped{4});
    inputs.emplace_back(HandMoved{{0.001, 0.002, -0.003}});
    inputs.emplace_back(SettingsChanged{settings});
    inputs.emplace_back(HandChanged{hand, settings, true});
    inputs.emplace_back(LeftHandChanged{{}});
    inputs.emplace_back(HandOffered{"Novint Falcon"});
    inputs.emplace_back(Placed{{1.0, 2.0, 1.0 / 3.0}, 0.5});
    inputs.emplace_back(Announcement{"Sound goes nowhere.", SpeechClass::Alarm});
    SpeechTopics topics;
    topics.add(SpeechTopic::Lesson);
    inputs.emplace_back(LinesOwed{topics});
    inputs.emplace_back(FirstMinutesBegun{"the speech server", true});
    inputs.emplace_back(LessonLeft{});
    inputs.emplace_back(SetUpOver{});
    inputs.emplace_back(LastPlaceKnown{{{"/a/b.map", 0.03125, 0.3048, "Annex"}, {1.0, 2.0, 3.0}, 0.25}});
    inputs.emplace_back(WentOnAt{{{"/a/b.map"}, {1.0, 2.0, 3.0}, 0.25}});
    inputs.emplace_back(CrashReportKnown{"/a/crash.txt", {"It broke off.", "\"quoted\""}});
    inputs.emplace_back(SettingSet{"workspace.scale", "40.0"});
    inputs.emplace_back(SettingsFaultsKnown{{"settings.toml, line 2: \"F99\" is no key."}});
    inputs.emplace_back(DevicesFound{{"Novint Falcon, called falcon."}});
    inputs.emplace_back(WorldsKnown{{"/worlds", {"/a/b.map", "/c.obj"}}});
    TeacherActed taught;
    taught.kind = TeacherActed::Kind::Lead;
    taught.text = "to the \"kitchen\"";
    taught.items = {"Hall", "Küche"};
    taught.places_m = {{1.0, 2.0, 0.5}, {1.0 / 3.0, 0.0, 0.0}};
    taught.number = 0.6;
    inputs.emplace_back(std::move(taught));
    WorldEntered world;
    world.request = {"/a/b.map", 1.0 / 64.0, {}, "Annex"};
    world.settings.emplace().workspace.scale = 8.0;
    world.begins_at = Placed{{1.0, 2.0, 1.0 / 3.0}, 0.5, "Kitchen \"annex\""};
    inputs.emplace_back(std::move(world));
    for (const SessionInput& input : inputs) {
        const std::string line = input_line(input, 1234.5678901234, 77, 1000.0);
        const auto read = read_input_line(line);
        ASSERT_TRUE(read) << line;
        EXPECT_EQ(read->frame, 77U);
        EXPECT_EQ(read->now_s, 1234.5678901234);
        EXPECT_EQ(read->input.index(), input.index()) << line;
        EXPECT_EQ(input_line(read->input, read->now_s, read->frame, 1000.0), line);
    }
    EXPECT_EQ(inputs.size(), std::variant_size_v<SessionInput>);
    const auto changed = read_input_line(input_line(inputs[12], 0.0, 0, 0.0));
    const auto& taken = std::get<HandChanged>(changed->input);
    EXPECT_EQ(taken.hand.spec.delay_s, 0.00125);
    EXPECT_EQ(taken.hand.serial, "A9001");
    EXPECT_EQ(taken.settings.haptic.device, "falcon");
    EXPECT_EQ(taken.settings.keys, settings.keys);
    EXPECT_EQ(taken.settings.profiles.at("falcon a9001").ceiling_n, 1.25);
    EXPECT_TRUE(taken.for_want_of_one);
}

// Returns the size of a recording of fifteen minutes: ten times the size of a minute and a half. The hand strokes a
// wall and trembles. The ticks of the loop are some microseconds early or late.
std::size_t bytes_of_fifteen_minutes(bool among_free_bodies) {
    std::mt19937_64 draw(9);
    std::normal_distribution<double> jitter(0.0, 8e-6);
    std::string text;
    std::size_t bytes = 0;
    HandNumbers before{};
    double now_s = 1000.0, last_m = 0.0, speed = 0.0;
    const auto on_grid = [](double v) { return std::round(v / 5.5e-5) * 5.5e-5; };
    for (int tick = 0; tick < 90000; ++tick) {
        now_s = 1000.0 + tick * 1e-3 + jitter(draw);
        const double stroke = std::fmod(tick * 1e-3, 4.0) / 2.0;
        const double part = stroke < 1.0 ? stroke * stroke * (3.0 - 2.0 * stroke) : 1.0;
        const double tremor = 5e-5 * std::sin(2.0 * 3.14159265 * 9.0 * tick * 1e-3);
        HandRow row;
        row.time_s = in_whole_microseconds(now_s);
        row.sample.position_m = {on_grid(0.06 * part + tremor), on_grid(0.02 * part - tremor), on_grid(tremor)};
        round_to_whole_steps(row.sample);
        // The wall has 400 N/m and the default damping. The force follows the encoder values.
        const double deep_m = row.sample.position_m.x - 0.055, moved_m = row.sample.position_m.x - last_m;
        last_m = row.sample.position_m.x;
        speed += 0.27 * (moved_m / 1e-3 - speed);
        const bool touches = deep_m > 0.0;
        if (touches) row.force_n = {-std::clamp(400.0 * deep_m + 5.0 * speed, 0.0, 2.5), -1.2 * deep_m * 100.0, 0.0};
        row.contact = touches ? FeatureId{12} : kNoFeature;
        row.servo = 1;
        const auto frame = static_cast<std::uint32_t>(tick / 17);
        row.reads = {1, frame, frame, 0, 0, 0, true, false};
        if (among_free_bodies) row.bodies = {1, static_cast<std::uint64_t>(tick * 0.24), 0};
        const HandNumbers numbers = numbers_of(row);
        text += row_text(numbers, before, text.empty());
        before = numbers;
        if (tick % 400 == 399) bytes += gzip_piece(std::exchange(text, {})).size();
    }
    return 10 * bytes;
}

TEST(RecordingRows, of_fifteen_minutes_with_force_need_at_most_four_megabytes) {
    for (const bool among_free_bodies : {false, true}) {
        const std::size_t bytes = bytes_of_fifteen_minutes(among_free_bodies);
        std::printf("15 minutes of a hand with force%s: %.2f MB\n", among_free_bodies ? " among free bodies" : "",
                    static_cast<double>(bytes) * 1e-6);
        EXPECT_LT(bytes, 4'000'000U);
    }
}

TEST(RoundingOfSamples, gives_whole_micrometres_that_are_read_back_unchanged) {
    std::mt19937_64 draw(3);
    std::uniform_real_distribution<double> place(-0.3, 0.3);
    for (int i = 0; i < 10000; ++i) {
        DeviceSample sample;
        const double was = place(draw);
        sample.position_m = {was, was * 0.5, -was};
        round_to_whole_steps(sample);
        EXPECT_LE(std::abs(sample.position_m.x - was), 0.5000001e-6);
        const auto whole = static_cast<double>(std::llround(sample.position_m.x * 1e6));
        EXPECT_EQ(whole / 1e6, sample.position_m.x);
    }
}

}  // namespace recording_test
}  // namespace handrail
