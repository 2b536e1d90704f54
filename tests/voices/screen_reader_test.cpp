// Tests that Orca reads the program aloud, on a private desktop for the test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/core/session/session.h"
#include "tests/support/names.h"
#include "tests/support/times_in.h"
#include "tests/voices/desktop.h"
#include "tests/voices/exploring.h"

namespace handrail::test {
namespace screen_reader_test {

using testing::HasSubstr;
using testing::Not;

// Removes blanks and full stops at the end. The program appends a blank to a name that repeats the last name, because
// Orca reads only changes. Orca 48 ends its utterances with a full stop, but Orca 43 does not.
std::string without_end(std::string text) {
    text.erase(text.find_last_not_of(" .") + 1);
    return text;
}

// Returns the number of processes with this name that have `folder` in their environment.
int processes_called(const std::string& name, const std::filesystem::path& folder) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::string own;
        std::getline(std::ifstream(entry.path() / "comm"), own);
        count += own == name && content_of(entry.path() / "environ").find(folder.string()) != std::string::npos;
    }
    return count;
}

class ReadByOrca : public testing::Test {
protected:
    // Starts Orca and the program, and gives the program's window the keyboard focus. If `speech_server` is true, the
    // program can also find the speech server.
    void begin(bool speech_server) {
        if (const std::string why = Desktop::why_not(); !why.empty()) GTEST_SKIP() << why;
        desktop = std::make_unique<Desktop>(folder.path());
        ASSERT_TRUE(desktop->running());
        ASSERT_TRUE(desktop->start_orca()) << desktop->everything();
        program = std::make_unique<Exploring>(folder, desktop->environment(speech_server),
                                              std::vector<std::string>{"--device", "none"});
        ASSERT_TRUE(desktop->focus_window()) << everything();
    }
    // Returns the recorded speech and the text that the program wrote.
    std::string everything() const { return "said:\n" + program->said() + desktop->everything(); }
    int times_spoken(const std::string& words) const {
        const auto all = desktop->speech->recorded();
        return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const Recorded& entry) {
            return entry.event == "speak" && without_end(entry.words) == without_end(words);
        }));
    }
    bool spoken(const std::string& words, int times = 1) const {
        return eventually([&] { return times_spoken(words) == times; });
    }
    bool speaks_of(const std::string& words) const {
        return eventually([&] { return desktop->speech->spoke(words); });
    }
    // Opens the settings desk as a list.
    void open_desk() {
        ASSERT_TRUE(speaks_of("facing north")) << everything();
        ASSERT_TRUE(desktop->press("F10"));
        ASSERT_TRUE(eventually([&] { return desktop->objects().find("list \"Your desk") != std::string::npos; }))
            << desktop->objects();
    }
    // Runs a Python program, in which the variable `desk` is the desk's list. Returns the lines that the program
    // prints. Each line must have `cells` cells, which | separates.
    std::vector<std::vector<std::string>> work_at_desk(const std::string& python, std::size_t cells) const {
        const std::string find = "import os, pyatspi, time\nsaid = '" + (folder.path() / "said").string() + "'" + R"(
def told(): return os.path.getsize(said)
# True once what get() returns has changed. False if the program has said something and nothing changed.
def changes(get, before, heard):
    until = time.time() + 120
    while time.time() < until:
        if get() != before: return True
        if told() > heard: until = min(until, time.time() + 5)
        time.sleep(0.02)
    return False
# Waits until the program has said something.
def answers(heard):
    until = time.time() + 20
    while time.time() < until and told() == heard: time.sleep(0.02)
def find(a):
    if a.getRoleName() == 'list': return a
    for i in range(a.childCount):
        found = find(a.getChildAtIndex(i))
        if found: return found
for a in pyatspi.Registry.getDesktop(0):
    if a and a.name == 'Handrail': desk = find(a)
)";
        const std::string report = desktop->query_objects(find + python);
        std::vector<std::vector<std::string>> rows;
        std::istringstream lines(report);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream parts(line);
            rows.emplace_back();
            for (std::string part; std::getline(parts, part, '|');) rows.back().push_back(part);
            EXPECT_EQ(rows.back().size(), cells) << report;
        }
        return rows;
    }
    void leave() {
        EXPECT_TRUE(desktop->press("Escape"));
        EXPECT_TRUE(program->says("Press Escape again")) << everything();
        EXPECT_TRUE(desktop->press("Escape"));
        EXPECT_EQ(program->process().exit_status(), 0) << everything();
    }

    TemporaryFolder folder;
    std::unique_ptr<Desktop> desktop;
    std::unique_ptr<Exploring> program;
};

