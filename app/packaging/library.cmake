# The core as a library: for C++ static libraries and headers, found by find_package(handrail); for C libhandrail.so with
# one header. docs/library.md describes both.
foreach(name base geometry scene settings ifc floorplan osm imdf words readers render compile dynamics device servo)
  list(APPEND core handrail_${name})
  get_target_property(folder handrail_${name} HANDRAIL_FOLDER)
  list(APPEND core_folders ${folder})
  target_include_directories(handrail_${name} INTERFACE $<INSTALL_INTERFACE:include/handrail>)
  target_compile_features(handrail_${name} INTERFACE $<INSTALL_INTERFACE:cxx_std_20>)
  set_target_properties(handrail_${name} PROPERTIES EXPORT_NAME ${name})
endforeach()

include(CMakePackageConfigHelpers)
set(config_folder lib/cmake/handrail)
install(TARGETS ${core} EXPORT handrail ARCHIVE DESTINATION lib COMPONENT development OPTIONAL)
install(EXPORT handrail NAMESPACE handrail:: DESTINATION ${config_folder} FILE handrailTargets.cmake COMPONENT development)
write_basic_package_version_file(${made}/handrailConfigVersion.cmake VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_SOURCE_DIR}/handrailConfig.cmake ${made}/handrailConfigVersion.cmake
        DESTINATION ${config_folder} COMPONENT development)
# Each header says in its first line whether it stays as it is.
install(CODE "
  set(source \"${CMAKE_SOURCE_DIR}\")
  set(folders \"${core_folders}\")
  set(version \"${PROJECT_VERSION}\")
  set(to \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/include/handrail\")
  include(\"${CMAKE_CURRENT_SOURCE_DIR}/install_headers.cmake\")" COMPONENT development)

# The library that other programs load: the same objects, of which only the functions of the header are visible.
add_library(handrail_shared SHARED EXCLUDE_FROM_ALL $<TARGET_OBJECTS:handrail_c>)
set_target_properties(handrail_shared PROPERTIES OUTPUT_NAME handrail VERSION ${PROJECT_VERSION} SOVERSION 0 LINKER_LANGUAGE CXX
  LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib EXPORT_NAME c)
target_include_directories(handrail_shared INTERFACE $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/haptic/c> $<INSTALL_INTERFACE:include>)
target_link_libraries(handrail_shared PRIVATE $<TARGET_PROPERTY:handrail_c,LINK_LIBRARIES>)
target_link_options(handrail_shared PRIVATE LINKER:--version-script=${CMAKE_CURRENT_SOURCE_DIR}/libhandrail.map LINKER:--no-undefined)
set_target_properties(handrail_shared PROPERTIES LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/libhandrail.map)
install(TARGETS handrail_shared EXPORT handrail_c
  LIBRARY DESTINATION lib COMPONENT library OPTIONAL NAMELINK_COMPONENT development)
install(EXPORT handrail_c NAMESPACE handrail:: DESTINATION ${config_folder} FILE handrailCTargets.cmake COMPONENT development)
install(FILES ${CMAKE_SOURCE_DIR}/haptic/c/handrail.h DESTINATION include COMPONENT development)
