// Completes an answer to an ioctl in the mocks.
#pragma once

#include <umockdev.h>

namespace handrail::test {

// Gives the client its result and, if that is negative, its errno. Returns true: this mock has handled the request.
inline gboolean complete(UMockdevIoctlClient* client, long result, int error) {
    umockdev_ioctl_client_complete(client, result, error);
    return TRUE;
}

}  // namespace handrail::test