TEST_F(ReadByOrca, speaks_through_orca_from_the_first_word_and_without_its_own_voice) {
    ASSERT_NO_FATAL_FAILURE(begin(true));
    if (!program) return;
    ASSERT_TRUE(speaks_of("facing north")) << everything();
    ASSERT_TRUE(desktop->press("Right"));
    EXPECT_TRUE(spoken("North-north-east")) << everything();
    ASSERT_TRUE(desktop->press("c"));
    EXPECT_TRUE(speaks_of("Facing north-north-east, 22 degrees")) << everything();
    // Orca must say the text once. The program must not send it to the speech server as well.
    EXPECT_EQ(times_spoken("North-north-east"), 1) << everything();
    EXPECT_TRUE(desktop->speech->spoke("Handrail.")) << everything();
    EXPECT_THAT(program->said(), Not(HasSubstr("built-in voice"))) << everything();
    leave();
}

TEST_F(ReadByOrca, repeats_word_for_word_on_request) {
    ASSERT_NO_FATAL_FAILURE(begin(false));
    if (!program) return;
    ASSERT_TRUE(speaks_of("facing north")) << everything();
    ASSERT_TRUE(desktop->press("Right"));
    ASSERT_TRUE(spoken("North-north-east")) << everything();
    ASSERT_TRUE(desktop->press("space"));
    EXPECT_TRUE(spoken("North-north-east", 2)) << everything();
    ASSERT_TRUE(desktop->press("space"));
    EXPECT_TRUE(spoken("North-north-east", 3)) << everything();
    leave();
}

TEST_F(ReadByOrca, gives_orca_each_key_first_except_the_stop_key) {
    ASSERT_NO_FATAL_FAILURE(begin(false));
    if (!program) return;
    ASSERT_TRUE(speaks_of("facing north")) << everything();
    // Insert with F makes Orca describe the font; F alone is Handrail's force key. If a busy machine delays Orca's
    // answer, the key goes to the program (KeyGate). So try several times.
    const auto ours = [&] { return times_in(program->said(), "There is no touch device"); };
    bool used_by_orca = false;
    for (std::size_t requested = 1; requested <= 20 && !used_by_orca; ++requested) {
        const std::size_t before = ours();
        ASSERT_TRUE(desktop->display->xdotool("keydown Insert key f keyup Insert"));
        ASSERT_TRUE(desktop->press("c"));
        ASSERT_TRUE(eventually([&] { return times_in(program->said(), "say: Facing north") == requested; }))
            << everything();
        used_by_orca = ours() == before;
    }
    EXPECT_TRUE(used_by_orca) << everything();
    const std::size_t before = ours();
    // On a busy machine, Orca 48 also uses the first key after Insert is released, and ignores it. So press the key
    // again.
    EXPECT_TRUE(eventually([&] { return desktop->press("f") && eventually([&] { return ours() > before; }, 2.0); }))
        << everything();
    EXPECT_TRUE(speaks_of("There is no touch device")) << everything();
    ASSERT_TRUE(desktop->press("F12"));
    EXPECT_TRUE(program->says("alert: ")) << everything();
    leave();
}

