// Tests how the session explains actions: by words for a person who types, by keys for a person who presses keys. If
// there is no device, the session does not mention force. It announces soft things in the same way as hard things.
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/core/explorer.h"
#include "worlds/base/typist.h"

namespace handrail {
namespace acting_words_test {

using test::box_brush;
using test::entity;
using test::key;

struct Typist {
    Typist() { speak_to_typist(true); }
    ~Typist() { speak_to_typist(false); }
};

TEST(ActingWords, name_typed_commands_if_the_person_types) {
    const Typist typist;
    EXPECT_EQ(KeyMap({}).keys_of(Command::DropMark), "mark");
    test::AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    s.run(0.1);
    EXPECT_TRUE(s.heard("Type forward to walk. Type where to hear where you are, or help for a list of words."))
        << s.news();
    EXPECT_EQ(s.request(Command::KeptRoutes),
              "You have not kept a route here yet. keep-way keeps the route that you planned or walked last.");
    EXPECT_EQ(s.request(Command::WhatIsThis), "There is no touch device. Type where to hear what is around you.");
    EXPECT_EQ(s.request(Command::StopEverything), "Stopped. forces turns sounds on again.");
    // No announcement names a key.
    for (const std::string& line : s.said)
        for (const char* word : {"Press", "F1", "F2", "F12", "Shift+", "Enter", "Escape", "Grave"})
            EXPECT_EQ(line.find(word), std::string::npos) << line;
}

TEST(ActingWords, name_keys_if_the_person_uses_keys) {
    test::AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    s.run(0.1);
    EXPECT_TRUE(s.heard("Press Up to walk. F2 says where you are, and F1 lists the keys."));
    EXPECT_EQ(s.request(Command::KeptRoutes),
              "You have not kept a route here yet. Control+8 keeps the route that you planned or walked last.");
}

TEST(WithNoDevice, nothing_is_said_about_force) {
    test::AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    s.run(0.1);
    for (const Command command : {Command::ToggleForces, Command::ToggleForces, Command::StopEverything,
                                  Command::ToggleForces, Command::TakeMe, Command::CrossLines}) {
        s.request(command);
        s.run(0.5);
    }
    EXPECT_TRUE(s.heard("There is no touch device."));
    EXPECT_TRUE(s.heard("Stopped."));
    EXPECT_TRUE(s.heard("Sounds on again"));
    for (const std::string& line : s.said) EXPECT_EQ(line.find("orce"), std::string::npos) << line;
    EXPECT_EQ(s.count(SoundKind::ForcesOn) + s.count(SoundKind::ForcesOff), 0);
    EXPECT_FALSE(s.app.hand().tuning.panic);
    EXPECT_TRUE(s.app.hand().tuning.forces_on) << "a device that is plugged in later is not off";
}

TEST(WhatGivesWay, is_announced_while_it_is_pressed) {
    for (const char* soft : {"elastic", "plastic"}) {
        const std::string room = test::room_brushes(0, 0, 0, 320, 640, 128);
        const std::string cushion =
            entity("func_wall", key("name", "Big cushion") + key("soft", soft) + key("soft_depth", "16"),
                   box_brush(96, 64, 0, 224, 192, 20));
        auto scene =
            read_quake_map(entity("worldspawn", key("building", "1"), room) +
                               entity("info_player_start", key("origin", "160 40 24") + key("angle", "90")) + cushion,
                           "soft.map", {});
        ASSERT_TRUE(scene);
        test::Explorer person(std::make_shared<const Scene>(std::move(*scene)), "sim-t");
        person.tap(Command::ScaleDetail, 1.5);
        const double ground_m = 20.0 / 32.0;
        // Moves the hand down onto the soft thing, a millimetre at a time, until the thing pushes back although the
        // hand touches nothing hard.
        bool pressed = false;
        person.hold({0.0, 0.04, 0.0});
        person.tap(Command::ScaleRoom, 1.5);
        for (double z = 0.0; z > -0.06 && !pressed; z -= 0.001) {
            person.hold({0.0, 0.03, z}, 0.05);
            person.run(0.05);
            pressed = person.tool().soft_n > 0.2 && person.tool().contacts.count == 0;
        }
        ASSERT_TRUE(pressed) << soft << " at " << person.tool().proxy_m.z << ", its top at " << ground_m;
        const FeatureId felt = person.tool().touched();
        EXPECT_EQ(person.app().scene()->features[felt.value].name, "Big cushion");
        const std::size_t from = person.lines();
        person.tap(Command::WhatIsThis, 1.0);
        EXPECT_TRUE(person.heard("Big cushion", from)) << person.all_heard(from);
        person.hold({0.0, 0.03, 0.03});
        person.run(0.3);
        EXPECT_FALSE(person.tool().touches());
    }
}

}  // namespace acting_words_test
}  // namespace handrail
