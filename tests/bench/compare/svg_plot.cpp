#include "tests/bench/compare/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/names.h"
#include "worlds/base/markup.h"

namespace handrail::bench {
namespace {

constexpr double kWidth = 960.0, kHeight = 640.0, kLeft = 110.0, kRight = 250.0, kTop = 60.0, kBottom = 80.0;

// Formats a power of ten for reading, for example "1e-9".
std::string power(int exponent) {
    return exponent >= 0 && exponent <= 3 ? fmt::format("{:g}", std::pow(10.0, exponent))
                                          : fmt::format("1e{}", exponent);
}

struct Axis {
    int first = 0, last = 1;  // range of the axis, as exponents of ten
    double from = 0.0, to = 1.0;
    double at(double value) const {
        const double least = std::pow(10.0, first);
        return from + (to - from) * (std::log10(std::max(value, least)) - first) / (last - first);
    }
};

template <class Value>
Axis axis_over(const Plot& plot, double least, double from, double to, Value&& value) {
    double low = std::numeric_limits<double>::infinity(), high = least > 0.0 ? least : 0.0;
    for (const PlotSeries& series : plot.series)
        for (const PlotPoint& point : series.points) {
            const double v = std::max(value(point), least);
            if (!(v > 0.0)) continue;
            low = std::min(low, v);
            high = std::max(high, v);
        }
    if (!(high > 0.0)) low = high = 1.0;
    low = std::min(low, high);
    Axis axis{static_cast<int>(std::floor(std::log10(low) + 1e-9)),
              static_cast<int>(std::ceil(std::log10(high) - 1e-9)), from, to};
    if (axis.last <= axis.first) axis.last = axis.first + 1;
    return axis;
}

// Draws one of twelve marks, 6 units in size.
std::string mark(std::size_t shape, double x, double y) {
    const bool filled = shape % 2 == 0;
    const std::string style =
        filled ? R"(fill="#000" stroke="#000" stroke-width="2")" : R"(fill="#fff" stroke="#000" stroke-width="2")";
    switch (shape / 2 % 5) {
        case 0:
            return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="6" {}/>)", x, y, style);
        case 1:
            return fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="11" height="11" {}/>)", x - 5.5, y - 5.5, style);
        case 2:
            return fmt::format(R"(<path d="M{:.1f} {:.1f}l7 12h-14z" {}/>)", x, y - 7.0, style);
        case 3:
            return fmt::format(R"(<path d="M{:.1f} {:.1f}l7 7l-7 7l-7 -7z" {}/>)", x, y - 7.0, style);
        default:
            return fmt::format(R"(<path d="M{:.1f} {:.1f}l7 -12h-14z" {}/>)", x, y + 7.0, style);
    }
}

}  // namespace

std::string svg_of(const Plot& plot) {
    const Axis x = axis_over(plot, plot.least_x, kLeft, kWidth - kRight, [](const PlotPoint& p) { return p.x; });
    const Axis y = axis_over(plot, plot.least_y, kHeight - kBottom, kTop, [](const PlotPoint& p) { return p.y; });
    std::string words = fmt::format("Across: {}. Up: {}. Both axes are logarithmic.", plot.x_title, plot.y_title);
    for (const PlotSeries& series : plot.series) {
        words += fmt::format(" {}:", series.name);
        for (const PlotPoint& p : series.points)
            words += fmt::format(" {}{:.3g} across, {:.3g} up;", p.label.empty() ? "" : p.label + ", ", p.x, p.y);
    }
    std::string out = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:g} {1:g}" role="img" aria-labelledby="title words")"
        R"( font-family="sans-serif" font-size="16">
