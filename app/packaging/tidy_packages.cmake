# Run by CPack once the packages are made. CPack gives a package with a shared library scripts that call ldconfig. Debian
# wants the trigger instead, which libhandrail0 has.
list(FILTER CPACK_PACKAGE_FILES INCLUDE REGEX "/libhandrail0_")
set(unpacked ${CPACK_PACKAGE_FILES}.unpacked)
execute_process(COMMAND dpkg-deb -R ${CPACK_PACKAGE_FILES} ${unpacked} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE ${unpacked}/DEBIAN/postinst ${unpacked}/DEBIAN/postrm)
execute_process(COMMAND dpkg-deb --root-owner-group -b ${unpacked} ${CPACK_PACKAGE_FILES} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${unpacked})
