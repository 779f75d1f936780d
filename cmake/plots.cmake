# Draws the demos' plots anew from the CSV files that they have written:
#
#   cmake [options] -P cmake/plots.cmake
#
#   -DFROM=reports    where the CSV files are; here when not given. By name:
#                     boat_in_waves_{series,spectra,moments}.csv  (--csv, --spectra, --moments)
#                     floating_cube_{logs,fall}.csv               (--logs, --fall)
#                     hard_cases_scores.csv, speed_vs_error_rows.csv, wave_accuracy_rows.csv   (--csv)
#   -DTO=pictures     where to draw them; beside the CSV files when not given
#   -DFORMAT=svg      or png, as when not given
#
# How they look is in demos/plots: a script of gnuplot for each, and style.gp for all.

cmake_minimum_required(VERSION 3.25)

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH source_dir)
set(scripts "${source_dir}/demos/plots")

if(NOT FROM)
    set(FROM .)
endif()
if(NOT TO)
    set(TO "${FROM}")
endif()
if(NOT FORMAT)
    set(FORMAT png)
endif()
file(MAKE_DIRECTORY "${TO}")
file(REAL_PATH "${FROM}" FROM)
file(REAL_PATH "${TO}" TO)

find_program(gnuplot gnuplot NO_CACHE)
if(NOT gnuplot)
    message(FATAL_ERROR "gnuplot is not installed (Debian: gnuplot-nox)")
endif()

set(tables_of_boat_in_waves series spectra moments)
set(tables_of_floating_cube logs fall)
set(tables_of_hard_cases scores)
set(tables_of_speed_vs_error rows)
set(tables_of_wave_accuracy rows)

set(drawn 0)
foreach(demo IN ITEMS boat_in_waves floating_cube hard_cases speed_vs_error wave_accuracy)
    set(settings "set loadpath '${scripts}'; picture = '${TO}/${demo}.${FORMAT}'")
    set(missing "")
    foreach(table IN LISTS tables_of_${demo})
        set(file "${FROM}/${demo}_${table}.csv")
        if(NOT EXISTS "${file}")
            list(APPEND missing ${demo}_${table}.csv)
        endif()
        string(APPEND settings "; ${table} = '${file}'")
    endforeach()
    if(missing)
        list(JOIN missing ", " missing)
        message(STATUS "${demo}: not drawn, without ${missing}")
        continue()
    endif()
    execute_process(
        COMMAND "${gnuplot}" -e "${settings}" "${scripts}/${demo}.gp"
        COMMAND_ERROR_IS_FATAL ANY)
    message(STATUS "${demo}: ${TO}/${demo}.${FORMAT}")
    math(EXPR drawn "${drawn} + 1")
endforeach()
if(drawn EQUAL 0)
    message(FATAL_ERROR "No CSV files of the demos in ${FROM}")
endif()
