#include <iostream>

#include "app/main/commands.h"

int main(int, char**) {
    std::cerr << "The command line is being written.\n";
    return 2;
}
