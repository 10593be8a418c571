# Compiles every table of data/ into a target, as text, so that an installed library needs no data folder.

function(emulsion_embed_data target)
  file(GLOB tables CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/data/*.csv)
  set(source ${PROJECT_BINARY_DIR}/generated/embedded_tables.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/WriteEmbeddedTables.cmake)
  list(JOIN tables "|" joined)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${source} "-DTABLES=${joined}" -P ${script}
    DEPENDS ${tables} ${script}
    COMMENT "Embedding data/*.csv"
    VERBATIM)
  target_sources(${target} PRIVATE ${source})
endfunction()
