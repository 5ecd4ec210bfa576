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
  # The manual page and the completions are printed by the command itself: its declarations are
  # their one source. Where it cannot run here (another processor's), they are left out.
  if(NOT CMAKE_CROSSCOMPILING)
    set(printed ${PROJECT_BINARY_DIR}/generated/command)
    file(MAKE_DIRECTORY ${printed})
    add_custom_command(TARGET limn_command POST_BUILD
      COMMAND limn_command man > ${printed}/limn.1
      COMMAND limn_command completion bash > ${printed}/limn
      COMMAND limn_command completion zsh > ${printed}/_limn
      COMMAND limn_command completion fish > ${printed}/limn.fish
      VERBATIM)
    install(FILES ${printed}/limn.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
    install(FILES ${printed}/limn DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
    install(FILES ${printed}/_limn DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
    install(FILES ${printed}/limn.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  endif()
endif()
# The Python module, where Debian's Python looks if the prefix is /usr; elsewhere PYTHONPATH names it.
set(LIMN_PYTHON_DIR lib/python3/dist-packages CACHE STRING
  "Where `cmake --install` puts the Python module, below the prefix")
if(TARGET limn_python)
  install(TARGETS limn_python LIBRARY DESTINATION ${LIMN_PYTHON_DIR}/limn)
  install(FILES ${python_files} DESTINATION ${LIMN_PYTHON_DIR}/limn)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/schemes DESTINATION ${CMAKE_INSTALL_DATADIR}/limn
  FILES_MATCHING PATTERN *.toml)
