// Tests what `handrail export` writes, says and refuses.
#include <fstream>
#include <sstream>

#include "app/main/command_line.h"
#include "app/main/commands.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/files.h"

namespace handrail::test {
namespace export_command_test {

struct Outcome {
    int status = -1;
    std::string out, err;
};

Outcome run(std::vector<std::string> words) {
    words.insert(words.begin(), "export");
    std::ostringstream out, err;
    Outcome outcome;
    outcome.status = run_command_line(words, out, err);
    outcome.out = out.str();
    outcome.err = err.str();
    return outcome;
}

std::string house() { return test::bundled_world("house.map"); }

TEST(ExportCommand, writes_a_sheet_its_key_and_samples_and_reports_what_was_simplified) {
    const TemporaryFolder folder;
    const std::string svg = (folder.path() / "plan.svg").string();
    const Outcome done = run({house(), "--swell", svg, "--storey", "2", "--strip"});
    ASSERT_EQ(done.status, 0) << done.err;
    for (const char* name : {"plan.svg", "plan-key-1.svg", "plan-key-2.svg", "plan-strip.svg"}) {
        const Result<std::string> text = read_whole_file(folder.path() / name);
        ASSERT_TRUE(text) << name;
        EXPECT_EQ(text->substr(0, 5), "<?xml") << name;
    }
    EXPECT_THAT(done.out,
                testing::HasSubstr("plan.svg: House with a garden, storey 2 of 2, 1 to 75, 6 rooms, 4 things."));
    EXPECT_THAT(done.out, testing::HasSubstr("Left out for lack of space:"));
    EXPECT_THAT(done.out, testing::HasSubstr("Print it at 100 percent"));
}

TEST(ExportCommand, writes_a_plate_for_a_3d_printer) {
    const TemporaryFolder folder;
    const std::filesystem::path stl = folder.path() / "plate.stl";
    const Outcome done = run({house(), "--stl", stl.string()});
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_GT(read_whole_file(stl)->size(), 100'000U);
    EXPECT_THAT(done.out, testing::HasSubstr("plate.stl: 1 to 128, "));
    EXPECT_THAT(done.out, testing::HasSubstr("Plate: Left out for lack of space: "));
}

TEST(ExportCommand, writes_routes_in_words_for_print_and_for_braille) {
    const TemporaryFolder folder;
    const std::filesystem::path txt = folder.path() / "card.txt", brf = folder.path() / "card.brf";
    ASSERT_EQ(run({house(), "--route-card", txt.string(), "--to", "kitchen"}).status, 0);
    const std::string text = *read_whole_file(txt);
    EXPECT_THAT(text, testing::StartsWith("From the base to Kitchen.\nFace north.\n"));
    EXPECT_THAT(text, testing::HasSubstr("until you meet"));
    EXPECT_THAT(text, testing::HasSubstr("Open it."));
    const Outcome all = run({house(), "--route-card", brf.string(), "--set", "walk.step_length_m=0.5"});
    ASSERT_EQ(all.status, 0) << all.err;
    EXPECT_THAT(all.out, testing::HasSubstr("routes in words."));
    const std::string cells = *read_whole_file(brf);
    std::size_t line = 0, lines = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] == '\f') lines = 0;
        else if (cells[i] == '\r') {
            EXPECT_EQ(cells[i + 1], '\n');
            EXPECT_LE(++lines, 25U);
            line = 0;
            ++i;
        } else EXPECT_LE(++line, 40U);
    }
    EXPECT_EQ(std::count(cells.begin(), cells.end(), '\f'), 8) << "nine rooms, each on a page of its own";
    EXPECT_THAT(all.err, testing::Not(testing::HasSubstr("No route leads to")));
    const Outcome here = run({house(), "--route-card", (folder.path() / "here.txt").string(), "--to", "hall"});
    EXPECT_EQ(here.status, 1);
    EXPECT_THAT(here.err, testing::HasSubstr("The route begins in Hall already."));
}

