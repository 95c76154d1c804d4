#pragma once
// Fully converged discrete solutions of the steady circular contact from an independent program: a semismooth
// Newton-GMRES method with the exact convolution and without multigrid; residual below 1e-9, digits stable to 1e-7
// relative. Discretization: eqs. (4)-(7) with arithmetic means of epsilon at half points, K exact for a constant
// pressure on each cell, h^2 sum P = 2 pi/3; upstream2 is upstream1 in the first interior column. p0 = 1.96e8 Pa.
#include "reynolds/wedge.hpp"

namespace ehl::reference {

using reynolds::Wedge;

enum class Fluid {
  roelands_z060,  ///< Roelands z = 0.6, alpha = 1.7e-8 1/Pa, Dowson-Higginson
  roelands_z068,  ///< Roelands z = 0.68, alpha = 2.2e-8 1/Pa, Dowson-Higginson
  barus           ///< Barus, incompressible
};

struct CircularContact {
  double M, L;
  Fluid fluid;
  Wedge wedge;
  int n;  ///< cells along x and along y
  double Hc, Hm, H00, P_max;
};

/// The domain is [-4.5, 1.5] x [-3, 3] for M < 200, and [-2.5, 1.5] x [-2, 2] for M >= 200.
inline constexpr CircularContact circular_contacts[] = {
    {50, 10, Fluid::roelands_z060, Wedge::upstream1, 64, 0.2383353, 0.1408380, -0.7624608, 1.03036},
    {50, 10, Fluid::roelands_z060, Wedge::upstream1, 128, 0.2319077, 0.1386783, -0.7658594, 1.02473},
    {50, 10, Fluid::roelands_z060, Wedge::upstream1, 256, 0.2268404, 0.1364029, -0.7692692, 1.02174},
    {50, 10, Fluid::roelands_z060, Wedge::upstream1, 512, 0.2238346, 0.1349626, -0.7714234, 1.02013},
    {50, 10, Fluid::roelands_z060, Wedge::upstream1, 1024, 0.2222136, 0.1341140, -0.7726176, 1.07547},
    {50, 10, Fluid::roelands_z060, Wedge::upstream2, 64, 0.2048788, 0.1250491, -0.7864794, 1.01335},
    {50, 10, Fluid::roelands_z060, Wedge::upstream2, 128, 0.2165305, 0.1310840, -0.7772233, 1.01726},
    {50, 10, Fluid::roelands_z060, Wedge::upstream2, 256, 0.2195099, 0.1328261, -0.7747776, 1.01833},
    {50, 10, Fluid::roelands_z060, Wedge::upstream2, 512, 0.2202619, 0.1331309, -0.7741321, 1.02247},
    {50, 10, Fluid::roelands_z060, Wedge::upstream2, 1024, 0.2204508, 0.1332160, -0.7739598, 1.09377},
    {20, 10, Fluid::roelands_z068, Wedge::upstream1, 64, 0.4590566, 0.3078470, -0.5300979, 1.14797},
    {20, 10, Fluid::roelands_z068, Wedge::upstream1, 128, 0.4477823, 0.3023058, -0.5373188, 1.21668},
    {20, 10, Fluid::roelands_z068, Wedge::upstream1, 256, 0.4406293, 0.2977244, -0.5423538, 1.30534},
    {20, 10, Fluid::roelands_z068, Wedge::upstream1, 512, 0.4366747, 0.2953351, -0.5452397, 1.40582},
    {20, 10, Fluid::roelands_z068, Wedge::upstream2, 64, 0.4195678, 0.2866922, -0.5586345, 1.10218},
    {20, 10, Fluid::roelands_z068, Wedge::upstream2, 128, 0.4292066, 0.2912435, -0.5511211, 1.19771},
    {20, 10, Fluid::roelands_z068, Wedge::upstream2, 256, 0.4316474, 0.2924931, -0.5491297, 1.31260},
    {20, 10, Fluid::roelands_z068, Wedge::upstream2, 512, 0.4322618, 0.2926796, -0.5485957, 1.42721},
    {200, 10, Fluid::roelands_z068, Wedge::upstream1, 64, 0.0887068, 0.0390136, -0.9167052, 1.01389},
    {200, 10, Fluid::roelands_z068, Wedge::upstream1, 128, 0.0869610, 0.0400519, -0.9173558, 1.01267},
    {200, 10, Fluid::roelands_z068, Wedge::upstream1, 256, 0.0847918, 0.0397823, -0.9187902, 1.01165},
    {200, 10, Fluid::roelands_z068, Wedge::upstream1, 512, 0.0833676, 0.0393790, -0.9198041, 1.01103},
    {200, 10, Fluid::roelands_z068, Wedge::upstream2, 64, 0.0712636, 0.0335809, -0.9293163, 1.00582},
    {200, 10, Fluid::roelands_z068, Wedge::upstream2, 128, 0.0790176, 0.0372484, -0.9232389, 1.00921},
    {200, 10, Fluid::roelands_z068, Wedge::upstream2, 256, 0.0810336, 0.0384671, -0.9216173, 1.01006},
    {200, 10, Fluid::roelands_z068, Wedge::upstream2, 512, 0.0815457, 0.0387375, -0.9211869, 1.01027},
    {1000, 10, Fluid::roelands_z068, Wedge::upstream1, 64, 0.0243384, 0.0019061, -0.9780256, 1.00307},
    {1000, 10, Fluid::roelands_z068, Wedge::upstream1, 128, 0.0266023, 0.0075744, -0.9756731, 1.00471},
    {1000, 10, Fluid::roelands_z068, Wedge::upstream1, 256, 0.0263116, 0.0084867, -0.9757343, 1.00470},
    {1000, 10, Fluid::roelands_z068, Wedge::upstream1, 512, 0.0256562, 0.0085876, -0.9761842, 1.00448},
    {1000, 10, Fluid::roelands_z068, Wedge::upstream2, 64, 0.0099379, 0.0004252, -0.9880743, 0.99605},
    {1000, 10, Fluid::roelands_z068, Wedge::upstream2, 128, 0.0205906, 0.0057630, -0.9800866, 1.00187},
    {1000, 10, Fluid::roelands_z068, Wedge::upstream2, 256, 0.0235827, 0.0079207, -0.9777802, 1.00352},
    {1000, 10, Fluid::roelands_z068, Wedge::upstream2, 512, 0.0243671, 0.0083204, -0.9771619, 1.00394},
    {20, 10, Fluid::barus, Wedge::upstream2, 64, 0.4818633, 0.2987626, -0.5326295, 1.43055},
    {20, 10, Fluid::barus, Wedge::upstream2, 128, 0.4935611, 0.3051575, -0.5244483, 1.78161},
    {20, 10, Fluid::barus, Wedge::upstream2, 256, 0.4965217, 0.3062982, -0.5222892, 2.47779},
    {20, 10, Fluid::barus, Wedge::upstream2, 512, 0.4972664, 0.3065501, -0.5217142, 3.29807},
    {50, 10, Fluid::barus, Wedge::upstream1, 64, 0.2891110, 0.1522753, -0.7370953, 1.20480},
    {50, 10, Fluid::barus, Wedge::upstream1, 128, 0.2814494, 0.1501672, -0.7409240, 1.32256},
    {50, 10, Fluid::barus, Wedge::upstream1, 256, 0.2751409, 0.1474274, -0.7448580, 1.66707},
    {50, 10, Fluid::barus, Wedge::upstream2, 64, 0.2472972, 0.1345097, -0.7646094, 1.04611},
    {50, 10, Fluid::barus, Wedge::upstream2, 128, 0.2621254, 0.1412801, -0.7540098, 1.29635},
    {50, 10, Fluid::barus, Wedge::upstream2, 256, 0.2659092, 0.1431564, -0.7512240, 1.65490},
};

/// Limits h -> 0 on the same domains, extrapolated from both wedge schemes (for Barus from upstream2 alone).
struct CircularLimit {
  double M, L;
  Fluid fluid;
  double Hc, Hm;
};
inline constexpr CircularLimit circular_limits[] = {
    {50, 10, Fluid::roelands_z060, 0.22051, 0.13324},  {20, 10, Fluid::roelands_z068, 0.43247, 0.29275},
    {200, 10, Fluid::roelands_z068, 0.08172, 0.03882}, {1000, 10, Fluid::roelands_z068, 0.02463, 0.00849},
    {20, 10, Fluid::barus, 0.49752, 0.30663},          {50, 10, Fluid::barus, 0.26717, 0.14378},
};

}  // namespace ehl::reference
