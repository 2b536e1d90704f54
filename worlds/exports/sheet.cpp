#include "worlds/exports/sheet.h"

#include <fmt/format.h>

#include <cstdint>

#include "worlds/base/markup.h"

namespace handrail::exports {
namespace {

// Returns a PDF text string: UTF-16 in hexadecimal digits.
std::string pdf_text(const std::string& text) {
    std::string out = "<FEFF";
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i]);
        const std::size_t length = first < 0x80 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
        std::uint32_t code = first < 0x80 ? first : first & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length && i + k < text.size(); ++k)
            code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
        if (code >= 0x10000)
            out += fmt::format("{:04X}{:04X}", 0xD800 + ((code - 0x10000) >> 10 & 0x3FFU), 0xDC00 + (code & 0x3FFU));
        else out += fmt::format("{:04X}", code);
        i += length;
    }
    return out + ">";
}

}  // namespace

std::string svg_of(const SheetPage& page, const std::string& language) {
    std::string svg = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
        "xml:lang=\"{}\" role=\"img\" aria-labelledby=\"name\" aria-describedby=\"words\" width=\"{:.3f}mm\" "
        "height=\"{:.3f}mm\" viewBox=\"0 0 {:.3f} {:.3f}\">\n<title id=\"name\">{}</title>\n<desc "
        "id=\"words\">{}</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g fill=\"#000\" "
        "fill-rule=\"evenodd\">\n",
        markup_text(language), page.width_mm, page.height_mm, page.width_mm, page.height_mm, markup_text(page.title),
        markup_text(page.text));
    for (const SheetShape& shape : page.shapes) {
        svg += "<path d=\"";
        for (const auto& loop : shape.loops_mm) {
            for (std::size_t i = 0; i < loop.size(); ++i)
                svg += fmt::format("{}{:.2f} {:.2f}", i == 0 ? 'M' : 'L', loop[i].x, page.height_mm - loop[i].y);
            svg += 'Z';
        }
        svg += "\"/>\n";
    }
    for (const SheetDot& dot : page.dots)
        svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", dot.at_mm.x,
                           page.height_mm - dot.at_mm.y, dot.radius_mm);
    return svg + "</g>\n</svg>\n";
}

std::string pdf_of(std::span<const SheetPage> pages, const std::string& language) {
    constexpr double kPointsPerMm = 72.0 / 25.4;
    std::vector<std::string> objects(3);
    std::string kids;
    for (const SheetPage& page : pages) {
        std::string drawn = fmt::format("1 J 1 j 0 g 0 G\n{:.6f} 0 0 {:.6f} 0 0 cm\n", kPointsPerMm, kPointsPerMm);
        for (const SheetShape& shape : page.shapes) {
            for (const auto& loop : shape.loops_mm) {
                for (std::size_t i = 0; i < loop.size(); ++i)
                    drawn += fmt::format("{:.3f} {:.3f} {}\n", loop[i].x, loop[i].y, i == 0 ? 'm' : 'l');
                drawn += "h\n";
            }
            drawn += "f*\n";
        }
        for (const SheetDot& dot : page.dots)  // a disc is a line of zero length with round ends
            drawn += fmt::format("{:.3f} w {:.3f} {:.3f} m {:.3f} {:.3f} l S\n", 2.0 * dot.radius_mm, dot.at_mm.x,
                                 dot.at_mm.y, dot.at_mm.x, dot.at_mm.y);
        objects.push_back(fmt::format("<</Length {}>>stream\n{}endstream", drawn.size(), drawn));
        objects.push_back(
            fmt::format("<</Type/Page/Parent 2 0 R/MediaBox[0 0 {:.3f} {:.3f}]/Resources<<>>/Contents {} 0 R>>",
                        page.width_mm * kPointsPerMm, page.height_mm * kPointsPerMm, objects.size()));
        kids += fmt::format("{} 0 R ", objects.size());
    }
    objects[0] = fmt::format(
        "<</Type/Catalog/Pages 2 0 R/Lang({})/ViewerPreferences<</PrintScaling/None/DisplayDocTitle true>>>>",
        language);
    objects[1] = fmt::format("<</Type/Pages/Kids[{}]/Count {}>>", kids, pages.size());
    objects[2] = fmt::format("<</Title {} /Subject {}>>", pdf_text(pages.empty() ? "" : pages.front().title),
                             pdf_text(pages.empty() ? "" : pages.front().text));
    std::string pdf = "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n";
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        places.push_back(pdf.size());
        pdf += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
    }
    const std::size_t table = pdf.size();
    pdf += fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects.size() + 1);
    for (const std::size_t place : places) pdf += fmt::format("{:010} 00000 n \n", place);
    return pdf +
           fmt::format("trailer<</Size {}/Root 1 0 R/Info 3 0 R>>\nstartxref\n{}\n%%EOF\n", objects.size() + 1, table);
}

}  // namespace handrail::exports
