/// @kind@.@name@.
#include <cmath>

#include <gtest/gtest.h>

#include <lumen/lumen.h>
#include <lumen/editor.h>
#include <lumen/testing.h>

namespace {

@body@
}  // namespace
