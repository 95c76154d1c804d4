// CMake compiles the precompiled headers of the tests with this file.