TEST_F(ReadByOrca, speaks_lists_and_exposes_their_items_as_objects) {
    ASSERT_NO_FATAL_FAILURE(begin(false));
    if (!program) return;
    ASSERT_TRUE(speaks_of("facing north")) << everything();
    EXPECT_THAT(desktop->objects(), Not(HasSubstr("list \""))) << everything();
    ASSERT_TRUE(desktop->press("Tab"));
    ASSERT_TRUE(speaks_of("What you can do")) << everything();
    std::string objects;
    const auto finds = [&](const std::string& words) {
        return eventually([&] { return (objects = desktop->objects()).find(words) != std::string::npos; });
    };
    EXPECT_TRUE(finds("  list \"Menu")) << objects;
    EXPECT_TRUE(finds("selected")) << objects;
    // Down must move the selection to the second item, and Orca must speak that item.
    std::istringstream lines(objects);
    std::string first, second;
    for (std::string line; std::getline(lines, line) && second.empty();)
        if (line.find("list item") != std::string::npos) (first.empty() ? first : second) = line;
    EXPECT_THAT(first, HasSubstr("selected"));
    ASSERT_FALSE(second.empty()) << objects;
    ASSERT_TRUE(desktop->press("Down"));
    EXPECT_TRUE(finds(second + " selected focused")) << objects;
    const std::size_t quote = second.find('"');
    EXPECT_TRUE(speaks_of(second.substr(quote + 1, second.find_first_of("\",", quote + 1) - quote - 1)))
        << everything();
    ASSERT_TRUE(desktop->press("Escape"));
    EXPECT_TRUE(eventually([&] { return desktop->objects().find("list") == std::string::npos; })) << desktop->objects();
    leave();
}

// Changes each control of the desk by the actions of its accessible object. Then makes the same changes in a session
// without a window. The texts of the controls must be the same in both.
TEST_F(ReadByOrca, changes_every_control_of_the_desk_through_its_accessible_actions) {
    ASSERT_NO_FATAL_FAILURE(begin(false));
    if (!program) return;
    ASSERT_NO_FATAL_FAILURE(open_desk());
    // For each item, this program prints the name, the actions, and the name after an action. It tries the action
    // decrease, and then increase if decrease changed nothing. If an item has no decrease, it tries press.
    static constexpr const char* kWork = R"(
def name(i): return desk.getChildAtIndex(i).name
last = [i for i in range(desk.childCount) if name(i) == 'Go to that world']  # the desk goes with this world
for i in [i for i in range(desk.childCount) if i not in last] + last:
    before = name(i)
    actions = desk.getChildAtIndex(i).queryAction()
    names = [actions.getName(n) for n in range(actions.nActions)]
    if before.startswith('Touch device'):  # its list would lie over the desk
        print(i, '|', before, '|', ' '.join(names), '|', before, '|', 'none')
        continue
    for act in (['decrease', 'increase'] if 'decrease' in names else ['press']):
        heard = told()
        actions.doAction(names.index(act))
        if i in last: break
        if act == 'press':
            answers(heard)
            break
        if changes(lambda: name(i), before, heard): break
    print(i, '|', before, '|', ' '.join(names), '|', before if i in last else name(i), '|', act)
)";
    Session app(Settings{}, HandFacts{});
    std::size_t worked = 0, changed = 0;
    for (std::vector<std::string>& parts : work_at_desk(kWork, 5)) {
        ASSERT_EQ(parts.size(), 5U);
        SCOPED_TRACE(parts[1]);
        ++worked;
        const std::size_t i = std::stoul(parts[0]);
        parts.erase(parts.begin());
        parts[0].erase(0, 1);
        ASSERT_LT(i, app.desk_visit().desk().controls().size());
        const DeskControl& control = app.desk_visit().desk().controls()[i];
        EXPECT_EQ(parts[0].rfind(control.name, 0), 0U);
        EXPECT_EQ(parts[1], control.adjustable() ? " press increase decrease " : " press ");
        // Skip these controls, because worlds and marks differ between the two sessions.
        if (!control.adjustable() || control.many) continue;
        // The text of this control, as that of the knob, may contain results of earlier changes. So this session
        // repeats the same changes.
        if (control.kind == DeskKind::Assign) {
            EXPECT_EQ(parts[0], app.desk_visit().desk().words(i) + " ");
        }
        const std::string before = app.desk_visit().desk().words(i);
        app.desk_visit().step(i, -1);
        if (app.desk_visit().desk().words(i) == before) app.desk_visit().step(i, 1);
        EXPECT_EQ(parts[2], " " + app.desk_visit().desk().words(i) + " ");
        changed += parts[0] != parts[2].substr(1);
    }
    EXPECT_EQ(worked, app.desk_visit().desk().controls().size());
    EXPECT_GE(changed, 12U);
    EXPECT_TRUE(program->says("say: Distances in metres")) << everything();
    EXPECT_TRUE(program->says("say: Going to ")) << everything();
}

