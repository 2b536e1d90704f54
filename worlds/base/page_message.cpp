// A page fills in its texts by PlainMessage, where the program uses ICU.
#include "worlds/base/plain_message.h"

namespace handrail {

std::unique_ptr<const Message> compile_message(std::string_view pattern, const std::string& language,
                                               MessageFault* fault) {
    return compile_plain_message(pattern, language, fault);
}

std::string capitalised(std::string_view text) { return plain_capitalised(text); }

}  // namespace handrail
