// handrail-reader: the process that reads files which others made. Started only by the program; see
// app/import/reader_process.h.
#include "app/import/reader_process.h"

int main(int argc, char** argv) { return handrail::importing::reader_process(argc, argv); }
