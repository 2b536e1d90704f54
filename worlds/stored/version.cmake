# One number for many sources: cmake -DOUTPUT=FILE.cpp "-DFILES=a.cpp;b.cpp" -P version.cmake
foreach(file IN LISTS FILES)
  file(SHA256 ${file} hash)
  string(SHA256 all "${all}${hash}")
endforeach()
string(SUBSTRING ${all} 0 16 hash)
file(WRITE ${OUTPUT} "// Made of the sources by version.cmake.\n#include \"worlds/stored/stored_scene.h\"\n\nconst std::uint64_t handrail::stored::kWorldsVersion = 0x${hash}U;\n")
