// Helps the mocks to complete the answer to an ioctl.
#pragma once

#include <umockdev.h>

namespace handrail::test {

// Passes `result` to the client and, if it is negative, `error` as errno. Returns true, which tells umockdev that the
// mock has processed the request.
inline gboolean complete(UMockdevIoctlClient* client, long result, int error) {
    umockdev_ioctl_client_complete(client, result, error);
    return TRUE;
}

}  // namespace handrail::test
