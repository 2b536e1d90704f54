// Tests the report of a crash: what it contains, what it must never contain, and where its file is.
#include "app/core/kept/crash_notes.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "app/core/kept/last_place.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace crash_notes_test {
namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

TEST(CrashNotes, list_the_last_actions_with_times_before_the_end_and_repeated_ones_once) {
    CrashNotes notes({"Handrail 1."});
    EXPECT_THAT(notes.text(), HasSubstr("No actions were recorded before the end."));
    notes.note("forward", 10.0);
    notes.note("forward", 10.5);
    notes.note("where", 12.0);
    EXPECT_THAT(notes.text(), HasSubstr("Handrail 1.\n"));
    EXPECT_THAT(notes.text(), HasSubstr("forward, 2 times: 1.5 seconds.\nwhere: 0 seconds.\n"));
    EXPECT_EQ(notes.changes(), 4U);
    for (int i = 0; i < 1000; ++i) notes.note(i % 2 ? "left" : "right", 20.0 + i);
    EXPECT_THAT(notes.text(), Not(HasSubstr("where")));
    EXPECT_LT(notes.text().size(), 4000U);
}

TEST(CrashNotes, contain_values_of_settings_only_if_they_identify_nobody) {
    EXPECT_TRUE(may_be_reported("0.8", "0 to 1"));
    EXPECT_TRUE(may_be_reported("-3", "any"));
    EXPECT_TRUE(may_be_reported("true", "true or false"));
    EXPECT_TRUE(may_be_reported("\"text\"", "auto, screen-reader, speech-dispatcher, embedded or text"));
    EXPECT_TRUE(may_be_reported("\"screen-reader\"", "auto, screen-reader or text"));
    EXPECT_FALSE(may_be_reported("\"reader\"", "auto, screen-reader or text")) << "a part of a word";
    EXPECT_FALSE(may_be_reported("\"annas-falcon\"", "auto, none or the name of a device"));
    EXPECT_FALSE(may_be_reported("\"A9001\"", "auto, none or the name of a device"));
    EXPECT_FALSE(may_be_reported("\"/srv/anna/lou.wav\"", "a file"));
    EXPECT_FALSE(may_be_reported("[1, 2]", "a list"));
    EXPECT_FALSE(may_be_reported("\"", "\""));
    EXPECT_FALSE(may_be_reported("", ""));
}

std::vector<fs::path> reports_beside(const fs::path& sessions) {
    std::vector<fs::path> found;
    std::error_code ec;
    for (const auto& file : fs::directory_iterator(sessions.parent_path() / "crash-reports", ec))
        found.push_back(file.path());
    return found;
}

// Runs a session that writes `text` to its report and is then killed.
void die_with(const fs::path& sessions, const std::string& text, const std::string& signal) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        SessionTrace trace(sessions);
        trace.note_report(text, 0.0);
        if (!signal.empty()) std::ofstream(trace.signal_file()) << signal;
        for (;;) ::usleep(1000);
    }
    const bool written = test::eventually([&] {
        bool report = false, ended = signal.empty();
        std::error_code ec;
        for (const auto& file : fs::directory_iterator(sessions, ec)) {
            report = report || (file.path().extension() == ".report" && test::content_of(file.path()) == text);
            ended = ended || (file.path().extension() == ".signal" && test::content_of(file.path()) == signal);
        }
        return report && ended;
    });
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_TRUE(written);
}

TEST(CrashReport, is_saved_next_to_the_sessions_with_cause_and_place) {
    const TemporaryFolder folder;
    const fs::path sessions = folder.path() / "sessions";
    die_with(sessions, "Handrail 1.\nforward: 0.0 seconds.\n", "11\nhandrail+0x1f\n-\n");
    {
        SessionTrace next(sessions);
        EXPECT_TRUE(next.crashed());
        ASSERT_TRUE(fs::exists(next.report()));
        const std::string text = test::content_of(next.report());
        EXPECT_EQ(text,
                  "Crash report.\nThe program ended with an invalid memory access, signal 11.\n"
                  "Handrail 1.\nforward: 0.0 seconds.\nhandrail+0x1f\n-\n");
        EXPECT_EQ(fs::status(next.report()).permissions() & fs::perms::others_read, fs::perms::none);
        next.end();
    }
    EXPECT_TRUE(fs::is_empty(sessions));
    EXPECT_TRUE(SessionTrace(sessions).report().empty()) << "told once";
    EXPECT_EQ(reports_beside(sessions).size(), 1U) << "and it stays";
}

TEST(CrashReport, of_a_kill_says_that_the_end_was_not_seen_and_an_orderly_exit_leaves_no_report) {
    const TemporaryFolder folder;
    const fs::path sessions = folder.path() / "sessions";
    {
        SessionTrace left(sessions);
        left.note_report("text\n", 0.0);
        left.end();
    }
    EXPECT_TRUE(fs::is_empty(sessions));
    EXPECT_FALSE(SessionTrace(sessions).crashed());
    EXPECT_TRUE(reports_beside(sessions).empty());
    die_with(sessions, "Handrail 1.\n", "");
    const SessionTrace next(sessions);
    EXPECT_THAT(test::content_of(next.report()), HasSubstr("How the program ended is not known"));
}

