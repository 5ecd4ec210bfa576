// Uses an installed limn as the README says.
#include <iostream>

#include "limn/mesh/split.h"
#include "limn/scheme/shipped_files.h"

int main() {
  for (const limn::Split& split : limn::splits()) {
    std::cout << split.name << ": " << split.description << '\n';
  }
  std::cout << limn::shipped_files().size() << " shipped schemes\n";
  return limn::splits().empty() ? 1 : 0;
}
