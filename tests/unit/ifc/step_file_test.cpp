// Tests the file format on which IFC is based: strings, values, and reports of damage.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/unit/ifc/ifc_text.h"
#include "worlds/ifc/step_file.h"

namespace handrail {
namespace step_file_test {

using ::testing::HasSubstr;

std::string step(const std::string& data, const std::string& schema = "IFC4") {
    return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('" + schema + "'));\nENDSEC;\nDATA;\n" + data +
           "\nENDSEC;\nEND-ISO-10303-21;\n";
}
std::string sentence_for(const std::string& bytes) {
    const Result<Scene> scene = read_ifc(bytes, "a.ifc");
    EXPECT_FALSE(scene.has_value());
    return scene ? "" : scene.error().sentence();
}

TEST(StepText, decodes_names_in_any_script) {
    EXPECT_EQ(decoded("K\\X2\\00FC\\X0\\che"), "Küche");
    EXPECT_EQ(decoded("B\\S\\|ro"), "Büro");
    EXPECT_EQ(decoded("\\X\\DCbung"), "Übung");
    EXPECT_EQ(decoded("\\X2\\53A8623F\\X0\\"), "厨房");
    EXPECT_EQ(decoded("\\X2\\D83DDEAA\\X0\\ \\X4\\0001F6AA\\X0\\"), "🚪 🚪");
    EXPECT_EQ(decoded("\\PE\\\\S\\2\\S\\Q"), "Вб");
    EXPECT_EQ(decoded("it''s a\\\\b"), "it's a\\b");
    EXPECT_EQ(decoded("Küche"), "Küche");
    EXPECT_EQ(decoded("K\xFC"
                      "che"),
              "Küche");
    EXPECT_EQ(decoded("\\X2\\00"), "00") << "cut in the middle";
}

TEST(StepFile, finds_instances_with_their_lines_between_comments_and_strings) {
    const std::string text = step("#1=A('a;b''c',/* x;\n */(1.,-2.E-1,$),.T.,#7,IFCLABEL('x'));\n#7 = B ( ) ;");
    const Result<StepFile> file = StepFile::read(text, "a.ifc");
    ASSERT_TRUE(file.has_value()) << file.error().sentence();
    EXPECT_EQ(file->schema(), "IFC4");
    ASSERT_EQ(file->instances().size(), 2U);
    EXPECT_EQ(file->instances()[1].line, 8);
    const std::vector<StepValue> values = file->values_of(file->instances()[0]);
    ASSERT_EQ(values.size(), 5U);
    EXPECT_EQ(decoded(values[0].text), "a;b'c");
    ASSERT_EQ(values[1].items.size(), 3U);
    EXPECT_EQ(values[1].items[1].number, -0.2);
    EXPECT_EQ(values[1].items[2].kind, StepValue::Kind::Nothing);
    EXPECT_EQ(values[2].text, "T");
    EXPECT_EQ(values[3].reference, 7U);
    EXPECT_EQ(values[4].type, "IFCLABEL");
    EXPECT_EQ(values[4].text, "x");
}

TEST(StepFile, reports_an_error_in_one_sentence_with_its_line) {
    EXPECT_THAT(sentence_for(step("#1=A(1);\n#1=B(2);")), AllOf(HasSubstr("line 7"), HasSubstr("second time")));
    EXPECT_THAT(sentence_for(step("#1=A(1;")), AllOf(HasSubstr("line 6"), HasSubstr("damaged")));
    EXPECT_THAT(sentence_for(step("", "AUTOMOTIVE_DESIGN")), HasSubstr("AUTOMOTIVE_DESIGN"));
    EXPECT_THAT(sentence_for(step("")), HasSubstr("no building"));
    EXPECT_THAT(sentence_for("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n#1=A('never ends"),
                AllOf(HasSubstr("line 6"), HasSubstr("cut short")));
    EXPECT_THAT(sentence_for(std::string("\xFF\xFEI\0S\0O\0", 8)), HasSubstr("UTF-16"));
    EXPECT_THAT(sentence_for("version https://git-lfs.github.com/spec/v1\n"), HasSubstr("git lfs pull"));
    EXPECT_THAT(sentence_for("hello"), HasSubstr("ISO-10303-21"));
}

TEST(StepFile, never_exceeds_its_recursion_limit) {
    const std::string text = step("#1=A(" + std::string(200'000, '(') + std::string(200'000, ')') + ");");
    const Result<StepFile> file = StepFile::read(text, "deep.ifc");
    ASSERT_TRUE(file.has_value());
    std::vector<StepValue> values = file->values_of(file->instances()[0]);
    int depth = 0;
    for (const std::vector<StepValue>* at = &values; !at->empty(); at = &at->front().items) ++depth;
    EXPECT_EQ(depth, StepFile::kDeepest);
}

}  // namespace step_file_test
}  // namespace handrail
