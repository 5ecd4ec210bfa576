#include "limn/refine/fast/stencil.h"

namespace limn::fast {

RowTable to_rows(const Stencil& stencil) {
  RowTable table;
  for (const Tap& tap : stencil) table.terms.push_back({table.sources++, tap.weight});
  table.row_begin.push_back(table.sources);
  return table;
}

}  // namespace limn::fast
