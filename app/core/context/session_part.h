// What all features of a session have in common: the context that they look at. App thread only.
#pragma once

#include "app/core/context/session_context.h"

namespace handrail {

// Never copied: the session, other features, open lists and questions know a feature by its place.
class SessionPart {
public:
    SessionPart(const SessionPart&) = delete;
    SessionPart& operator=(const SessionPart&) = delete;

protected:
    explicit SessionPart(const SessionContext& context) : context_(context) {}
    ~SessionPart() = default;

    const SessionContext& context_;  // outlives the feature
};

}  // namespace handrail
