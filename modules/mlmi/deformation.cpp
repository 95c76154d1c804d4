#include "mlmi/deformation.hpp"

#include <optional>

#include "core/constants.hpp"
#include "core/errors.hpp"
#include "kernel/influence.hpp"
#include "mlmi/direct_sum.hpp"
#include "mlmi/fourier_convolution.hpp"

namespace ehl::mlmi {
namespace {

// Eq. (6): the deformation in units of a^2/R for the pressure in units of p_h.
constexpr double half_space_factor = 2.0 / (core::pi * core::pi);

// Below this size starting a team of threads costs more than it saves.
constexpr int smallest_parallel = 256;

}  // namespace

struct Deformation::Implementation {
  std::string description;
  std::optional<DirectSum> direct;
  std::optional<FourierConvolution> fourier;
};

Deformation::Deformation(const core::Grid& grid, const Parameters& parameters, int threads)
    : implementation_(std::make_unique<Implementation>()) {
  const int team = std::max(grid.nx, grid.ny) < smallest_parallel ? 1 : std::max(1, threads);
  const auto table = kernel::influence_table(grid.nx, grid.ny, grid.hx(), grid.hy());
  if (parameters.method == Method::direct) {
    implementation_->direct.emplace(grid.nodes_x(), grid.nodes_y(), table, half_space_factor, team);
    implementation_->description = "direct sum";
  } else {
    implementation_->fourier.emplace(grid.nodes_x(), grid.nodes_y(), table, half_space_factor, team);
    implementation_->description = std::string("FFT (") + fourier_library() + ")";
  }
}
Deformation::~Deformation() = default;
Deformation::Deformation(Deformation&&) noexcept = default;
Deformation& Deformation::operator=(Deformation&&) noexcept = default;

void Deformation::evaluate(const core::Field& P, core::Field& w) {
  if (implementation_->direct) implementation_->direct->apply(P.at_x(0), P.stride(), w.at_x(0), w.stride());
  if (implementation_->fourier) implementation_->fourier->apply(P.at_x(0), P.stride(), w.at_x(0), w.stride());
}

std::string Deformation::description() const { return implementation_->description; }
std::size_t Deformation::bytes() const {
  return implementation_->direct ? implementation_->direct->bytes() : implementation_->fourier->bytes();
}

}  // namespace ehl::mlmi