// Sets each slider, volume and knob of the desk through the value of its accessible object. Then makes the same changes
// in a session without a window. Text and number must be the same in both.
TEST_F(ReadByOrca, exposes_each_quantity_of_the_desk_as_a_settable_value) {
    ASSERT_NO_FATAL_FAILURE(begin(false));
    if (!program) return;
    ASSERT_NO_FATAL_FAILURE(open_desk());
    // For each item with a value, this program prints the index, minimum, maximum, step and number. Then it sets the
    // value to about a third of the range, and prints the item's name and number. The knob has no control assigned.
    static constexpr const char* kWork = R"(
for i in range(desk.childCount):
    item = desk.getChildAtIndex(i)
    try: value = item.queryValue()
    except NotImplementedError: continue
    before = (item.name, value.currentValue)
    shown = [value.minimumValue, value.maximumValue, value.minimumIncrement, value.currentValue]
    heard = told()
    value.currentValue = value.minimumValue + 0.3 * (value.maximumValue - value.minimumValue)
    changes(lambda: (item.name, value.currentValue), before, heard)
    print(i, '|', ' '.join(repr(n) for n in shown), '|', item.name, '|', repr(value.currentValue))
)";
    Session app(Settings{}, HandFacts{});
    std::size_t worked = 0;
    for (const std::vector<std::string>& parts : work_at_desk(kWork, 4)) {
        ASSERT_EQ(parts.size(), 4U);
        SCOPED_TRACE(parts[2]);
        ++worked;
        const std::size_t i = std::stoul(parts[0]);
        ASSERT_LT(i, app.desk_visit().desk().controls().size());
        const auto number = app.desk_visit().desk().number(i);
        ASSERT_TRUE(number) << "no quantity";
        ItemNumber shown;
        std::istringstream(parts[1]) >> shown.least >> shown.most >> shown.step >> shown.now;
        EXPECT_NEAR(shown.least, number->least, 1e-9);
        EXPECT_NEAR(shown.most, number->most, 1e-9);
        EXPECT_NEAR(shown.step, number->step, 1e-9);
        EXPECT_NEAR(shown.now, number->now, 1e-9);
        app.desk_visit().put_number(i, number->least + 0.3 * (number->most - number->least));
        EXPECT_EQ(parts[2], " " + app.desk_visit().desk().words(i) + " ");
        EXPECT_NEAR(std::stod(parts[3]), app.desk_visit().desk().number(i)->now, 1e-9);
    }
    std::size_t quantities = 0;
    for (std::size_t i = 0; i < app.desk_visit().desk().controls().size(); ++i)
        quantities += app.desk_visit().desk().number(i).has_value();
    EXPECT_EQ(worked, quantities);
    EXPECT_GE(quantities, 12U);
    ASSERT_TRUE(desktop->press("Escape"));
    leave();
}

TEST_F(ReadByOrca, speaks_each_item_once_and_messages_about_it_too) {
    ASSERT_NO_FATAL_FAILURE(begin(false));
    if (!program) return;
    ASSERT_TRUE(speaks_of("facing north")) << everything();
    ASSERT_TRUE(desktop->press("F10"));
    ASSERT_TRUE(speaks_of("Sound volume")) << everything();
    ASSERT_TRUE(desktop->press("Down"));
    ASSERT_TRUE(speaks_of("Speech volume")) << everything();
    ASSERT_TRUE(desktop->press("F1"));  // F1 explains lists; the explanation is not an item
    EXPECT_TRUE(speaks_of("Up and Down move through the list")) << everything();
    ASSERT_TRUE(desktop->press("Left"));
    EXPECT_TRUE(speaks_of("90 percent")) << everything();
    ASSERT_TRUE(desktop->press("Escape"));
    EXPECT_TRUE(speaks_of("Left")) << everything();
    ::usleep(500000);
    ASSERT_TRUE(desktop->press("c"));
    EXPECT_TRUE(speaks_of("Facing north, 0 degrees")) << everything();
    int items = 0;
    for (const Recorded& entry : desktop->speech->recorded())
        items += entry.event == "speak" && entry.words.find("Speech volume, 100 percent") != std::string::npos;
    EXPECT_EQ(items, 1) << everything();
    // When the list closes, the window's object receives the keyboard focus again. Orca must read only its name, not
    // its kind.
    for (const char* kind : {"drawing area", "unknown"}) EXPECT_FALSE(desktop->speech->spoke(kind)) << everything();
    leave();
}

