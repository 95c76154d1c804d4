#pragma once
// For which processors the numerics in use were compiled.

namespace ehl::core {

/// "x86-64", "x86-64-v2", "x86-64-v3" (AVX2), "x86-64-v4" (AVX-512): the level of the x86-64 psABI that the compiler
/// was told to use for this copy of the numerics. "generic" on other architectures. limits: an instruction set between
/// two levels counts as the lower one.
const char* processor_level();

}  // namespace ehl::core
