// Linked into sanitized builds. OpenVDB does not free the part of a tree that it has read when it finds it damaged;
// what cannot be used is remembered (bake/grid_reader.h), so that a damaged file is read once. libarchive 3.6 does not
// free the 10 KiB of an archive's buffer after a disk was full.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:openvdb\nleak:libarchive"; }
