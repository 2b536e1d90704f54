// Gives the thing under the hand, or ahead, another name, kind or material. The person types a sentence, such as "call
// this piano, a landmark, of wood", or chooses from a list. labels.h defines how labels are stored. Use this class on
// the app thread only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/labels.h"

namespace handrail::core {

// What a person typed for a label. An empty part stays as it is.
struct TypedLabel {
    std::string called;
    std::optional<LabelKind> kind;
    std::string material;  // name in the material library
};
// Understands "piano, landmark, wood" and "piano as a landmark of wood", in any order of the parts after the name.
// A word for a kind or material counts only after a comma or a small word, so "glass door" is a name. Pure function of
// the language spoken.
TypedLabel typed_label(std::string_view text);

class LabelList : SessionPart {
public:
    LabelList(const SessionContext& context, WorldState& world) : SessionPart(context), world_(world) {}

    // Reads the labels from the side file and puts them on the scene.
    void enter_world();
    // Announces the stored labels that could not be read.
    void announce_unreadable(double now_s) const;
    // Reads the labels again. Call it when another session has changed them in the side file.
    void take_again();
    // Carries out the command Label: opens the list for the thing here. Returns false for other commands.
    bool act(Command command, double now_s);
    // Labels the thing here as the typed text says.
    void take_text(std::string_view text, double now_s);
    // Stores the label and puts it on the scene.
    void put(const Label& label, double now_s);
    // Marks this thing as a landmark.
    void make_landmark(FeatureId feature, double now_s);

    // The session sets this function. It is called when something in the scene has another material, so that the hand
    // must feel it.
    std::function<void(double now_s)> on_material;

private:
    const Feature* thing_or_refusal(double now_s) const;
    void open(const Feature& feature, double now_s);
    void request_name(Label label, double now_s);
    void open_kinds(Label label, double now_s);
    void open_materials(Label label, double now_s);
    void remove(const Label& label, double now_s);

    WorldState& world_;
    std::vector<Error> unreadable_;
};

}  // namespace handrail::core
