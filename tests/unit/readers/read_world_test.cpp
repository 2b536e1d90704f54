#include "tests/support/map_text.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

using testing::HasSubstr;

std::string sentence_for(const std::string& name, std::string_view bytes) {
    const test::TemporaryFolder folder;
    const Result<Scene> scene = read_world(folder.write(name, bytes));
    return scene ? "read as " + scene->report.format : scene.error().sentence();
}

TEST(ReadWorld, chooses_the_reader_by_the_files_ending) {
    EXPECT_EQ(sentence_for("a.map", test::entity("worldspawn", {}, test::box_brush(0, 0, 0, 64, 64, 64))), "read as map");
    EXPECT_EQ(sentence_for("A.MAP", test::entity("worldspawn", {}, test::box_brush(0, 0, 0, 64, 64, 64))), "read as map");
    EXPECT_EQ(sentence_for("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "read as obj");
    EXPECT_EQ(sentence_for("a.txt", "hello"), "a.txt: Handrail reads worlds from .map and .obj files, told by the file's ending. This file has another.");
}

TEST(ReadWorld, recognises_files_given_by_mistake_and_says_what_to_do) {
    EXPECT_THAT(sentence_for("a.map", "version https://git-lfs.github.com/spec/v1\noid sha256:00\n"), HasSubstr("git lfs pull"));
    EXPECT_THAT(sentence_for("a.map", std::string("\x1D\0\0\0rest", 8)), HasSubstr("compiled Quake level"));
    EXPECT_THAT(sentence_for("a.bsp", "IBSP...."), HasSubstr("compiled game level"));
    EXPECT_THAT(sentence_for("a.map", std::string("\x66\x66\x0E\x40RMF....", 11)), HasSubstr("export it as a .map"));
    EXPECT_THAT(sentence_for("pak0.pak", "PACK...."), HasSubstr("Unpack it"));
    EXPECT_THAT(sentence_for("a.ifc", "ISO-10303-21;"), HasSubstr("IFC"));
    EXPECT_EQ(sentence_for("a.map", ""), "a.map: This file is empty.");
}

TEST(ReadWorld, says_why_a_file_cannot_be_read) {
    const test::TemporaryFolder folder;
    const Result<Scene> missing = read_world(folder.path() / "none.map");
    ASSERT_FALSE(missing.has_value());
    EXPECT_EQ(missing.error().sentence(), "none.map: This file cannot be opened: No such file or directory.");
    const Result<Scene> is_folder = read_world(folder.path());
    ASSERT_FALSE(is_folder.has_value());
    EXPECT_THAT(is_folder.error().sentence(), HasSubstr("This is a folder"));
}

}  // namespace
}  // namespace handrail
