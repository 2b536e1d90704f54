// Tests names that a person gives to rooms by a key or a typed word. They are stored next to the world, and the session
// reports those that no longer fit.
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"
#include "worlds/base/files.h"

namespace handrail {
namespace room_names_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Returns the map of two rooms of 6 by 5 m with a gap of this many units in the wall between them (160: there is no
// wall). The walker starts in the western room.
std::string two_rooms(double gap_units = 32.0) {
    using test::box_brush;
    const double low = 80.0 - 0.5 * gap_units, high = 80.0 + 0.5 * gap_units;
    return test::entity("worldspawn", test::key("building", "1"),
                        test::room_brushes(0, 0, 0, 400, 160, 96) + box_brush(196, 0, 0, 204, low, 96) +
                            box_brush(196, high, 0, 204, 160, 96)) +
           test::entity("info_player_start", test::key("origin", "40 80 24"));
}

struct Person : test::AppSession {
    explicit Person(const fs::path& world) {
        app.apply(WorldEntered{make_ready(test::world_in(world)), SideFile::of_world(world, {})}, now);
        run(0.1);
        request(Command::Exits);  // The answer waits until the rooms are known.
    }
    // Gives the room a name by keys only: the key that asks for the name, the letters, and Enter.
    std::string name(const std::string& typed) {
        EXPECT_EQ(app.keys().find("Control+N"), Command::NameRoom);
        request(Command::NameRoom);
        app.apply(TextTyped{typed}, now);
        app.apply(KeyTapped{"Enter"}, now);
        listen();
        return said.back();
    }
};

struct World {
    explicit World(const std::string& text = two_rooms()) { write(text); }
    void write(const std::string& text) const { EXPECT_TRUE(write_file_atomically(path, text)); }
    fs::path side_file() const { return path.string() + ".handrail.toml"; }
    test::TemporaryFolder folder;
    fs::path path = folder.path() / "flat.map";
};

TEST(NamesOfRooms, that_the_person_gives_are_used_everywhere_and_saved_for_the_next_session) {
    const World world;
    const std::string sign =
        "K\xC3\xBC"
        "che \xE5\x8E\xA8\xE6\x88\xBF";
    {
        Person p(world.path);
        EXPECT_THAT(p.said.back(), HasSubstr("Room, west."));
        EXPECT_EQ(p.name(sign), "This room is now called " + sign + ".");
        EXPECT_THAT(p.request(Command::WhereAmI), testing::StartsWith(sign + ", "));
        EXPECT_THAT(p.request(Command::Exits), testing::StartsWith(sign + ". "));
        p.app.apply(Placed{{9.0, 2.5, 0.0}, 0.0}, p.now);
        p.run(0.1);
        EXPECT_THAT(p.request(Command::Exits), HasSubstr("to " + sign));
        EXPECT_EQ(p.name("Study"), "This room is now called Study.");
        EXPECT_EQ(p.name("Library"), "This room is now called Library.");  // This gives the room another name.
    }
    Person p(world.path);
    EXPECT_THAT(p.request(Command::WhereAmI), testing::StartsWith(sign + ", "));
    EXPECT_THAT(p.request(Command::Exits), HasSubstr("to Library"));
    EXPECT_FALSE(p.heard("fit"));
}

TEST(NamesOfRooms, can_be_typed_in_a_terminal_by_command_and_line) {
    const World world;
    Person p(world.path);
    const CommandInfo* row = find_command("name-room");
    ASSERT_TRUE(row);
    EXPECT_THAT(p.request(row->command), HasSubstr("Type another name for this room"));
    EXPECT_TRUE(p.app.apply(LineTyped{"Workshop"}, p.now));
    p.listen();
    EXPECT_EQ(p.said.back(), "This room is now called Workshop.");
}

TEST(NamesOfRooms, may_have_at_most_200_bytes_and_must_be_unique) {
    const World world;
    Person p(world.path);
    const std::string longest(200, 'a');
    EXPECT_EQ(p.name(longest), "This room is now called " + longest + ".");
    p.request(Command::NameRoom);
    p.app.apply(LineTyped{std::string(201, 'b')}, p.now);
    p.listen();
    EXPECT_THAT(p.said.back(), HasSubstr("cannot be any longer"));
    p.app.apply(KeyTapped{"Escape"}, p.now);
    p.listen();
    EXPECT_EQ(p.said.back(), "The name was not changed.");
    p.app.apply(Placed{{9.0, 2.5, 0.0}, 0.0}, p.now);
    p.run(0.1);
    EXPECT_THAT(p.name(std::string(200, 'A')), HasSubstr("Another room is already called"));
    EXPECT_THAT(p.request(Command::WhereAmI), testing::StartsWith("Room, east, "));
}

TEST(NamesOfRooms, are_reset_by_typing_the_rooms_original_name) {
    const World world;
    Person p(world.path);
    p.name("Shop");
    EXPECT_TRUE(fs::exists(world.side_file()));
    EXPECT_EQ(p.name("room, west"), "This room is now called room, west.");
    EXPECT_EQ(SideFile::of_world(world.path, {}).entries("room_name").size(), 0U);
}

TEST(NamesOfRooms, that_no_longer_fit_an_edited_world_are_reported) {
    const World world;
    {
        Person p(world.path);
        p.name("Shop");
        p.app.apply(Placed{{9.0, 2.5, 0.0}, 0.0}, p.now);
        p.run(0.1);
        p.name("Larder");
    }
    // The world was edited, but the rooms are the same, so all names fit.
    world.write(two_rooms(36.0));
    {
        Person p(world.path);
        EXPECT_FALSE(p.heard("fit")) << p.said.back();
        EXPECT_THAT(p.request(Command::Exits), HasSubstr("Shop. 1 exit"));
    }
    // Without the wall, there is one room of twice the size, which is not taken for either of the two named rooms.
    world.write(two_rooms(160.0));
    {
        Person p(world.path);
        EXPECT_TRUE(p.heard("This world has changed since you named rooms. 2 of 2 names no longer fit: Shop; Larder."));
        EXPECT_THAT(p.request(Command::WhereAmI), testing::Not(HasSubstr("Shop")));
    }
    // The names stay in the file, so they are back when the wall is back.
    world.write(two_rooms());
    Person p(world.path);
    EXPECT_THAT(p.request(Command::WhereAmI), testing::StartsWith("Shop, "));
}

TEST(NamesOfRooms, that_are_damaged_are_set_aside_reported_and_started_empty) {
    const World world;
    ASSERT_TRUE(write_file_atomically(world.side_file(), "[[room_name]]\nname = \"Shop\nplace_m = [1.0, 2.5, 0.0]\n"));
    {
        Person p(world.path);
        EXPECT_TRUE(p.heard("is damaged in line 2. It has been saved as flat.map.handrail.toml.damaged"))
            << p.said.front();
        EXPECT_THAT(p.request(Command::WhereAmI), testing::StartsWith("Room, west, "));
        EXPECT_EQ(p.name("Shop"), "This room is now called Shop.");
    }
    // Two unusable entries in a readable file are reported. They are still in the file after something else was saved.
    ASSERT_TRUE(write_file_atomically(
        world.side_file(),
        "[[room_name]]\nname = \"Shop\"\nplace_m = [1.0, 2.5, 0.0]\n[[room_name]]\nname = \"Attic\"\nplace_m = [1.0]\n"
        "[[room_name]]\nplace_m = [1.0, 2.5, 0.0]\n"));
    Person p(world.path);
    EXPECT_TRUE(
        p.heard("flat.map.handrail.toml, line 4: the room name Attic needs place_m with three decimal numbers, "
                "such as [1.0, 2.5, 0.0]. Add them, or "
                "delete the entry. 1 more room name cannot be read."))
        << testing::PrintToString(p.said);
    EXPECT_THAT(p.request(Command::WhereAmI), testing::StartsWith("Shop, "));
    p.name("Store");
    const auto kept = read_whole_file(world.side_file());
    ASSERT_TRUE(kept);
    EXPECT_THAT(*kept, HasSubstr("Attic"));
    EXPECT_THAT(*kept, HasSubstr("Store"));
}

}  // namespace room_names_test
}  // namespace handrail