TEST(ExportCommand, uses_the_labels_that_a_person_gave) {
    const TemporaryFolder folder;
    const std::filesystem::path map = folder.path() / "first_room.map";
    std::filesystem::copy_file(test::bundled_world("first_room.map"), map);
    folder.write("first_room.map.handrail.toml",
                 "[[landmark]]\ncalled = \"carpenter's bench\"\nname = \"Table\"\nplace_m = [4.4, 2.6, 0.37]\n");
    const Outcome sheet = run({map.string(), "--swell", (folder.path() / "plan.svg").string()});
    EXPECT_EQ(sheet.status, 0) << sheet.err;
    const std::string key = read_whole_file(folder.path() / "plan-key-1.svg").value_or("");
    EXPECT_THAT(key, testing::HasSubstr("carpenter's bench"));
    const Outcome card =
        run({map.string(), "--route-card", (folder.path() / "card.txt").string(), "--to", "carpenter's bench"});
    EXPECT_EQ(card.status, 0) << card.err;
    EXPECT_THAT(read_whole_file(folder.path() / "card.txt").value_or(""),
                testing::HasSubstr("From the base to carpenter's bench."));
}

TEST(ExportCommand, exits_with_status_1_and_suggests_help_if_a_sheet_breaks_its_promises) {
    const TemporaryFolder folder;
    // The hall has two closets. They are too small for signs, so a finger could not tell which closet is which.
    const std::filesystem::path world = folder.path() / "closets.rooms";
    std::ofstream(world) << "Storey: Ground, 3 metres high.\n"
                            "Hall, 60 by 40 metres. Door outside in the middle of the south wall.\n"
                            "Closet one, 1.5 by 1.5 metres, north of Hall. Door to Hall.\n"
                            "Closet two, 1.5 by 1.5 metres, north of Hall, 10 metres further east. Door to Hall.\n";
    const Outcome done = run({world.string(), "--swell", (folder.path() / "plan.svg").string()});
    EXPECT_EQ(done.status, 1);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "plan.svg")) << "it is written all the same";
    const std::string lack = "There is no room for the signs of these rooms: Closet one; Closet two.";
    EXPECT_THAT(done.out, testing::HasSubstr(lack));
    EXPECT_EQ(done.out.find(lack), done.out.rfind(lack)) << "it is said once";
    for (const char* help : {"--sheets", "--around", "--coarse"}) EXPECT_THAT(done.out, testing::HasSubstr(help));
    EXPECT_THAT(done.out, testing::Not(testing::HasSubstr("--paper a3"))) << "the closets are too small there too";
    const Outcome coarse = run({world.string(), "--swell", (folder.path() / "coarse.svg").string(), "--coarse"});
    EXPECT_EQ(coarse.status, 0) << "it was offered: " << coarse.out;
}

TEST(ExportCommand, offers_no_coarser_plan_that_does_not_help) {
    const TemporaryFolder folder;
    // The two rooms need signs on a coarse plan, too. The plan has no space for both a sign and the wide door of such a
    // narrow room.
    const std::filesystem::path world = folder.path() / "stores.rooms";
    std::ofstream(world) << "Storey: Ground, 3 metres high.\n"
                            "Hall, 60 by 40 metres. Door outside in the middle of the south wall.\n"
                            "Store one, 1.5 by 12 metres, north of Hall. Door to Hall.\n"
                            "Store two, 1.5 by 12 metres, north of Hall, 10 metres further east. Door to Hall.\n";
    const Outcome done = run({world.string(), "--swell", (folder.path() / "plan.svg").string()});
    EXPECT_EQ(done.status, 1);
    EXPECT_THAT(done.out, testing::HasSubstr("--around"));
    EXPECT_THAT(done.out, testing::Not(testing::HasSubstr("--coarse")));
    EXPECT_EQ(run({world.string(), "--swell", (folder.path() / "coarse.svg").string(), "--coarse"}).status, 1);
}

