// Draws the plan on a page: where the learner walked and which objects were touched. Words below the plan say the same.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/report/page_parts.h"
#include "app/report/report_page.h"
#include "worlds/base/language.h"
#include "worlds/base/markup.h"
#include "worlds/base/text.h"

namespace handrail::report {
namespace {

// A box on the plan that a text occupies, so that no other text may overlap it.
struct Box {
    double left, top, right, bottom;
    bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

// Returns the space that a name needs in letters of height `letter`, centred at a point. Assumes a generous mean width
// of the letters, because fonts differ.
Box box_of(const std::string& name, double x, double y, double letter) {
    const double half = 0.32 * letter * static_cast<double>(characters_of(name).size());
    return {x - half, y - letter, x + half, y + 0.3 * letter};
}

// Returns a height at which the name overlaps no other text: its own place, or up to two lines above or below, inside
// the picture. Returns nothing if there is no space; the name is then only in the words below the plan.
std::optional<double> free_line(const std::string& name, double x, double y, double letter, double wide, double high,
                                const std::vector<Box>& taken) {
    for (const double lines : {0.0, 1.4, -1.4, 2.8, -2.8}) {
        const Box box = box_of(name, x, y + lines * letter, letter);
        if (box.left < 0.0 || box.right > wide || box.top < 0.0 || box.bottom > high) continue;
        if (std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return box.meets(other); }))
            return y + lines * letter;
    }
    return std::nullopt;
}

// Draws the plan as SVG in tenths of a metre, with north at the top. Texts in the SVG are hidden from screen readers,
// which would otherwise read them in the middle of the page. The words below the plan contain the same facts in order.
std::string plan_svg(const SessionReport& report, std::string_view id) {
    const plan::Storey& storey = *report.storey;
    const auto x = [&](const Vec2& p) { return (p.x - storey.min_m.x) * 10.0; };
    const auto y = [&](const Vec2& p) { return (storey.max_m.y - p.y) * 10.0; };
    const double wide = x(storey.max_m), high = y(storey.min_m), letter = std::max(3.0, std::max(wide, high) / 45.0);
    std::string svg = fmt::format(
        "<svg role=\"img\" aria-labelledby=\"{0}-name\" aria-describedby=\"{0}-words\" viewBox=\"0 0 {1:.1f} "
        "{2:.1f}\">\n<title id=\"{0}-name\">{3}</title>\n<g class=\"wall\">\n",
        id, wide, high, markup_text(phrase("report.plan_title", {{"world", storey.world}, {"storey", storey.number}})));
    const auto path = [&](std::span<const Vec2> points) {
        std::string d;
        for (std::size_t i = 0; i < points.size(); ++i)
            d += fmt::format("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', x(points[i]), y(points[i]));
        return d;
    };
    for (const plan::PlanOutline& wall : storey.walls_m) svg += fmt::format("<path d=\"{}Z\"/>\n", path(wall));
    svg += "</g>\n<g class=\"wall\" stroke=\"currentColor\">\n";
    for (const auto& sheet : storey.sheets_m) svg += fmt::format("<path d=\"{}\"/>\n", path(sheet));
    svg += "</g>\n";
    const double stroke = letter / 4.0;
    for (const std::vector<Vec2>& way : report.ways_m)
        if (way.size() >= 2)
            svg += fmt::format("<path class=\"way\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n", stroke, path(way));
    svg += fmt::format("<g aria-hidden=\"true\" text-anchor=\"middle\" font-size=\"{:.1f}\">\n", letter);
    // Place the numbers of touched objects first, then the names around them. If several objects were touched in one
    // place, only the most frequently touched one gets a number there.
    std::vector<Box> taken;
    std::string numbers;
    for (std::size_t i = 0; i < report.contacts.size(); ++i) {
        const Vec2& at = report.contacts[i].place_m;
        const Box spot{x(at) - letter, y(at) - letter, x(at) + letter, y(at) + letter};
        if (std::any_of(taken.begin(), taken.end(), [&](const Box& other) { return spot.meets(other); })) continue;
        taken.push_back(spot);
        numbers += fmt::format(
            "<circle class=\"spot\" stroke-width=\"{:.2f}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/><text "
            "class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
            stroke, x(at), y(at), letter, x(at), y(at) + 0.35 * letter, i + 1);
    }
    for (const plan::StoreyRoom& room : storey.rooms) {
        const std::string name = capitalised(room.name);
        const auto line = free_line(name, x(room.middle_m), y(room.middle_m), letter, wide, high, taken);
        if (!line) continue;
        taken.push_back(box_of(name, x(room.middle_m), *line, letter));
        svg += fmt::format("<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x(room.middle_m), *line,
                           markup_text(name));
    }
    return svg + numbers + "</g>\n</svg>\n";
}

}  // namespace

std::string plan_html(const SessionReport& report, std::string_view id) {
    if (!report.storey) return {};
    std::string html = plan_svg(report, id) + fmt::format("<p id=\"{}-words\">", id);
    for (const std::string& sentence : plan_words(report)) html += markup_text(sentence) + " ";
    html += "</p>\n";
    if (report.contacts.empty()) return html;
    html += "<p>" + markup_text(phrase("report.contacts")) + "</p>\n<ol>\n";
    for (const ReportContact& contact : report.contacts)
        html += "<li>" +
                markup_text(phrase("report.contact", {{"name", capitalised(contact.name)}, {"count", contact.count}})) +
                "</li>\n";
    return html + "</ol>\n";
}

}  // namespace handrail::report
