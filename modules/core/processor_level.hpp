#pragma once
// Processor level for which the loaded numerics were compiled.

namespace ehl::core {

/// "x86-64", "x86-64-v2", "x86-64-v3" (AVX2) or "x86-64-v4" (AVX-512): level of the x86-64 psABI for which this copy of
/// the numerics was compiled; "generic" on other architectures. limits: instruction sets between two levels count as
/// the lower.
const char* processor_level();

}  // namespace ehl::core
