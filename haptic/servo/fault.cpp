#include "haptic/servo/fault.h"

namespace handrail {

const char* fault_sentence(Fault fault) {
    switch (fault) {
        case Fault::None:
            return "";
        case Fault::BadSample:
            return "The touch device sent positions that cannot be. Its force is off; press the force key to try again.";
        case Fault::Jump:
            return "The touch device's position jumped. Its force is off; press the force key to try again.";
        case Fault::Unplugged:
            return "Device unplugged. Everything else goes on.";
        case Fault::DeviceSilent:
            return "The touch device stopped answering. Its force comes back slowly when it does.";
        case Fault::LateLoop:
            return "The computer is too busy for steady touch. The force is off; press the force key to try again.";
        case Fault::Stalled:
            return "The computer stopped for a moment. The force comes back slowly.";
        case Fault::Unhomed:
            return "The touch device does not know its position yet. Move the grip through its whole reach.";
        case Fault::BadForce:
            return "Handrail computed a force that cannot be. The force is off; press the force key to try again.";
        case Fault::TooHot:
            return "The motors of the touch device are too warm. Its force is off until they have cooled.";
        case Fault::DriverError:
            return "The touch device reports an error. Its force is off; press the force key to try again.";
        case Fault::FocusLost:
            return "The window lost the keyboard. The force is off until it is back.";
        case Fault::ButtonReleased:
            return "Button released. The force is off until you hold it.";
    }
    return "";
}

}  // namespace handrail
