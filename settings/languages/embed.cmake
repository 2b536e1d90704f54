# Writes the language files into a C++ source: cmake -DOUTPUT=FILE.cpp -DFILES="en.toml;de.toml" -P embed.cmake
# Compilers need take no string literal above 65,536 bytes, so a file stands in pieces of whole lines, each a string of its own whose length is written by the
# compiler and never counted while compiling (clang gives up counting 190,000 characters).
set(source "// Made of settings/languages by embed.cmake.\n#include \"worlds/base/bundled_languages.h\"\n\nnamespace handrail {\nnamespace {\n\nusing namespace std::string_view_literals;\n\n")
set(table "constexpr BundledLanguage kLanguages[] = {\n")
foreach(file IN LISTS FILES)
  get_filename_component(code ${file} NAME_WE)
  file(READ ${file} content)
  string(APPEND source "constexpr std::string_view k_${code}[] = {\n")
  string(LENGTH "${content}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${content}" ${at} 4000 piece)
    string(FIND "${piece}" "\n" end REVERSE)  # no character in two pieces, whose bytes would be none
    math(EXPR end "${end} + 1")
    string(SUBSTRING "${piece}" 0 ${end} piece)
    string(APPEND source "R\"toml(${piece})toml\"sv,\n")
    math(EXPR at "${at} + ${end}")
  endwhile()
  string(APPEND source "};\n\n")
  string(APPEND table "    {\"${code}\"sv, k_${code}},\n")
endforeach()
string(APPEND source "${table}};\n\n}  // namespace\n\nconst std::span<const BundledLanguage> kBundledLanguages(kLanguages);\n\n}  // namespace handrail\n")
file(WRITE ${OUTPUT} "${source}")
