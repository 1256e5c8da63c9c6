# Writes OUTPUT, a source that defines engine_version(): VERSION and a digest of the C++ files under ROOT.
file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/*.h ${ROOT}/*.cpp)
list(SORT sources)
set(digests "")
foreach(source IN LISTS sources)
  file(SHA256 ${ROOT}/${source} digest)
  string(APPEND digests "${source} ${digest}\n")
endforeach()
string(SHA256 digest "${digests}")
string(SUBSTRING ${digest} 0 8 digest)
file(WRITE ${OUTPUT} "#include \"engine/simulation/run.h\"

const char* rouleau::engine_version() {
  return \"${VERSION}+${digest}\";
}
")
