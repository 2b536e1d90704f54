#include "app/core/places/label_list.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/core/context/thing_here.h"
#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/typed_sentences.h"
#include "app/core/dialogue/typed_words.h"
#include "app/core/dialogue/words.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

constexpr std::array kKinds{LabelKind::Thing, LabelKind::Landmark, LabelKind::Clue};
constexpr std::size_t kMostWords = 2;  // a material has at most this many words: "steel grille"

std::string kind_words(LabelKind kind) {
    return phrase(kind == LabelKind::Landmark ? "places.landmark"
                  : kind == LabelKind::Clue   ? "places.clue"
                                              : "places.thing");
}

// Returns the words in the form in which they are compared.
std::string plain_of(const std::vector<TypedWord>& words, std::size_t first, std::size_t end) {
    std::string all;
    for (std::size_t i = first; i < end; ++i) all += (all.empty() ? "" : " ") + words[i].plain;
    return all;
}

std::string plain_text(const std::string& text) {
    const std::vector<TypedWord> words = typed_words(text);
    return plain_of(words, 0, words.size());
}

// Takes a kind or a material from its words. Returns false if they mean neither.
bool take_part(const std::string& plain, TypedLabel& label) {
    for (const LabelKind kind : kKinds)
        if (plain == plain_text(kind_words(kind))) return label.kind = kind, true;
    for (const MaterialSpec& spec : material_library())
        if (plain == plain_text(std::string(spec.name)) || plain == plain_text(spoken_material(spec.name)))
            return label.material = spec.name, true;
    return false;
}

// Takes kinds and materials from the end of `words`, each with the small words before it. If nothing is before a kind
// or material, it needs no small word. Returns the number of words that are left.
std::size_t take_parts(const std::vector<TypedWord>& words, TypedLabel& label) {
    static_assert(kMostWords == 2);
    const std::vector<TypedWord> small = typed_words(phrase("labels.small"));
    const auto is_small = [&](std::size_t i) {
        return std::any_of(small.begin(), small.end(),
                           [&](const TypedWord& word) { return word.plain == words[i].plain; });
    };
    for (std::size_t end = words.size();;) {
        std::size_t left = end;
        for (std::size_t count = 1; left == end && count <= std::min(kMostWords, end); ++count) {
            const std::size_t first = end - count;
            if (first > 0 && !is_small(first - 1)) continue;
            if (take_part(plain_of(words, first, end), label)) left = first;
        }
        if (left == end) return end;
        while (left > 0 && is_small(left - 1)) --left;
        end = left;
        if (end == 0) return 0;
    }
}

}  // namespace

TypedLabel typed_label(std::string_view text) {
    TypedLabel label;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        std::vector<TypedWord> words = typed_words(text.substr(begin, end - begin));
        words.resize(take_parts(words, label));
        if (const std::string part = written_from(words, 0); !part.empty())
            label.called += label.called.empty() ? without_fillers(part) : ", " + part;
        begin = end + 1;
    }
    return label;
}

void LabelList::enter_world() {
    const std::vector<Label> labels = read_labels(context_.additions, unreadable_);
    if (changes(*world_.scene, labels))
        world_.scene = std::make_shared<const Scene>(with_labels(*world_.scene, labels));
}

void LabelList::take_again() {
    const std::shared_ptr<const Scene> before = world_.scene;
    enter_world();
    if (before == world_.scene) return;
    world_.movers.follow(world_.scene->movers);
    on_material(context_.tick_s);
}

void LabelList::announce_unreadable(double now_s) const {
    if (!unreadable_.empty())
        context_.say(unreadable_words("landmarks.unreadable", unreadable_), cues::SpeechClass::Answer, now_s);
}

const Feature* LabelList::thing_or_refusal(double now_s) const {
    const auto here = thing_here(context_);
    if (!here) context_.answer(phrase("labels.nothing"), now_s);
    return here ? context_.world.scene->find(here->id) : nullptr;
}

bool LabelList::act(Command command, double now_s) {
    if (command != Command::Label) return false;
    if (const Feature* feature = thing_or_refusal(now_s)) open(*feature, now_s);
    return true;
}

void LabelList::take_text(std::string_view text, double now_s) {
    const Feature* feature = thing_or_refusal(now_s);
    if (!feature) return;
    const TypedLabel typed = typed_label(text);
    Label label = label_of(context_.additions, *feature);
    if (!typed.called.empty()) {
        const auto good = good_name(typed.called);
        if (!good) return context_.answer(good.error().message, now_s);
        label.called = *good;
    }
    if (typed.kind) label.kind = *typed.kind;
    if (!typed.material.empty()) label.material = typed.material;
    put(label, now_s);
}

