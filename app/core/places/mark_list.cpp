#include "app/core/places/mark_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/context/soundscape.h"
#include "app/core/context/spotlight.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/contract.h"
#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kMarkNear_hand_m = 0.008, kMarkNear_walker_m = 1.0;
// A landmark or clue within this distance of the walker is announced by a sound.
constexpr double kLandmarkNear_m = 1.5;
// A landmark is announced again if the walker has been farther away than the near distance times this factor.
constexpr double kFarther = 1.5;

}  // namespace

void MarkList::enter_world() {
    faults_.clear();
    read(faults_);
    near_.clear();
    landmarks_near_.clear();
    touched_ = kNoFeature;
    first_look_ = true;
}

void MarkList::take_again() {
    std::vector<Error> faults;  // errors to announce when the world has been entered
    read(faults);
    near_.assign(marks_.size(), true);
}

void MarkList::read(std::vector<Error>& faults) {
    marks_ = read_marks(context_.additions, faults);
    check_marks(*context_.world.scene, context_.additions, marks_);
}

void MarkList::announce_faults(double now_s) {
    if (!faults_.empty())
        context_.say(unreadable_words("marks.unreadable", std::exchange(faults_, {})), cues::SpeechClass::Answer,
                     now_s);
    if (std::string unfit = unfit_sentence(marks_); !unfit.empty())
        context_.say(std::move(unfit), cues::SpeechClass::Answer, now_s);
}

bool MarkList::save(double now_s) {
    write_marks(context_.additions, marks_);
    return context_.session_requests.save_additions(now_s);
}

void MarkList::save_and_answer(const std::string& words, double now_s) {
    write_marks(context_.additions, marks_);
    context_.keep_and_answer(words, now_s);
}

bool MarkList::act(Command command, double now_s) {
    if (command == Command::DropMark) drop(false, now_s);
    else if (command == Command::DeleteMark) open_delete(now_s);
    else if (command == Command::Marks) open(now_s);
    else return false;
    return true;
}

void MarkList::tick_button(double now_s) {
    const std::uint32_t pressed = context_.hands.tool.buttons & ~std::exchange(buttons_, context_.hands.tool.buttons);
    const int button = context_.settings.marks.button;
    if (button > 0 && (pressed & (1U << (button - 1))) != 0 &&
        (context_.hands.tuning.workspace.grab_buttons & (1U << (button - 1))) == 0 &&
        !(button == 1 && context_.settings.haptic.button_to_feel))
        drop(true, now_s);
}

void MarkList::drop(bool by_button, double now_s) {
    Vec3 place = context_.avatar.feet_m();
    if (context_.hands.answers()) {
        // While a simulated hand is still moving to the walker, the mark is set at the walker.
        if (!servo::is_lost(context_.hands.tool.fault) &&
            context_.hands.tool.workspace_jump == context_.hands.pose.jump)
            place = context_.hands.tool.proxy_m;
        else if (!context_.hands.keys_alone) return context_.answer(phrase("guide.hand_unknown"), now_s);
    }
    Mark mark = new_mark(*context_.world.scene, context_.additions, marks_, place);
    const std::string name = mark.name;
    marks_.push_back(std::move(mark));
    near_.resize(marks_.size() - 1, false);
    near_.push_back(true);
    context_.play_at(cues::SoundKind::Mark, place, now_s);
    if (by_button || !context_.settings.marks.ask_name)
        return save_and_answer(phrase("marks.set", {{"name", name}}), now_s);
    save(now_s);
    TextSpec question;
    question.question = phrase("marks.set_and_ask", {{"name", name}});
    question.text = name;
    question.done = [this, name](const std::string& typed) { rename(name, typed, context_.tick_s); };
    context_.request_text(std::move(question), now_s);
}

void MarkList::rename(const std::string& name, const std::string& typed, double now_s) {
    const auto mark = std::find_if(marks_.begin(), marks_.end(), [&](const Mark& m) { return m.name == name; });
    const auto good = good_name(typed);
    if (!good) return context_.answer(good.error().message, now_s);
    if (mark == marks_.end()) return;
    mark->name = *good;
    save_and_answer(*good, now_s);
}

void MarkList::remove(std::size_t which, double now_s) {
    if (which >= marks_.size()) return;
    const std::string name = marks_[which].name;
    marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(which));
    near_.assign(marks_.size(), true);
    save_and_answer(phrase("marks.deleted", {{"name", name}}), now_s);
}

std::vector<ListItem> MarkList::items() const {
    std::vector<ListItem> items;
    for (const Mark& mark : marks_) {
        const std::string where = where_words(context_, point_box(mark.place_m));
        items.push_back({mark.name, mark.fits ? where : phrase("marks.may_not_fit", {{"where", where}})});
    }
    return items;
}

