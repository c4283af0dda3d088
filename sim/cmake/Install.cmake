# cmake --install: the program, its run-time files, and the package for other projects; and cpack -G DEB.
#
# Run `cmake --build` first: packing builds nothing, so that it does not build the tests.
include(CMakePackageConfigHelpers)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY TRUE)
set(data ${CMAKE_INSTALL_DATADIR}/rayclock)

# The manual page and the shell completions, from the options that the commands declare.
set(printed ${PROJECT_BINARY_DIR}/printed)
set(prints)
set(forms man bash zsh fish)
set(printed_files rayclock.1 rayclock _rayclock rayclock.fish)
foreach(name file IN ZIP_LISTS forms printed_files)
  list(APPEND prints COMMAND ${CMAKE_COMMAND} -E make_directory ${printed}/${name}
    COMMAND rayclock --print ${name} > ${printed}/${name}/${file})
endforeach()
add_custom_command(OUTPUT ${printed}/man/rayclock.1 ${prints} DEPENDS rayclock)
add_custom_target(manual ALL DEPENDS ${printed}/man/rayclock.1)

install(TARGETS rayclock RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS rc_picture_codec LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/rayclock)
install(FILES ${printed}/man/rayclock.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${printed}/bash/rayclock DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${printed}/zsh/_rayclock DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${printed}/fish/rayclock.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(DIRECTORY rtl scenes DESTINATION ${data})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

# find_package(rayclock): the program, the C++ library (library/CMakeLists.txt), and the Verilog sources in
# the order that tools need.
file(GLOB_RECURSE rtl_of_package CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/rtl rtl/*.sv)
list(REMOVE_ITEM rtl_of_package rc_pkg.sv)
list(SORT rtl_of_package)
list(JOIN rtl_of_package " " rtl_of_package)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/rayclock)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/rayclock-config.cmake.in
  ${PROJECT_BINARY_DIR}/rayclock-config.cmake INSTALL_DESTINATION ${package_folder} PATH_VARS
  CMAKE_INSTALL_BINDIR data)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rayclock-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rayclock-config.cmake ${PROJECT_BINARY_DIR}/rayclock-config-version.cmake
  DESTINATION ${package_folder})

# Without Verilator and a compiler the model runs, but not the RTL. Reports need Vega.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_VENDOR rayclock)
set(CPACK_PACKAGE_CONTACT "rayclock <rayclock@localhost>")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "verilator (>= 5.006), g++, zlib1g-dev, libjs-vega")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "assimp-utils, gtkwave, yosys")
if(rc_python)   # the package then has the module
  string(APPEND CPACK_DEBIAN_PACKAGE_SUGGESTS ", python3-numpy")
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/Packing.cmake)
include(CPack)
