# cmake --install: library, headers, command, scheme files, and find_package(limn).
include(CMakePackageConfigHelpers)

set(limn_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/limn)
install(TARGETS limn EXPORT limnTargets FILE_SET HEADERS)
install(EXPORT limnTargets NAMESPACE limn:: DESTINATION ${limn_package_dir})
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/limnConfig.cmake.in ${PROJECT_BINARY_DIR}/limnConfig.cmake
  INSTALL_DESTINATION ${limn_package_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/limnConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/limnConfig.cmake ${PROJECT_BINARY_DIR}/limnConfigVersion.cmake
  DESTINATION ${limn_package_dir})
if(TARGET limn_command)
  install(TARGETS limn_command)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/schemes DESTINATION ${CMAKE_INSTALL_DATADIR}/limn
  FILES_MATCHING PATTERN *.toml)
