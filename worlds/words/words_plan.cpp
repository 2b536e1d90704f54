#include "worlds/words/words_plan.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/human_measures.h"
#include "worlds/base/text.h"

namespace handrail::words {
namespace {

constexpr std::size_t kMostSentences = 60'000, kMostRooms = 4'000, kMostStoreys = 60;
constexpr double kLeastStorey_m = 2.3;
constexpr double kLeastWall_m = 0.05, kMostWall_m = 0.6, kLeastStep_m = 0.2, kMostStep_m = 2.0;

}  // namespace

void WordsPlan::warn(int line, const std::string& message, const std::string& action) {
    constexpr std::size_t kMostKept = 20;
    ++warnings_in_all_;
    if (warnings_.size() < kMostKept)
        warnings_.push_back({Severity::Warning, file_, line, 0, one_line(message), one_line(action)});
}

Result<floorplan::FloorPlan> WordsPlan::build(std::string_view bytes) {
    plan_.format = "rooms";
    plan_.schema = phrase("rooms_text.schema");
    plan_.measures_known = true;
    if (bytes.find('\0') != std::string_view::npos) return fail(phrase("rooms_text.no_text"), file_);
    const std::vector<WordSentence> sentences = sentences_of(bytes);
    if (sentences.size() > kMostSentences) return fail(phrase("rooms_text.too_large"), file_);
    speaker_.language = language_of(sentences);
    // The first pass collects all names, because a sentence may use a name before another sentence defines it. The pass
    // also reads the length of a step.
    std::vector<std::string> names;
    for (const WordSentence& sentence : sentences) {
        SaidSentence head = head_of(sentence, speaker_);
        if (head.kind == SentenceKind::Step)
            for (std::size_t i = 0; i < sentence.tokens.size(); ++i)
                if (sentence.tokens[i].kind == WordToken::Kind::Number) {
                    const bool cm = i + 1 < sentence.tokens.size() && (sentence.tokens[i + 1].folded.starts_with("c") ||
                                                                       sentence.tokens[i + 1].folded.starts_with("z"));
                    speaker_.step_m =
                        std::clamp(sentence.tokens[i].number * (cm ? 0.01 : 1.0), kLeastStep_m, kMostStep_m);
                    break;
                }
        if (head.kind == SentenceKind::Room || head.kind == SentenceKind::Storey || head.kind == SentenceKind::Thing)
            names.push_back(name_key(head.name, speaker_.language));
    }
    for (std::string& name : names)
        if (!name.empty()) speaker_.names.insert(std::move(name));
    for (std::size_t i = 0; i < sentences.size(); ++i) {
        SaidSentence said = understood(sentences[i], speaker_);
        // "Hall. Door outside." at the start of a paragraph describes a room whose size the author forgot.
        if (said.kind == SentenceKind::Thing && said.parts.empty() && sentences[i].paragraph &&
            i + 1 < sentences.size() && !sentences[i + 1].paragraph) {
            const SentenceKind next = understood(sentences[i + 1], speaker_).kind;
            if (next == SentenceKind::Door || next == SentenceKind::Opening || next == SentenceKind::Window)
                said.kind = SentenceKind::Room;
        }
        take(std::move(said), sentences[i].line);
    }
    if (rooms_.empty())
        return fail(phrase("rooms_text.no_rooms"), file_, sentences.empty() ? 0 : sentences.front().line);
    if (rooms_.size() > kMostRooms || storeys_.size() > kMostStoreys)
        return fail(phrase("rooms_text.too_large"), file_);
    lay_storeys();
    set_sizes();
    place_rooms();
    find_overlaps();
    set_raises();
    add_spaces();
    doors_of_.resize(rooms_.size());
    for (std::size_t r = 0; r < rooms_.size(); ++r) add_doors(r);
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        windows_here_.clear();
        placed_things_.clear();
        placed_here_.clear();
        doors_here_ = doors_of_[r];
        add_windows(r);
        add_things(r);
    }
    for (const Said& said : starts_) add_start(said);
    constexpr std::size_t kMostWork = 300'000'000;
    if (work_ > kMostWork) return fail(phrase("rooms_text.too_large"), file_);
    const auto warn_count = [&](std::string_view key, int count) {
        if (count > 0) plan_.guessed.push_back(phrase(key, {{"n", count}}));
    };
    warn_count("rooms_text.guessed_doors", middle_doors_);
    warn_count("rooms_text.guessed_sizes", usual_sizes_);
    warn_count("rooms_text.guessed_places", without_place_);
    if (steps_) plan_.guessed.push_back(phrase("rooms_text.guessed_step", {{"cm", 100.0 * speaker_.step_m}}));
    if (left_and_right_) plan_.guessed.push_back(phrase("rooms_text.guessed_left"));
    return std::move(plan_);
}