<title id="title">{2}</title>
<desc id="words">{3}</desc>
<rect width="{0:g}" height="{1:g}" fill="#fff"/>
<text x="{4:g}" y="32" font-size="20" font-weight="bold">{2}</text>
)",
        kWidth, kHeight, markup_text(plot.title), markup_text(words), kLeft);
    const int x_every = std::max(1, (x.last - x.first + 7) / 8), y_every = std::max(1, (y.last - y.first + 9) / 10);
    for (int p = x.first; p <= x.last; ++p) {
        const double at = x.at(std::pow(10.0, p));
        out += fmt::format("<path d=\"M{:.1f} {:g}V{:g}\" stroke=\"#999\" stroke-width=\"1\"/>\n", at, kTop,
                           kHeight - kBottom);
        if ((p - x.first) % x_every == 0)
            out += fmt::format("<text x=\"{:.1f}\" y=\"{:g}\" text-anchor=\"middle\">{}</text>\n", at,
                               kHeight - kBottom + 24.0, power(p));
    }
    for (int p = y.first; p <= y.last; ++p) {
        const double at = y.at(std::pow(10.0, p));
        if ((p - y.first) % y_every != 0) continue;
        const bool floor = plot.least_y > 0.0 && p == y.first && std::pow(10.0, p) <= plot.least_y * 1.01;
        out += fmt::format("<path d=\"M{:g} {:.1f}H{:g}\" stroke=\"#999\" stroke-width=\"1\"/>\n", kLeft, at,
                           kWidth - kRight);
        out += fmt::format("<text x=\"{:g}\" y=\"{:.1f}\" text-anchor=\"end\">{}{}</text>\n", kLeft - 8.0, at + 5.0,
                           floor ? "≤ " : "", power(p));
    }
    out += fmt::format("<path d=\"M{0:g} {1:g}V{2:g}H{3:g}\" fill=\"none\" stroke=\"#000\" stroke-width=\"2\"/>\n",
                       kLeft, kTop, kHeight - kBottom, kWidth - kRight);
    out += fmt::format("<text x=\"{:g}\" y=\"{:g}\" text-anchor=\"middle\">{}</text>\n",
                       (kLeft + kWidth - kRight) / 2.0, kHeight - 24.0, markup_text(plot.x_title));
    out += fmt::format("<text transform=\"translate(28 {:g}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                       (kTop + kHeight - kBottom) / 2.0, markup_text(plot.y_title));
    double key_y = kTop + 10.0;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const PlotSeries& series = plot.series[i];
        if (series.line && series.points.size() > 1) {
            std::string way;
            for (const PlotPoint& p : series.points)
                way += fmt::format("{}{:.1f} {:.1f}", way.empty() ? "M" : "L", x.at(p.x), y.at(p.y));
            out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#000\" stroke-width=\"2\"{}/>\n", way,
                               i % 2 ? " stroke-dasharray=\"8 5\"" : "");
        }
        for (const PlotPoint& p : series.points) {
            out += mark(i, x.at(p.x), y.at(p.y)) + "\n";
            if (!p.label.empty())
                out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\">{}</text>\n", x.at(p.x) + 10.0,
                                   y.at(p.y) - 8.0, markup_text(p.label));
        }
        // The legend: the names are broken into lines that fit its width.
        out += mark(i, kWidth - kRight + 24.0, key_y) + "\n";
        std::string line;
        std::vector<std::string> lines;
        for (std::size_t begin = 0; begin < series.name.size();) {
            const std::size_t end = std::min(series.name.find(' ', begin), series.name.size());
            const std::string word = series.name.substr(begin, end - begin);
            if (!line.empty() && line.size() + 1 + word.size() > 24) {
                lines.push_back(line);
                line.clear();
            }
            line += (line.empty() ? "" : " ") + word;
            begin = end + 1;
        }
        lines.push_back(line);
        for (const std::string& one : lines) {
            out += fmt::format("<text x=\"{:g}\" y=\"{:.1f}\">{}</text>\n", kWidth - kRight + 40.0, key_y + 5.0,
                               markup_text(one));
            key_y += 20.0;
        }
        key_y += 8.0;
    }
    return out + "</svg>\n";
}

}  // namespace handrail::bench
