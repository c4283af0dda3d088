# cmake -DSOURCE=folder [-DPARTIAL=ON: exceptions may be missing] [-DFILES=bound] [-DFOLDERS=bound]
#   -P folders.cmake
# A newcomer can read the contents of a folder. A folder of model, rtl, sim and tests holds at most twelve
# files, a folder of model, rtl and sim at most twelve folders. Files that differ only in their endings count
# as one.
cmake_policy(VERSION 3.25)
if(NOT FILES)
  set(FILES 12)
endif()
if(NOT FOLDERS)
  set(FOLDERS 12)
endif()
# The exceptions. A folder that needs no exception any more must leave this list.
set(exceptions
  # Each file holds one scene family, command, parser, module or table, and has its name.
  model/scene/generate    # a family of scenes
  sim/app                 # a command
  tests/fuzz/dict         # a parser
  tests/formal            # a module that is proven
  tests/meta/mutants      # a table of faults
  # One file for each question. tests/README.md has them in a table.
  tests/reference
  tests/scene
  tests/system/elastic
  # Parts of one thing that only make sense together.
  model/core              # parameters and payloads, which all rooms include
  model/scene             # the parts of a scene
  sim/explore/stress      # a run of stress
  sim/judge/reference     # the reference tracer
  sim/silicon/chip        # a run of nextpnr
  sim/view/page           # the parts of a page, with their style and script
  tests/fuzz/program      # a program of all parsers
  tests/meta/campaign     # a program
  tests/support/cases     # operands of units, for the tests and the campaign
)
set(faults "")
set(crowded)
foreach(tree model rtl sim tests)
  file(GLOB_RECURSE entries LIST_DIRECTORIES true RELATIVE ${SOURCE} ${SOURCE}/${tree}/*)
  foreach(entry IN LISTS entries ITEMS ${tree})
    if(NOT IS_DIRECTORY ${SOURCE}/${entry})
      continue()
    endif()
    file(GLOB inside LIST_DIRECTORIES true RELATIVE ${SOURCE}/${entry} ${SOURCE}/${entry}/*)
    set(folders)
    set(files)
    foreach(one IN LISTS inside)
      if(IS_DIRECTORY ${SOURCE}/${entry}/${one})
        list(APPEND folders ${one})
      else()
        cmake_path(GET one STEM stem)
        list(APPEND files ${stem})
      endif()
    endforeach()
    list(REMOVE_DUPLICATES files)
    list(LENGTH files count)
    if(count GREATER FILES)
      list(APPEND crowded ${entry})
      if(NOT entry IN_LIST exceptions)
        string(APPEND faults "${entry} has ${count} files, more than ${FILES}\n")
      endif()
    endif()
    list(LENGTH folders count)
    if(count GREATER FOLDERS AND NOT tree STREQUAL "tests")
      string(APPEND faults "${entry} has ${count} folders, more than ${FOLDERS}\n")
    endif()
  endforeach()
endforeach()
foreach(entry IN LISTS exceptions)
  if(NOT PARTIAL AND NOT entry IN_LIST crowded)
    string(APPEND faults "${entry} is an exception in tests/meta/checks/folders.cmake without need\n")
  endif()
endforeach()
if(faults)
  message(FATAL_ERROR "${faults}")
endif()
message("no folder is too full")
