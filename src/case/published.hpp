#pragma once
// The published film formulas that the program compares with: their codes in the names of columns, and their names.

namespace ehl::program {

struct Publication {
  const char* code = "";
  const char* name = "";
};

namespace published {

inline constexpr Publication moes{"moes", "Moes 1992"};
inline constexpr Publication nvm{"nvm", "Nijenbanning, Venner, Moes 1994"};
inline constexpr Publication hd{"hd", "Hamrock, Dowson 1977"};
inline constexpr Publication chittenden{"chittenden", "Chittenden et al. 1985"};
inline constexpr Publication dh{"dh", "Dowson, Higginson 1968; Toyoda 1979"};

}  // namespace published
}  // namespace ehl::program
