#pragma once
// exp, expm1, log1p and square root for a vector register of values. The scalar functions of the library prevent
// vectorisation of the loops over nodes, and every sweep evaluates the viscosity at every node.
//
// The error is below 2 units in the last place (tests/unit/rheology). NaN gives NaN, and the functions overflow and
// underflow as the scalar ones do.
#include <cmath>

#include "core/simd.hpp"

namespace ehl::rheology {

using core::broadcast;
using core::Lanes;

/// The 64-bit patterns that encode the values.
using Bits [[gnu::vector_size(sizeof(Lanes))]] = unsigned long long;

/// Reinterpretation of the bits, without conversion.
inline Bits bits_of(Lanes x) { return reinterpret_cast<Bits>(x); }
inline Lanes value_of(Bits b) { return reinterpret_cast<Lanes>(b); }

namespace elementary_detail {

// ln 2 in two parts: the first has 32 bits, so its product with every possible exponent n is exact.
inline constexpr double ln2_high = 0x1.62e42feep-1;
inline constexpr double ln2_low = 1.9082149292705877e-10;
inline constexpr double inverse_ln2 = 1.4426950408889634;
// Adding 1.5 * 2^52 leaves the nearest integer in the low bits of the sum.
inline constexpr double round_to_integer = 0x1.8p52;

/// (e^r - 1 - r)/r^2 for |r| <= ln2/2. source: Chebyshev interpolation in 60 digits; error 0.07 ulp of e^r.
inline Lanes exp_tail(Lanes r) {
  const Lanes r2 = r * r;
  const Lanes r4 = r2 * r2;
  const Lanes c01 = 0.5 + r * 0.16666666666666669;
  const Lanes c23 = 0.04166666666662413 + r * 0.008333333333330062;
  const Lanes c45 = 0.0013888888917213717 + r * 0.00019841269863053618;
  const Lanes c67 = 2.4801521295954376e-05 + r * 2.7557268459997064e-06;
  const Lanes c89 = 2.7620088445409746e-07 + r * 2.510038549551032e-08;
  return (c01 + r2 * c23) + r4 * ((c45 + r2 * c67) + r4 * c89);
}

/// [log((1+s)/(1-s)) - 2s]/s in powers of w = s^2 <= 0.0295, without the factor w. source: as for exp_tail(); error
/// 0.02 ulp.
inline Lanes log_tail(Lanes w) {
  const Lanes w2 = w * w;
  const Lanes c01 = 0.666666666666667 + w * 0.3999999999989889;
  const Lanes c23 = 0.28571428626253836 + w * 0.22222211089379496;
  const Lanes c45 = 0.1818289243253687 + w * 0.15331611722055008;
  return (c01 + w2 * c23) + (w2 * w2) * (c45 + w2 * 0.14617807153417325);
}

/// x = n ln2 + r, |r| <= ln2/2. in: |x| < 1e9. out: n as a double, r.
inline void split_exponent(Lanes x, Lanes& n, Lanes& r) {
  n = (x * inverse_ln2 + round_to_integer) - round_to_integer;
  r = (x - n * ln2_high) - n * ln2_low;
}

/// 2^n for an integral |n| <= 1022.
inline Lanes power_of_two(Lanes n) { return value_of((bits_of(n + round_to_integer) + 1023) << 52); }

}  // namespace elementary_detail

/// e^x.
/// limits: x = 0 gives exactly 1; below -708 the result loses bits gradually, below -745.2 it is 0;
/// above 709.79 it is infinite. NaN gives NaN.
inline Lanes exp(Lanes x) {
  namespace detail = elementary_detail;
  // Beyond these bounds the result is 0 or infinite; the comparisons let NaN pass.
  x = x < -746.0 ? broadcast(-746.0) : x;
  x = x > 710.0 ? broadcast(710.0) : x;
  Lanes n, r;
  detail::split_exponent(x, n, r);
  const Lanes mantissa = 1.0 + (r + r * r * detail::exp_tail(r));
  // In two factors, because 2^n overflows before e^x does.
  const Lanes half = (n * 0.5 + detail::round_to_integer) - detail::round_to_integer;
  return (mantissa * detail::power_of_two(half)) * detail::power_of_two(n - half);
}

/// e^x - 1, accurate for small x.
/// limits: x = 0 gives exactly 0; below -40 it is -1. NaN gives NaN, above 709.79 it is infinite.
inline Lanes expm1(Lanes x) {
  namespace detail = elementary_detail;
  x = x < -60.0 ? broadcast(-60.0) : x;
  x = x > 710.0 ? broadcast(710.0) : x;
  Lanes n, r;
  detail::split_exponent(x, n, r);
  const Lanes tail = r * r * detail::exp_tail(r);
  // Half the power of two first: 2^1024 is not a double, but (2^1024 - 1)/2 is.
  const Lanes half = detail::power_of_two(n - 1.0);
  return 2.0 * ((half - 0.5) + (half * r + half * tail));
}

/// ln(1 + u), accurate for small u.
/// limits: u = 0 gives exactly 0; u = -1 gives -infinity; u < -1 and NaN give NaN; infinity stays.
inline Lanes log1p(Lanes u) {
  namespace detail = elementary_detail;
  const Lanes x = 1.0 + u;
  // Rounding error of the addition (Knuth's two-sum), added back below.
  const Lanes part = x - 1.0;
  const Lanes lost = (1.0 - (x - part)) + (u - part);

  // x = 2^e m with m in [sqrt(1/2), sqrt(2)).
  constexpr unsigned long long bits_of_sqrt_half = 0x3fe6a09e667f3bcdULL;
  const Bits biased = (bits_of(x) - bits_of_sqrt_half + (1023ULL << 52)) >> 52;
  const Bits shift = (biased - 1023) << 52;
  const Lanes m = value_of(bits_of(x) - shift);
  const Lanes inverse_power = value_of((1023ULL << 52) - shift);
  // A small non-negative integer placed in the low bits of 2^52 is that integer plus 2^52.
  const Lanes e = value_of(biased | 0x4330000000000000ULL) - (0x1p52 + 1023.0);

  const Lanes f = (m - 1.0) + lost * inverse_power;
  const Lanes s = f / (2.0 + f);
  const Lanes w = s * s;
  const Lanes half_square = 0.5 * f * f;
  const Lanes correction = s * (half_square + w * detail::log_tail(w)) + e * detail::ln2_low;
  Lanes result = e * detail::ln2_high - ((half_square - correction) - f);

  constexpr double infinity = __builtin_inf();
  result = x == infinity ? x : result;
  result = x == 0.0 ? broadcast(-infinity) : result;
  return x >= 0.0 ? result : broadcast(__builtin_nan(""));
}

/// Correctly rounded.
inline Lanes square_root(Lanes x) {
  Lanes root;
  for (int lane = 0; lane < core::lanes; ++lane) root[lane] = std::sqrt(x[lane]);
  return root;
}

}  // namespace ehl::rheology
