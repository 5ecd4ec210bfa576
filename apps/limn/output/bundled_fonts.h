#pragma once

namespace limn::app {

/// Where fonts lie beside the program, as in the tar file of `./dev package`
/// (../share/limn/fonts/fonts.conf from its folder), has figures drawn with them, so that they need
/// none of the system; FONTCONFIG_FILE in the environment comes first. Before any thread starts.
void use_bundled_fonts();

}  // namespace limn::app
