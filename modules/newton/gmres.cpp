#include "newton/gmres.hpp"

#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_spfgmr.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/errors.hpp"

namespace ehl::newton {
namespace {

constexpr int krylov_vectors = 30;
constexpr int restarts = 2;

std::span<double> values(N_Vector v) {
  return {N_VGetArrayPointer_Serial(v), static_cast<std::size_t>(N_VGetLength_Serial(v))};
}

/// C code lies between the functions and the caller: an exception is stored here until control has returned from it.
struct Calls {
  const LinearSystem& system;
  std::exception_ptr error;
};

/// out: 0 on success; the library stops at any other value.
template <class Function>
int guarded(void* data, Function function) {
  Calls& calls = *static_cast<Calls*>(data);
  try {
    function(calls.system);
    return 0;
  } catch (...) {
    calls.error = std::current_exception();
    return -1;
  }
}

int product(void* data, N_Vector v, N_Vector Av) {
  return guarded(data, [&](const LinearSystem& system) { system.product(values(v), values(Av)); });
}

int precondition(void* data, N_Vector v, N_Vector solved, realtype, int) {
  return guarded(data, [&](const LinearSystem& system) {
    std::ranges::copy(values(v), values(solved).begin());
    system.precondition(values(solved));
  });
}

/// The library's objects, freed in the required order.
struct Objects {
  SUNContext context = nullptr;
  N_Vector b = nullptr, x = nullptr;
  SUNLinearSolver solver = nullptr;
  ~Objects() {
    if (solver) SUNLinSolFree(solver);
    if (x) N_VDestroy(x);
    if (b) N_VDestroy(b);
    if (context) SUNContext_Free(&context);
  }
};

}  // namespace

GmresResult gmres(const LinearSystem& system, std::span<const double> b, double tolerance, std::span<double> x) {
  const auto check = [](bool fine) {
    if (!fine) throw core::SolverError("GMRES cannot be set up: not enough memory?");
  };
  const auto size = static_cast<sunindextype>(b.size());
  Calls calls{system, nullptr};
  Objects own;
  check(SUNContext_Create(nullptr, &own.context) == 0);
  own.b = N_VNew_Serial(size, own.context);
  own.x = N_VMake_Serial(size, x.data(), own.context);
  check(own.b && own.x);
  own.solver = SUNLinSol_SPFGMR(own.x, SUN_PREC_RIGHT, krylov_vectors, own.context);
  check(own.solver && SUNLinSol_SPFGMRSetMaxRestarts(own.solver, restarts) == 0 &&
        SUNLinSolSetATimes(own.solver, &calls, product) == 0 &&
        SUNLinSolSetPreconditioner(own.solver, &calls, nullptr, precondition) == 0 &&
        SUNLinSolInitialize(own.solver) == 0 && SUNLinSolSetZeroGuess(own.solver, SUNTRUE) == 0);
  std::ranges::copy(b, values(own.b).begin());
  std::ranges::fill(x, 0.0);
  const int flag = SUNLinSolSolve(own.solver, nullptr, own.x, own.b, tolerance * std::sqrt(N_VDotProd(own.b, own.b)));
  if (calls.error) std::rethrow_exception(calls.error);
  return {flag == SUNLS_SUCCESS || flag == SUNLS_RES_REDUCED, flag == SUNLS_SUCCESS, SUNLinSolNumIters(own.solver)};
}

}  // namespace ehl::newton
