# Run by CPack once the packages are made. CPack gives a package with a shared library scripts that call ldconfig, where Debian wants
# the trigger that libhandrail0 has; the scripts go.
foreach(package IN LISTS CPACK_PACKAGE_FILES)
  if(package MATCHES "/libhandrail0_")
    set(unpacked ${package}.unpacked)
    execute_process(COMMAND dpkg-deb -R ${package} ${unpacked} COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE ${unpacked}/DEBIAN/postinst ${unpacked}/DEBIAN/postrm)
    execute_process(COMMAND dpkg-deb --root-owner-group -b ${unpacked} ${package} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE_RECURSE ${unpacked})
  endif()
endforeach()
