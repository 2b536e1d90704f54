# The core as a library. For C++ static libraries and headers, found by find_package(handrail); for C, and for all that calls
# C, libhandrail.so with one header. docs/library.md tells about both, and what of them stays as it is.

# handrail_needed(OUT OTHERS LIBRARY...): these libraries and all of ours that they link, and what else those link.
function(handrail_needed out others)
  set(todo ${ARGN})
  while(todo)
    list(POP_FRONT todo library)
    if(library IN_LIST found)
      continue()
    endif()
    list(APPEND found ${library})
    get_target_property(links ${library} LINK_LIBRARIES)
    foreach(link IN LISTS links)
      if(link MATCHES "^(handrail_[a-z_]+)$")
        list(APPEND todo ${link})
      elseif(link)
        list(APPEND rest ${link})
      endif()
    endforeach()
  endwhile()
  list(REMOVE_DUPLICATES rest)
  set(${out} ${found} PARENT_SCOPE)
  set(${others} ${rest} PARENT_SCOPE)
endfunction()

handrail_needed(core core_links handrail_render handrail_compile handrail_dynamics handrail_device handrail_readers handrail_servo)
set(core_folders "")
foreach(library IN LISTS core)
  get_target_property(folder ${library} HANDRAIL_FOLDER)
  list(APPEND core_folders ${folder})
endforeach()

include(CMakePackageConfigHelpers)
set(config_folder lib/cmake/handrail)
foreach(library IN LISTS core)
  string(REGEX REPLACE "^handrail_" "" name ${library})
  target_include_directories(${library} INTERFACE $<INSTALL_INTERFACE:include/handrail>)
  target_compile_features(${library} INTERFACE $<INSTALL_INTERFACE:cxx_std_20>)
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${library} EXPORT handrail ARCHIVE DESTINATION lib COMPONENT development OPTIONAL)
endforeach()
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

# What is loaded at run time: the same objects, of which only what the header names is seen from outside.
if(NOT HANDRAIL_SANITIZE AND NOT HANDRAIL_FUZZER)
  add_library(handrail_shared SHARED EXCLUDE_FROM_ALL $<TARGET_OBJECTS:handrail_c>)
  set_target_properties(handrail_shared PROPERTIES OUTPUT_NAME handrail VERSION ${PROJECT_VERSION} SOVERSION 0 LINKER_LANGUAGE CXX
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib EXPORT_NAME c)
  target_include_directories(handrail_shared INTERFACE $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/haptic/c> $<INSTALL_INTERFACE:include>)
  get_target_property(loaded_links handrail_c LINK_LIBRARIES)
  target_link_libraries(handrail_shared PRIVATE ${loaded_links})
  target_link_options(handrail_shared PRIVATE LINKER:--version-script=${CMAKE_CURRENT_SOURCE_DIR}/libhandrail.map LINKER:--no-undefined)
  set_target_properties(handrail_shared PROPERTIES LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/libhandrail.map)
  install(TARGETS handrail_shared EXPORT handrail_c
    LIBRARY DESTINATION lib COMPONENT library OPTIONAL NAMELINK_COMPONENT development)
  install(EXPORT handrail_c NAMESPACE handrail:: DESTINATION ${config_folder} FILE handrailCTargets.cmake COMPONENT development)
  install(FILES ${CMAKE_SOURCE_DIR}/haptic/c/handrail.h DESTINATION include COMPONENT development)
endif()
