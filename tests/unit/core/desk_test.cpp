// Tests the desk: where its controls are, and that hand and keys change all of them in the same way.
#include "app/core/desk/desk.h"

#include <fmt/format.h>

#include <functional>

#include "app/core/desk/desk_panel.h"
#include "app/core/kept/marks.h"
#include "haptic/servo/personal_space.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/explorer.h"

namespace handrail {
namespace desk_test {

using test::SceneBuilder;

std::shared_ptr<const Scene> open_ground() {
    SceneBuilder b;
    b.box({-20, -20, -0.2}, {20, 20, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    b.box({-20, 19, 0}, {20, 20, 2.6}, "north wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.scene().name = "test ground";
    b.start({0, 0, 0}, 0.0);
    return b.share();
}

// A session in virtual time, with the simulated hand of a device or without a hand.
class DeskSession : public test::Explorer {
public:
    explicit DeskSession(const char* device, const Settings& settings = {})
        : Explorer(open_ground(), device, settings, furnish) {}
    static void furnish(Session& app, WorldEntered& world) {
        app.apply(WorldsKnown{{test::project_root() / "worlds/maps", {}}}, 0.0);
        SideFile& additions = world.additions.emplace();
        std::vector<Mark> marks(2);
        marks[0].name = "Bench";
        marks[0].place_m = {5, 9, 0};
        marks[1].name = "Well";
        marks[1].place_m = {-7, 3, 0};
        write_marks(additions, marks);
    }
    void go(const Vec3& to_m, double speed_m_per_s = 0.15) { hold(to_m, speed_m_per_s); }
    void pull_through() {
        const double reach = spec().workspace_radius_m;
        go({at_m().x, -0.3 * reach, at_m().z});
        go({0.0, -0.3 * reach, 0.0});
        go({0.0, -0.95 * reach, 0.0}, 0.05);
        run(0.2);
        go({0.0, -0.3 * reach, 0.0});
    }
    // Moves the hand in front of the control, and then to the distance `off_m` from its face. A negative distance
    // presses the control.
    bool reach(const std::string& name, double across_m, double up_m, double off_m) {
        const auto place = app().desk_visit().place_m(name);
        if (!place) return false;
        const Vec3 before = *place + Vec3(across_m, -0.012, up_m);
        go({at_m().x, before.y, at_m().z});
        go(before);
        go(*place + Vec3(across_m, -off_m, up_m), 0.05);
        run(0.1);
        return true;
    }
    // Turns pages until the page with the control is shown.
    void find(const std::string& name) {
        for (int i = 0; i < 12 && !app().desk_visit().place_m(name); ++i) press("Next page");
        ASSERT_TRUE(app().desk_visit().place_m(name)) << name;
    }
    double deep_m() const { return 1.5 / effective_stiffness_n_per_m(spec(), 1e-3, 5.0) / 0.8 * 1.05; }
    void touch(const std::string& name) {
        const DeskKind kind = app().desk_visit().desk().controls()[*app().desk_visit().desk().find(name)].kind;
        const bool knob = kind == DeskKind::Knob,
                   list = kind == DeskKind::List;  // touched next to the post of the knob or the notch of the list
        // A slider with an even number of positions has a ridge in its middle, which makes a press there deeper. So the
        // hand touches the slider next to the ridge.
        double across = 0.0;
        if (kind == DeskKind::Slider) {
            const DeskGrid grid = desk_grid(spec());
            const std::size_t i = *app().desk_visit().desk().find(name);
            const DeskPanel panel = lay_out_desk(app().desk_visit().desk().controls(), spec(),
                                                 desk_pages(app().desk_visit().desk().controls(), grid)[i]);
            across = panel.of(i)->x_of(panel.of(i)->positions / 2) - panel.of(i)->x_m;
        }
        ASSERT_TRUE(reach(name, knob ? 0.0045 : across, list ? 0.004 : 0.0, -0.2 * deep_m()));
        withdraw();
    }
    void press(const std::string& name, double across_m = 0.0, double up_m = 0.0) {
        ASSERT_TRUE(reach(name, across_m, up_m, -deep_m()));
        withdraw();
    }
    void withdraw() { go(at_m() - Vec3(0.0, 0.015, 0.0)); }
    void slide_to(const Vec3& to_m) { go(to_m, 0.03); }
};

const char* const kDevices[] = {"sim-t", "sim-f"};

TEST(DeskPanel, controls_are_large_far_apart_reachable_and_complete_on_every_device) {
    Session app(Settings{}, HandFacts{});
    for (const DeviceSpec& spec : device_specs()) {
        SCOPED_TRACE(spec.name);
        std::vector<int> seen(app.desk_visit().desk().controls().size(), 0);
        std::size_t pages = 1;
        for (std::size_t page = 0; page < pages; ++page) {
            const DeskPanel panel = lay_out_desk(app.desk_visit().desk().controls(), spec, page);
            pages = panel.pages;
            EXPECT_TRUE(validate(*panel.scene)) << validate(*panel.scene).error().message;
            for (std::size_t i = 0; i < panel.placed.size(); ++i) {
                const PlacedControl& a = panel.placed[i];
                if (a.control) ++seen[*a.control];
                EXPECT_GE(a.width_m, 0.013 - 1e-12);
                EXPECT_GE(a.height_m, 0.013 - 1e-12);
                const Vec3 corner(std::abs(a.x_m) + 0.5 * a.width_m, a.face_y_m, std::abs(a.z_m) + 0.5 * a.height_m);
                EXPECT_LE(glm::length(corner), spec.workspace_radius_m);
                // The surface that the hand feels is within the stated size, so the gap between two controls is really
                // free.
                const Aabb felt = panel.scene->find(a.feature)->bounds_m;
                if (a.kind != DeskKind::Indicator) {
                    EXPECT_GE(felt.min_m.x, a.x_m - 0.5 * a.width_m - 3e-4);
                    EXPECT_LE(felt.max_m.z, a.z_m + 0.5 * a.height_m + 3e-4);
                }
                for (std::size_t j = 0; j < i; ++j) {
                    const PlacedControl& b = panel.placed[j];
                    const double across = std::abs(a.x_m - b.x_m) - 0.5 * (a.width_m + b.width_m),
                                 up = std::abs(a.z_m - b.z_m) - 0.5 * (a.height_m + b.height_m);
                    EXPECT_GE(std::max(across, up), 0.0064 - 1e-12);
                }
            }
        }
        for (std::size_t i = 0; i < seen.size(); ++i)
            EXPECT_EQ(seen[i], 1) << app.desk_visit().desk().controls()[i].name;
    }
}

TEST(DeskPanel, the_hand_feels_a_detent_for_each_position_of_sliders_and_knobs) {
    DeskSession s("sim-t");
    s.pull_through();
    ASSERT_TRUE(s.app().at_desk());
    const auto control = s.app().desk_visit().desk().find("Speech rate");
    ASSERT_TRUE(control);
    const DeskPanel panel = lay_out_desk(s.app().desk_visit().desk().controls(), *find_device_spec("sim-t"), 0);
    const PlacedControl* slider = panel.of(*control);
    ASSERT_NE(slider, nullptr);
    // The hand slides along under a light press. The proxy must rise over a ridge between each two positions.
    s.reach("Speech rate", slider->x_of(0) - slider->x_m, 0.0, -0.002);
    std::vector<double> heights;
    for (double x = slider->x_of(0); x <= slider->x_of(slider->positions - 1); x += 1e-4) {
        s.slide_to({x, s.at_m().y, s.at_m().z});
        heights.push_back(slider->face_y_m - kDeskProxyM - s.tool().desk.proxy_m.y);
    }
    int ridges = 0;
    bool up = false;
    for (const double height : heights) {
        if (!up && height > 1.5e-4) up = true, ++ridges;
        if (up && height < 0.8e-4) up = false;
    }
    EXPECT_EQ(ridges, slider->positions - 1);
}

TEST(DeskPanel, a_control_has_the_same_number_on_every_page) {
    // If the numbers of controls changed while a control is pressed and the page turns, the press would change another
    // control of the new page.
    Session app(Settings{}, HandFacts{});
    const auto controls = app.desk_visit().desk().controls();
    const DeviceSpec& spec = *find_device_spec("sim-f");
    const DeskPanel first = lay_out_desk(controls, spec, 0);
    ASSERT_GE(first.pages, 3U);
    FeatureId turn = kNoFeature;
    std::vector<FeatureId> seen;
    for (std::size_t page = 0; page < first.pages; ++page)
        for (const PlacedControl& one : lay_out_desk(controls, spec, page).placed) {
            if (one.control) {
                EXPECT_EQ(std::count(seen.begin(), seen.end(), one.feature), 0) << controls[*one.control].name;
                seen.push_back(one.feature);
            } else {
                EXPECT_TRUE(page == 0 || one.feature == turn) << page;
                turn = one.feature;
            }
        }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), turn), 0);
}

// Every control gives the same result, whether the hand operates it at the desk or keys operate it in the list.
TEST(Desk, every_control_can_be_read_and_changed_by_hand_and_by_keys) {
    for (const char* device : kDevices) {
        if (device != kDevices[0] && test::kSanitizerScale < 1.0) continue;
        DeskSession by_hand(device), by_keys(nullptr);
        by_hand.pull_through();
        ASSERT_TRUE(by_hand.app().at_desk()) << device;
        EXPECT_TRUE(by_hand.heard("Your desk")) << by_hand.all_heard(0);
        by_keys.key("F10");
        const Desk& desk = by_hand.app().desk_visit().desk();
        for (std::size_t i = 0; i < desk.controls().size(); ++i) {
            const DeskControl control = desk.controls()[i];
            SCOPED_TRACE(fmt::format("{}, {}", device, control.name));
            // This control shows which device is in use. Pressing it starts a search for connected devices.
            const bool of_hand = control.name == "Touch device";
            EXPECT_EQ(by_keys.app().desk_visit().desk().controls()[i].name, control.name);
            // Touches the control, so that its value is announced.
            by_hand.find(control.name);
            std::size_t from = by_hand.lines();
            by_hand.touch(control.name);
            EXPECT_TRUE(by_hand.heard(desk.words(i), from))
                << by_hand.all_heard(from) << " instead of " << desk.words(i);
            const DialogueView view = by_keys.app().dialogue().view();
            ASSERT_EQ(view.kind, DialogueView::Kind::List);
            ASSERT_EQ(view.at, i);
            EXPECT_EQ(view.items[i].name, control.name);
            EXPECT_EQ(view.items[i].value, by_keys.app().desk_visit().desk().value(i));
            if (!of_hand) {
                EXPECT_EQ(by_keys.app().desk_visit().desk().value(i), desk.value(i));
            }
            // Changes the value of the control.
            from = by_hand.lines();
            const int before = control.count() > 0 ? control.position() : 0;
            const int step = before > 0 ? -1 : 1;
            const char* key = step > 0 ? "Right" : "Left";
            switch (control.kind) {
                case DeskKind::Slider: {
                    const DeskPanel panel =
                        lay_out_desk(desk.controls(), *find_device_spec(device),
                                     desk_pages(desk.controls(), desk_grid(*find_device_spec(device)))[i]);
                    const PlacedControl& on = *panel.of(i);
                    by_hand.press(control.name, on.x_of(before + step) - on.x_m);
                    by_keys.key(key);
                    break;
                }
                case DeskKind::List:
                    by_hand.press(control.name, 0.0, step > 0 ? -0.004 : 0.004);
                    by_keys.key(key);
                    break;
                case DeskKind::Assign: {
                    by_hand.press(control.name);
                    EXPECT_TRUE(by_hand.heard("set by the knob", from)) << by_hand.all_heard(from);
                    by_hand.find("Volume knob");
                    // Turns the knob until the value has changed. Anticlockwise reduces the value.
                    ASSERT_TRUE(by_hand.reach("Volume knob", 0.0, 0.0045, -by_hand.deep_m()));
                    const Vec3 top = by_hand.at_m();
                    for (int deg = 3; deg <= 120 && control.position() == before;
                         deg += 3) {  // The hand of a soft device lags behind its target.
                        const double turn = radians_from_degrees(deg);
                        by_hand.slide_to(top +
                                         Vec3(0.0045 * step * std::sin(turn), 0.0, 0.0045 * (std::cos(turn) - 1.0)));
                    }
                    by_hand.withdraw();
                    by_keys.key("Enter");
                    by_keys.key(key);
                    break;
                }
                case DeskKind::Knob: {
                    ASSERT_TRUE(by_hand.reach(control.name, 0.0045, 0.0,
                                              // The turn starts at three o'clock. Turning clockwise increases the
                                              // value.
                                              -by_hand.deep_m()));
                    const Vec3 right = by_hand.at_m();
                    const std::string knob_before = desk.value(i);
                    for (int deg = 3; deg <= 120 && desk.value(i) == knob_before; deg += 3) {
                        const double turn = radians_from_degrees(deg);
                        by_hand.slide_to(right + Vec3(0.0045 * (std::cos(turn) - 1.0), 0.0, -0.0045 * std::sin(turn)));
                    }
                    by_hand.withdraw();
                    EXPECT_NE(desk.value(i), knob_before);
                    by_keys.key("Right");
                    break;
                }
                case DeskKind::Button:
                    by_hand.press(control.name);
                    by_keys.key("Enter");
                    break;
                case DeskKind::Indicator:
                    by_hand.press(control.name);
                    EXPECT_TRUE(by_hand.heard(desk.words(i), from));
                    by_keys.key("Enter");
                    break;
            }
            if (control.count() > 0) {
                EXPECT_EQ(control.position(), before + step);
            }
            if (!of_hand) {
                EXPECT_EQ(by_keys.app().desk_visit().desk().value(i), desk.value(i));
            }
            if (control.kind != DeskKind::Indicator && control.kind != DeskKind::Knob) {
                EXPECT_TRUE(by_hand.heard(of_hand ? "Looking for devices that are plugged in." : desk.value(i), from))
                    << by_hand.all_heard(from);
            }
            for (const DeskSetting& row : desk_settings()) {
                if (row.key == "workspace.scale") continue;
                EXPECT_EQ(*setting_text(by_hand.app().settings(), row.key),
                          *setting_text(by_keys.app().settings(), row.key))
                    << row.key;
            }
            by_keys.key("Down");
        }
        // A change of the scale waits until the hand is back in the world. After that, both sessions have the same
        // scale.
        EXPECT_EQ(by_hand.app().settings().workspace.scale, Settings{}.workspace.scale);
        by_hand.pull_through();
        EXPECT_FALSE(by_hand.app().at_desk());
        EXPECT_TRUE(by_hand.heard("Back in the world. At the base"));
        EXPECT_NE(by_hand.app().settings().workspace.scale, Settings{}.workspace.scale);
        EXPECT_EQ(by_hand.app().settings().workspace.scale, by_keys.app().settings().workspace.scale);
    }
}

TEST(Desk, a_world_is_chosen_from_its_list_and_entered_with_the_button_next_to_it) {
    DeskSession s(nullptr);
    Session& app = s.app();
    const std::size_t world = *app.desk_visit().desk().find("World"),
                      go = *app.desk_visit().desk().find("Go to that world");
    EXPECT_FALSE(app.requests().take_world());
    const std::string first = app.desk_visit().desk().value(world), second = app.desk_visit().step(world, 1);
    EXPECT_NE(first, second);
    EXPECT_FALSE(app.requests().take_world()) << "looking through the list goes nowhere";
    EXPECT_EQ(app.desk_visit().press(go), "Going to " + second + ".");
    const auto wanted = app.requests().take_world();
    ASSERT_TRUE(wanted);
    EXPECT_EQ(name_of_file(wanted->file), second);
    EXPECT_TRUE(std::filesystem::exists(wanted->file));
    app.apply(WorldsKnown{{}}, s.now_s());
    EXPECT_EQ(app.desk_visit().desk().value(world), "none");
    EXPECT_EQ(app.desk_visit().step(world, 1), "none");
    EXPECT_EQ(app.desk_visit().press(go), "There is no world to go to.");
    EXPECT_FALSE(app.requests().take_world());
}

TEST(Desk, a_beacon_can_be_set_on_a_mark_from_its_list_and_removed) {
    DeskSession s(nullptr);
    Session& app = s.app();
    const std::size_t mark = *app.desk_visit().desk().find("Mark"),
                      beacon = *app.desk_visit().desk().find("Beacon on that mark");
    EXPECT_EQ(app.desk_visit().desk().value(mark), "Bench");
    EXPECT_EQ(app.desk_visit().step(mark, 1), "Well");
    EXPECT_EQ(app.desk_visit().desk().value(beacon), "off");
    EXPECT_EQ(app.desk_visit().press(beacon).rfind("Beacon on Well, ", 0), 0U);
    EXPECT_EQ(app.desk_visit().desk().value(beacon), "Well");
    EXPECT_EQ(app.guide().beacon().name(), "Well");
    EXPECT_EQ(app.desk_visit().step(mark, -1), "Bench");
    app.desk_visit().press(beacon);
    EXPECT_EQ(app.guide().beacon().name(), "Bench") << "another mark is taken at once";
    EXPECT_EQ(app.desk_visit().press(beacon), "Beacon off");
    EXPECT_FALSE(app.guide().beacon().on());
    app.apply(WorldEntered{make_ready(open_ground())}, 1.0);  // this world has no marks
    EXPECT_EQ(app.desk_visit().desk().value(mark), "none yet");
    EXPECT_EQ(app.desk_visit().press(beacon), "There are no marks yet. Insert or Shift+M sets one.");
}

TEST(Desk, steps_or_metres_position_and_explored_share_are_shown) {
    DeskSession s(nullptr);
    Session& app = s.app();
    const std::size_t units = *app.desk_visit().desk().find("Steps or metres"),
                      where = *app.desk_visit().desk().find("Where am I");
    EXPECT_EQ(app.desk_visit().desk().value(units), "steps");
    EXPECT_EQ(app.desk_visit().press(units), "Distances in metres");
    EXPECT_FALSE(app.settings().speech.distances_in_steps);
    EXPECT_EQ(app.desk_visit().desk().value(units), "metres");
    EXPECT_EQ(app.desk_visit().press(where), app.where_am_i());
    const std::size_t explored = *app.desk_visit().desk().find("Explored");
    const std::string before = app.desk_visit().desk().value(explored);
    EXPECT_EQ(before.rfind("Walls ", 0), 0U) << before;
    s.key("Up");
    s.run(8.0);
    app.apply(CommandDown{Command::Forward}, 8.2);
    s.run(12.0);
    app.apply(CommandUp{Command::Forward}, 8.2);
    EXPECT_NE(app.desk_visit().desk().value(explored), before);
}

TEST(Desk, lists_and_lessons_are_german_in_a_german_session) {
    const test::InLanguage german("en");  // restores English at the end of the test
    Session app(Settings{}, HandFacts{});
    ASSERT_TRUE(app.desk_visit().desk().find("Speech volume"));
    Settings settings;
    settings.speech.language = "de";
    app.apply(SettingsChanged{settings}, 0.0);
    const auto volume = app.desk_visit().desk().find("Lautstärke der Sprache"),
               force = app.desk_visit().desk().find("Stärkste Kraft");
    ASSERT_TRUE(volume && force);
    EXPECT_EQ(app.desk_visit().step(*volume, -1), "90 Prozent");
    EXPECT_EQ(app.desk_visit().desk().words(*force), "Stärkste Kraft, normal, 2,5 Newton");
    Dialogue dialogue;
    ListSpec list;
    list.title = "Welten";
    list.items = {{"Haus", {}, false}, {"Schule", {}, false}};
    EXPECT_EQ(dialogue.open(std::move(list)), "Welten. Haus, 1 von 2");
    LessonRun first(first_minutes(), false, "Orca");
    EXPECT_EQ(first.begin().instruction,
              "Willkommen. Handrail spricht mit Orca. Enter beginnt, Leertaste sagt es noch einmal, Escape verlässt.");
}

// A screen reader sets a number, and the control moves to the nearest position. So the hand, the keys and the
// accessible tree can reach the same values.
TEST(Desk, quantities_are_numbers_and_snap_to_the_nearest_position) {
    Session app(Settings{}, HandFacts{});
    const Desk& desk = app.desk_visit().desk();
    const auto find = [&](const char* name) { return *desk.find(name); };
    const std::size_t volume = find("Sound volume"), knob = find("Volume knob"), rate = find("Speech rate"),
                      force = find("Strongest force");
    EXPECT_EQ(desk.number(knob), ItemNumber{}) << "nothing is on it";
    EXPECT_EQ(app.desk_visit().put_number(knob, 0.5), desk.value(knob));
    EXPECT_EQ(app.desk_visit().put_number(volume, 0.43), "40 percent");
    ASSERT_TRUE(desk.number(volume));
    EXPECT_NEAR(desk.number(volume)->now, 0.4, 1e-12);
    EXPECT_NEAR(desk.number(volume)->step, 0.1, 1e-9);
    EXPECT_EQ(desk.number(volume)->least, 0.0);
    EXPECT_EQ(desk.number(volume)->most, 1.0);
    app.desk_visit().press(volume);
    EXPECT_EQ(desk.number(knob), desk.number(volume));
    EXPECT_EQ(app.desk_visit().put_number(knob, 7.0), "100 percent, Sound volume") << "beyond the end is the end";
    EXPECT_EQ(desk.value(volume), "100 percent");
    EXPECT_EQ(app.desk_visit().put_number(rate, 262.0), "250 words per minute");
    EXPECT_EQ(desk.number(rate)->step, 25.0);
    EXPECT_EQ(app.desk_visit().put_number(force, 2.0), "full, as strong as the device allows")
        << "a slider of words counts its positions";
    EXPECT_EQ(desk.number(force)->most, 2.0);
    for (const double none : {std::nan(""), HUGE_VAL, -HUGE_VAL})
        EXPECT_EQ(app.desk_visit().put_number(rate, none), "250 words per minute");
    // Every slider, volume and knob is a quantity; switches, choices and buttons are not.
    for (std::size_t i = 0; i < desk.controls().size(); ++i) {
        const DeskControl& control = desk.controls()[i];
        const bool number = desk.number(i).has_value();
        const bool worked_along =
            control.kind == DeskKind::Slider || control.kind == DeskKind::Assign || control.kind == DeskKind::Knob;
        EXPECT_TRUE(number || !worked_along) << control.name;
        EXPECT_FALSE(number &&
                     (control.kind == DeskKind::Button || control.kind == DeskKind::Indicator || control.many))
            << control.name;
        if (!number || control.kind == DeskKind::Knob) continue;
        // Setting an end or a position by its number gives the same value as single steps to it.
        app.desk_visit().put_number(i, desk.number(i)->least);
        for (int position = 0; position < control.count(); ++position) {
            EXPECT_EQ(control.position(), position) << control.name;
            const ItemNumber there = *desk.number(i);
            app.desk_visit().step(i, 1);
            app.desk_visit().put_number(i, there.now + 0.3 * there.step);
            EXPECT_EQ(desk.number(i)->now, there.now) << control.name;
            app.desk_visit().step(i, 1);
        }
        EXPECT_EQ(desk.number(i)->now, desk.number(i)->most) << control.name;
    }
}

TEST(Desk, grooves_are_switched_on_the_desk_and_felt_in_the_world) {
    Session app(Settings{}, HandFacts{});
    const std::size_t grooves = *app.desk_visit().desk().find("Grooves in the floor");
    EXPECT_EQ(app.desk_visit().desk().value(grooves), "off");
    EXPECT_EQ(app.desk_visit().step(grooves, 1), "on");
    EXPECT_TRUE(app.settings().guidance.grooves);
    EXPECT_EQ(app.take_setting_changes().back(), (std::pair<std::string, std::string>("guidance.grooves", "true")));
    EXPECT_EQ(app.desk_visit().step(grooves, -1), "off");
    EXPECT_FALSE(app.settings().guidance.grooves);
}

TEST(Desk, the_device_button_presses_the_control_that_the_hand_touches) {
    DeskSession s("sim-t");
    s.pull_through();
    ASSERT_TRUE(s.reach("Sound volume", 0.0, 0.0, -0.2 * s.deep_m()));
    EXPECT_FALSE(s.app().desk_visit().desk().on_knob());
    s.button(true);
    EXPECT_EQ(s.app().desk_visit().desk().on_knob(), s.app().desk_visit().desk().find("Sound volume"));
    s.button(false);
}

TEST(Desk, the_world_pauses_and_escape_returns_to_it) {
    DeskSession s("sim-t");
    s.pull_through();
    ASSERT_TRUE(s.app().at_desk());
    const Vec3 feet = s.app().feet_m();
    const std::size_t from = s.lines();
    s.key("Up");
    s.key("Right");
    s.run(1.0);
    EXPECT_EQ(s.app().feet_m(), feet);
    EXPECT_EQ(s.app().heading_rad(), 0.0);
    EXPECT_TRUE(s.heard("You are at your desk", from));
    s.key("Escape");
    s.run(0.1);
    EXPECT_FALSE(s.app().at_desk());
    EXPECT_FALSE(s.app().requests().leave);
    s.key("Up");
    s.run(1.0);
    EXPECT_GT(s.app().feet_m().y, 0.5);
}

TEST(Desk, can_be_switched_off_completely) {
    Settings settings;
    settings.desk.use = false;
    DeskSession s("sim-t", settings);
    s.pull_through();
    EXPECT_FALSE(s.app().at_desk());
    EXPECT_FALSE(s.heard("Your desk"));
    s.key("F10");
    EXPECT_FALSE(s.app().dialogue().is_open());
    EXPECT_TRUE(s.heard("switched off"));
}

TEST(Desk, a_value_between_two_positions_moves_to_the_next_one_in_either_direction) {
    Settings settings;
    settings.sound.volume = 0.83;
    Session app(settings, HandFacts{});
    const std::size_t volume = *app.desk_visit().desk().find("Sound volume");
    EXPECT_EQ(app.desk_visit().desk().value(volume), "83 percent");
    EXPECT_EQ(app.desk_visit().step(volume, 1), "90 percent");
    settings.sound.volume = 0.83;
    app.apply(SettingsChanged{settings}, 0.0);
    EXPECT_EQ(app.desk_visit().step(volume, -1), "80 percent");
    EXPECT_EQ(app.desk_visit().step(volume, -20), "0 percent");
    EXPECT_EQ(app.desk_visit().step(volume, -1), "0 percent");
    EXPECT_EQ(app.desk_visit().put(volume, 99), "100 percent");
    const std::size_t force = *app.desk_visit().desk().find("Strongest force");
    EXPECT_EQ(app.desk_visit().step(force, 1), "full, as strong as the device allows");
    EXPECT_EQ(app.settings().haptic.ceiling, ForceCeiling::Full);
    const auto changes = app.take_setting_changes();
    ASSERT_FALSE(changes.empty());
    EXPECT_EQ(changes.back(), (std::pair<std::string, std::string>("haptic.ceiling", "full")));
}

}  // namespace desk_test
}  // namespace handrail
