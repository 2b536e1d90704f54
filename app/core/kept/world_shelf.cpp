#include "app/core/kept/world_shelf.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "app/core/dialogue/words.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLargestList = 64 * 1024;
constexpr std::size_t kMostInFolder = 1000;
constexpr std::array<std::string_view, 12> kEndings{".map", ".ifc", ".osm",  ".osm.bz2", ".osm.pbf", ".imdf.zip",
                                                    ".obj", ".glb", ".gltf", ".ply",     ".stl",     ".rooms"};

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

bool is_world(const fs::path& file) {
    const std::string name = lower_ascii(file.filename().string());
    return std::any_of(kEndings.begin(), kEndings.end(),
                       [&](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

std::string name_of_file(const fs::path& file) {
    const std::string stem = file.stem().string();
    std::string name;
    for (const std::string& character : characters_of(stem))
        if (is_utf8(character) && !is_control(character[0]))
            name += character == "_" || character == "-" ? " " : character;
    return name.empty() ? phrase("worlds.without_a_name") : sentence_case(name);
}

std::vector<ShelvedWorld> worlds_in(const fs::path& folder) {
    std::vector<ShelvedWorld> worlds;
    std::error_code ec;
    for (fs::directory_iterator it(folder, ec), end; !ec && it != end && worlds.size() < kMostInFolder;
         it.increment(ec)) {
        std::error_code unreadable;
        if (is_world(it->path()) && it->is_regular_file(unreadable))
            worlds.push_back({name_of_file(it->path()), it->path()});
    }
    std::sort(worlds.begin(), worlds.end(), [](const ShelvedWorld& a, const ShelvedWorld& b) {
        return std::tie(a.name, a.file) < std::tie(b.name, b.file);
    });
    return worlds;
}

RecentWorlds::RecentWorlds(fs::path file) : file_(std::move(file)) {
    std::error_code ec;
    if (file_.empty() || fs::status(file_, ec).type() == fs::file_type::not_found) return;
    const auto content = read_whole_file(file_, kLargestList);
    bool good = content && is_utf8(*content);
    for (std::size_t at = 0; good && at < content->size();) {
        const std::size_t end = std::min(content->find('\n', at), content->size());
        const std::string line = content->substr(at, end - at);
        at = end + 1;
        if (line.empty()) continue;
        good = line[0] == '/' && std::none_of(line.begin(), line.end(), is_control);
        if (good && worlds_.size() < kMost) worlds_.emplace_back(line);
    }
    if (good) return;
    worlds_.clear();
    fs::path aside = file_;
    aside += ".damaged";
    fs::rename(file_, aside, ec);
    news_ =
        ec ? phrase("worlds.list_damaged_stays") : phrase("worlds.list_damaged", {{"file", aside.filename().string()}});
    if (ec) file_.clear();
}

void RecentWorlds::add(const fs::path& world) {
    std::error_code ec;
    fs::path whole = fs::absolute(world, ec);
    const std::string text = whole.string();
    if (ec || !is_utf8(text) || std::any_of(text.begin(), text.end(), is_control)) return;
    std::erase(worlds_, whole);
    worlds_.insert(worlds_.begin(), std::move(whole));
    if (worlds_.size() > kMost) worlds_.resize(kMost);
    if (file_.empty()) return;
    std::string content;
    for (const fs::path& one : worlds_) content += one.string() + '\n';
    if (!write_file_atomically(file_, content))
        file_.clear();  // the folder cannot be written, so the list stays in memory
}

std::string RecentWorlds::take_news() { return std::exchange(news_, {}); }

fs::path recent_worlds_path() {
    // As in user_data_folder(), relative paths are ignored.
    const char* state = std::getenv("XDG_STATE_HOME");
    const char* home = std::getenv("HOME");
    if (state && state[0] == '/') return fs::path(state) / "handrail" / "recent-worlds.txt";
    if (home && home[0] == '/') return fs::path(home) / ".local" / "state" / "handrail" / "recent-worlds.txt";
    return {};
}

}  // namespace handrail::core
