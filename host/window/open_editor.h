/// Opens a source file in the person's editor.
#pragma once

#include <string>

namespace lumenshop {

/// Runs $VISUAL (else $EDITOR) with "+LINE FILE", detached from the program. Throws lumen::Error: neither is set, no such file.
void open_in_editor(const std::string& file, int line);

}  // namespace lumenshop
