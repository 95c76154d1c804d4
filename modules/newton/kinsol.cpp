#include "newton/kinsol.hpp"

#include <kinsol/kinsol.h>
#include <kinsol/kinsol_ls.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_spfgmr.h>

#include <algorithm>
#include <exception>
#include <string>

#include "core/errors.hpp"

namespace ehl::newton {
namespace {

constexpr int krylov_vectors = 30;
constexpr int restarts = 2;
constexpr double any_length = 1e100;
constexpr double never = 1e-300;  // zero would mean the library's own tolerance

std::span<double> values(N_Vector v) {
  return {N_VGetArrayPointer_Serial(v), static_cast<std::size_t>(N_VGetLength_Serial(v))};
}

/// What the callbacks see: C code lies between them and the caller, so an exception waits here until it is past it.
struct Calls {
  const KrylovProblem& problem;
  std::exception_ptr error;
  std::string message;  ///< KINSOL's last one

  /// KINSOL's convention: 0 went well, 1 try a shorter step, -1 stop.
  template <class Function>
  int guarded(Function function) {
    try {
      return function() ? 0 : 1;
    } catch (...) {
      error = std::current_exception();
      return -1;
    }
  }
};

Calls& calls(void* data) { return *static_cast<Calls*>(data); }

int residual(N_Vector u, N_Vector F, void* data) {
  Calls& c = calls(data);
  return c.guarded([&] { return c.problem.residual(values(u), values(F)); });
}

int setup(N_Vector u, N_Vector, N_Vector, N_Vector, void* data) {
  Calls& c = calls(data);
  return c.guarded([&] { return c.problem.linearize(values(u)); });
}

int precondition(N_Vector, N_Vector, N_Vector, N_Vector, N_Vector v, void* data) {
  Calls& c = calls(data);
  return c.guarded([&] {
    c.problem.precondition(values(v));
    return true;
  });
}

int jacobian(N_Vector v, N_Vector Jv, N_Vector, booleantype*, void* data) {
  Calls& c = calls(data);
  return c.guarded([&] {
    c.problem.jacobian(values(v), values(Jv));
    return true;
  });
}

void keep_message(int, const char*, const char*, char* text, void* data) { calls(data).message = text; }

/// In one step a return that says "not converged yet" is what was asked for.
std::string in_words(int flag, const std::string& message) {
  switch (flag) {
    case KIN_SUCCESS:
    case KIN_INITIAL_GUESS_OK:
    case KIN_STEP_LT_STPTOL:
    case KIN_MAXITER_REACHED: return "";
    case KIN_LINSOLV_NO_RECOVERY: return "the linear solver does not converge";
    case KIN_LSETUP_FAIL: return "the preconditioner is singular";
    case KIN_FIRST_SYSFUNC_ERR: return "the residual has no value at the start of the step";
    case KIN_REPTD_SYSFUNC_ERR: return "the residual has no value along the step, however short";
    default: return message.empty() ? "KINSOL returns " + std::to_string(flag) : message;
  }
}

}  // namespace

struct Kinsol::Implementation {
  Calls calls;
  SUNContext context = nullptr;
  N_Vector u = nullptr;
  N_Vector ones = nullptr;
  SUNLinearSolver linear = nullptr;
  void* memory = nullptr;

  explicit Implementation(const KrylovProblem& problem) : calls{problem, nullptr, ""} {}
  ~Implementation() {
    if (memory) KINFree(&memory);
    if (linear) SUNLinSolFree(linear);
    if (ones) N_VDestroy(ones);
    if (u) N_VDestroy(u);
    if (context) SUNContext_Free(&context);
  }
};

Kinsol::Kinsol(const KrylovProblem& problem) : implementation_(std::make_unique<Implementation>(problem)) {
  Implementation& own = *implementation_;
  const auto check = [](bool fine) {
    if (!fine) throw core::SolverError("KINSOL cannot be set up: not enough memory?");
  };
  check(SUNContext_Create(nullptr, &own.context) == 0);
  own.u = N_VNew_Serial(static_cast<sunindextype>(problem.size), own.context);
  check(own.u != nullptr);
  own.ones = N_VClone(own.u);
  own.linear = SUNLinSol_SPFGMR(own.u, SUN_PREC_RIGHT, krylov_vectors, own.context);
  own.memory = KINCreate(own.context);
  check(own.ones && own.linear && own.memory);
  N_VConst(1.0, own.ones);
  check(KINSetErrHandlerFn(own.memory, keep_message, &own.calls) == KIN_SUCCESS);
  check(KINInit(own.memory, residual, own.u) == KIN_SUCCESS);
  check(KINSetUserData(own.memory, &own.calls) == KIN_SUCCESS);
  check(SUNLinSol_SPFGMRSetMaxRestarts(own.linear, restarts) == 0);
  check(KINSetLinearSolver(own.memory, own.linear, nullptr) == KIN_SUCCESS);
  check(KINSetPreconditioner(own.memory, setup, precondition) == KIN_SUCCESS);
  check(KINSetJacTimesVecFn(own.memory, jacobian) == KIN_SUCCESS);
  check(KINSetEtaForm(own.memory, KIN_ETACONSTANT) == KIN_SUCCESS);
  // One step per call, of any length, whatever the residual: the caller judges and shortens it.
  check(KINSetNumMaxIters(own.memory, 1) == KIN_SUCCESS);
  check(KINSetMaxNewtonStep(own.memory, any_length) == KIN_SUCCESS);
  check(KINSetFuncNormTol(own.memory, never) == KIN_SUCCESS);
  check(KINSetScaledStepTol(own.memory, never) == KIN_SUCCESS);
}

Kinsol::~Kinsol() = default;

KinsolStep Kinsol::step(std::span<double> u, double linear_tolerance) {
  Implementation& own = *implementation_;
  KINSetEtaConstValue(own.memory, linear_tolerance);
  std::ranges::copy(u, values(own.u).begin());
  own.calls.error = nullptr;
  own.calls.message.clear();
  const int flag = KINSol(own.memory, own.u, KIN_NONE, own.ones, own.ones);
  if (own.calls.error) std::rethrow_exception(own.calls.error);
  std::ranges::copy(values(own.u), u.begin());
  KinsolStep step{.reason = in_words(flag, own.calls.message)};
  KINGetNumLinIters(own.memory, &step.linear_iterations);
  return step;
}

}  // namespace ehl::newton
