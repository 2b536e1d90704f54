// How the mocks complete the answer to an ioctl.
#pragma once

#include <umockdev.h>

namespace handrail::test {

// Gives the client its result and, if the result is negative, its errno. Returns true, because the mock has handled the
// request.
inline gboolean complete(UMockdevIoctlClient* client, long result, int error) {
    umockdev_ioctl_client_complete(client, result, error);
    return TRUE;
}

}  // namespace handrail::test
