#include "transient/ida.hpp"

#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

#include "core/errors.hpp"

namespace ehl::transient {
namespace {

/// Number of internal steps is not bounded: IDASolve returns after every step.
constexpr long unlimited = -1;

std::span<double> values(N_Vector v) {
  return {N_VGetArrayPointer_Serial(v), static_cast<std::size_t>(N_VGetLength_Serial(v))};
}

/// State shared with the callbacks. C code lies between them and the caller, so exceptions are stored here and thrown
/// again behind it.
struct Calls {
  const DaeProblem& problem;
  std::exception_ptr error{};
  std::string message{};  ///< last message of IDA
  int cycles = 0;         ///< since the step began
  int newton_steps = 0;   ///< since the step began
  int last_count = 0;     ///< iterations of the last solution, of both kinds
  double last_T = 0.0;

  /// IDA's convention: 0 success, positive: try a shorter step, negative: stop.
  template <class Function>
  int guarded(int shorter, Function function) {
    try {
      return function() ? 0 : shorter;
    } catch (...) {
      error = std::current_exception();
      return -1;
    }
  }
};

Calls& calls(void* data) { return *static_cast<Calls*>(data); }

int weights(N_Vector y, N_Vector w, void* data) {
  Calls& c = calls(data);
  return c.guarded(-1, [&] {
    c.problem.weights(c.last_T, values(y), values(w));
    // IDA does not check the weights itself.
    return std::ranges::all_of(values(w), [](double weight) { return weight > 0.0 && std::isfinite(weight); });
  });
}

int event(realtype T, N_Vector y, N_Vector, realtype* value, void* data) {
  Calls& c = calls(data);
  return c.guarded(-1, [&] {
    *value = c.problem.event(T, values(y));
    return true;
  });
}

/// IDA asks for a residual function but never calls it when the caller supplies the nonlinear solver.
int no_residual(realtype, N_Vector, N_Vector, N_Vector, void*) { return -1; }

/// Solves one implicit step; the last argument is IDA's memory.
int solve_stage(SUNNonlinearSolver solver, N_Vector, N_Vector correction, N_Vector ewt, realtype tolerance, booleantype,
                void* ida) {
  Calls& c = calls(solver->content);
  realtype T = 0.0, cj = 0.0;
  N_Vector y_predicted = nullptr, yp_predicted = nullptr, y = nullptr, yp = nullptr, res = nullptr;
  void* user = nullptr;
  if (IDAGetNonlinearSystemData(ida, &T, &y_predicted, &yp_predicted, &y, &yp, &res, &cj, &user) != IDA_SUCCESS)
    return -1;
  return c.guarded(SUN_NLS_CONV_RECVR, [&] {
    c.last_T = T;
    const Stage stage{T, cj, values(y_predicted), values(yp_predicted), values(ewt), tolerance};
    const StageResult result = c.problem.solve(stage, values(correction));
    c.last_count = result.cycles + result.newton_steps;
    c.cycles += result.cycles;
    c.newton_steps += result.newton_steps;
    // IDA's error test would accept NaN, because a comparison with NaN is false.
    return result.solved && std::ranges::all_of(values(correction), [](double v) { return std::isfinite(v); });
  });
}

void keep_message(int, const char*, const char*, char* text, void* data) { calls(data).message = text; }

std::string in_words(int flag, const std::string& message) {
  switch (flag) {
    case IDA_ERR_FAIL: return "the error test failed with the shortest allowed step";
    case IDA_CONV_FAIL: return "the cycles did not converge with the shortest allowed step";
    case IDA_TOO_MUCH_ACC: return "the tolerance is too small for floating-point numbers";
    default: return message.empty() ? "IDA returns " + std::to_string(flag) : message;
  }
}

}  // namespace

struct Ida::Implementation {
  Calls calls;
  StepLimits limits;
  SUNContext context = nullptr;
  N_Vector y = nullptr;
  N_Vector yp = nullptr;
  N_Vector between = nullptr;
  SUNNonlinearSolver solver = nullptr;
  void* memory = nullptr;
  long rejected = 0;
  long not_solved = 0;

