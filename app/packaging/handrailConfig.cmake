# find_package(handrail): handrail::render, handrail::compile, handrail::device, handrail::dynamics, handrail::readers, what these
# need, handrail::servo, and handrail::c, the library of the C header, where it is installed.
include(CMakeFindDependencyMacro)
foreach(package BZip2 EXPAT PNG Threads ZLIB fmt glm nlohmann_json tomlplusplus)
  find_dependency(${package})
endforeach()
find_dependency(ICU COMPONENTS i18n uc)
include(${CMAKE_CURRENT_LIST_DIR}/handrailTargets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/handrailCTargets.cmake OPTIONAL)