TEST_F(ReadByOrca, speaks_a_question_and_the_typed_answer) {
    ASSERT_NO_FATAL_FAILURE(begin(false));
    if (!program) return;
    ASSERT_TRUE(speaks_of("facing north")) << everything();
    for (const auto& [key, words] : {std::pair{"Tab", "What you can do"},
                                     {"Down", "Worlds"},
                                     {"Return", "First room"},
                                     {"End", "Another file or folder"},
                                     {"Return", "Which file or folder?"}}) {
        ASSERT_TRUE(desktop->press(key));
        ASSERT_TRUE(speaks_of(words)) << key << "\n" << everything();
    }
    EXPECT_TRUE(eventually([&] {
        return desktop->objects().find("entry \"Which file or folder? Type its path.\" focused") != std::string::npos;
    })) << desktop->objects();
    ASSERT_TRUE(desktop->press("q z"));
    ASSERT_TRUE(desktop->press("Up"));
    EXPECT_TRUE(speaks_of("Type its path. qz")) << everything();
    EXPECT_THAT(desktop->query_objects(R"(
import pyatspi
def show(a):
    if a.getRoleName() == 'entry': print(a.queryText().getText(0, -1))
    for i in range(a.childCount): show(a.getChildAtIndex(i))
for a in pyatspi.Registry.getDesktop(0):
    if a and a.name == 'Handrail': show(a)
)"),
                HasSubstr("qz"));
    ASSERT_TRUE(desktop->press("Escape Escape Escape"));
    leave();
}

TEST_F(ReadByOrca, continues_when_orca_is_killed_and_uses_it_again_when_it_returns) {
    ASSERT_NO_FATAL_FAILURE(begin(true));
    if (!program) return;
    ASSERT_TRUE(speaks_of("facing north")) << everything();
    desktop->kill_orca();
    EXPECT_TRUE(program->says("alert: The screen reader is no longer available; speech now uses the speech server."))
        << everything();
    EXPECT_TRUE(spoken("The screen reader is no longer available; speech now uses the speech server.")) << everything();
    ASSERT_TRUE(desktop->press("Right"));
    EXPECT_TRUE(spoken("North-north-east")) << everything();
    ASSERT_TRUE(desktop->start_orca()) << everything();
    EXPECT_TRUE(speaks_of("Speech now uses the screen reader.")) << everything();
    ASSERT_TRUE(desktop->press("c"));
    EXPECT_TRUE(speaks_of("Facing north-north-east, 22 degrees")) << everything();
    leave();
}

TEST_F(ReadByOrca, continues_when_the_whole_session_bus_ends) {
    ASSERT_NO_FATAL_FAILURE(begin(true));
    if (!program) return;
    ASSERT_TRUE(speaks_of("facing north")) << everything();
    desktop->end_session();
    EXPECT_TRUE(program->says("alert: The screen reader is no longer available; speech now uses the speech server."))
        << everything();
    ASSERT_TRUE(desktop->press("Right"));
    EXPECT_TRUE(spoken("North-north-east")) << everything();
    leave();
}

TEST(WithoutASessionBus, no_bus_is_started_and_speech_does_not_wait_for_one) {
    if (const std::string why = Desktop::why_not(); !why.empty()) GTEST_SKIP() << why;
    const TemporaryFolder folder;
    const auto display = VirtualDisplay::start();
    ASSERT_TRUE(display);
    Exploring program(folder,
                      {{"DISPLAY", std::getenv("DISPLAY")},
                       {"LIBGL_ALWAYS_SOFTWARE", "1"},
                       {"NO_AT_BRIDGE", ""},
                       {"DBUS_SESSION_BUS_ADDRESS", ""},
                       {"XDG_RUNTIME_DIR", folder.path().string()}},
                      {"--device", "none"});
    EXPECT_TRUE(program.says("facing north")) << program.said();
    EXPECT_EQ(processes_called("handrail", folder.path()), 1) << "or this looks at the wrong place";
    EXPECT_EQ(processes_called("dbus-launch", folder.path()), 0);
    EXPECT_EQ(processes_called("dbus-daemon", folder.path()), 0);
}

}  // namespace screen_reader_test
}  // namespace handrail::test
