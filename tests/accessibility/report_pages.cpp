// Writes reports of sessions into a folder, so that accessibility checkers in browsers can examine the pages. Usage:
// report_pages FOLDER
// The program writes these reports:
// - a session with everything, in English and in German
// - a session without a hand and a plan
// - an empty session
// - several sessions of one learner
// - a page with deliberate faults, which the checkers must find
#include <filesystem>
#include <iostream>

#include "app/report/report_page.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/navigation/navigation.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

std::optional<Storey> ground_floor(const std::string& map) {
    const auto scene = read_world(test::project_root() / "worlds" / "maps" / map);
    if (!scene) return std::nullopt;
    const auto ways = Navigation::make(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    if (!ways) return std::nullopt;
    const RoomGraph graph = make_rooms(*scene, (*ways)->space());
    auto storey = storey_of(*scene, graph, (*ways)->space(), storey_of_start(*scene, graph, (*ways)->space()));
    if (!storey) return std::nullopt;
    return std::move(*storey);
}

SessionReport session_in(const std::string& map) {
    SessionReport report;
    report.learner = "Blue Heron";
    report.lesson = "Three rooms";
    report.session = "First session";
    report.started_utc = "2026-11-22T17:30:00Z";
    report.seconds = 754.0;
    report.storey = ground_floor(map);
    if (!report.storey) return report;
    report.world = report.storey->world;
    std::vector<Vec2>& way = report.ways_m.emplace_back();
    for (const StoreyRoom& room : report.storey->rooms) {
        way.push_back(room.middle_m);
        report.rooms.push_back(room.name);
    }
    report.walked_m = 20.0;
    report.notes = {{61.0, "Held the rail."}};
    ReportTask go{ReportTaskKind::Go, report.storey->rooms.front().name, true, {}};
    ReportTask learn{ReportTaskKind::Learn, report.storey->rooms.back().name, std::nullopt, {}};
    double value = 1.3;
    for (const ReportMeasureInfo& info : report_measures())
        (info.unit == "%" ? learn : go).measures.push_back({std::string(info.key), value *= 1.2});
    report.tasks = {go, learn};
    report.strategies = {{"perimeter", 300.0}, {"grid", 40.0}, {"object", 60.0}, {"base", 20.0}, {"mixed", 30.0}};
    report.course = {{0.0, "House. You are in Hall."}, {65.4, "Door."}};
    for (std::size_t i = 0; i < std::min<std::size_t>(9, way.size()); ++i)
        report.contacts.push_back({way[i], "door frame", static_cast<int>(9 - i)});
    return report;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

}  // namespace
}  // namespace handrail

int main(int count, char** words) {
    using namespace handrail;
    if (count != 2) return 2;
    const std::filesystem::path folder = words[1];
    bool written = true;
    const auto write = [&](const std::string& name, const std::string& page) {
        written = write_file_atomically(folder / name, page).has_value() && written;
    };
    const SessionReport house = session_in("house.map"), school = session_in("school.map");
    if (!house.storey || !school.storey) {
        std::cout << "House or school cannot be read.\n";
        return 1;
    }
    write("house.html", report_page(house));
    write("school.html", report_page(school));
    SessionReport no_hand = house;
    no_hand.contacts.clear();
    no_hand.storey.reset();
    write("no-hand.html", report_page(no_hand));
    write("nothing.html", report_page({}));
    std::vector<SessionReport> sessions(3, house);
    for (std::size_t i = 0; i < sessions.size(); ++i) sessions[i].session = std::string(1, static_cast<char>('1' + i));
    write("learner.html", learner_page(sessions));
    std::string broken = report_page(house);
    for (const auto& [what, by] : {std::pair<std::string, std::string>{" lang=\"en\"", ""},
                                   {" aria-labelledby=\"plan-name\"", ""},
                                   {"<title id=\"plan-name\">", "<desc>"},
                                   {"--soft:#4a4f59", "--soft:#ccc"},
                                   {"--soft:#c3c8d0", "--soft:#333"},
                                   {"<h2", "<h4"},
                                   {"</h2", "</h4"}})
        broken = replaced(broken, what, by);
    write("broken.html", broken);
    if (!speak_language("de")) return 1;
    write("haus.html", report_page(session_in("house.map")));
    return written ? 0 : 1;
}
