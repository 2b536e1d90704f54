// The end of an answer to an ioctl, as the mocks give it.
#pragma once

#include <umockdev.h>

namespace handrail::test {

// Gives the client its result and, below zero, its errno; true: the request was this mock's.
inline gboolean complete(UMockdevIoctlClient* client, long result, int error) {
    umockdev_ioctl_client_complete(client, result, error);
    return TRUE;
}

}  // namespace handrail::test
