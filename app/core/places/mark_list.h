// The person's marks in the present world: setting, naming, deleting and choosing them. Also plays a sound if the hand
// or the walker comes near a mark, a landmark or a clue. World metres, unless a name says otherwise. App thread only;
// marks.h says how marks are stored.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/stops.h"

namespace handrail::core {

class MarkList : SessionPart {
public:
    // marks: of the present world, stored where every feature can read them.
    MarkList(const SessionContext& context, std::vector<Mark>& marks) : SessionPart(context), marks_(marks) {}

    // Reads the marks from what the person added to the world; errors wait for tell_faults().
    void enter_world();
    void tell_faults(double now_s);
    // The marks have changed in their file.
    void take_again();
    // Handles DropMark, DeleteMark and Marks. Returns false for other commands.
    bool act(Command command, double now_s);
    // Sets a mark if the device's button was pressed.
    void tick_button(double now_s);
    // Plays the sound of a mark, landmark or clue if the hand or the walker comes near; marks are also announced.
    void tick(double now_s);

    // A row above the marks in their list.
    struct Row {
        ListItem item;
        std::function<void(double now_s)> chosen;
        std::function<std::string(int by)> adjusted{};  // of an adjustable row; returns its new value in words
    };
    // Set by the session: the present rows above the marks; and the action if the person wants to find the chosen mark.
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
    std::vector<Error> faults_;  // not announced yet
    // What the hand and the walker are near to, so that each is announced once.
    std::vector<bool> near_;                // by mark
    std::vector<FeatureId> landmarks_;      // landmarks and clues of listed_of_
    std::weak_ptr<const Scene> listed_of_;  // weak, so that the scene can be destroyed
    std::vector<FeatureId> landmarks_near_;
    FeatureId touched_ = kNoFeature;
    bool first_look_ = true;     // what is near on entering is not announced
    std::uint32_t buttons_ = 0;  // the device's buttons one tick earlier; kept across worlds, because the device stays
};

}  // namespace handrail::core
