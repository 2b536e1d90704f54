// Tests labels: the thing under the hand or ahead gets another name, kind or material, by a sentence or from a list.
#include <gmock/gmock.h>

#include <filesystem>

#include "app/core/kept/labels.h"
#include "app/core/places/label_list.h"
#include "haptic/render/haptic_scene.h"
#include "tests/support/box_scene.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"
#include "worlds/base/files.h"

namespace handrail {
namespace labels_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

// Returns the map of a room with a table straight ahead of the walker, who faces north.
std::string room_with_table() {
    return test::entity("worldspawn", test::key("building", "1"), test::room_brushes(0, 0, 0, 200, 200, 96)) +
           test::entity("thing", test::key("name", "Table"), test::box_brush(80, 120, 0, 120, 160, 60)) +
           test::entity("info_player_start", test::key("origin", "100 60 24") + test::key("angle", "90"));
}

struct World {
    World() { EXPECT_TRUE(write_file_atomically(path, room_with_table())); }
    fs::path side_file() const { return path.string() + ".handrail.toml"; }
    test::TemporaryFolder folder;
    fs::path path = folder.path() / "flat.map";
};

struct Person : test::AppSession {
    explicit Person(const fs::path& world) {
        app.apply(WorldEntered{make_ready(test::world_in(world)), SideFile::of_world(world, {})}, now);
        run(0.1);
    }
    const Feature& thing(const std::string& name) const {
        for (const Feature& feature : app.scene()->features)
            if (feature.name == name) return feature;
        ADD_FAILURE() << name;
        return app.scene()->features.front();
    }
};

TEST(Labels, that_a_sentence_gives_are_used_at_once_and_in_the_next_session) {
    const World world;
    {
        Person p(world.path);
        EXPECT_EQ(p.line("call this workbench, landmark, wood"),
                  "Table is now called workbench: a landmark, made of wood.");
        EXPECT_THAT(p.request(Command::AheadOfMe), HasSubstr("Workbench, 3 steps ahead"));
    }
    Person p(world.path);
    const Feature& bench = p.thing("workbench");
    EXPECT_TRUE(bench.landmark);
    EXPECT_EQ(p.app.scene()->material(bench.material).name, "wood");
    // A second label changes only what it says.
    EXPECT_EQ(p.line("label metal, clue"), "Workbench is labelled: a clue, made of metal.");
    EXPECT_EQ(SideFile::of_world(world.path, {}).entries("landmark").size(), 1U);
}

TEST(Labels, can_be_chosen_from_a_list_and_removed_again) {
    const World world;
    Person p(world.path);
    EXPECT_EQ(p.app.keys().find("Alt+E"), Command::Label);
    EXPECT_THAT(p.request(Command::Label), StartsWith("Label Table"));
    EXPECT_THAT(p.line("name"), HasSubstr("Type a name"));
    EXPECT_THAT(p.line("Workbench"), StartsWith("Table is now called Workbench: a thing."));
    p.request(Command::Label);
    p.line("kind");
    EXPECT_EQ(p.line("clue"), "Workbench is labelled: a clue.");
    p.request(Command::Label);
    p.line("material");
    EXPECT_EQ(p.line("steel grille"), "Workbench is labelled: a clue, made of steel grille.");
    EXPECT_FALSE(p.app.requests().take_read_again());
    p.request(Command::Label);
    EXPECT_THAT(p.line("remove"), StartsWith("The label of Table has been removed."));
    EXPECT_TRUE(p.app.requests().take_read_again());
    EXPECT_EQ(SideFile::of_world(world.path, {}).entries("landmark").size(), 0U);
}

TEST(Labels, belong_to_the_thing_that_is_said_to_be_ahead_and_not_to_the_wall_behind_it) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "first_room.map";
    fs::copy_file(test::bundled_world("first_room.map"), path);
    Person p(path);
    for (int i = 0; i < 2; ++i) p.tap(Command::TurnRight, 0.5);
    EXPECT_THAT(p.request(Command::WhereAmI), HasSubstr("Ahead: Table"));
    EXPECT_THAT(p.line("label desk"), StartsWith("Table is now called desk"));
    for (int i = 0; i < 2; ++i) p.tap(Command::TurnLeft, 0.5);
    EXPECT_THAT(p.request(Command::WhereAmI), HasSubstr("Ahead: north wall"));
    EXPECT_THAT(p.line("label far end"), StartsWith("North wall is now called far end"));
}

TEST(Labels, change_what_the_hand_feels) {
    const World world;
    Person p(world.path);
    const auto before = p.app.haptic_scene();
    p.line("label Table, rubber");
    const auto after = p.app.haptic_scene();
    EXPECT_NE(before->generation, after->generation);
    const double rubber = find_material("rubber")->stiffness_fraction;
    const auto has_rubber = [&](const render::HapticScene& scene) {
        return std::any_of(scene.materials.begin(), scene.materials.end(),
                           [&](const auto& material) { return material.stiffness_fraction == rubber; });
    };
    EXPECT_FALSE(has_rubber(*before));
    EXPECT_TRUE(has_rubber(*after));
}

TEST(Labels, say_what_to_do_if_nothing_is_there) {
    test::SceneBuilder b;
    b.box({0, 0, -0.1}, {60, 100, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.start({3, 0.5, 0}, 0.0);
    test::AppSession p;
    p.app.apply(WorldEntered{make_ready(b.share())}, p.now);
    p.run(0.1);
    EXPECT_THAT(p.request(Command::Label), HasSubstr("nothing with a name is ahead"));
}

TEST(Labels, are_read_from_older_files_as_landmarks_and_keep_unknown_keys) {
    SideFile file;
    SideEntry entry;
    entry["name"] = std::string("Table");
    put_place(entry, {1.0, 2.0, 3.0});
    entry["colour"] = std::string("red");
    file.set_entries("landmark", {entry});
    std::vector<Error> faults;
    const std::vector<Label> labels = read_labels(file, faults);
    ASSERT_EQ(labels.size(), 1U);
    EXPECT_EQ(labels[0].kind, LabelKind::Landmark);
    keep_label(file, labels[0]);
    EXPECT_EQ(file.entries("landmark"), std::vector<SideEntry>{entry});
}

TEST(Labels, are_understood_with_commas_and_with_small_words) {
    const auto is = [](const std::string& text, const std::string& called, int kind, const std::string& material) {
        const TypedLabel label = typed_label(text);
        EXPECT_EQ(label.called, called) << text;
        EXPECT_EQ(label.kind ? static_cast<int>(*label.kind) : -1, kind) << text;
        EXPECT_EQ(label.material, material) << text;
    };
    is("piano, landmark, wood", "piano", 1, "wood");
    is("the piano as a landmark of wood", "piano", 1, "wood");
    is("glass door", "glass door", -1, "");
    is("stairs, steel grille", "stairs", -1, "steel grille");
    is("Anna's desk, left", "Anna's desk, left", -1, "");
    const test::InLanguage german("de");
    is("Klavier als Orientierungspunkt aus Holz", "Klavier", 1, "wood");
    is("Stahlgitter", "", -1, "steel grille");
}

}  // namespace labels_test
}  // namespace handrail
