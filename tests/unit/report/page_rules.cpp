#include "tests/unit/report/page_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include "tests/support/names.h"
#include "worlds/base/text.h"

namespace handrail::test {
namespace page_rules {

struct Element {
    std::string name, text;  // text: the element's own text, up to the next tag
    std::map<std::string, std::string> attributes;
    std::vector<std::size_t> inside;  // indices of the element's ancestors, outermost first
    bool has(const std::string& key) const { return attributes.contains(key); }
    std::string get(const std::string& key) const { return has(key) ? attributes.at(key) : std::string(); }
};

struct Page {
    std::vector<Element> elements;
    std::vector<std::string> faults;
};

Page parsed(std::string_view html) {
    static const std::set<std::string> kVoid{"meta", "br", "hr", "img", "link"};
    static const std::regex kAttribute(R"(([a-zA-Z:-]+)="([^"]*)\")");
    Page page;
    std::vector<std::size_t> open;
    std::size_t at = 0;
    while (at < html.size()) {
        const std::size_t tag = html.find('<', at);
        const std::string text(html.substr(at, std::min(tag, html.size()) - at));
        if (!open.empty()) page.elements[open.back()].text += text;
        if (tag == std::string_view::npos) break;
        const std::size_t end = html.find('>', tag);
        if (end == std::string_view::npos) {
            page.faults.push_back("a tag is not closed");
            break;
        }
        std::string inner(html.substr(tag + 1, end - tag - 1));
        at = end + 1;
        if (inner.starts_with("!DOCTYPE")) continue;
        if (inner.starts_with("/")) {
            const std::string name = inner.substr(1);
            if (open.empty() || page.elements[open.back()].name != name)
                page.faults.push_back("</" + name + "> closes what is not open");
            else open.pop_back();
            continue;
        }
        const bool closed = inner.ends_with("/");
        Element element;
        element.name = inner.substr(0, inner.find_first_of(" \n/"));
        element.inside = open;
        for (auto it = std::sregex_iterator(inner.begin(), inner.end(), kAttribute); it != std::sregex_iterator(); ++it)
            element.attributes[(*it)[1]] = (*it)[2];
        page.elements.push_back(element);
        if (!closed && !kVoid.contains(element.name)) open.push_back(page.elements.size() - 1);
        if (element.name == "style") {  // a style element contains no tags
            const std::size_t stop = html.find("</style>", at);
            page.elements.back().text = std::string(html.substr(at, stop - at));
            at = std::min(stop, html.size());
        }
    }
    for (const std::size_t i : open) page.faults.push_back("<" + page.elements[i].name + "> stays open");
    return page;
}

std::string trimmed_text(std::string text) {
    static const std::array<std::pair<std::string, std::string>, 4> kNames{
        {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}};
    for (const auto& [name, sign] : kNames)
        for (std::size_t i = 0; (i = text.find(name, i)) != std::string::npos; i += sign.size())
            text.replace(i, name.size(), sign);
    std::string out;
    for (const char c : text)
        if (c != '\n' && !(c == ' ' && (out.empty() || out.back() == ' '))) out += c;
    while (!out.empty() && out.back() == ' ') out.pop_back();
    return out;
}

// Relative luminance of a colour, as WCAG 2 defines it.
double luminance(const std::string& hex) {
    const bool small = hex.size() == 4;
    double sum = 0.0;
    const std::array<double, 3> weights{0.2126, 0.7152, 0.0722};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string part = small ? std::string(2, hex[1 + i]) : hex.substr(1 + 2 * i, 2);
        const double c = std::stoi(part, nullptr, 16) / 255.0;
        sum += weights[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return sum;
}

double contrast(const std::string& a, const std::string& b) {
    const double one = luminance(a), other = luminance(b);
    return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

void check_style(const std::string& style, std::vector<std::string>& faults) {
    static const std::regex kSet(R"(:root\{([^}]*)\})"), kColour(R"(--([a-z]+):(#[0-9a-fA-F]+))");
    int sets = 0;
    for (auto it = std::sregex_iterator(style.begin(), style.end(), kSet); it != std::sregex_iterator(); ++it, ++sets) {
        const std::string body = (*it)[1];
        std::map<std::string, std::string> colours;
        for (auto c = std::sregex_iterator(body.begin(), body.end(), kColour); c != std::sregex_iterator(); ++c)
            colours[(*c)[1]] = (*c)[2];
        if (!colours.contains("paper")) {
            faults.push_back("a set of colours without paper");
            continue;
        }
        for (const auto& [name, colour] : colours)
            if (name != "paper" && contrast(colour, colours["paper"]) < (name == "line" ? 3.0 : 4.5))
                faults.push_back("too little contrast: " + name);
    }
    if (sets < 3) faults.push_back("no colours for light, dark and print");
    if (style.find("url(") != std::string::npos || style.find("@import") != std::string::npos)
        faults.push_back("a request from the style");
    if (style.find("overflow-wrap") == std::string::npos) faults.push_back("long words do not wrap");
    static const std::regex kBare(R"((^|[;{ ])color:(#[0-9a-fA-F]{3,6}))");
    for (auto it = std::sregex_iterator(style.begin(), style.end(), kBare); it != std::sregex_iterator(); ++it)
        if (contrast((*it)[2], "#ffffff") < 4.5) faults.push_back("too little contrast: a colour of its own");
}

}  // namespace page_rules

std::vector<std::string> page_faults(std::string_view html) {
    using namespace page_rules;
    Page page = parsed(html);
    std::vector<std::string>& faults = page.faults;
    const auto of_name = [&](const std::string& name) {
        std::vector<const Element*> found;
        for (const Element& element : page.elements)
            if (element.name == name) found.push_back(&element);
        return found;
    };
    const auto within = [&](const Element& element, const std::string& name) {
        return std::any_of(element.inside.begin(), element.inside.end(),
                           [&](std::size_t i) { return page.elements[i].name == name; });
    };
    if (!html.starts_with("<!DOCTYPE html>")) faults.push_back("no doctype");
    if (of_name("html").size() != 1 || of_name("html")[0]->get("lang").empty()) faults.push_back("no language");
    if (of_name("title").empty() || trimmed_text(of_name("title")[0]->text).empty()) faults.push_back("no title");
    if (of_name("main").size() != 1) faults.push_back("no main part");
    if (of_name("h1").size() != 1) faults.push_back("not one h1");
    int level = 0;
    for (const Element& element : page.elements)
        if (element.name.size() == 2 && element.name[0] == 'h' && element.name[1] >= '1' && element.name[1] <= '6') {
            const int own = element.name[1] - '0';
            if (own > level + 1) faults.push_back("heading " + element.name + " after h" + std::to_string(level));
            if (trimmed_text(element.text).empty()) faults.push_back("an empty heading");
            level = own;
        }
    std::map<std::size_t, bool> captioned, row_headed;
    for (std::size_t i = 0; i < page.elements.size(); ++i) {
        const Element& element = page.elements[i];
        if (element.name == "table") captioned[i], row_headed[i];
        for (const std::size_t outer : element.inside) {
            if (page.elements[outer].name != "table") continue;
            if (element.name == "caption" && !trimmed_text(element.text).empty()) captioned[outer] = true;
            if (element.name == "th" && element.get("scope") == "row") row_headed[outer] = true;
        }
        if (element.name == "th" && element.get("scope") != "col" && element.get("scope") != "row")
            faults.push_back("a head cell without scope");
    }
    for (const auto& [table, yes] : captioned)
        if (!yes) faults.push_back("a table without caption");
    for (const auto& [table, yes] : row_headed)
        if (!yes) faults.push_back("a table without row heads");
    std::set<std::string> ids;
    for (const Element& element : page.elements)
        if (element.has("id") && !ids.insert(element.get("id")).second)
            faults.push_back("id twice: " + element.get("id"));
    for (const Element& element : page.elements) {
        for (const char* key : {"aria-labelledby", "aria-describedby"})
            if (element.has(key) && !ids.contains(element.get(key)))
                faults.push_back("points at no id: " + element.get(key));
        for (const char* key : {"src", "href", "srcset", "action", "data", "poster"})
            if (element.has(key) && !element.get(key).starts_with("#"))
                faults.push_back("a request: " + element.get(key));
        if (element.name == "script" || element.name == "link" || element.name == "iframe")
            faults.push_back("a request: " + element.name);
        if (element.has("style") || std::any_of(element.attributes.begin(), element.attributes.end(),
                                                [](const auto& a) { return a.first.starts_with("on"); }))
            faults.push_back("style or script in an attribute");
        if ((element.name == "svg" || element.get("role") == "img") && element.get("aria-labelledby").empty() &&
            element.get("aria-label").empty())
            faults.push_back("a picture without a name");
        if (element.name == "img" && element.get("alt").empty()) faults.push_back("a picture without a name");
        if (element.name == "text" && within(element, "svg")) {
            const bool hidden = std::any_of(element.inside.begin(), element.inside.end(), [&](std::size_t i) {
                return page.elements[i].get("aria-hidden") == "true";
            });
            if (!hidden) faults.push_back("text of a picture is read out");
        }
        if (element.name == "li" && !within(element, "ul") && !within(element, "ol"))
            faults.push_back("an item without a list");
    }
    const auto styles = of_name("style");
    if (styles.size() != 1) faults.push_back("not one style");
    else check_style(styles[0]->text, faults);
    bool guarded = false;
    for (const Element* meta : of_name("meta"))
        guarded |= meta->get("content").find("default-src 'none'") != std::string::npos;
    if (!guarded) faults.push_back("no policy against requests");
    return faults;
}

std::string spoken_text(std::string_view html) {
    using namespace page_rules;
    const Page page = parsed(html);
    std::string out;
    for (const Element& element : page.elements) {
        const auto hides = [&](const Element& one) {
            return one.get("aria-hidden") == "true" || one.name == "style" || one.name == "head";
        };
        if (hides(element) || std::any_of(element.inside.begin(), element.inside.end(),
                                          [&](std::size_t i) { return hides(page.elements[i]); }))
            continue;
        const std::string text = trimmed_text(element.text);
        if (!text.empty()) out += element.name + ": " + text + "\n";
    }
    return out;
}

double lix_of(const std::string& text) {
    double words = 0.0, long_words = 0.0, sentences = 0.0;
    std::size_t letters = 0;
    const auto end_word = [&] {
        words += letters > 0 ? 1.0 : 0.0;
        long_words += letters > 6 ? 1.0 : 0.0;
        letters = 0;
    };
    for (const std::string& sign : characters_of(text)) {
        const bool letter = sign.size() > 1 || std::isalnum(static_cast<unsigned char>(sign[0]));
        if (letter) ++letters;
        else end_word();
        if (sign == "." || sign == "!" || sign == "?" || sign == ":") sentences += 1.0;
    }
    end_word();
    return words == 0.0 ? 0.0 : words / std::max(1.0, sentences) + 100.0 * long_words / words;
}

}  // namespace handrail::test
