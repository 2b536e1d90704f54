#include "haptic/servo/fault.h"

#include "worlds/base/language.h"

namespace handrail::servo {

std::string fault_sentence(Fault fault) {
    switch (fault) {
        case Fault::None:
            return "";
        case Fault::BadSample:
            return phrase("fault.bad_sample");
        case Fault::Jump:
            return phrase("fault.jump");
        case Fault::Unplugged:
            return phrase("fault.unplugged");
        case Fault::DeviceSilent:
            return phrase("fault.device_silent");
        case Fault::LateLoop:
            return phrase("fault.late_loop");
        case Fault::Stalled:
            return phrase("fault.stalled");
        case Fault::Unhomed:
            return phrase("fault.unhomed");
        case Fault::BadForce:
            return phrase("fault.bad_force");
        case Fault::TooHot:
            return phrase("fault.too_hot");
        case Fault::DriverError:
            return phrase("fault.driver_error");
        case Fault::MayPush:
            return phrase("fault.may_push");
        case Fault::ForceOff:
            return phrase("fault.force_off");
        case Fault::FocusLost:
            return phrase("fault.focus_lost");
        case Fault::ButtonReleased:
            return phrase("fault.button_released");
    }
    return "";
}

}  // namespace handrail::servo