  Implementation(const DaeProblem& problem, const StepLimits& step_limits) : calls{problem}, limits(step_limits) {}
  ~Implementation() {
    if (memory) IDAFree(&memory);
    if (solver) SUNNonlinSolFreeEmpty(solver);
    for (N_Vector v : {between, yp, y})
      if (v) N_VDestroy(v);
    if (context) SUNContext_Free(&context);
  }
};

Ida::Ida(const DaeProblem& problem, const StepLimits& limits, double T, std::span<const double> y,
         std::span<const double> yp)
    : implementation_(std::make_unique<Implementation>(problem, limits)) {
  Implementation& own = *implementation_;
  const auto check = [](bool fine) {
    if (!fine) throw core::SolverError("IDA cannot be set up: not enough memory?");
  };
  check(SUNContext_Create(nullptr, &own.context) == 0);
  own.y = N_VNew_Serial(static_cast<sunindextype>(problem.size), own.context);
  check(own.y != nullptr);
  own.yp = N_VClone(own.y);
  own.between = N_VClone(own.y);
  check(own.yp && own.between);
  std::ranges::copy(y, values(own.y).begin());
  std::ranges::copy(yp, values(own.yp).begin());
  own.calls.last_T = T;
  own.memory = IDACreate(own.context);
  check(own.memory != nullptr);
  check(IDASetErrHandlerFn(own.memory, keep_message, &own.calls) == IDA_SUCCESS);
  check(IDAInit(own.memory, no_residual, T, own.y, own.yp) == IDA_SUCCESS);
  check(IDASetUserData(own.memory, &own.calls) == IDA_SUCCESS);
  check(IDAWFtolerances(own.memory, weights) == IDA_SUCCESS);
  own.solver = SUNNonlinSolNewEmpty(own.context);
  check(own.solver != nullptr);
  own.solver->content = &own.calls;
  own.solver->ops->gettype = [](SUNNonlinearSolver) { return SUNNONLINEARSOLVER_ROOTFIND; };
  own.solver->ops->setsysfn = [](SUNNonlinearSolver, SUNNonlinSolSysFn) { return 0; };
  own.solver->ops->solve = solve_stage;
  own.solver->ops->getnumiters = [](SUNNonlinearSolver solver, long* count) {
    *count = calls(solver->content).last_count;
    return 0;
  };
  check(IDASetNonlinearSolver(own.memory, own.solver) == IDA_SUCCESS);
  check(IDASetMaxOrd(own.memory, limits.max_order) == IDA_SUCCESS);
  check(IDASetMaxNumSteps(own.memory, unlimited) == IDA_SUCCESS);
  check(IDASetMaxStep(own.memory, limits.longest) == IDA_SUCCESS);
  check(IDASetMinStep(own.memory, limits.shortest) == IDA_SUCCESS);
  if (limits.first > 0.0) check(IDASetInitStep(own.memory, limits.first) == IDA_SUCCESS);
  if (problem.event) {
    check(IDARootInit(own.memory, 1, event) == IDA_SUCCESS);
    int falling = -1;
    check(IDASetRootDirection(own.memory, &falling) == IDA_SUCCESS);
    check(IDASetNoInactiveRootWarn(own.memory) == IDA_SUCCESS);
  }
}

Ida::~Ida() = default;

void Ida::restart(double T, std::span<const double> y, std::span<const double> yp, double first_step) {
  Implementation& own = *implementation_;
  std::ranges::copy(y, values(own.y).begin());
  std::ranges::copy(yp, values(own.yp).begin());
  own.calls.last_T = T;
  if (IDAReInit(own.memory, T, own.y, own.yp) != IDA_SUCCESS) throw core::SolverError("IDA cannot be restarted");
  IDASetInitStep(own.memory, first_step);
  own.rejected = own.not_solved = 0;  // IDA counts from zero again
}

StepReport Ida::step(double T_stop) {
  Implementation& own = *implementation_;
  own.calls.error = nullptr;
  own.calls.message.clear();
  own.calls.cycles = own.calls.newton_steps = 0;
  realtype T = 0.0;
  int flag = IDASetStopTime(own.memory, T_stop);  // refused for a time that has passed
  if (flag == IDA_SUCCESS) flag = IDASolve(own.memory, T_stop, &T, own.y, own.yp, IDA_ONE_STEP);
  if (own.calls.error) std::rethrow_exception(own.calls.error);
  StepReport report{.T = T, .cycles = own.calls.cycles, .newton_steps = own.calls.newton_steps};
  switch (flag) {
    case IDA_SUCCESS: report.end = StepReport::End::accepted; break;
    case IDA_TSTOP_RETURN: report.end = StepReport::End::at_stop; break;
    case IDA_ROOT_RETURN: report.end = StepReport::End::at_event; break;
    default: report.end = StepReport::End::failed; report.reason = in_words(flag, own.calls.message);
  }
  IDAGetLastStep(own.memory, &report.length);
  IDAGetLastOrder(own.memory, &report.order);
  long rejected = 0, not_solved = 0;
  IDAGetNumErrTestFails(own.memory, &rejected);
  IDAGetNumStepSolveFails(own.memory, &not_solved);
  report.rejected = static_cast<int>(rejected - own.rejected);
  report.not_solved = static_cast<int>(not_solved - own.not_solved);
  own.rejected = rejected;
  own.not_solved = not_solved;
  return report;
}

std::span<const double> Ida::y() const { return values(implementation_->y); }
std::span<const double> Ida::yp() const { return values(implementation_->yp); }

void Ida::interpolate(double T, std::span<double> y) const {
  Implementation& own = *implementation_;
  // IDAGetDky refuses only times before the last step, so later ones are refused here.
  realtype reached = 0.0;
  IDAGetCurrentTime(own.memory, &reached);
  const double rounding = 1e-14 * std::abs(reached);
  if (T > reached + rounding || IDAGetDky(own.memory, T, 0, own.between) != IDA_SUCCESS)
    throw std::logic_error("interpolation outside the last step");
  std::ranges::copy(values(own.between), y.begin());
}

}  // namespace ehl::transient