void MarkList::open_delete(double now_s) {
    if (marks_.empty())
        return context_.answer(phrase("desk.no_marks", {{"key", context_.keys.keys_of(Command::DropMark)}}), now_s);
    ListSpec list;
    list.title = phrase("marks.delete_which");
    list.items = items();
    list.chosen = [this](std::size_t i) { remove(i, context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

// Opens the list of marks, with the rows of `rows_above` first.
void MarkList::open(double now_s) {
    const std::vector<Row> above = rows_above ? rows_above() : std::vector<Row>();
    ListSpec list;
    list.title = phrase("marks.title");
    for (const Row& row : above) list.items.push_back(row.item);
    for (ListItem& item : items()) list.items.push_back(std::move(item));
    list.adjusted = [above](std::size_t i, int by) { return above[i].adjusted(by); };
    list.chosen = [this, above](std::size_t i) {
        if (i < above.size()) return above[i].chosen(context_.tick_s);
        i -= above.size();
        if (i < marks_.size()) on_find({marks_[i].name, point_box(marks_[i].place_m), kNoFeature}, context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

// Lists landmarks and clues once for each scene, because a building has tens of thousands of features, too many to
// examine in each tick.
void MarkList::list_landmarks() {
    const std::shared_ptr<const Scene>& scene = context_.world.scene;
    if (!listed_of_.owner_before(scene) && !scene.owner_before(listed_of_)) return;
    listed_of_ = scene;
    landmarks_.clear();
    for (std::uint32_t i = 0; i < scene->features.size(); ++i) {
        const Feature& feature = scene->features[i];
        if ((feature.landmark || feature.clue) && !feature.bounds_m.empty()) landmarks_.push_back(FeatureId{i});
    }
}

void MarkList::tick(double now_s) {
    contract_pre(context_.world.scene != nullptr && context_.world.solids != nullptr);
    const bool announces = !std::exchange(first_look_, false);
    const Vec3 waist = context_.avatar.feet_m() + Vec3(0.0, 0.0, kWaist_m);
    const std::optional<Spotlight> beam = spotlight(context_);
    // Returns the horizontal distance to the box if the box is on this storey, in the spotlight and not behind a wall
    // or door. Otherwise returns 1e9.
    const auto walker_to_m = [&](const Aabb& box, double range_m) {
        const Vec3 place = nearest_place(box, waist);
        const Vec3 way = place - waist;
        const double level_m = std::hypot(way.x, way.y);
        if (beam && !beam->shows(place)) return 1e9;
        if (level_m > range_m || std::abs(way.z) > kAboveOrBelow_m) return 1e9;
        return muffling_db(*context_.world.solids, waist, place) >= kDoorMuffles_db ? 1e9 : level_m;
    };
    const bool hand = context_.hands.answers() && context_.hands.tool.workspace_jump == context_.hands.pose.jump;
    near_.resize(marks_.size(), false);
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        const Vec3& place = marks_[i].place_m;
        const double more = near_[i] ? kFarther : 1.0;
        const double hand_m = hand ? glm::length(context_.hands.tool.proxy_m - place) / scale(context_) : 1e9;
        const bool near = hand_m <= more * kMarkNear_hand_m ||
                          walker_to_m(point_box(place), more * kMarkNear_walker_m) <= more * kMarkNear_walker_m;
        if (near && !near_[i] && announces && !context_.hands.tuning.panic) {
            context_.play_at(cues::SoundKind::Mark, place, now_s);
            context_.say(marks_[i].name, cues::SpeechClass::Contact, now_s);
        }
        near_[i] = near;
    }
    const auto sound_of = [](const Feature& feature) {
        return feature.landmark ? cues::SoundKind::Landmark : cues::SoundKind::Clue;
    };
    list_landmarks();
    std::vector<std::pair<double, FeatureId>> near;
    for (const FeatureId id : landmarks_) {
        const Feature& feature = context_.world.scene->features[id.value];
        const bool was = std::find(landmarks_near_.begin(), landmarks_near_.end(), id) != landmarks_near_.end();
        const double range_m = (was ? kFarther : 1.0) * kLandmarkNear_m;
        if (const double to_m = walker_to_m(feature.bounds_m, range_m); to_m <= range_m) near.emplace_back(to_m, id);
    }
    // In a crowded place, only the nearest ones sound.
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    near.resize(std::min(near.size(), static_cast<std::size_t>(context_.settings.sound.most_at_once)));
    std::vector<FeatureId> near_now;
    for (const auto& [to_m, id] : near) {
        const bool was = std::find(landmarks_near_.begin(), landmarks_near_.end(), id) != landmarks_near_.end();
        const Feature& feature = context_.world.scene->features[id.value];
        near_now.push_back(id);
        if (!was && announces && !context_.hands.tuning.panic)
            context_.play_at(sound_of(feature), nearest_place(feature.bounds_m, waist), now_s);
    }
    landmarks_near_ = std::move(near_now);
    const FeatureId touched = hand && context_.hands.tool.touches() ? context_.hands.tool.touched() : kNoFeature;
    if (touched != touched_ && touched) {
        const Feature* feature = context_.world.scene->find(touched);
        if (feature && (feature->landmark || feature->clue) && !context_.hands.tuning.panic)
            context_.play_at(sound_of(*feature), context_.hands.tool.proxy_m, now_s);
    }
    if (touched || !context_.hands.tool.touches()) touched_ = touched;
}

}  // namespace handrail::core
