#include "limn/fast/kernel/stencil.h"

#include <map>

namespace limn::fast {

RowTable to_rows(const Stencil& stencil) {
  RowTable table;
  for (const Tap& tap : stencil) table.terms.push_back({table.sources++, tap.weight});
  table.row_begin.push_back(table.sources);
  return table;
}

FormRows to_rows(std::span<const refine::LinearForm<double>> forms) {
  std::map<Index, int> slots;
  for (const refine::LinearForm<double>& form : forms)
    for (const auto& [vertex, weight] : form.terms)
      if (weight != 0) slots.emplace(vertex, 0);
  FormRows found;
  auto& [table, vertices] = found;
  for (auto& [vertex, slot] : slots) {
    slot = table.sources++;
    vertices.push_back(vertex);
  }
  for (const refine::LinearForm<double>& form : forms) {
    for (const auto& [vertex, weight] : form.terms)
      if (weight != 0) table.terms.push_back({slots.at(vertex), weight});
    table.row_begin.push_back(static_cast<int>(table.terms.size()));
  }
  return found;
}

}  // namespace limn::fast
