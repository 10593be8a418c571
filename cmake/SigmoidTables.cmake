# Solves for the tables of src/spectrum/sigmoid_table.h and compiles them into a library of their own, which `target`
# needs: emulsion_sigmoid_tables(emulsion_spectrum). It takes less than half a minute of one core.
#
# In two steps, so that the solving is done again only when its input or its few sources change. The solver is always
# built optimised and without sanitizers, under which it would take minutes.

function(emulsion_sigmoid_tables target)
  set(folder ${PROJECT_SOURCE_DIR}/src/spectrum)
  set(problems ${PROJECT_BINARY_DIR}/generated/sigmoid_problems.bin)
  set(tables ${PROJECT_BINARY_DIR}/generated/sigmoid_tables.bin)
  set(source ${PROJECT_BINARY_DIR}/generated/sigmoid_tables.cpp)

  # The input. The library comes by its file: as a target it would bring the tables with it.
  add_executable(emulsion_write_sigmoid_problems ${folder}/generate/write_sigmoid_problems.cpp)
  target_include_directories(emulsion_write_sigmoid_problems PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(emulsion_write_sigmoid_problems PRIVATE
    emulsion_settings $<TARGET_FILE:${target}> emulsion::core)
  add_dependencies(emulsion_write_sigmoid_problems ${target})
  add_custom_command(
    OUTPUT ${problems}
    COMMAND emulsion_write_sigmoid_problems ${problems}.new
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${problems}.new ${problems}
    DEPENDS emulsion_write_sigmoid_problems ${target}
    COMMENT "Writing the equations of the sigmoid tables"
    VERBATIM)

  # The solving
  add_executable(emulsion_solve_sigmoid_tables
    ${folder}/generate/solve_sigmoid_tables.cpp
    ${folder}/sigmoid_table_solver.cpp
    ${folder}/sigmoid_solver.cpp
    ${PROJECT_SOURCE_DIR}/src/core/matrix3.cpp)
  target_include_directories(emulsion_solve_sigmoid_tables PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(emulsion_solve_sigmoid_tables PRIVATE emulsion_settings_unsanitized)
  target_compile_options(emulsion_solve_sigmoid_tables PRIVATE -O2)
  add_custom_command(
    OUTPUT ${tables}
    COMMAND emulsion_solve_sigmoid_tables ${problems} ${tables}
    DEPENDS emulsion_solve_sigmoid_tables ${problems}
    COMMENT "Solving for the sigmoid tables"
    VERBATIM)

  # The assembler takes the tables as they are: as numbers in a source they would take minutes to compile.
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [=[
// Made by cmake/SigmoidTables.cmake.
#include "spectrum/sigmoid_table.h"

asm(".section .rodata\n"
    ".balign 64\n"
    "emulsion_sigmoid_tables_begin:\n"
    ".incbin \"@tables@\"\n"
    "emulsion_sigmoid_tables_end:\n"
    ".balign 4\n"
    ".text\n");
extern "C" const float emulsion_sigmoid_tables_begin[], emulsion_sigmoid_tables_end[];

namespace emulsion {

std::span<const float> embedded_sigmoid_tables() noexcept {
    return {emulsion_sigmoid_tables_begin, emulsion_sigmoid_tables_end};
}

}  // namespace emulsion
]=])
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${tables})
  add_library(emulsion_sigmoid_tables STATIC ${source})
  target_include_directories(emulsion_sigmoid_tables PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(emulsion_sigmoid_tables PRIVATE $<BUILD_INTERFACE:emulsion_settings_unsanitized>)
  target_link_libraries(${target} INTERFACE emulsion_sigmoid_tables)
endfunction()
