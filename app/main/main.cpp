#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>

#include "app/main/command_line.h"
#include "app/main/long_work.h"
#include "app/main/plain_output.h"

namespace {

// Opens those of the descriptors 0, 1 and 2 that our parent process has closed. Otherwise the next file that we open
// would get one of these numbers, and our printed output would overwrite that file.
void open_standard_descriptors() {
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(number, F_GETFD) < 0 && errno == EBADF && ::open("/dev/null", O_RDWR) != number)
            ::_exit(1);  // open() returns the lowest free number, which must be this one
}

}  // namespace

int main(int argc, char** argv) {
    open_standard_descriptors();
    const handrail::program::LongWork progress = handrail::program::LongWork::begun();
    handrail::program::PlainOutput plain(std::cerr);
    const handrail::program::LongWorkLines lines(progress, plain);
    return handrail::program::run_command_line({argv + 1, argv + argc}, std::cout, std::cerr, progress);
}
