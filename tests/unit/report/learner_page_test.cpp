// Tests the report on a learner over several sessions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/report/report_page.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/report/page_rules.h"

namespace handrail::test {
namespace learner_page_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Returns three sessions with a route to the library, on which the learner improves each time. The second session also
// has a route to the gym.
std::vector<SessionReport> three_sessions() {
    const auto session = [](const char* started, double seconds, double ratio, double missed, double help) {
        SessionReport report;
        report.learner = "Blue Heron <b>";
        report.learner_id = "k7f2m3qa";
        report.started_utc = started;
        report.world = "School";
        report.seconds = seconds;
        report.tasks.push_back({ReportTaskKind::Go,
                                "Library",
                                true,
                                {{"path_ratio", ratio},
                                 {"time", 90.0},
                                 {"turns_missed", missed},
                                 {"turns_early", 1.0},
                                 {"help_asked", help}}});
        report.strategies = {{"perimeter", 60.0}, {"grid", 20.0}};
        return report;
    };
    std::vector<SessionReport> reports = {session("2026-11-22T12:00:00Z", 600.0, 2.1, 2.0, 5.0),
                                          session("2026-11-24T12:00:00Z", 540.0, 1.4, 0.0, 1.0),
                                          session("2026-11-30T12:00:00Z", 480.0, 1.1, 0.0, 0.0)};
    reports[1].tasks.push_back({ReportTaskKind::Go, "Gym", false, {{"time", 30.0}}});
    return reports;
}

TEST(LearnerWords, describe_the_outcome_of_each_route) {
    EXPECT_THAT(
        learner_words(three_sessions()),
        ElementsAre("There were 3 sessions, 27 minutes in all.", "You set out for Library 3 times.",
                    "Your route there got shorter.", "Wrong turns on the way there: 3 the first time, 1 the last time.",
                    "Requests for help on the way there: 5 the first time, 0 the last time.",
                    "You set out for Gym once."));
    std::vector<SessionReport> back = three_sessions();
    std::swap(back[0], back[2]);
    EXPECT_THAT(learner_words(back), testing::Contains("Your route there got longer."));
    back[0].tasks[0].measures.clear();
    back[1].tasks[0].measures.clear();
    EXPECT_THAT(learner_words(back), testing::Not(testing::Contains(HasSubstr("Your route"))))
        << "measured once is no change";
}

TEST(LearnerWords, are_easy_to_read_in_both_languages) {
    for (const char* language : {"en", "de"}) {
        const InLanguage spoken(language);
        std::string text;
        for (const std::string& sentence : learner_words(three_sessions())) {
            EXPECT_LE(std::count(sentence.begin(), sentence.end(), ' '), 19) << sentence;
            text += sentence + "\n";
        }
        EXPECT_LT(lix_of(text), 40.0) << text;
    }
}

TEST(LearnerPage, keeps_every_rule_in_both_languages_and_without_any_session) {
    for (const char* language : {"en", "de"}) {
        const InLanguage spoken(language);
        const std::vector<SessionReport> reports = three_sessions();
        EXPECT_THAT(page_faults(learner_page(reports)), IsEmpty()) << language;
        EXPECT_THAT(page_faults(learner_page(std::span(reports).first(1))), IsEmpty()) << "of one session";
        EXPECT_THAT(page_faults(learner_page({})), IsEmpty()) << "of none";
    }
}

TEST(LearnerPage, is_read_in_the_intended_order) {
    const std::string text = spoken_text(learner_page(three_sessions()));
    std::size_t at = 0;
    for (const char* line :
         {"h1: Report: Blue Heron <b>", "h2: In short", "li: There were 3 sessions", "h2: From session to session",
          "caption: Going to Library", "th: Session 1, 22 November 2026", "td: 2.10", "th: Session 3, 30 November 2026",
          "td: 1.10", "caption: Going to Gym", "td: not measured", "h2: How you moved", "th: Along the walls",
          "td: 75 percent", "h2: Sessions", "td: School", "h2: Session 1, 22 November 2026", "li: You reached Library.",
          "h2: Session 3, 30 November 2026"}) {
        const std::size_t found = text.find(line, at);
        ASSERT_NE(found, std::string::npos) << line << " is not after what comes before it in\n" << text;
        at = found;
    }
}

}  // namespace learner_page_test
}  // namespace handrail::test