void LabelList::open(const Feature& feature, double now_s) {
    const Label label = label_of(context_.additions, feature);
    const std::string name = one_line(spoken_name(feature)),
                      material = spoken_material(context_.world.scene->material(feature.material).name);
    ListSpec list;
    list.title = phrase("labels.title", {{"name", name}});
    list.items = {{phrase("labels.name"), name},
                  {phrase("labels.kind"), kind_words(kind_of(feature))},
                  {phrase("labels.material"), material.empty() ? phrase("labels.no_material") : material}};
    std::vector<Error> faults;
    const std::vector<Label> all = read_labels(context_.additions, faults);
    if (std::any_of(all.begin(), all.end(),
                    [&](const Label& one) { return one.thing == label.thing && one.at_m == label.at_m; }))
        list.items.push_back({phrase("labels.remove"), {}});
    list.chosen = [this, label](std::size_t i) {
        if (i == 0) request_name(label, context_.tick_s);
        else if (i == 1) open_kinds(label, context_.tick_s);
        else if (i == 2) open_materials(label, context_.tick_s);
        else remove(label, context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void LabelList::request_name(Label label, double now_s) {
    TextSpec question;
    question.question = phrase("labels.which_name");
    question.text = label.called.empty() ? label.thing : label.called;
    question.done = [this, label](const std::string& typed) mutable {
        const auto good = good_name(typed);
        if (!good) return context_.answer(good.error().message, context_.tick_s);
        label.called = *good;
        put(label, context_.tick_s);
    };
    context_.request_text(std::move(question), now_s);
}

void LabelList::open_kinds(Label label, double now_s) {
    ListSpec list;
    list.title = phrase("labels.which_kind");
    for (const LabelKind kind : kKinds) {
        if (kind == label.kind) list.at = list.items.size();
        list.items.push_back({kind_words(kind), phrase("labels.kind_means", {{"kind", kind_word(kind)}})});
    }
    list.chosen = [this, label](std::size_t i) mutable {
        label.kind = kKinds.at(i);
        put(label, context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void LabelList::open_materials(Label label, double now_s) {
    ListSpec list;
    list.title = phrase("labels.which_material");
    for (const MaterialSpec& spec : material_library()) {
        if (spec.name == label.material) list.at = list.items.size();
        list.items.push_back({spoken_material(spec.name), {}});
    }
    list.chosen = [this, label](std::size_t i) mutable {
        label.material = material_library()[i].name;
        put(label, context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void LabelList::put(const Label& label, double now_s) {
    const std::vector<Feature>& features = world_.scene->features;
    const bool renamed =
        !label.called.empty() && std::none_of(features.begin(), features.end(),
                                              [&](const Feature& feature) { return feature.name == label.called; });
    keep_label(context_.additions, label);
    const std::vector<Label> labels{label};
    if (changes(*world_.scene, labels)) {
        world_.scene = std::make_shared<const Scene>(with_labels(*world_.scene, labels));
        world_.movers.follow(world_.scene->movers);
        if (!label.material.empty()) on_material(now_s);
    }
    const std::string was = sentence_case(one_line(spoken_kind(label.thing)));
    context_.keep_and_answer(
        phrase("labels.done", {{"named", renamed ? "yes" : "no"},
                               {"was", was},
                               {"name", renamed ? one_line(label.called)
                                                : sentence_case(one_line(label.called.empty() ? spoken_kind(label.thing)
                                                                                              : label.called))},
                               {"kind", kind_word(label.kind)},
                               {"known", label.material.empty() ? "no" : "yes"},
                               {"material", spoken_material(label.material)}}),
        now_s);
}

void LabelList::make_landmark(FeatureId id, double now_s) {
    const Feature* feature = world_.scene->find(id);
    contract_pre(feature != nullptr);
    if (!feature) return;
    Label label = label_of(context_.additions, *feature);
    label.kind = LabelKind::Landmark;
    put(label, now_s);
}

// The file has the name, kind and material that the thing had before. So the owner of the session reads the world
// again, and the person continues at the same place.
void LabelList::remove(const Label& label, double now_s) {
    drop_label(context_.additions, label);
    if (!context_.session_requests.save_additions(now_s)) return;
    context_.requests.read_again = true;
    context_.answer(phrase("labels.removed", {{"name", one_line(spoken_kind(label.thing))}}), now_s);
}

}  // namespace handrail::core
