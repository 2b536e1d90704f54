// Defines the base class of all features of a session. The base class keeps the reference to the context. Use it on the
// app thread only.
#pragma once

#include "app/core/context/session_context.h"

namespace handrail::core {

// Not copyable, because the session, other features, open lists and questions keep the address of a feature.
class SessionPart {
public:
    SessionPart(const SessionPart&) = delete;
    SessionPart& operator=(const SessionPart&) = delete;

protected:
    explicit SessionPart(const SessionContext& context) : context_(context) {}
    ~SessionPart() = default;

    const SessionContext& context_;  // must outlive the feature
};

}  // namespace handrail::core
