// Tests the list of faults that somebody should correct in a world. A person goes from fault to fault with keys and
// typed words, and corrects the faults in the list.
#include "app/core/kept/labels.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/explorer.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace fault_list_test {

using test::Explorer;
using testing::HasSubstr;

// Makes a room of 8 by 6 metres without a name and a landmark. It has two things, one of which could be a landmark.
std::shared_ptr<const Scene> bare_room() {
    const std::string map = test::entity("worldspawn", test::key("message", "Bare room") + test::key("building", "1"),
                                         test::room_brushes(0, 0, 0, 256, 192, 96)) +
                            test::entity("thing", test::key("name", "Stove"), test::box_brush(0, 0, 0, 20, 20, 30)) +
                            test::entity("info_player_start", test::key("origin", "128 96 24"));
    Result<Scene> scene = read_quake_map(map, "bare.map");
    EXPECT_TRUE(scene.has_value());
    return std::make_shared<const Scene>(std::move(*scene));
}

std::vector<std::string> names_of(const DialogueView& view) {
    std::vector<std::string> names;
    for (const ListItem& item : view.items) names.push_back(item.name);
    return names;
}

TEST(FaultList, leads_from_fault_to_fault_with_the_place_and_advice_for_each) {
    Explorer p(bare_room(), nullptr);
    p.key("Alt+8");
    ASSERT_TRUE(p.app().dialogue().is_open());
    const DialogueView faults = p.app().dialogue().view();
    ASSERT_EQ(faults.items.size(), 2U) << testing::PrintToString(names_of(faults));
    EXPECT_THAT(faults.items[0].name, HasSubstr("has no name"));
    EXPECT_THAT(faults.items[1].name, HasSubstr("has no landmark"));
    EXPECT_FALSE(faults.items[0].value.empty()) << "where it is";
    p.line("2");
    EXPECT_THAT(p.app().dialogue().view().title, HasSubstr("such as Stove"));
    EXPECT_THAT(names_of(p.app().dialogue().view()),
                testing::ElementsAre("Mark Stove as a landmark", "Find this place or go there"));
    p.key("Escape");
    EXPECT_EQ(p.app().dialogue().view().title, faults.title) << "back among the faults";
}

TEST(FaultList, repairs_a_missing_name_and_a_missing_landmark_on_the_spot) {
    Explorer p(bare_room(), nullptr);
    p.tap(Command::Faults);
    p.line("1");
    p.line("Give this room a name");
    p.line("Kitchen");
    ASSERT_TRUE(p.app().dialogue().is_open()) << "the list opens again";
    ASSERT_EQ(p.app().dialogue().view().items.size(), 1U);
    EXPECT_THAT(p.app().dialogue().view().items[0].name, HasSubstr("Kitchen has no landmark"));
    p.line("1");
    p.line("Mark Stove as a landmark");
    EXPECT_TRUE(p.heard("Stove is labelled: a landmark")) << p.all_heard(0);
    const Scene& scene = *p.app().scene();
    EXPECT_EQ(std::count_if(scene.features.begin(), scene.features.end(), [](const Feature& f) { return f.landmark; }),
              1);
    p.tap(Command::Faults);
    EXPECT_TRUE(p.heard("No problems found here.")) << p.all_heard(0);
}

// Makes two rooms, the second of which has no door.
std::shared_ptr<const Scene> shut_kitchen() {
    Result<Scene> scene = read_words(
        "Building: Two rooms.\n\nRoom: Hall, 4 by 6 metres. Door outside in the south wall.\n\n"
        "Room: Kitchen, 4 by 4 metres, east of Hall. Stove in the north-east corner, landmark.\n",
        "two.rooms");
    EXPECT_TRUE(scene.has_value());
    return std::make_shared<const Scene>(std::move(*scene));
}

