# One number for many sources: cmake -DOUTPUT=FILE.cpp -DNAME=kVersion -DHEADER=declares/it.h "-DFILES=a.cpp;b.cpp" -P version.cmake
set(all "")
foreach(file IN LISTS FILES)
  file(SHA256 ${file} hash)
  string(APPEND all "${hash}")
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING ${hash} 0 16 hash)
file(WRITE ${OUTPUT} "// Made of the sources by version.cmake.\n#include \"${HEADER}\"\n\nconst std::uint64_t handrail::${NAME} = 0x${hash}U;\n")
