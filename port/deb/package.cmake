# Two packages of Debian, of what install.cmake leaves, by `cpack -G DEB` in a build
# for /usr: inkcell-tools has the programs, libinkcell-dev the sources.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "the Inkcell authors")
set(CPACK_PACKAGE_CONTACT "the Inkcell authors <inkcell@inkcell.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL tools Unspecified)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME inkcell-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_DESCRIPTION
"makes and draws fonts for microcontrollers
inkcell-fontgen compiles outline fonts into minimal outlines or distance
fields. The other programs draw and judge them with the device's code.")

set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME libinkcell-dev)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS inkcell-tools)
set(CPACK_DEBIAN_UNSPECIFIED_DESCRIPTION
"scalable, antialiased type for microcontrollers
Sources of a library that draws fonts of any size with integers only, without
heap. find_package(Inkcell) compiles them with the compiler of the project.")

set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/finish.cmake)
set(CPACK_INKCELL_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_INKCELL_CHANGES "docs/CHANGELOG.md in the sources.")
include(CPack)
