# What a page shows is what is compiled: its blocks of the language cpp are the snippets of the programs, in any
# order, and there are no others. A snippet stands between lines of `// [snippet]` and `// [end]`, and is shown
# without their indentation.
#
#   cmake -D PAGE=<Markdown file> -D PROGRAMS=<C++ file>[,<C++ file>...] -P snippets_test.cmake

cmake_minimum_required(VERSION 3.25)

# Sets <name>_count, and <name>_1 and so on to what stands in the text between `begin` and `end`.
function(cut_blocks name text begin end)
    set(count 0)
    string(LENGTH "${begin}" begin_length)
    while(TRUE)
        string(FIND "${text}" "${begin}" position)
        if(position EQUAL -1)
            break()
        endif()
        string(SUBSTRING "${text}" 0 ${position} before)
        string(REGEX REPLACE ".*\n" "" indentation "${before}")
        math(EXPR position "${position} + ${begin_length}")
        string(SUBSTRING "${text}" ${position} -1 text)
        string(FIND "${text}" "${end}" length)
        if(length EQUAL -1)
            message(FATAL_ERROR "There is no ${end} after:\n${text}")
        endif()
        string(SUBSTRING "${text}" 0 ${length} block)
        string(SUBSTRING "${text}" ${length} -1 text)
        string(REPLACE "\n${indentation}" "\n" block "\n${block}")
        math(EXPR count "${count} + 1")
        set(${name}_${count} "${block}" PARENT_SCOPE)
    endwhile()
    set(${name}_count ${count} PARENT_SCOPE)
endfunction()

# Fails if one of the blocks is not among the others.
function(expect_among where name others)
    foreach(i RANGE 1 ${${name}_count})
        set(found FALSE)
        foreach(j RANGE 1 ${${others}_count})
            if(${name}_${i} STREQUAL ${others}_${j})
                set(found TRUE)
            endif()
        endforeach()
        if(NOT found)
            message(FATAL_ERROR "Only in ${where}:${${name}_${i}}")
        endif()
    endforeach()
endfunction()

file(READ "${PAGE}" page)
cut_blocks(shown "${page}" "```cpp\n" "```\n")

set(program "")
string(REPLACE "," ";" PROGRAMS "${PROGRAMS}")
foreach(file IN LISTS PROGRAMS)
    file(READ "${file}" text)
    string(APPEND program "${text}")
endforeach()
cut_blocks(compiled "${program}" "// [snippet]\n" "// [end]\n")

if(shown_count EQUAL 0 OR compiled_count EQUAL 0)
    message(FATAL_ERROR "${shown_count} blocks in ${PAGE}, ${compiled_count} snippets in ${PROGRAMS}")
endif()
expect_among("${PAGE}" shown compiled)
expect_among("${PROGRAMS}" compiled shown)
message(STATUS "snippets: ${shown_count} of ${PAGE} are compiled")
