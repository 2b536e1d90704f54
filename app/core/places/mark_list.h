// The person's marks in the world one is in: setting, naming, deleting and choosing them; and what sounds when hand or
// body comes near a mark, a landmark or a clue. Metres, world, if not said otherwise. App thread only; marks.h says how
// they are kept.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/stops.h"

namespace handrail {

class MarkList : SessionPart {
public:
    // marks: of the world one is in, where everybody may look at them.
    MarkList(const SessionContext& context, std::vector<Mark>& marks) : SessionPart(context), marks_(marks) {}

    // Reads them from what the person added to the world; what is wrong with that waits for tell_faults().
    void enter_world();
    void tell_faults(double now_s);
    // They have been changed in their file.
    void take_again();
    // DropMark, DeleteMark and Marks. False: it is another's.
    bool act(Command command, double now_s);
    // The device's button sets one.
    void tick_button(double now_s);
    // A mark, landmark or clue makes its sound when hand or body comes near; marks are named.
    void tick(double now_s);

    // A line above the marks in their list.
    struct Row {
        ListItem item;
        std::function<void(double now_s)> chosen;
        std::function<std::string(int by)> adjusted{};  // of an adjustable one; its value from then on
    };
    // Set by the session: what stands there now; and that the person wants to find the chosen mark.
    std::function<std::vector<Row>()> rows_above;
    std::function<void(const Goal& mark, double now_s)> on_find;

private:
    void list_landmarks();
    void read(std::vector<Error>& faults);
    bool save(double now_s);
    void save_and_answer(const std::string& words, double now_s);
    void drop(bool by_button, double now_s);
    void rename(const std::string& name, const std::string& typed, double now_s);
    void remove(std::size_t which, double now_s);
    std::vector<ListItem> items() const;
    void open_delete(double now_s);
    void open(double now_s);

    std::vector<Mark>& marks_;
    std::vector<Error> faults_;  // not told yet
    // Where hand and body have been told to be near, so that each is told once.
    std::vector<bool> near_;                // by mark
    std::vector<FeatureId> landmarks_;      // and clues, of listed_of_
    std::weak_ptr<const Scene> listed_of_;  // whose end it does not put off
    std::vector<FeatureId> landmarks_near_;
    FeatureId touched_ = kNoFeature;
    bool first_look_ = true;     // what is near on entering is not told
    std::uint32_t buttons_ = 0;  // of the device, a tick before; worlds change, the device stays
};

}  // namespace handrail
