// What LeakSanitizer passes over in a program that is built with the sanitizers. HDF5 reads an object header of a
// damaged file into memory, finds that its checksum is wrong, and forgets that memory. A leak of the program itself is
// not hidden: memory that HDF5 gave out belongs to an identifier, which HDF5 still knows at the end.
extern "C" {
const char* __lsan_default_suppressions() { return "leak:libhdf5"; }
const char* __lsan_default_options() { return "print_suppressions=0"; }
}
