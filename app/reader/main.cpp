// Runs handrail-reader, a process that reads files of unknown origin. Only the main program starts handrail-reader; see
// app/import/reader_process.h.
#include "app/import/reader_process.h"

int main(int argc, char** argv) { return handrail::importing::reader_process(argc, argv); }