TEST(CrashReport, files_are_limited_to_the_newest_five) {
    const TemporaryFolder folder;
    const fs::path sessions = folder.path() / "sessions", reports = folder.path() / "crash-reports";
    fs::create_directories(reports);
    for (int i = 0; i < 8; ++i) std::ofstream(reports / ("2020-01-0" + std::to_string(i + 1) + "-120000.txt")) << i;
    die_with(sessions, "Handrail 1.\n", "6\n");
    const SessionTrace next(sessions);
    EXPECT_EQ(reports_beside(sessions).size(), 5U);
    EXPECT_TRUE(fs::exists(next.report()));
    EXPECT_FALSE(fs::exists(reports / "2020-01-01-120000.txt"));
}

TEST(MenuOfReports, reads_a_crash_report_and_the_devices_line_by_line) {
    test::AppSession session;
    session.app.apply(WorldEntered{make_ready(test::our_world("first_room.map"))}, 0.0);
    session.run(0.1);
    session.request(Command::Menu);
    EXPECT_FALSE(session.heard("Report on the session")) << "there is none";
    session.line("escape");
    session.app.apply(CrashReportKnown{"/a/report.txt", {"It ended.", "forward: 0.0 seconds."}}, session.now);
    session.request(Command::Menu);
    session.line("Report on the session that crashed");
    session.run(0.1);
    EXPECT_TRUE(session.heard("Crash report")) << session.news();
    session.line("list");
    EXPECT_TRUE(session.heard("forward: 0.0 seconds")) << session.news();
    session.line("escape");
    session.request(Command::Menu);
    session.line("Touch devices: what is plugged in");
    session.run(0.1);
    EXPECT_TRUE(session.app.requests().take_devices());
    EXPECT_FALSE(session.app.requests().take_devices());
    session.app.apply(DevicesFound{{"Novint Falcon, called falcon.", "State: ready."}}, session.now);
    session.listen();
    EXPECT_TRUE(session.heard("In use: no hand; everything works by keyboard and sound, 1 of 3")) << session.news();
    session.news();
    session.line("list");
    EXPECT_TRUE(session.heard("State: ready")) << session.news();
}

TEST(MenuOfReports, lists_every_fault_of_the_settings) {
    test::AppSession session;
    session.app.apply(WorldEntered{make_ready(test::our_world("first_room.map"))}, 0.0);
    session.run(0.1);
    session.app.apply(SettingsFaultsKnown{{"settings.toml, line 2: one fault.", "settings.toml, line 9: another."}},
                      session.now);
    session.request(Command::Menu);
    session.line("Problems in your settings");
    session.run(0.1);
    EXPECT_TRUE(session.heard("line 2: one fault")) << session.news();
    session.line("list");
    EXPECT_TRUE(session.heard("line 9: another")) << session.news();
}

// Opens the list of devices by its typed word, and from the desk by hand or key. The list names the hand in use before
// the connected devices.
TEST(MenuOfReports, opens_the_list_of_devices_by_a_typed_command_and_from_the_desk) {
    const HandFacts falcon{true, false, *find_device_spec("falcon")};
    test::AppSession session({}, falcon);
    session.app.apply(WorldEntered{make_ready(test::our_world("first_room.map"))}, 0.0);
    session.run(0.1);
    EXPECT_EQ(session.request(Command::Devices), "Looking for devices that are plugged in.");
    EXPECT_FALSE(session.app.idle()) << "what is typed next waits for the list";
    EXPECT_TRUE(session.app.requests().take_devices());
    session.app.apply(DevicesFound{{"Novint Falcon, called falcon."}}, session.now);
    session.listen();
    EXPECT_TRUE(session.heard("In use: Falcon, reach 4 centimetres, up to 3 newtons, 1 of 2")) << session.news();
    session.line("escape");
    EXPECT_TRUE(session.app.idle());
    const Desk& desk = session.app.desk_visit().desk();
    const auto control = desk.find("Touch device");
    ASSERT_TRUE(control);
    EXPECT_EQ(desk.words(*control), "Touch device, Falcon, reach 4 centimetres, up to 3 newtons");
    session.app.apply(HandChanged{{true, true, *find_device_spec("sim-t")}, {}, true}, session.now);
    EXPECT_EQ(desk.value(*control), "a simulated hand that you move with the keys, because no device was found");
    session.app.apply(HandChanged{{}, {}}, session.now);
    EXPECT_EQ(desk.value(*control), "no hand; everything works by keyboard and sound");
    EXPECT_EQ(session.app.desk_visit().press(*control), "Looking for devices that are plugged in.");
    EXPECT_TRUE(session.app.requests().take_devices());
}

TEST(MenuOfReports, describes_the_devices_in_german) {
    const test::InLanguage german("de");
    Settings settings;
    settings.speech.language = "de";
    test::AppSession session(settings);
    session.app.apply(WorldEntered{make_ready(test::our_world("first_room.map"))}, 0.0);
    session.run(0.1);
    EXPECT_EQ(session.request(Command::Devices), phrase("devices.looking"));
    session.app.apply(DevicesFound{{"Novint Falcon."}}, session.now);
    session.listen();
    EXPECT_TRUE(session.heard("In Gebrauch: keine Hand, alles mit Tastatur und Klang, 1 von 2")) << session.news();
}

}  // namespace crash_notes_test
}  // namespace handrail