TEST(FaultList, creates_a_missing_door_that_is_saved_and_can_remove_it_again) {
    Explorer p(shut_kitchen(), nullptr);
    p.tap(Command::Faults);
    ASSERT_TRUE(p.app().dialogue().is_open());
    p.line("Kitchen cannot be reached");
    const std::vector<std::string> acts = names_of(p.app().dialogue().view());
    ASSERT_FALSE(acts.empty());
    EXPECT_EQ(acts[0], "A door is missing here: add a door to Hall");
    p.line("1");
    EXPECT_TRUE(p.heard("There is now a door between Kitchen, Hall. The world is being read again.")) << p.all_heard(0);
    EXPECT_TRUE(p.app().requests().take_read_again()) << "its owner is to read it again";
    EXPECT_FALSE(p.app().requests().take_read_again());
    p.tap(Command::Faults);
    const std::vector<std::string> now = names_of(p.app().dialogue().view());
    ASSERT_FALSE(now.empty());
    EXPECT_EQ(now.back(), "Door added between Kitchen, Hall");
    p.line(std::to_string(now.size()));
    p.line("Remove this door");
    EXPECT_TRUE(p.heard("The door between Kitchen, Hall is a wall again.")) << p.all_heard(0);
    EXPECT_TRUE(p.app().requests().take_read_again());
    p.tap(Command::Faults);
    for (const std::string& name : names_of(p.app().dialogue().view()))
        EXPECT_EQ(name.find("Door added"), std::string::npos);
}

TEST(FaultList, is_empty_for_the_school) {
    Explorer p(test::our_world("school.map"), nullptr);
    p.tap(Command::Faults);
    EXPECT_TRUE(p.heard("No problems found here.")) << p.all_heard(0);
    EXPECT_FALSE(p.app().dialogue().is_open());
}

TEST(Landmarks, are_saved_in_the_side_file_and_restored_in_the_world) {
    const test::TemporaryFolder folder;
    const auto world = folder.write("bare.map", "bytes");
    const std::shared_ptr<const Scene> scene = bare_room();
    const auto stove = std::find_if(scene->features.begin(), scene->features.end(),
                                    [](const Feature& feature) { return feature.name == "Stove"; });
    ASSERT_NE(stove, scene->features.end());
    {
        SideFile file = SideFile::of_world(world, folder.path());
        Label label = label_of(file, *stove);
        label.kind = LabelKind::Landmark;
        keep_label(file, label);
        ASSERT_TRUE(file.save().has_value());
    }
    const SideFile file = SideFile::of_world(world, folder.path());
    std::vector<Error> faults;
    std::vector<Label> kept = read_labels(file, faults);
    EXPECT_TRUE(faults.empty());
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_EQ(kept[0].thing, "Stove");
    const auto marked = std::make_shared<const Scene>(with_labels(*scene, kept));
    EXPECT_TRUE(marked->features[static_cast<std::size_t>(stove - scene->features.begin())].landmark);
    EXPECT_FALSE(stove->landmark) << "the world itself stays as it is";
    kept[0].at_m.x += 1.0;  // After this change, there is no thing at the stored place.
    EXPECT_FALSE(changes(*scene, kept));
    EXPECT_FALSE(changes(*marked, read_labels(file, faults))) << "nothing is left to mark";
}

TEST(Landmarks, that_are_unreadable_are_reported_and_stay_in_the_file) {
    const test::TemporaryFolder folder;
    const auto world = folder.write("bare.map", "bytes");
    folder.write("bare.map.handrail.toml",
                 "[[landmark]]\nname = \"Stove\"\n\n[[landmark]]\nplace_m = [1.0, 2.0, 3.0]\n");
    const SideFile file = SideFile::of_world(world, folder.path());
    std::vector<Error> faults;
    EXPECT_TRUE(read_labels(file, faults).empty());
    ASSERT_EQ(faults.size(), 2U);
    EXPECT_THAT(faults[0].sentence(), HasSubstr("line 1"));
    EXPECT_THAT(unreadable_words("landmarks.unreadable", faults), HasSubstr("1 more landmark cannot be read"));
}

}  // namespace fault_list_test
}  // namespace handrail
