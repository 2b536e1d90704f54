#include "app/core/scenario/scenario.h"

#include <fstream>

#include "app/core/scenario/scenario_run.h"
#include "app/core/session/headless_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace scenario_test {

namespace fs = std::filesystem;

class ScenarioFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  ("handrail_scenario_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(folder_ / "w.map") << "{\n\"classname\" \"worldspawn\"\n}\n";
    }
    void TearDown() override { fs::remove_all(folder_); }
    Result<Scenario> read(const std::string& body) {
        std::ofstream(folder_ / "s.toml") << body;
        return read_scenario(folder_ / "s.toml", {});
    }
    std::string error(const std::string& body) {
        const auto s = read(body);
        return s ? "no error" : s.error().sentence();
    }
    fs::path folder_;
};

constexpr const char* kHead = "title = \"t\"\nworld = \"w.map\"\n";

TEST_F(ScenarioFile, reads_actions_and_expectations_with_their_time_windows) {
    const auto s =
        read(std::string(kHead) +
             "[[do]]\nname = \"go\"\nhold = \"forward\"\nfor_s = 2\n[[do]]\nmove_to = [1, 2, 3.5]\nmeanwhile = true\n"
             "[[expect]]\nsay = \"wall\"\nafter = \"go ends\"\nwithin_s = 0.5\ntimes = 1\n");
    ASSERT_TRUE(s) << s.error().sentence();
    ASSERT_EQ(s->actions.size(), 2U);
    EXPECT_EQ(std::get<HoldCommand>(s->actions[0].step).command, Command::Forward);
    EXPECT_EQ(std::get<MoveHand>(s->actions[1].step).to_m, Vec3(1, 2, 3.5));
    EXPECT_TRUE(s->actions[1].meanwhile);
    EXPECT_TRUE(s->expectations[0].from.at_end);
    EXPECT_EQ(s->expectations[0].to.offset_s, 0.5);
}

TEST_F(ScenarioFile, turns_a_sweep_into_three_moves_per_direction) {
    const auto s = read(std::string(kHead) +
                        "[[do]]\nname = \"w\"\nsweep_at = [0, 0, 1]\nfrom_deg = 0\nto_deg = 90\nangles = 2\nreach_m = "
                        "1\ndepth_m = 0.5\n[[expect]]\nfree = true\n");
    ASSERT_TRUE(s) << s.error().sentence();
    ASSERT_EQ(s->actions.size(), 6U);
    EXPECT_EQ(std::get<MoveHand>(s->actions[1].step).to_m, Vec3(0, -0.5, 1));
    EXPECT_NEAR(std::get<MoveHand>(s->actions[5].step).to_m.x, 1.0, 1e-12);
    EXPECT_EQ(s->actions[5].name, "w last");
}

// For each bad file, the error names the line and what to do. Nothing is returned from a bad file.
TEST_F(ScenarioFile, reports_what_is_wrong_and_where) {
    const std::string head = kHead;
    EXPECT_THAT(error("title = \"t\"\n"), testing::HasSubstr("needs the key \"world\""));
    EXPECT_THAT(error("title = \"t\"\nworld = \"gone.map\"\n"), testing::HasSubstr("line 2"));
    EXPECT_THAT(error(head), testing::HasSubstr("expects nothing"));
    EXPECT_THAT(error(head + "[[do]]\npress = \"forwrad\"\n"),
                testing::AllOf(testing::HasSubstr("line 4"), testing::HasSubstr("\"forward\"")));
    EXPECT_THAT(error(head + "[[do]]\nhold = \"forward\"\n"), testing::HasSubstr("for_s"));
    EXPECT_THAT(error(head + "[[do]]\nwait_s = -1\n"), testing::HasSubstr("from 0 to"));
    EXPECT_THAT(error(head + "[[do]]\nwait_s = 1\npress = \"forward\"\n"), testing::HasSubstr("exactly one"));
    EXPECT_THAT(error(head + "[[do]]\nmove_to = [1, nan, 2]\n"), testing::HasSubstr("finite"));
    EXPECT_THAT(error(head + "[[do]]\nwait = 1\n"), testing::HasSubstr("Did you mean \"wait_s\""));
    EXPECT_THAT(error(head + "[[expect]]\nsaid = \"x\"\n"), testing::HasSubstr("Did you mean \"say\""));
    EXPECT_THAT(error(head + "[[do]]\nname = \"reach\"\nwait_s = 1\n[[expect]]\nsay = \"x\"\nafter = \"reech\"\n"),
                testing::HasSubstr("Did you mean \"reach\""));
    EXPECT_THAT(error(head + "[[expect]]\nsound = \"gong\"\n"), testing::HasSubstr("There is no sound"));
    EXPECT_THAT(error(head + "[[expect]]\nforce_n = [2, 1]\n"), testing::HasSubstr("lower number first"));
    EXPECT_THAT(error(head + "[[do]\n"), testing::HasSubstr("not valid TOML"));
    EXPECT_THAT(error(head + "tytle = 1\n[[expect]]\nfree = true\n"), testing::HasSubstr("Did you mean \"title\""));
}

