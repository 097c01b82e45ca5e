# What each package of Debian has besides its files: texts, and manual pages of its
# programs, which help2man makes of their --help.
set(names inkcell-tools libinkcell-dev)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component name IN ZIP_LISTS CPACK_COMPONENTS_ALL names)
  set(top ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr)
  file(GLOB programs ${top}/bin/*)
  foreach(program ${programs})
    cmake_path(GET program FILENAME man)
    file(MAKE_DIRECTORY ${top}/share/man/man1)
    execute_process(COMMAND help2man --no-info --no-discard-stderr
      --version-string=${CPACK_PACKAGE_VERSION} "--name=fonts for microcontrollers"
      --output=${top}/share/man/man1/${man}.1 ${program}
      COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  file(READ ${CPACK_INKCELL_LICENSE} licence)
  file(WRITE ${top}/share/doc/${name}/copyright "${licence}
The Apache License is in /usr/share/common-licenses/Apache-2.0.
")
  file(WRITE ${top}/share/doc/${name}/changelog.Debian
"inkcell (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; \
urgency=medium

  * ${CPACK_INKCELL_CHANGES}

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  file(GLOB packed ${top}/share/man/man1/* ${top}/share/doc/${name}/changelog.Debian)
  execute_process(COMMAND gzip -9n ${packed} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
