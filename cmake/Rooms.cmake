# A room is one folder of src/ and one library target: emulsion_room(film ...) makes emulsion::film of src/film/*.cpp.

function(emulsion_room name)
  cmake_parse_arguments(room "" "" "LINKS;PRIVATE_LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  add_library(emulsion_${name} STATIC ${sources})
  add_library(emulsion::${name} ALIAS emulsion_${name})
  target_include_directories(emulsion_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_link_libraries(emulsion_${name}
    PUBLIC ${room_LINKS}
    PRIVATE $<BUILD_INTERFACE:emulsion_settings> ${room_PRIVATE_LINKS})
  target_compile_features(emulsion_${name} PUBLIC cxx_std_20)
endfunction()

# The `emulsion` program: the room src/cli and its main.cpp.
function(emulsion_program)
  target_compile_definitions(emulsion_cli PUBLIC EMULSION_VERSION="${PROJECT_VERSION}")
  add_executable(emulsion ${PROJECT_SOURCE_DIR}/src/cli/main.cpp)
  target_link_libraries(emulsion PRIVATE emulsion_settings emulsion::cli CLI11::CLI11)
endfunction()

# One test program per room: test_film of tests/film/*.cpp, its cases found by ctest. Those of suites "Long/..." get the
# label "long", without which scripts/test leaves them out. PATTERN: which of the files; default: *.cpp.
function(emulsion_test_room name)
  cmake_parse_arguments(room "" "PATTERN" "LINKS" ${ARGN})
  if(NOT room_PATTERN)
    set(room_PATTERN *.cpp)
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/${room_PATTERN})
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE emulsion_settings ${room_LINKS} emulsion_test_support GTest::gmock_main)
  target_compile_definitions(test_${name} PRIVATE
    EMULSION_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  # What is tested is optimised in its own room: the tests themselves are compiled once and run once.
  target_compile_options(test_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. TEST_FILTER -Long/* DISCOVERY_MODE PRE_TEST
    PROPERTIES TIMEOUT 600 ENVIRONMENT ${EMULSION_TEST_ENVIRONMENT})
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. TEST_FILTER Long/* TEST_LIST test_${name}_long
    DISCOVERY_MODE PRE_TEST
    PROPERTIES TIMEOUT 600 LABELS long ENVIRONMENT ${EMULSION_TEST_ENVIRONMENT})
endfunction()

# One benchmark program per file: bench_film_add of bench/film/add.cpp. Built when asked for, by its name or all together
# as "benchmarks": the tests need none of them.
function(emulsion_bench_room name)
  cmake_parse_arguments(room "" "" "LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/${name}/*.cpp)
  foreach(source IN LISTS sources)
    get_filename_component(stem ${source} NAME_WE)
    add_executable(bench_${name}_${stem} EXCLUDE_FROM_ALL ${source})
    add_dependencies(benchmarks bench_${name}_${stem})
    target_link_libraries(bench_${name}_${stem} PRIVATE emulsion_settings ${room_LINKS} benchmark::benchmark)
    target_include_directories(bench_${name}_${stem} PRIVATE ${PROJECT_SOURCE_DIR}/bench)
    target_compile_definitions(bench_${name}_${stem} PRIVATE EMULSION_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  endforeach()
endfunction()