void WordsPlan::take(SaidSentence said, int line) {
    steps_ |= said.in_steps;
    const bool read_before = said.kind == SentenceKind::Step || said.kind == SentenceKind::Language;
    for (const std::string& words : read_before ? std::vector<std::string>() : said.not_understood)
        warn(line, phrase("rooms_text.not_understood", {{"words", one_line(words.substr(0, 120))}}),
             phrase("rooms_text.then_rest_counts"));
    const SaidPart *high = said.find(Statement::High), *thick = said.find(Statement::Thick),
                   *walls = said.find(Statement::Walls);
    const auto needs_room = [&] {
        if (!rooms_.empty()) return false;
        warn(line, phrase("rooms_text.before_rooms"), phrase("rooms_text.then_left_out"));
        return true;
    };
    switch (said.kind) {
        case SentenceKind::Building:
            plan_.name = one_line(said.name.substr(0, 200));
            break;
        case SentenceKind::Storey: {
            Storey storey{one_line(said.name.substr(0, 200)), {}, {}, line};
            if (high) {
                storey.height_m = std::clamp(high->numbers[0], kLeastStorey_m, kHighestStorey_m);
                if (*storey.height_m != high->numbers[0])
                    warn(line, phrase("rooms_text.odd_height", {{"height", high->numbers[0]}}),
                         phrase("rooms_text.then_height", {{"height", *storey.height_m}}));
            }
            if (const SaidPart* above = said.find(Statement::AboveFloor))
                storey.floor_m = std::clamp(above->numbers[0], -200.0, 1000.0);
            storeys_.push_back(std::move(storey));
            break;
        }
        case SentenceKind::Walls:
            if (thick) plan_.wall_m = std::clamp(thick->numbers[0], kLeastWall_m, kMostWall_m);
            if (walls) plan_.wall_material = walls->name;
            break;
        case SentenceKind::Step:
        case SentenceKind::Language:
            break;
        case SentenceKind::Room: {
            if (storeys_.empty()) storeys_.push_back({phrase("rooms_text.ground_floor"), {}, {}, 0});
            WordRoom room;
            room.storey = storeys_.size() - 1;
            room.said = {std::move(said), line};
            const std::string key = name_key(room.said.words.name, speaker_.language);
            std::vector<std::size_t>& same = by_name_[key];
            for (const std::size_t other : same)
                if (rooms_[other].storey == room.storey) {
                    warn(line, phrase("rooms_text.same_name", {{"name", room.said.words.name}}),
                         phrase("rooms_text.then_nearest"));
                    break;
                }
            same.push_back(rooms_.size());
            rooms_.push_back(std::move(room));
            break;
        }
        case SentenceKind::Door:
        case SentenceKind::SlidingDoor:
        case SentenceKind::Opening:
        case SentenceKind::Lift:
        case SentenceKind::Flight:
        case SentenceKind::Drop:
            if (!needs_room()) rooms_.back().doors.push_back({std::move(said), line});
            break;
        case SentenceKind::Window:
            if (!needs_room()) rooms_.back().windows.push_back({std::move(said), line});
            break;
        case SentenceKind::Thing:
            if (!needs_room()) rooms_.back().things.push_back({std::move(said), line});
            break;
        case SentenceKind::Start:
            if (needs_room()) break;
            starts_.push_back({std::move(said), line});
            start_rooms_.push_back(rooms_.size() - 1);
            break;
    }
}

void WordsPlan::lay_storeys() {
    double next_m = 0.0;
    bool guessed = false;
    for (Storey& storey : storeys_) {
        if (!storey.floor_m) storey.floor_m = next_m;
        guessed |= !storey.height_m;
        next_m = *storey.floor_m + storey.height_m.value_or(kUsualStorey_m);
    }
    std::vector<std::size_t> order(storeys_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return *storeys_[a].floor_m < *storeys_[b].floor_m; });
    level_of_.resize(storeys_.size());
    int ground = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (std::abs(*storeys_[order[i]].floor_m) <
            std::abs(*storeys_[order[static_cast<std::size_t>(ground)]].floor_m))
            ground = static_cast<int>(i);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Storey& storey = storeys_[order[i]];
        level_of_[order[i]] = i;
        const double least_m = i == 0 ? -1e9 : plan_.levels.back().floor_m + kLeastStorey_m;
        if (*storey.floor_m < least_m)
            warn(storey.line, phrase("rooms_text.storeys_near", {{"name", storey.name}}),
                 phrase("rooms_text.then_floor", {{"floor", least_m}}));
        plan_.levels.push_back(
            {static_cast<double>(static_cast<int>(i) - ground), storey.name, std::max(*storey.floor_m, least_m)});
    }
    plan_.storey_m = storeys_[order.back()].height_m.value_or(kUsualStorey_m);
    if (guessed) plan_.guessed.push_back(phrase("rooms_text.guessed_height", {{"height", kUsualStorey_m}}));
}

std::string WordsPlan::room_words(const WordRoom& room) const { return one_line(room.said.words.name.substr(0, 100)); }

std::size_t WordsPlan::room_named(const std::string& name, std::size_t but) const {
    const auto found = by_name_.find(name_key(name, speaker_.language));
    if (found == by_name_.end()) return kNoRoom;
    // Prefers rooms of the same storey over other rooms with the same name.
    std::size_t best = kNoRoom;
    for (const std::size_t r : found->second) {
        if (r == but) continue;
        if (best == kNoRoom) best = r;
        if (but != kNoRoom && rooms_[r].storey == rooms_[but].storey) return r;
    }
    return best;
}

std::string WordsPlan::nearest_room(const std::string& name) const {
    std::vector<std::string> names;
    for (const WordRoom& room : rooms_)
        if (names.size() < 500) names.push_back(room.said.words.name);
    return one_line(nearest_name(name.substr(0, 60), names));
}

}  // namespace handrail::words
