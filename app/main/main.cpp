#include <iostream>

#include "app/main/command_line.h"

int main(int argc, char** argv) { return handrail::run_command_line({argv + 1, argv + argc}, std::cout, std::cerr); }
