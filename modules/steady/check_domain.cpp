// Checks a domain, given or chosen, against the error that it causes.
#include <fmt/format.h>

#include "steady/domain_error.hpp"
#include "steady/keys.hpp"

namespace ehl::steady {

void check_domain(deck::Deck& deck, const Scene& scene) {
  constexpr double too_much = 0.5;
  const deck::Part domain{deck, "domain"};
  const double error = rough_domain_error(scene);
  if (scene.far_field && error > 1.0) {
    domain.complain(domain.given("x_inlet") ? "x_inlet" : "y_half",
                    fmt::format("the closed far field does not hold so close to the contact: its pressure there would "
                                "change the film by about {:.0f} %. Leave the domain open, or set far_field = zero",
                                100.0 * error));
    return;
  }
  if (domain.given("x_inlet")) return;
  if (error > too_much)
    domain.complain(
        "x_inlet",
        fmt::format("is left open, but the longest inlet that is chosen, {:.4g}, cuts off about {:.0f} % of the film, "
                    "because a light load is carried far from the contact. Give x_inlet, as far as the oil reaches",
                    scene.grid.X_a, 100.0 * error));
}

}  // namespace ehl::steady
