#include "app/main/page_export.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/core/whereabouts/storeys.h"
#include "app/main/world_files.h"
#include "worlds/base/contract.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/markup.h"
#include "worlds/stored/stored_navigation.h"
#include "worlds/stored/stored_scene.h"

namespace handrail::program {
namespace {

constexpr std::size_t kMostCore_bytes = 64U << 20;

std::string gzipped(std::string_view bytes) {
    z_stream stream{};
    constexpr int kGzip = 15 + 16;  // the largest window, with the header and checksum of gzip
    [[maybe_unused]] const int ready = deflateInit2(&stream, 9, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY);
    contract_pre(ready == Z_OK);
    std::string packed(deflateBound(&stream, bytes.size()), '\0');
    std::string input(bytes);
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = static_cast<uInt>(input.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    [[maybe_unused]] const int done = deflate(&stream, Z_FINISH);
    contract_pre(done == Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t three = 0;
        for (std::size_t i = 0; i < 3; ++i)
            three = three << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i) text += at + i <= bytes.size() ? kDigits[three >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

// The labels of the page in each bundled language, as the page's script reads them.
std::string labels() {
    nlohmann::json all;
    for (const LanguageName& language : bundled_languages()) {
        nlohmann::json& own = all[language.code];
        own["name"] = language.name;
        for (const auto& [key, text] : bundled_texts(language.code))
            if (key.starts_with("page_label.")) own[key.substr(key.find('.') + 1)] = text;
    }
    std::string text = all.dump();
    // "</script" in a label would end the element that contains them.
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) text.replace(at, 1, "\\u003c");
    return text;
}

}  // namespace

Result<std::string> page_core() {
    const std::filesystem::path core = shared_folder() / "page.html";
    std::error_code ec;
    if (!std::filesystem::exists(core, ec)) return fail(phrase("export.no_page_core"));
    return read_whole_file(core, kMostCore_bytes);
}

std::string plain_building(const Scene& scene, const navigation::RoomGraph& graph) {
    const std::vector<core::StoreyOfRooms> storeys = core::storeys_of(scene, graph);
    std::string html;
    for (std::size_t i = storeys.size(); i-- > 0;) {
        html += fmt::format("<h2>{}</h2>\n<ul>\n", markup_text(core::storey_name(storeys, i)));
        for (const std::uint32_t room : storeys[i].rooms) {
            std::vector<std::string> joined;
            for (const navigation::Portal& portal : graph.portals)
                for (std::size_t side = 0; side < 2; ++side)
                    if (portal.rooms[side] == room && !(portal.one_way && side == 1))
                        joined.push_back(graph.rooms[portal.rooms[1 - side]].name);
            std::sort(joined.begin(), joined.end());
            joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
            html += fmt::format(
                "<li>{}</li>\n",
                markup_text(phrase("export.page_room", {{"room", capitalised(graph.rooms[room].name)},
                                                        {"area", graph.rooms[room].area_m2},
                                                        {"count", joined.size()},
                                                        {"names", fmt::format("{}", fmt::join(joined, ", "))}})));
        }
        html += "</ul>\n";
    }
    return html;
}

std::string page_of(std::string_view core, const Scene& scene, const navigation::RoomGraph& graph,
                    const navigation::WalkSpace& space) {
    const std::pair<std::string_view, std::string> marks[] = {
        {"@LANGUAGE@", spoken_language()},
        {"@TITLE@", markup_text(in_spoken_language(scene.name, scene.name_in))},
        {"@PLAIN@", plain_building(scene, graph)},
        {"@TEXTS@", labels()},
        {"@SCENE@", base64(gzipped(stored::stored(scene)))},
        {"@NAVIGATION@", base64(gzipped(stored::stored_navigation(space, graph)))}};
    std::string page;
    while (!core.empty()) {
        const std::size_t at = std::min(core.find('@'), core.size());
        page += core.substr(0, at);
        core.remove_prefix(at);
        const auto mark = std::find_if(std::begin(marks), std::end(marks),
                                       [&](const auto& one) { return core.starts_with(one.first); });
        if (mark != std::end(marks)) {
            page += mark->second;
            core.remove_prefix(mark->first.size());
        } else if (!core.empty()) {
            page += '@';
            core.remove_prefix(1);
        }
    }
    return page;
}

}  // namespace handrail::program
