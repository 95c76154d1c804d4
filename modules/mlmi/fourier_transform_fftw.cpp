// Fourier transforms by FFTW. It is under the GPL, and so is a program built with this file (README, Licence).
#include <fftw3.h>

#include <map>
#include <mutex>

#include "mlmi/buffer.hpp"
#include "mlmi/fourier_transform.hpp"

namespace ehl::mlmi {
namespace {

// The planner is the only part of FFTW that two threads must not use at the same time.
std::mutex planner;

// FFTW_ESTIMATE makes no timings: the same machine always gets the same plan, and so the same bits.
constexpr unsigned flags = FFTW_ESTIMATE;

fftw_complex* as_complex(double* p) { return reinterpret_cast<fftw_complex*>(p); }

struct Plan {
  fftw_plan handle = nullptr;
  Plan() = default;
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;
  ~Plan() { fftw_destroy_plan(handle); }
};

/// A transform and its inverse.
struct Pair {
  Plan forward, inverse;
};

/// The plans of one kind by their length, kept until the program ends: a plan takes much longer than a transform, and
/// contacts are solved one after another on grids of the same sizes. A plan may run on any arrays of the same
/// alignment, in many threads at once.
class Plans {
 public:
  /// The plans of one length; make(pair) makes them if they do not exist yet.
  template <class Make>
  const Pair& of(int length, Make make) {
    const std::lock_guard lock(planner);
    const auto [place, fresh] = by_length_.try_emplace(length);
    if (fresh) make(place->second);
    return place->second;
  }

 private:
  std::map<int, Pair> by_length_;
};

const Pair& real_plans(int length) {
  static Plans plans;
  return plans.of(length, [length](Pair& pair) {
    const auto size = static_cast<std::size_t>(length);
    Buffer row(size), spectrum(size + 2);
    pair.forward.handle =
        fftw_plan_dft_r2c_1d(length, row.data(), as_complex(spectrum.data()), flags | FFTW_PRESERVE_INPUT);
    pair.inverse.handle =
        fftw_plan_dft_c2r_1d(length, as_complex(spectrum.data()), row.data(), flags | FFTW_DESTROY_INPUT);
  });
}

const Plan& complex_plan(int length) {
  static Plans plans;
  const Pair& pair = plans.of(length, [length](Pair& made) {
    Buffer from(2 * static_cast<std::size_t>(length)), to(from.size());
    made.forward.handle = fftw_plan_dft_1d(length, as_complex(from.data()), as_complex(to.data()), FFTW_FORWARD,
                                           flags | FFTW_PRESERVE_INPUT);
  });
  return pair.forward;
}

const Pair& column_plans(int length) {
  static Plans plans;
  return plans.of(length, [length](Pair& pair) {
    constexpr int columns = ColumnTransform::columns;
    Buffer from(static_cast<std::size_t>(length) * 2 * columns), to(from.size());
    fftw_complex *in = as_complex(from.data()), *out = as_complex(to.data());
    const auto plan = [&](int sign) {
      return fftw_plan_many_dft(1, &length, columns, in, nullptr, columns, 1, out, nullptr, columns, 1, sign, flags);
    };
    pair.forward.handle = plan(FFTW_FORWARD);
    pair.inverse.handle = plan(FFTW_BACKWARD);
  });
}

}  // namespace

const char* fourier_library() { return "FFTW"; }

struct RealTransform::Implementation {
  const Pair& plans;
};

RealTransform::RealTransform(int length)
    : implementation_(std::make_unique<Implementation>(Implementation{real_plans(length)})) {}
RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;
RealTransform& RealTransform::operator=(RealTransform&&) noexcept = default;

void RealTransform::forward(const double* row, double* spectrum) const {
  // PRESERVE_INPUT: the plan only reads the row.
  fftw_execute_dft_r2c(implementation_->plans.forward.handle, const_cast<double*>(row), as_complex(spectrum));
}
void RealTransform::inverse(double* spectrum, double* row) const {
  fftw_execute_dft_c2r(implementation_->plans.inverse.handle, as_complex(spectrum), row);
}

struct ComplexTransform::Implementation {
  const Plan& plan;
};

ComplexTransform::ComplexTransform(int length)
    : implementation_(std::make_unique<Implementation>(Implementation{complex_plan(length)})) {}
ComplexTransform::~ComplexTransform() = default;
ComplexTransform::ComplexTransform(ComplexTransform&&) noexcept = default;
ComplexTransform& ComplexTransform::operator=(ComplexTransform&&) noexcept = default;

void ComplexTransform::forward(const double* in, double* out) const {
  fftw_execute_dft(implementation_->plan.handle, as_complex(const_cast<double*>(in)), as_complex(out));
}

struct ColumnTransform::Implementation {
  const Pair& plans;
};

ColumnTransform::ColumnTransform(int length)
    : implementation_(std::make_unique<Implementation>(Implementation{column_plans(length)})) {}
ColumnTransform::~ColumnTransform() = default;
ColumnTransform::ColumnTransform(ColumnTransform&&) noexcept = default;

void ColumnTransform::forward(double* in, double* out) const {
  fftw_execute_dft(implementation_->plans.forward.handle, as_complex(in), as_complex(out));
}
void ColumnTransform::inverse(double* in, double* out) const {
  fftw_execute_dft(implementation_->plans.inverse.handle, as_complex(in), as_complex(out));
}

}  // namespace ehl::mlmi
