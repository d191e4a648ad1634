/// How shader files are taken apart and put together.

#include "frame/glsl_file.h"

#include <gtest/gtest.h>
#include <lumen/error.h>

namespace {

using lumenshop::GlslFile;

std::string emitted(const std::string& source, std::vector<std::string_view> entries, GlslFile::Stage stage = GlslFile::Stage::fragment) {
  return GlslFile("test/file.glsl", source).emit(stage, entries, "x_", 7);
}

TEST(GlslFile, PrefixesItsFileScopeNamesAndNothingElse) {
  const std::string text = emitted("const float radius = 2.0;\nfloat helper(float a) { return a * radius; }\n"
                                   "vec3 diffuse(Properties p, Surface s) { return vec3(helper(p.radius), s.helper, length(s.normal)); }\n", {"diffuse"});
  EXPECT_NE(text.find("const float x_radius"), text.npos);
  EXPECT_NE(text.find("float x_helper(float a)"), text.npos);
  EXPECT_NE(text.find("vec3 x_diffuse(x_Properties p, Surface s)"), text.npos);
  EXPECT_NE(text.find("x_helper(p.radius)"), text.npos);
  EXPECT_NE(text.find("s.helper"), text.npos);
  EXPECT_NE(text.find("length(s.normal)"), text.npos);
}

TEST(GlslFile, KeepsFieldNamesOfItsStructs) {
  const std::string text = emitted("float size() { return 1.0; }\nstruct Ray { vec3 at; float size; };\nRay make() { Ray r; r.size = size(); return r; }\n", {"make"});
  EXPECT_NE(text.find("struct x_Ray { vec3 at; float size; }"), text.npos);
  EXPECT_NE(text.find("r.size = x_size()"), text.npos);
}

TEST(GlslFile, EmitsOnlyWhatTheEntryReaches) {
  const std::string text = emitted("float a() { return 1.0; }\nfloat b() { return a(); }\nfloat c() { return 3.0; }\n", {"b"});
  EXPECT_NE(text.find("x_a"), text.npos);
  EXPECT_EQ(text.find("x_c"), text.npos);
}

TEST(GlslFile, SaysTheLineOfEachItem) {
  EXPECT_NE(emitted("\n\n// words\nfloat a() { return 1.0; }\n", {"a"}).find("#line " + std::to_string(7 * lumenshop::lines_per_file + 4) + "\nfloat x_a"), std::string::npos);
}

TEST(GlslFile, SeparatesStages) {
  const std::string source = "float both() { return 1.0; }\n#pragma stage vertex\nout vec3 v;\nvoid vertex(Properties p) { v = vec3(both()); }\n"
                             "#pragma stage fragment\nin vec3 v;\nvoid surface(Properties p) { both(); v; }\n";
  const std::string vertex = emitted(source, {"vertex"}, GlslFile::Stage::vertex), fragment = emitted(source, {"surface"});
  EXPECT_NE(vertex.find("out vec3 x_v"), vertex.npos);
  EXPECT_EQ(vertex.find("in vec3 x_v"), vertex.npos);
  EXPECT_NE(fragment.find("in vec3 x_v"), fragment.npos);
  EXPECT_EQ(fragment.find("out vec3"), fragment.npos);
}

TEST(GlslFile, RenamesMacrosAndBlocks) {
  const std::string text = emitted("#define TWICE(x) (2.0 * (x) * scale)\nuniform float scale;\nlayout(std430, binding = 9) buffer Cells { uint cells[]; };\n"
                                   "float use(Properties p) { return TWICE(p.scale) + float(cells[0]); }\n", {"use"});
  EXPECT_NE(text.find("#define x_TWICE(x) (2.0 * (x) * x_scale)"), text.npos);
  EXPECT_NE(text.find("x_TWICE(p.scale)"), text.npos);
  EXPECT_NE(text.find("buffer x_Cells { uint x_cells[]; }"), text.npos);
}

TEST(GlslFile, SaysWhatIsMissing) {
  EXPECT_THROW(GlslFile("t.glsl", "float a() { return 1.0;"), lumen::Error);
  EXPECT_THROW(GlslFile("t.glsl", "float a() { return 1.0; } }"), lumen::Error);
  EXPECT_THROW(GlslFile("t.glsl", "uniform float a"), lumen::Error);
  EXPECT_THROW(GlslFile("t.glsl", "#include \"/etc/passwd\"\n"), lumen::Error);
  EXPECT_THROW(GlslFile("t.glsl", "#ifdef A\n#endif\n"), lumen::Error);
}

}  // namespace
