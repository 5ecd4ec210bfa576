#pragma once
/// The parts of a scheme file that are data rather than rules: masks, factors, stages, facts.

#include "limn/scheme/file/toml_reader.h"

namespace limn::scheme {

/// { rows = [[…], …], scale = … }; `what` names it in errors.
Rows read_rows(TomlReader& in, const toml::node& node, std::string_view what);
/// { stages = …, directions = [{ step = [1, 0], count = … }, …], kernel = ROWS }
Factors read_factors(TomlReader& in, const toml::node& node);
/// { first = "bilinear" or "linear", then = "average", times = …, pair = … }, not yet counted;
/// `read_pair` reads the rule of that name.
Stages read_stages(TomlReader& in, const toml::node& node,
                   const std::function<Rule(const toml::node&)>& read_pair);
/// "triangle" or "quad"; nothing, and a fault, where it is another word.
std::optional<Lattice> read_lattice(TomlReader& in, const toml::node& node);
/// One entry of [[facts]]: into scheme.facts, scheme.equivalences or scheme.stated_mask.
void read_fact(TomlReader& in, const toml::node& node, Scheme& scheme);

}  // namespace limn::scheme
