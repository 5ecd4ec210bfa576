#pragma once
/// The results as Markdown, to be pasted into docs/performance.md.

#include <string>
#include <vector>

#include "measure.h"

namespace limn::peers {

/// What one contender took. Of repeated evaluation, `warm` is all there is.
struct Entry {
  std::string name;
  bool ours = true;
  int threads = 1;
  Measurement cold, warm;
};

/// One scheme on one mesh: the contenders in the order of the table, and the floor.
struct Outcome {
  std::string scheme;
  int steps = 0;
  std::vector<Entry> entries;
  Measurement floor;
  double floor_bytes = 0;  ///< of the whole result
};

/// Processor, compiler, date, how busy the machine is, and what the times are.
void print_machine();

/// A table's title and head, and what one race adds to it. "–": no such method.
void print_full_head(const std::string& mesh);
void print_full(const Outcome& outcome);
void print_again_head(const std::string& mesh);
void print_again(const Outcome& outcome);

/// One row a race: our fastest on one thread and two, the fastest peer, the floor.
struct Summary {
  std::string title;  ///< of what, on which mesh
  std::vector<Outcome> outcomes;
};
void print_summaries(const std::vector<Summary>& summaries);

}  // namespace limn::peers