TEST_F(ScenarioFile, survives_being_cut_at_every_byte) {
    const std::string whole = std::string(kHead) +
                              "[settings]\n\"workspace.scale\" = 30\n[[do]]\nname = \"a\"\npush_n = [0, 1, 0]\nfor_s = "
                              "1\n[[expect]]\nsay = \"x\"\nbefore = \"a\"\n";
    ASSERT_TRUE(read(whole));
    for (std::size_t n = 0; n < whole.size(); ++n) {
        const auto cut = read(whole.substr(0, n));
        if (!cut) {
            EXPECT_FALSE(cut.error().message.empty());
        }
    }
}

// The input determines everything in a session, so two runs make bit-identical logs.
TEST(RunScenario, gives_the_same_log_every_time) {
    struct Silent final : AudioSink {
        void play(const SoundCue&) override { ++count; }
        void set_loop(const SoundCue&) override { ++count; }
        void set_listener(const Listener&) override {}
        void stop_all() override {}
        void tick(double) override {}
        int count = 0;
    };
    struct Mute final : SpeechSink {
        void say(const Utterance& u) override { text += u.text; }
        void stop() override {}
        bool speaking() const override { return false; }
        std::string text;
    };
    test::SceneBuilder b;
    b.box({-5, -5, -0.2}, {5, 5, 0}, "floor");
    b.box({-5, 2, 0}, {5, 2.2, 3}, "wall");
    b.start({0, 0, 0}, 0.0);
    Scenario s;
    s.device = "sim-t";
    s.actions.push_back({"", HoldCommand{Command::Forward, 1.0}, {}, false, 0});
    s.actions.push_back({"", MoveHand{{0.3, 2.4, 1.0}, 0.1, false}, {}, true, 0});
    s.actions.push_back({"", PushHand{{0.5, 1.0, 0.0}, 0.5}, {}, false, 0});
    SessionLog first;
    std::string said;
    for (int round = 0; round < 2; ++round) {
        Silent audio;
        Mute speech;
        const auto log = run_scenario(s, b.share(), audio, speech, {read_requested});
        ASSERT_TRUE(log) << log.error().sentence();
        if (round == 0) {
            first = *log;
            said = speech.text;
            continue;
        }
        ASSERT_EQ(log->ticks.size(), first.ticks.size());
        for (std::size_t i = 0; i < first.ticks.size(); ++i) {
            ASSERT_EQ(log->ticks[i].force_n, first.ticks[i].force_n) << i;
            ASSERT_EQ(log->ticks[i].proxy_m, first.ticks[i].proxy_m) << i;
            ASSERT_EQ(log->ticks[i].feet_m, first.ticks[i].feet_m) << i;
        }
        EXPECT_EQ(speech.text, said);
        EXPECT_FALSE(said.empty());
    }
}

// The settings file next to the world is effective, as for a person. The settings of the scenario override it.
TEST(RunScenario, respects_the_settings_file_next_to_its_world) {
    const test::TemporaryFolder folder;
    const auto world = folder.path() / "room.map";
    std::filesystem::copy_file(test::bundled_world("first_room.map"), world);
    const auto scene = read_world(world);
    ASSERT_TRUE(scene);
    Scenario scenario;
    scenario.device = "sim-t";
    scenario.world.file = world;
    scenario.actions.push_back({"", Wait{0.1}, {}, false, 0});
    const auto scale = [&] {
        RecordingAudio audio;
        RecordingSpeech speech;
        const auto log = run_scenario(scenario, std::make_shared<const Scene>(*scene), audio, speech, {read_requested});
        return log ? std::to_string(log->ticks.back().scale) : log.error().sentence();
    };
    EXPECT_EQ(scale(), "60.000000");
    folder.write("room.settings.toml", "[workspace]\nscale = 8\n");
    EXPECT_EQ(scale(), "8.000000");
    scenario.settings["workspace.scale"] = "20";
    EXPECT_EQ(scale(), "20.000000");
    folder.write("room.settings.toml", "[haptic]\nceiling = \"full\"\n");
    EXPECT_THAT(scale(), testing::HasSubstr("room.settings.toml, line 2"));
}

}  // namespace scenario_test
}  // namespace handrail
