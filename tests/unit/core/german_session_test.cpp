// Tests a short session in German. Everything that the session says consists of whole German sentences, with the German
// names of the map. A change of the language takes effect with the next sentence.
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace german_session_test {

std::shared_ptr<const Scene> world(const char* file) { return test::world_once(test::project_root() / file); }

struct Visitor : test::AppSession {
    explicit Visitor(const Settings& settings = {}) : AppSession(settings, hand()) {}
    static HandFacts hand() {
        HandFacts facts;
        facts.present = facts.simulated = true;
        facts.spec = ideal_device_spec();
        return facts;
    }
    void touch(const std::string& name) {
        const auto& features = app.scene()->features;
        const auto found = std::find_if(features.begin(), features.end(),
                                        [&](const Feature& feature) { return feature.name == name; });
        ASSERT_NE(found, features.end()) << name;
        tool.contacts.count = 1;
        tool.contacts.strongest = 0;
        tool.contacts.contacts[0].feature = FeatureId{static_cast<std::uint32_t>(found - features.begin())};
        tool.ticks = 1;
        tool.waiting_for_hand = false;
    }
};

TEST(GermanSession, of_questions_touch_and_walking_is_in_whole_german_sentences_from_start_to_end) {
    const test::InLanguage german("de");
    Visitor s;
    s.app.apply(WorldEntered{make_ready(world("worlds/maps/house.map"))}, 0.0);
    s.run(0.1);
    EXPECT_EQ(s.said.front(),
              "Haus mit Garten, 20 mal 23 Meter. An der Tür, am Ausgangspunkt, Blick nach Norden. Haustür: 1 Schritt "
              "hinten. Vorn: Treppe, 4 Schritte. Pfeil hoch geht einen Schritt. F2 sagt den Standort, F1 die Tasten.");
    EXPECT_EQ(
        s.request(Command::WhereAmI),
        "Flur, an der Tür, am Ausgangspunkt, Blick nach Norden. Haustür Richtung Garten: 1 Schritt hinten. Tür zum "
        "Arbeitszimmer Richtung Arbeitszimmer: 3 Schritte, halb rechts.");
    EXPECT_EQ(s.request(Command::AroundMe),
              "Halb links: Wohnzimmertür, 3 Schritte. Halb rechts: Tür zum Arbeitszimmer, 3 Schritte. Hinten: "
              "Fußmatte, ganz nah. "
              "Links: Garderobenständer, 1 Schritt.");
    EXPECT_EQ(s.request(Command::AheadOfMe),
              "Wohnzimmertür, 3 Schritte, halb links. Standuhr, 4 Schritte, leicht rechts. "
              "Handlauf, 5 Schritte vorn. Treppe, 6 Schritte vorn.");
    EXPECT_EQ(s.request(Command::Heading), "Blick nach Norden, 0 Grad");
    s.touch("north wall");
    s.run(0.1);
    EXPECT_EQ(s.request(Command::WhatIsThis), "Nordwand, Sand");
    s.tool.contacts.count = 0;
    s.run(0.1);
    EXPECT_EQ(s.request(Command::WhatIsThis), "Die Hand berührt nichts.");
    s.request(Command::Forward);
    s.run(1.0);
    EXPECT_EQ(s.request(Command::Coordinates),
              "6 Ost, 1,4 Nord, Höhe 0 Meter, auf dem Boden. Die Hand: 0 Ost, 0 Nord, Höhe 0 Meter, darunter "
              "ist nichts.");
    EXPECT_EQ(s.request(Command::ScaleBar),
              "5 Schritte oder 3,5 Meter sind unter der Hand 5,8 Zentimeter. "
              "Norden ist für die Hand vom Körper weg, für die Füße vorn.");
    EXPECT_EQ(s.request(Command::ScaleRoom), "Raum, 9,6 Meter breit, 14 Schritte");
    const std::string exits =
        "Gartentür Richtung Garten: 11 Schritte vorn. Tür zum Hauswirtschaftsraum Richtung Hauswirtschaftsraum: 9 "
        "Schritte vorn. Badezimmertür Richtung Badezimmer: 6 Schritte, leicht rechts. Tür zum Arbeitszimmer Richtung "
        "Arbeitszimmer: 2 Schritte, rechts. Haustür Richtung Garten: 2 Schritte hinten. Wohnzimmertür Richtung "
        "Wohnzimmer: 2 Schritte, links. Treppe: 2 Schritte, leicht links.";
    EXPECT_EQ(s.request(Command::Exits), "Flur. 7 Ausgänge. " + exits);
    EXPECT_EQ(s.request(Command::UnvisitedExits), "Flur. 7 noch unbenutzte Ausgänge. " + exits);
    EXPECT_EQ(s.request(Command::Home), "Ausgangspunkt. Blick nach Norden.");
    EXPECT_EQ(s.request(Command::Leave), "Noch einmal Escape drücken, um zu beenden.");
    EXPECT_EQ(s.request(Command::Leave), "Auf Wiedersehen.");
}

// Makes a platform that ends four metres to the north, 1.2 metres above the ground beyond.
std::shared_ptr<const Scene> platform() {
    test::SceneBuilder b;
    b.box({-5, -5, -4}, {5, 4, 0}, "floor", SolidRole::Solid, "concrete", FeatureKind::Floor);
    b.box({-5, 4, -4}, {5, 14, -1.2}, "lower floor", SolidRole::Solid, "concrete", FeatureKind::Floor);
    b.start({0, 0, 0}, 0.0);
    return b.share();
}

TEST(GermanSession, warns_of_a_drop_in_german_and_stops_at_its_edge) {
    const test::InLanguage german("de");
    Visitor s;
    s.app.apply(WorldEntered{make_ready(platform())}, 0.0);
    s.run(0.1);
    s.said.clear();
    s.hold(Command::Forward, 6.0);
    EXPECT_EQ(s.said, (std::vector<std::string>{
                          "Absturzkante vorn, 3 Schritte",
                          "Absturzkante, 1,2 Meter tief. Noch einmal drücken, um darüber hinauszugehen."}));
}

TEST(GermanSession, reports_in_german_what_was_learnt_of_a_place_and_what_is_left) {
    const test::InLanguage german("de");
    Visitor s;
    s.app.apply(WorldEntered{make_ready(world("tests/scenarios/worlds/two_rooms_door.map"))}, 0.0);
    s.run(0.1);
    EXPECT_EQ(s.request(Command::LearnPlace),
              "Lernen: Raum, darin Bookcase. Hier ist der Ausgangspunkt. Zuerst die Wände: Umschalt+Pfeil links "
              "halten, um an ihnen entlangzugehen. 8 sagt den "
              "Stand, 7 was noch fehlt.");
    s.hold(Command::TrailLeft, 6.0);
    EXPECT_EQ(s.request(Command::ProgressReport),
              "Wände 23 Prozent, Boden 23 Prozent, 0 von 1 Tür. 6 Sekunden. Berührt: Westwand, Putz, Südwand, Putz, "
              "Bookcase, Holz.");
    EXPECT_EQ(s.request(Command::Unexplored), "Noch nicht erkundet: Boden, 1 Schritt, 170 Grad rechts");
    EXPECT_EQ(s.request(Command::Hunt),
              "Eine Uhr ist versteckt und tickt schnell, mit Kuckucksruf. Jetzt suchen: hingehen oder nach ihr "
              "greifen. 0 gibt einen Tipp.");
    EXPECT_EQ(s.request(Command::Hunt), "Weiter: 3 Schritte, 125 Grad rechts. Zu Fuß bis zur Uhr: 9 Schritte.");
    EXPECT_EQ(s.request(Command::SquareUp),
              "Gerade ausgerichtet. Blick nach Westen. Bookcase, Holz, 1 Schritt geradeaus");
    EXPECT_EQ(
        s.request(Command::LearnPlace),
        "Das Lernen ist beendet. Wände 23 Prozent, Boden 23 Prozent, 0 von 1 Tür. 6 Sekunden. Berührt: Westwand, Putz, "
        "Südwand, Putz, Bookcase, Holz.");
}

TEST(GermanSession, follows_the_language_for_generated_names_of_rooms_and_walls_but_keeps_the_maps_own_names) {
    Visitor s;
    s.app.apply(WorldEntered{make_ready(world("tests/scenarios/worlds/two_rooms_door.map"))}, 0.0);
    s.run(0.1);
    const std::string english = s.request(Command::WhereAmI);
    EXPECT_EQ(
        english,
        "Room with Bookcase, at the base, facing north. Door to room, north: 4 steps ahead. Ahead: Door, 4 steps.");
    {
        const test::InLanguage german("de");
        s.run(0.1);
        EXPECT_EQ(s.request(Command::WhereAmI),
                  "Bookcase, 2 Schritte, links. Rechts: Ostwand, Putz, 3 Schritte. Hinten: Südwand, Putz, 1 Schritt.")
            << "asked a second time";
        EXPECT_TRUE(
            s.request(Command::WhereAmI).starts_with("Raum, darin Bookcase, am Ausgangspunkt, Blick nach Norden. "));
        s.request(Command::WhereAmI);
    }
    s.run(0.1);
    EXPECT_EQ(s.request(Command::WhereAmI), english);
}

}  // namespace german_session_test
}  // namespace handrail
