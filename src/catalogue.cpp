#include "catalogue.hpp"

#include "contact/keys.hpp"
#include "fmg/keys.hpp"
#include "mlmi/keys.hpp"
#include "reynolds/keys.hpp"
#include "rheology/keys.hpp"
#include "steady/keys.hpp"
#include "transient/keys.hpp"

namespace ehl::program {

deck::Catalogue catalogue() {
  deck::Catalogue all;
  all.sections = {
      {"case", "What this case is called."},
      {"contact",
       "The contact, in ONE of three languages: M and L (Moes); W, U and G (Hamrock and Dowson); or SI: load, "
       "radius_x and the elastic data."},
      {"motion", "The speeds of the surfaces: u1 and u2, or u_m and srr. Only with a contact in SI."},
      {"lubricant", "The oil."},
      {"domain", "The computed rectangle, in radii of the Hertz contact."},
      {"grid", "The finest and the coarsest grid."},
      {"discretization", "How derivatives become differences."},
      {"deformation", "How the elastic deformation is evaluated."},
      {"multigrid", "How the full multigrid works; the defaults need no tuning."},
      {"continuation", "How a high load is reached from lower ones, where that is needed."},
      {"transient", "What happens in time, from the steady contact at time 0. Absent: steady."},
      {"surface1", "What surface 1 carries through the contact, with its own speed. Only with [transient]."},
      {"surface2", "What surface 2 carries through the contact. Only with [transient]."},
      {"output", "What is kept."},
  };
  for (const auto& keys : {steady::keys(), contact::keys(), rheology::keys(), reynolds::keys(), mlmi::keys(),
                           fmg::keys(), transient::keys()})
    all.keys.insert(all.keys.end(), keys.begin(), keys.end());

  const std::string later = "not available in this version: remove it";
  for (const char* section : {"surface", "thermal", "shear", "starvation", "subsurface", "friction"})
    all.unavailable.push_back({section, "",
                               later + " (this version solves isothermal, fully flooded "
                                       "contacts with a Newtonian lubricant)"});
  return all;
}

}  // namespace ehl::program
