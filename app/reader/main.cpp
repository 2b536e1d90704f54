// handrail-reader: the process in which files are read that others made. Started by the program alone; see
// app/import/reader_process.h.
#include "app/import/reader_process.h"

int main(int argc, char** argv) { return handrail::reader_process(argc, argv); }
