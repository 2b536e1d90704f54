// Tests the report of a session. Its words must be easy, its page must be accessible, and its tables must read back
// unchanged.
#include "app/report/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <regex>
#include <sstream>

#include "tests/support/lay_floor.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/report/page_rules.h"

namespace handrail::test {
namespace report_page_test {

// Returns two rooms of 6 by 4 and 3 by 4 m next to each other. A door joins them.
Storey two_rooms() {
    Storey storey;
    storey.world = "School";
    storey.min_m = {-0.5, -0.5};
    storey.max_m = {9.7, 4.7};
    const auto add = [&](const std::string& name, double x0, double x1) {
        StoreyRoom room;
        room.room = static_cast<std::uint32_t>(storey.rooms.size());
        room.name = name;
        room.loops_m = {{{x0, 0.25}, {x1, 0.25}, {x1, 3.75}, {x0, 3.75}}};
        room.min_m = {x0, 0.25};
        room.max_m = {x1, 3.75};
        room.middle_m = 0.5 * (room.min_m + room.max_m);
        storey.rooms.push_back(std::move(room));
    };
    add("entrance <hall>", 0.25, 6.1);
    add("Library", 6.1, 8.95);
    storey.walls_m = {{{6.0, 0.0}, {6.2, 0.0}, {6.2, 1.5}, {6.0, 1.5}}};
    storey.sheets_m = {{{{6.1, 2.5}, {6.1, 4.0}}}};
    lay_floor(storey);
    return storey;
}

SessionReport sample() {
    SessionReport report;
    report.learner = "Blue Heron";
    report.learner_id = "k7f2m3qa";
    report.lesson = "The way to the \"Library\", and back";
    report.session = "First session";
    report.started_utc = "2026-11-22T17:30:00Z";
    report.world = "School";
    report.seconds = 754.0;
    ReportTask go{ReportTaskKind::Go, "Library", true, {}};
    go.measures = {{"path_ratio", 1.31}, {"time", 95.0},    {"turns_missed", 1.0},
                   {"turns_early", 1.0}, {"pauses", 3.0},   {"pause_time", 12.5},
                   {"help_asked", 2.0},  {"led_time", 8.0}, {"detour_time", 30.0}};
    ReportTask learn{
        ReportTaskKind::Learn, "Entrance hall", std::nullopt, {{"walls_percent", 82.0}, {"exits_percent", 100.0}}};
    ReportTask point{ReportTaskKind::Point, "", std::nullopt, {{"pointing_off", 24.0}, {"pointing_side", -14.0}}};
    ReportTask distance{ReportTaskKind::Distance, "", std::nullopt, {{"distance_judged", 0.7}}};
    ReportTask order{ReportTaskKind::Order, "", std::nullopt, {{"order_kept", 0.33}}};
    ReportTask again{ReportTaskKind::Go,
                     "Library",
                     false,
                     {{"path_ratio", 2.5}, {"time", 300.0}, {"help_asked", 0.0}, {"turns_missed", 0.0}}};
    report.tasks = {go,
                    learn,
                    point,
                    distance,
                    order,
                    again,
                    {ReportTaskKind::Free, "", std::nullopt, {}},
                    {ReportTaskKind::Question, "How sure are you?", std::nullopt, {{"answer", 4.0}}},
                    {ReportTaskKind::Question, "What helped? The clock", std::nullopt, {}}};
    report.strategies = {{"perimeter", 300.0}, {"grid", 40.0},  {"object", 60.0},
                         {"base", 20.0},       {"mixed", 30.0}, {"none", 5.0}};
    report.course = {{0.0, "You are in the entrance hall."}, {65.4, "Door <open> & \"wide\"."}};
    report.contacts = {{{6.1, 1.4}, "door frame", 3}, {{2.0, 0.3}, "bench", 1}};
    report.walked_m = 7.1;
    report.rooms = {"Entrance <hall>", "Library"};
    report.ways_m = {{{1.0, 1.0}, {5.5, 2.0}}, {{8.0, 2.0}, {8.5, 2.0}}};
    report.notes = {{61.0, "held the rail"}};
    report.storey = two_rooms();
    return report;
}

std::string in_a_row(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += sentence + "\n";
    return text;
}

TEST(ReportWords, are_easy_to_read_in_both_languages) {
    for (const char* language : {"en", "de"}) {
        const InLanguage spoken(language);
        const std::vector<std::string> said = report_words(sample());
        EXPECT_GT(said.size(), 15U);
        const std::string text = in_a_row(said);
        EXPECT_LT(lix_of(text), 40.0) << text;
        for (const std::string& sentence : said) {
            EXPECT_LE(std::count(sentence.begin(), sentence.end(), ' '), 19) << sentence;
            EXPECT_TRUE(sentence.ends_with(".")) << sentence;
            for (const char* hard : {"ratio", "circular", "coverage", "perimeter", "Perimeter", "Quotient", "null"})
                EXPECT_EQ(sentence.find(hard), std::string::npos) << sentence;
        }
    }
    EXPECT_GT(lix_of("Institutional considerations necessitate comprehensive documentation requirements."), 60.0);
    EXPECT_LT(lix_of("The cat sat. It ate."), 10.0);
}

TEST(ReportWords, describe_what_happened_and_nothing_that_was_not_measured) {
    const std::string text = in_a_row(report_words(sample()));
    for (const char* sentence :
         {"You were in School for 13 minutes.", "You reached Library.", "It took 95 seconds.",
          "Your route was a little longer than necessary.", "You missed one turn.", "You stopped to think 3 times.",
          "You asked for help 2 times.", "A door was blocked, and you found another route.",
          "You know 82 percent of its walls.", "You know all its exits.",
          "When you point, you are 24 degrees off on average.", "You point a bit too far left.",
          "You judge distances to be shorter than they are.", "You did not reach Library this time.",
          "Your route was 2.5 times as long as necessary.", "You were asked: How sure are you? 4.",
          "You were asked: What helped? The clock.", "You mostly went along the walls."})
        EXPECT_NE(text.find(sentence), std::string::npos) << sentence << "\n" << text;
    for (const char* praise : {"You did it with no help.", "You made all the turns."})
        EXPECT_EQ(text.find(praise), std::string::npos) << "of a way that was given up: " << text;
    SessionReport arrived;
    arrived.tasks = {{ReportTaskKind::Go, "Library", true, {{"help_asked", 0.0}, {"turns_missed", 0.0}}}};
    EXPECT_EQ(in_a_row(report_words(arrived)),
              "You reached Library.\nYou made all the turns.\nYou did it with no help.\n");
    SessionReport bare;
    bare.tasks = {{ReportTaskKind::Go, "Library", std::nullopt, {{"time", NAN}}}};
    EXPECT_EQ(report_words(bare), std::vector<std::string>{"There is nothing to report yet."});
}

TEST(ReportWords, describe_the_route_through_the_rooms) {
    EXPECT_EQ(
        in_a_row(plan_words(sample())),
        "The plan shows School, storey 1 of 1. North is up.\nYou walked 7 metres.\nYour route led through: Entrance "
        "<hall>; Library.\n");
    SessionReport still = sample();
    still.walked_m = 0.0;
    EXPECT_THAT(in_a_row(plan_words(still)), testing::HasSubstr("You did not walk anywhere."));
    still.storey.reset();
    EXPECT_TRUE(plan_words(still).empty());
}

// Small rooms with long names are next to each other and above each other. The hand touched several objects at one
// place.
TEST(ReportPage, does_not_overlap_names_on_the_plan) {
    SessionReport report = sample();
    for (int i = 0; i < 30; ++i) {
        StoreyRoom room;
        room.name = fmt::format("Storeroom number {}", i);
        room.middle_m = {1.0 + 0.3 * (i % 6), 0.5 + 0.2 * (i / 6)};
        report.storey->rooms.push_back(room);
        report.contacts.push_back({{4.0 + 0.05 * i, 2.0}, "shelf", 1});
    }
    const std::string page = report_page(report);
    static const std::regex kText(R"re(<text class="name" x="([-0-9.]+)" y="([-0-9.]+)">([^<]*)</text>)re"),
        kLetter(R"re(font-size="([0-9.]+)")re");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(page, found, kLetter));
    const double letter = std::stod(found[1]);
    struct Name {
        double x, y, half;
    };
    std::vector<Name> names;
    for (auto it = std::sregex_iterator(page.begin(), page.end(), kText); it != std::sregex_iterator(); ++it)
        names.push_back(
            {std::stod((*it)[1]), std::stod((*it)[2]), 0.3 * letter * static_cast<double>((*it)[3].length())});
    EXPECT_GT(names.size(), 6U);
    EXPECT_LT(names.size(), 64U) << "not all of them have room";
    for (std::size_t i = 0; i < names.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_TRUE(std::abs(names[i].y - names[k].y) >= letter ||
                        std::abs(names[i].x - names[k].x) >= names[i].half + names[k].half)
                << i << " and " << k;
}

TEST(MeasuresPage, explains_every_measure_and_every_column) {
    const std::string page = content_of(project_root() / "docs" / "measures.md");
    for (const ReportMeasureInfo& info : report_measures())
        EXPECT_NE(page.find(fmt::format("\n| `{}` | {} | ", info.key, info.unit)), std::string::npos) << info.key;
    const std::string head = results_csv({});
    std::istringstream columns(head.substr(0, head.find('\r')));
    for (std::string column; std::getline(columns, column, ',');)
        EXPECT_NE(page.find("\n| `" + column + "` | "), std::string::npos) << column;
}

TEST(ReportPage, keeps_every_rule_in_both_languages_and_with_missing_parts) {
    for (const char* language : {"en", "de"}) {
        const InLanguage spoken(language);
        SessionReport report = sample();
        EXPECT_THAT(page_faults(report_page(report)), testing::IsEmpty()) << language;
        EXPECT_NE(report_page(report).find(fmt::format("<html lang=\"{}\">", language)), std::string::npos);
        EXPECT_LT(report_page(report).size(), 16000U);
        report.storey.reset();
        EXPECT_THAT(page_faults(report_page(report)), testing::IsEmpty()) << "with no plan";
        report.tasks.clear();
        report.strategies.clear();
        report.course.clear();
        EXPECT_THAT(page_faults(report_page(report)), testing::IsEmpty()) << "with nothing measured";
        EXPECT_THAT(page_faults(report_page({})), testing::IsEmpty()) << "with nothing at all";
    }
}

TEST(ReportPage, is_read_in_the_intended_order_without_the_texts_of_the_picture) {
    const std::string text = spoken_text(report_page(sample()));
    std::size_t at = 0;
    for (const char* line :
         {"h1: Report: First session",
          "p: For Blue Heron. Lesson: The way to the \"Library\", and back. Started: 22 November 2026, ",
          "h2: In short",
          "li: You were in School for 13 minutes.",
          "h2: In numbers",
          "caption: Going to Library",
          "th: Route length compared with the shortest",
          "td: 1.31",
          "td: 1 means the shortest possible route.",
          "caption: Getting to know Entrance hall",
          "td: 82 percent",
          "h2: How you moved",
          "th: Along the walls",
          "td: 66 percent",
          "h2: Plan",
          "title: Plan of School, storey 1, with your route",
          "p: The plan shows School",
          "li: Door frame, 3 times",
          "li: Bench, once",
          "h2: The teacher's notes and actions",
          "td: held the rail",
          "h2: Step by step",
          "th: 1:05",
          "td: Door <open> & \"wide\"."}) {
        const std::size_t found = text.find(line, at);
        ASSERT_NE(found, std::string::npos) << line << " is not after what comes before it in\n" << text;
        at = found;
    }
    EXPECT_EQ(text.find("text:"), std::string::npos) << "names of rooms in the middle of the page";
}

TEST(PageRules, detect_each_fault_that_is_planted_into_a_page) {
    const std::string page = report_page(sample());
    ASSERT_THAT(page_faults(page), testing::IsEmpty());
    const auto broken = [&](const std::string& what, const std::string& by) {
        std::string text = page;
        const std::size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        if (at != std::string::npos) text.replace(at, what.size(), by);
        return page_faults(text);
    };
    using testing::Contains;
    using testing::HasSubstr;
    EXPECT_THAT(broken(" lang=\"en\"", ""), Contains("no language"));
    EXPECT_THAT(broken("<h2 id=\"words\">In short</h2>", "<h4 id=\"words\">In short</h4>"),
                Contains("heading h4 after h1"));
    EXPECT_THAT(broken("<h2 id=\"words\">In short</h2>", "<h1 id=\"words\">In short</h1>"), Contains("not one h1"));
    EXPECT_THAT(broken("<caption>Going to Library</caption>", ""), Contains("a table without caption"));
    EXPECT_THAT(broken("<th scope=\"row\">", "<th>"), Contains("a head cell without scope"));
    EXPECT_THAT(broken(" aria-labelledby=\"plan-name\"", ""), Contains("a picture without a name"));
    EXPECT_THAT(broken("id=\"plan-words\"", "id=\"plan\""),
                testing::AllOf(Contains("id twice: plan"), Contains("points at no id: plan-words")));
    EXPECT_THAT(broken("<g aria-hidden=\"true\"", "<g"), Contains("text of a picture is read out"));
    EXPECT_THAT(broken("--soft:#4a4f59", "--soft:#bbb"), Contains("too little contrast: soft"));
    EXPECT_THAT(broken("--way:#ff9b8f", "--way:#333"), Contains("too little contrast: way"));
    EXPECT_THAT(broken("<main>", "<main><img src=\"https://example.org/a.png\" alt=\"a\">"),
                Contains(HasSubstr("a request")));
    EXPECT_THAT(broken("h1{", "@import url(x.css);h1{"), Contains("a request from the style"));
    EXPECT_THAT(broken("</ul>", ""), testing::Not(testing::IsEmpty()));
    EXPECT_THAT(broken("default-src 'none'", "default-src *"), Contains("no policy against requests"));
    // This page has many faults at once, as has the page for accessibility checkers in browsers. The rules must find at
    // least six of the faults.
    std::string worst = page;
    for (const auto& [what, by] :
         std::vector<std::pair<std::string, std::string>>{{" lang=\"en\"", ""},
                                                          {" scope=\"row\"", ""},
                                                          {" aria-labelledby=\"plan-name\"", ""},
                                                          {"--soft:#4a4f59", "--soft:#bbb"},
                                                          {"<h2", "<h4"},
                                                          {"</h2", "</h4"},
                                                          {"<caption>", "<p>"},
                                                          {"</caption>", "</p>"}})
        for (std::size_t at = 0; (at = worst.find(what, at)) != std::string::npos; at += by.size())
            worst.replace(at, what.size(), by);
    EXPECT_GE(page_faults(worst).size(), 6U);
}

TEST(Results, are_bit_identical_when_read_back_from_both_tables) {
    std::mt19937_64 random(11);
    std::vector<SessionReport> reports(3, sample());
    reports[1].session = "Second, \"quoted\"\nover two lines";
    for (SessionReport& report : reports)
        for (ReportTask& task : report.tasks)
            for (ReportMeasure& measure : task.measures)
                measure.value *= std::ldexp(static_cast<double>(random() >> 11), -50);
    const std::vector<ResultRow> rows = result_rows(reports);
    ASSERT_GT(rows.size(), 60U);
    const auto from_csv = read_results_csv(results_csv(rows), "results.csv");
    ASSERT_TRUE(from_csv) << from_csv.error().sentence();
    EXPECT_TRUE(*from_csv == rows);
    const auto from_json = read_results_json(results_json(rows), "results.json");
    ASSERT_TRUE(from_json) << from_json.error().sentence();
    EXPECT_TRUE(*from_json == rows);
    for (const ResultRow& row : rows) EXPECT_EQ(row.learner, "k7f2m3qa") << "never the name";
    EXPECT_EQ(results_csv(rows).find("Blue Heron"), std::string::npos);
    EXPECT_THAT(results_csv(rows), testing::StartsWith("learner,lesson,session,started,task,measure,value,unit\r\n"));
}

TEST(Results, are_described_column_by_column) {
    const std::string text = results_metadata("results.csv");
    EXPECT_THAT(text, testing::HasSubstr("\"http://www.w3.org/ns/csvw\""));
    EXPECT_THAT(text, testing::HasSubstr("\"url\": \"results.csv\""));
    for (const char* name : {"learner", "lesson", "session", "started", "task", "measure", "value", "unit"})
        EXPECT_THAT(text, testing::HasSubstr(fmt::format("\"titles\": \"{}\"", name)));
    EXPECT_EQ(text.find("report.csv_"), std::string::npos) << "every column has its words";
}

TEST(Results, cut_anywhere_or_damaged_are_read_or_reported_with_their_line) {
    const std::vector<ResultRow> rows = result_rows(std::vector{sample()});
    const std::string csv = results_csv(rows), json = results_json(rows);
    for (std::size_t cut = 0; cut < csv.size(); ++cut) {
        const auto read = read_results_csv(std::string_view(csv).substr(0, cut), "r.csv");
        if (!read) EXPECT_THAT(read.error().sentence(), testing::StartsWith("r.csv, line "));
        else EXPECT_LE(read->size(), rows.size());
    }
    for (std::size_t cut = 0; cut + 2 < json.size(); ++cut)
        EXPECT_FALSE(read_results_json(std::string_view(json).substr(0, cut), "r.json")) << cut;
    EXPECT_EQ(read_results_csv("a,b\n", "r.csv").error().line, 1);
    const std::string head = csv.substr(0, csv.find('\n') + 1);
    EXPECT_EQ(read_results_csv(head + "1,2,3\n", "r.csv").error().line, 2);
    EXPECT_EQ(read_results_csv(head + "a,b,c,d,e,f,nan,1\n", "r.csv").error().line, 2);
    EXPECT_EQ(read_results_csv(head + "a,b,c,d,e,f,1,1\n\"x", "r.csv").error().line, 3);
    EXPECT_FALSE(read_results_json("{\"schema\":2,\"results\":[]}", "r.json"));
    EXPECT_FALSE(read_results_json("{\"schema\":1,\"results\":[{\"learner\":3}]}", "r.json"));
}

TEST(ReportMeasures, are_named_and_explained_in_both_languages) {
    for (const char* language : {"en", "de"}) {
        const InLanguage spoken(language);
        for (const ReportMeasureInfo& info : report_measures()) {
            EXPECT_TRUE(has_phrase("report.measure_" + std::string(info.key))) << info.key;
            EXPECT_TRUE(has_phrase("report.means_" + std::string(info.key))) << info.key;
        }
        for (const char* strategy : {"perimeter", "grid", "object", "base", "mixed", "none"}) {
            EXPECT_TRUE(has_phrase("report.strategy_" + std::string(strategy)));
            EXPECT_TRUE(has_phrase("report.strategy_means_" + std::string(strategy)));
        }
    }
}

}  // namespace report_page_test
}  // namespace handrail::test
