# cmake -DOUTPUT=file.cpp "-DTABLES=a.csv|b.csv" -P WriteEmbeddedTables.cmake
# Writes one C++ file that defines emulsion::embedded_table_files() (src/spectrum/embedded_tables.h).

string(REPLACE "|" ";" TABLES "${TABLES}")
set(rows "")
foreach(table IN LISTS TABLES)
  get_filename_component(name ${table} NAME_WE)
  file(READ ${table} text)
  string(APPEND rows "    {\"${name}\", R\"csv(${text})csv\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made from data/*.csv by cmake/WriteEmbeddedTables.cmake.
#include \"spectrum/embedded_tables.h\"

namespace emulsion {

namespace {
constexpr EmbeddedTableFile kFiles[] = {
${rows}};
}  // namespace

std::span<const EmbeddedTableFile> embedded_table_files() noexcept { return kFiles; }

}  // namespace emulsion
")
