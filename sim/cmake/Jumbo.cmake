# Compiling several sources as one. tests/fuzz/program, a project of its own, includes this file too.
cmake_path(SET rc_jumbo_root NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../..)

# rc_jumbo(NAME): compiles sixteen sources of a target as one, so that headers are parsed and templates
# instantiated once for all of them. Sources with options of their own (rc_define, SKIP_UNITY_BUILD_INCLUSION)
# and generated sources stay alone. The sources of a unit share file-local names. A unit includes its sources by
# their path in the project, so that the compiler cache serves other clones too, which the units of CMake's own
# UNITY_BUILD prevent. The global property rc_jumbo_PATH lists the sources that are compiled together with
# PATH. tests/meta builds a mutant of PATH from this list.
function(rc_jumbo name)
  get_target_property(sources ${name} SOURCES)
  set(units)
  set(members)
  foreach(source IN LISTS sources)
    get_filename_component(source ${source} ABSOLUTE)
    get_source_file_property(defined ${source} COMPILE_DEFINITIONS)
    get_source_file_property(alone ${source} SKIP_UNITY_BUILD_INCLUSION)
    cmake_path(IS_PREFIX CMAKE_CURRENT_BINARY_DIR ${source} generated)
    if(defined OR alone OR generated)
      list(APPEND units ${source})
      continue()
    endif()
    file(RELATIVE_PATH part ${rc_jumbo_root} ${source})
    list(APPEND members ${part})
    list(LENGTH members length)
    if(length EQUAL 16)
      rc_jumbo_unit(${name})
    endif()
  endforeach()
  rc_jumbo_unit(${name})
  set_target_properties(${name} PROPERTIES SOURCES "${units}")
endfunction()

# Writes the unit of the sources in `members`, lists it in `units`, and empties `members`.
macro(rc_jumbo_unit name)
  if(members)
    list(LENGTH units number)
    set(unit ${CMAKE_CURRENT_BINARY_DIR}/jumbo/${name}_${number}.cpp)
    rc_write_unit(${unit} ${members})
    list(APPEND units ${unit})
    foreach(member IN LISTS members)
      set_property(GLOBAL PROPERTY rc_jumbo_${member} ${members})
    endforeach()
    set(members)
  endif()
endmacro()

# rc_write_unit(UNIT SOURCE...): writes a source that includes the others.
function(rc_write_unit unit)
  list(TRANSFORM ARGN PREPEND "#include \"")
  list(TRANSFORM ARGN APPEND "\"\n")
  list(JOIN ARGN "" text)
  file(CONFIGURE OUTPUT ${unit} CONTENT "${text}" @ONLY)
endfunction()
