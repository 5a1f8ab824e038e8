# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Debian packages: `cpack -G DEB` in the build folder writes one for each install component.
#   geodesic-processing         component `runtime`: the program, and the library if it is shared
#   libgeodesic-processing-dev  component `development`: headers, static library, files for CMake
#   geodesic-processing-doc     component `manual`, if GEODESIC_PROCESSING_DOCS is on; build the
#                               target `documentation` first
# The environment variable SOURCE_DATE_EPOCH sets the date in the changelog.

# Publishers of packages set an address that receives mail.
set(GEODESIC_PROCESSING_CONTACT "The authors of Geodesic_processing <maintainers@example.org>"
    CACHE STRING "maintainer of the Debian packages: name <address>")

set(CPACK_PACKAGE_NAME geodesic-processing)
set(CPACK_PACKAGE_CONTACT ${GEODESIC_PROCESSING_CONTACT})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# Debian's own packages begin with revision 1.  They replace packages with this revision.
set(CPACK_DEBIAN_PACKAGE_RELEASE 0upstream1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_ALL "")

# Debian requires a file with the license and a changelog in each package.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(package_build_folder ${PROJECT_BINARY_DIR}/debian)

# add_debian_package(COMPONENT NAME SECTION DESCRIPTION): the lines of the description have at most
# 79 characters.
function(add_debian_package component name section description)
  string(TOUPPER ${component} id)
  set(folder ${package_build_folder}/${name})
  set(comment "")
  if(component STREQUAL runtime AND GEODESIC_PROCESSING_VIEWER)
    set(comment
"Comment: The page of the viewer, viewer.html, contains scripts and kernels under the
 MIT license. The page shows their names and copyright notices.
")
  endif()
  file(CONFIGURE OUTPUT ${folder}/copyright @ONLY CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: @PROJECT_NAME@
@comment@
Files: *
Copyright: 2026 The authors of @PROJECT_NAME@
License: GPL-3.0-or-later
 On Debian systems, the text of version 3 of the GNU General Public License is in
 /usr/share/common-licenses/GPL-3.
")
  file(CONFIGURE OUTPUT ${folder}/changelog @ONLY CONTENT
"geodesic-processing (@PROJECT_VERSION@-@CPACK_DEBIAN_PACKAGE_RELEASE@) unstable; urgency=medium

  * Release @PROJECT_VERSION@.

 -- @GEODESIC_PROCESSING_CONTACT@  @date@
")
  file(ARCHIVE_CREATE OUTPUT ${folder}/changelog.Debian.gz PATHS ${folder}/changelog
       FORMAT raw COMPRESSION GZip COMPRESSION_LEVEL 9)
  install(FILES ${folder}/copyright ${folder}/changelog.Debian.gz
          DESTINATION share/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)

  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  set(CPACK_DEBIAN_${id}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${id}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${id}_DESCRIPTION ${description} PARENT_SCOPE)
endfunction()

if(GEODESIC_PROCESSING_PROGRAM OR BUILD_SHARED_LIBS)
  add_debian_package(runtime geodesic-processing math
"This package contains the program geodesic, which computes geodesic
distances, shortest paths, samples, Voronoi diagrams, remeshed surfaces,
texture atlases and optimal transport on triangle meshes and point clouds.")
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ${BUILD_SHARED_LIBS})
endif()

add_debian_package(development libgeodesic-processing-dev libdevel
"This package contains the headers and the library of Geodesic_processing,
and the files by which CMake finds them. The library computes geodesic
distances and shortest paths, and provides algorithms that use them.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libcgal-dev (>= 5.5.1), libboost-dev, libeigen3-dev (>= 3.3)")
if(GEODESIC_PROCESSING_HAS_CHOLMOD)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libsuitesparse-dev")
endif()
if(BUILD_SHARED_LIBS)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", geodesic-processing (= "
         "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
endif()

if(GEODESIC_PROCESSING_DOCS)
  add_debian_package(manual geodesic-processing-doc doc
"This package contains the user manual and the reference of
Geodesic_processing as HTML pages. The first page is
/usr/share/doc/geodesic-processing-doc/html/index.html.")
  set(CPACK_DEBIAN_MANUAL_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_MANUAL_PACKAGE_DEPENDS libjs-mathjax)
  # The link to MathJax in the build folder is absolute.  In a package it is relative.
  set(html_folder share/doc/geodesic-processing-doc/html)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/doc/html/ DESTINATION ${html_folder}
          COMPONENT manual EXCLUDE_FROM_ALL
          PATTERN mathjax EXCLUDE)
  install(CODE "file(CREATE_LINK ../../../javascript/mathjax
    \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${html_folder}/mathjax SYMBOLIC)"
    COMPONENT manual EXCLUDE_FROM_ALL)
endif()

include(CPack)
