#include "thermal/film_temperature.hpp"

#include "thermal/film_columns.hpp"

namespace ehl::thermal {

FilmTemperature::FilmTemperature(const Setup& setup) : columns_(std::make_unique<FilmColumns>(setup)) {}
FilmTemperature::FilmTemperature(FilmTemperature&&) noexcept = default;
FilmTemperature& FilmTemperature::operator=(FilmTemperature&&) noexcept = default;
FilmTemperature::~FilmTemperature() = default;

void FilmTemperature::start_from(const FilmTemperature& coarse, const FilmTemperature* coarser) {
  columns_->start_from(*coarse.columns_, coarser == nullptr ? nullptr : coarser->columns_.get());
}
void FilmTemperature::take(const core::Field& P, const core::Field& H, const core::Field* theta) {
  columns_->take(P, H, theta);
}
double FilmTemperature::sweep(bool back) { return columns_->sweep(back); }
void FilmTemperature::begin_in_time(double end) { columns_->begin_in_time(end); }
void FilmTemperature::begin_step(const TimeStep& step) { columns_->begin_step(step); }
void FilmTemperature::accept_step() { columns_->accept_step(); }
void FilmTemperature::restart() { columns_->restart(); }
bool FilmTemperature::flows_back() const { return columns_->flows_back(); }
const core::Field& FilmTemperature::I0() const { return columns_->I0(); }
const core::Field& FilmTemperature::M2() const { return columns_->M2(); }
const core::Field& FilmTemperature::C() const { return columns_->C(); }
const core::Field& FilmTemperature::rho() const { return columns_->rho(); }
const core::Field& FilmTemperature::more_x() const { return columns_->more_x(); }
const core::Field& FilmTemperature::more_y() const { return columns_->more_y(); }
const core::Field& FilmTemperature::less_tau() const { return columns_->less_tau(); }
const core::Field& FilmTemperature::tau_m() const { return columns_->tau_m(); }
const core::Field& FilmTemperature::q_1() const { return columns_->q_1(); }
const core::Field& FilmTemperature::q_2() const { return columns_->q_2(); }
double FilmTemperature::theta(int i, int j, int k) const { return columns_->theta(i, j, k); }
double FilmTemperature::velocity(int i, int j, int k) const { return columns_->velocity(i, j, k); }
Balance FilmTemperature::balance() const { return columns_->balance(); }
std::size_t FilmTemperature::bytes() const { return columns_->bytes(); }

}  // namespace ehl::thermal
