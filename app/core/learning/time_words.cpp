#include "app/core/learning/time_words.h"

#include <cmath>

#include "app/core/dialogue/words.h"
#include "worlds/base/language.h"

namespace handrail::core {

std::string time_words(double seconds) {
    const long all = std::lround(seconds);
    if (all < 60) return phrase("learning.seconds", {{"seconds", all}});
    return all % 60 == 0 ? minutes_words(seconds)
                         : phrase("learning.minutes_and_seconds", {{"minutes", all / 60}, {"seconds", all % 60}});
}

}  // namespace handrail::core
