# Writes OUTPUT, a C++ source that holds the files of FOLDER compressed: cmake -D FOLDER=... -D OUTPUT=... -P embed.cmake
file(GLOB names RELATIVE ${FOLDER} ${FOLDER}/*)
list(SORT names)
set(arrays "")
set(entries "")
set(count 0)
foreach(name ${names})
  # Without a name and a time in it, the same content gives the same bytes.
  execute_process(COMMAND gzip -9nc ${FOLDER}/${name} OUTPUT_FILE ${OUTPUT}.gz COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${OUTPUT}.gz hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(..)" "\\\\x\\1" text "${hex}")
  # Adjacent literals of 16 bytes each.
  string(REGEX REPLACE "(\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..\\\\x..)" "\\1\"\n    \"" text "${text}")
  string(APPEND arrays "constexpr std::string_view kFile${count}{\n    \"${text}\",\n    ${size}};\n")
  string(APPEND entries "      {\"${name}\", kFile${count}},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(REMOVE ${OUTPUT}.gz)
file(WRITE ${OUTPUT}
"// Written by embed.cmake.
#include \"server/room/embedded.h\"

namespace selvage::server::room {
namespace {

${arrays}
}  // namespace

std::vector<Embedded> embedded_files() {
  return {
${entries}  };
}

}  // namespace selvage::server::room
")
