# Makes the tiles of src/display/blue_noise.h and compiles them into `target`: emulsion_blue_noise_tiles(emulsion_display).
# It takes a few seconds of one core; the program is always built optimised and without sanitizers.

function(emulsion_blue_noise_tiles target)
  set(folder ${PROJECT_SOURCE_DIR}/src/display)
  set(source ${PROJECT_BINARY_DIR}/generated/blue_noise_tiles.cpp)
  add_executable(emulsion_write_blue_noise_tiles
    ${folder}/generate/write_blue_noise_tiles.cpp ${folder}/void_and_cluster.cpp)
  target_include_directories(emulsion_write_blue_noise_tiles PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(emulsion_write_blue_noise_tiles PRIVATE emulsion_settings_unsanitized)
  target_compile_options(emulsion_write_blue_noise_tiles PRIVATE -O2)
  add_custom_command(
    OUTPUT ${source}
    COMMAND emulsion_write_blue_noise_tiles ${source}
    DEPENDS emulsion_write_blue_noise_tiles
    COMMENT "Making the tiles of blue noise"
    VERBATIM)
  target_sources(${target} PRIVATE ${source})
endfunction()
