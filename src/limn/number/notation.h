#pragma once
/// How formulas are written.

namespace limn::number {

/// Text as scheme files write expressions ("(1 + c1 + c2 + c3)^2/16"), or LaTeX.
enum class Notation { text, latex };

}  // namespace limn::number
