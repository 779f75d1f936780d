# The target `docs`, which writes the API reference and the pages to docs/html in the build directory, and a test
# that nothing public is undocumented.

find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
    message(STATUS "Doxygen is not installed (Debian: doxygen): no API reference")
    if(BULLET_BUOYANCY_BUILD_TESTS)
        add_test(NAME docs.reference COMMAND "${CMAKE_COMMAND}" -E echo "Skipped: Doxygen is not installed")
        set_tests_properties(docs.reference PROPERTIES LABELS docs SKIP_REGULAR_EXPRESSION "Skipped")
    endif()
    return()
endif()

# What bullet_buoyancy.h names is the API. Some of it is made by the build.
set(umbrella "${PROJECT_SOURCE_DIR}/bullet_buoyancy/bullet_buoyancy.h")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${umbrella}")
file(STRINGS "${umbrella}" includes REGEX "^#include \"")
set(inputs "${umbrella}")
foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" header "${include}")
    if(EXISTS "${PROJECT_SOURCE_DIR}/${header}")
        list(APPEND inputs "${PROJECT_SOURCE_DIR}/${header}")
    else()
        list(APPEND inputs "${PROJECT_BINARY_DIR}/include/${header}")
    endif()
endforeach()
file(GLOB pages CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/*.md" "${PROJECT_SOURCE_DIR}/bullet_buoyancy/docs/*.md")

set(BUOYANCY_DOCS_DIR "${PROJECT_BINARY_DIR}/docs")
list(JOIN inputs "\" \\\n    \"" BUOYANCY_DOCS_HEADERS)
list(JOIN pages "\" \\\n    \"" BUOYANCY_DOCS_PAGES)
configure_file("${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in" "${BUOYANCY_DOCS_DIR}/Doxyfile" @ONLY)

# README shows pictures of the demos.
set(copy_pictures "")
file(GLOB pictures RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/demos/*/picture.png")
foreach(picture IN LISTS pictures)
    cmake_path(GET picture PARENT_PATH folder)
    list(APPEND copy_pictures
        COMMAND "${CMAKE_COMMAND}" -E make_directory "${BUOYANCY_DOCS_DIR}/html/${folder}"
        COMMAND "${CMAKE_COMMAND}" -E copy "${PROJECT_SOURCE_DIR}/${picture}" "${BUOYANCY_DOCS_DIR}/html/${folder}")
endforeach()

add_custom_target(docs
    COMMAND Doxygen::doxygen "${BUOYANCY_DOCS_DIR}/Doxyfile"
    ${copy_pictures}
    COMMENT "Writing ${BUOYANCY_DOCS_DIR}/html/index.html"
    VERBATIM)
if(BULLET_BUOYANCY_BUILD_TESTS)
    add_test(NAME docs.reference COMMAND Doxygen::doxygen "${BUOYANCY_DOCS_DIR}/Doxyfile")
    set_tests_properties(docs.reference PROPERTIES LABELS docs)
endif()