TEST(ExportCommand, suggests_several_sheets_if_one_is_too_small) {
    const TemporaryFolder folder;
    const std::filesystem::path world = folder.path() / "field.rooms", plan = folder.path() / "plan.svg";
    std::ofstream(world) << "Storey: Ground, 3 metres high.\n"
                            "Hall, 300 by 30 metres. Door outside in the middle of the south wall.\n";
    const Outcome done = run({world.string(), "--swell", plan.string()});
    EXPECT_EQ(done.status, 1);
    EXPECT_THAT(done.err, testing::HasSubstr("too large for one sheet"));
    for (const char* help : {"--paper a3", "--sheets", "--around"}) EXPECT_THAT(done.err, testing::HasSubstr(help));
    EXPECT_THAT(done.err, testing::Not(testing::HasSubstr("--coarse"))) << "that makes no storey smaller";
    EXPECT_EQ(run({world.string(), "--swell", plan.string(), "--paper", "a3", "--force"}).status, 0);
}

TEST(ExportCommand, replaces_files_only_on_request_and_then_all_of_them) {
    const TemporaryFolder folder;
    const std::filesystem::path pdf = folder.path() / "plan.pdf";
    std::ofstream(pdf) << "mine";
    const Outcome refused = run({house(), "--swell", pdf.string(), "--storey", "2"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_EQ(refused.err, pdf.string() + " already exists; --force replaces it.\n");
    EXPECT_EQ(*read_whole_file(pdf), "mine");
    EXPECT_EQ(run({house(), "--swell", pdf.string(), "--storey", "2", "--force"}).status, 0);
    EXPECT_EQ(read_whole_file(pdf)->substr(0, 5), "%PDF-");
    // The file for the key already exists, so the command must not write the sheet either.
    std::ofstream(folder.path() / "s-key-1.svg") << "mine";
    EXPECT_EQ(run({house(), "--swell", (folder.path() / "s.svg").string()}).status, 1);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "s.svg"));
}

TEST(ExportCommand, refuses_impossible_exports_in_one_sentence) {
    const TemporaryFolder folder;
    const std::string svg = (folder.path() / "plan.svg").string();
    const auto sentence = [&](std::vector<std::string> words, int status) {
        const Outcome outcome = run(std::move(words));
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    };
    EXPECT_THAT(sentence({house()}, 2), testing::HasSubstr("Say what to export"));
    EXPECT_THAT(sentence({house(), "--swell", "plan.png"}, 2), testing::HasSubstr(".svg or .pdf"));
    EXPECT_THAT(sentence({house(), "--swell", svg, "--paper", "a5"}, 2), testing::HasSubstr("a4 or a3"));
    EXPECT_THAT(sentence({house(), "--swell", svg, "--braille", "x"}, 2), testing::HasSubstr("en-ueb-g1"));
    EXPECT_THAT(sentence({house(), "--swell", svg, "--storey", "0"}, 2), testing::HasSubstr("whole number"));
    EXPECT_THAT(sentence({house(), "--swell", svg, "--storey", "7"}, 1), testing::HasSubstr("the lowest, to 2."));
    EXPECT_THAT(sentence({house(), "--swell", svg, "--to", "Kitchen"}, 2), testing::HasSubstr("--route-card"));
    EXPECT_THAT(sentence({house(), "--route-card", svg}, 2), testing::HasSubstr(".brf or .txt"));
    EXPECT_THAT(sentence({house(), "--route-card", "card.txt", "--to", "kitschen"}, 1),
                testing::HasSubstr("the nearest name is Kitchen"));
    EXPECT_THAT(sentence({"none.map", "--swell", svg}, 1), testing::HasSubstr("none.map"));
    EXPECT_THAT(sentence({house(), "--swell", (folder.path() / "no" / std::string(300, 'x')).string() + ".svg"}, 1),
                testing::HasSubstr("xxx"));
    EXPECT_FALSE(std::filesystem::exists(svg));
}

}  // namespace export_command_test
}  // namespace handrail::test
