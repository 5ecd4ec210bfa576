#include "limn/search/method.h"

namespace limn::search {

Result<std::unique_ptr<Method>> make_method(const MethodChoice& choice, const SearchSpace& space) {
  switch (choice.kind) {
    case MethodKind::grid: return make_grid(choice, space);
    case MethodKind::random: return make_random(choice, space);
    case MethodKind::sobol: return make_sobol(choice, space);
    case MethodKind::local: return make_local(choice, space);
    default: return make_evolution(choice, space);
  }
}

}  // namespace limn::search
