# The lines of code in README.md must be those between the markers of tests/consumer/main.cpp, which is compiled.
#
#   cmake -D README=<file> -D PROGRAM=<file> -P readme_test.cmake

file(READ "${README}" readme)
file(READ "${PROGRAM}" program)
string(REGEX MATCH "readme: begin\\](\n.*\n)    // \\[readme: end" found "${program}")
string(REPLACE "\n    " "\n" lines "${CMAKE_MATCH_1}")
if(lines STREQUAL "")
    message(FATAL_ERROR "No lines between the markers in ${PROGRAM}")
endif()
string(FIND "${readme}" "${lines}" position)
if(position EQUAL -1)
    message(FATAL_ERROR "README.md does not have these lines of ${PROGRAM}:\n${lines}")
endif()
