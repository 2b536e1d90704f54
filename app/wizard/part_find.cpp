// Implements the part `find` of the set-up: the search for a device. The program searches, and this part announces the
// news of the search.
#include "app/wizard/wizard.h"

#include "worlds/base/language.h"

namespace handrail::wizard {
namespace {

constexpr double kFirstAnswer_s = 0.2;  // after opening, a device needs this long until it reports its position

}  // namespace

void Wizard::begin_search() {
    wants_search_ = true;
    search_begun_s_ = -1.0;
}

std::string Wizard::search_question() const { return phrase("wizard.search"); }

void Wizard::watch_search() {
    for (const std::string& sentence : sense_.news)
        if (!sentence.empty()) say(sentence);
    if (sense_.search == WizardSearch::Nothing) {
        say(phrase("wizard.no_device"));
        return go_on();
    }
    if (sense_.search != WizardSearch::Ready || paused_) return;
    if (search_begun_s_ < 0.0) search_begun_s_ = now_s_;
    if (sense_.tool.ticks == 0 || now_s_ - search_begun_s_ < kFirstAnswer_s) return;
    felt_.tuning.touch.rated_stiffness_n_per_m = sense_.hand.spec.rated_stiffness_n_per_m;
    say(phrase("wizard.ready", {{"device", sense_.hand.spec.spoken_name()}}));
    go_on();
}

}  // namespace handrail::wizard
