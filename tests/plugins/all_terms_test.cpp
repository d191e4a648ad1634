/// Every installed term with every other of another kind, opaque and transparent, and every property of each: a new plugin is covered as it is.
#include <epoxy/gl.h>

#include <lumen/term.h>

#include "plugins/data_session.h"
#include "plugins/term_oracle.h"

namespace lumen::testing {
namespace {

constexpr Kind kinds[] = {Kind::ambient, Kind::diffuse, Kind::specular, Kind::opacity};

/// The installed types of a kind, with the properties that a shader sees.
struct Type {
  std::string id;
  std::vector<PropertySpec> properties;
};

std::vector<Type> installed(Kind kind) {
  const lumenshop::Installation installation = lumenshop::Installation::find();
  lumenshop::Registry registry({installation.plugins()}, nullptr);
  registry.load_all();
  lumenshop::Session session(registry);
  std::vector<Type> found;
  for (const lumenshop::TypeInfo& info : registry.types()) {
    if (info.kind != kind) continue;
    Type type{info.id, {}};
    for (const auto& slot : session.add(info.id).slots())
      if (slot->spec.id != "enabled") type.properties.push_back(slot->spec);
    found.push_back(std::move(type));
  }
  EXPECT_FALSE(found.empty()) << name_of(kind);
  return found;
}

/// A ball with dents, so that it bends in and out.
std::shared_ptr<Mesh> dented_ball() {
  auto mesh = std::make_shared<Mesh>(*sphere(96));
  std::vector<glm::vec3> positions(mesh->positions.begin(), mesh->positions.end());
  for (glm::vec3& p : positions) p *= 0.8f + 0.15f * std::sin(6 * p.x) * std::sin(6 * p.y);
  mesh->normals = average_normals(positions, {mesh->triangles.begin(), mesh->triangles.end()});
  mesh->positions = std::move(positions);
  mesh->finish();
  return mesh;
}

/// A picture whose color says where in it one is.
std::shared_ptr<Image> colors() {
  auto image = std::make_shared<Image>();
  image->width = image->height = 16;
  image->channels = {"R", "G", "B"};
  std::vector<float> pixels;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) pixels.insert(pixels.end(), {0.2f + 0.05f * float(x), 0.2f + 0.05f * float(y), 0.3f});
  image->pixels = std::move(pixels);
  image->finish();
  return image;
}

/// An opaque and a transparent surface of the same terms, side by side, under two lights.
class Pair {
 public:
  explicit Pair(const std::shared_ptr<Mesh>& mesh) : scene({64, 32}) {
    scene.set("camera.height", "2.4");
    look_from_near(scene);
    scene.give("shape", mesh);
    scene.add("filter.curvature", "bent", R"({"mesh": {"link": "shape.mesh"}})");
    for (const auto& [id, x] : {std::pair("solid", "-1.2"), std::pair("clear", "1.2")})
      scene.add("renderer.surface", id, R"({"mesh": {"link": "bent.result"}, "ambient_color": [0.2, 0.3, 0.1], "diffuse_color": [0.7, 0.4, 0.3], "specular_color": [0.5, 0.8, 1], "shininess": 12,
                                            "transform": [1,0,0,)" + std::string(x) + ", 0,1,0,0, 0,0,1,0, 0,0,0,1]}");
    scene.add("transparency.weighted", "weighted");
    scene.set("front.direction", json(slanted));
    scene.set("front.color", "[1, 0.9, 0.8]");
    scene.add("interactor.light", "back", R"({"direction": [-0.6, 0.1, -0.5], "color": [0.3, 0.6, 1], "intensity": 0.7})");
  }
  void use(Kind kind, const std::string& term) {
    if (kind != Kind::opacity) scene.set("solid." + std::string(name_of(kind)), term);
    scene.set("clear." + std::string(name_of(kind)), term);
  }
  /// The picture, sound in every layer that terms write.
  Pixels draw() {
    for (const char* layer : {"ambient", "diffuse", "specular", "opacity", "transparent"}) expect_finite(layer);
    Pixels color = expect_finite("color");
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    for (const Problem& problem : scene.problems()) ADD_FAILURE() << problem.message;
    EXPECT_EQ(color.rgba(14, 16).a, 1) << "the opaque surface is not there";
    return color;
  }

  Scene scene;

 private:
  Pixels expect_finite(const char* layer) {
    Pixels pixels = scene.layer(layer);
    float least = 0;
    bool finite = true;
    for (const float value : pixels.image().pixels) {
      finite = finite && std::isfinite(value);
      least = std::min(least, value);
    }
    EXPECT_TRUE(finite) << layer << " is not finite";
    EXPECT_GE(least, 0) << layer << " is negative";
    return pixels;
  }
};

/// All of one kind with all of another; the others take turns.
void expect_sound(Kind first, Kind second) {
  Pair pair(sphere(48));
  std::map<Kind, std::vector<Type>> types;
  for (const Kind kind : kinds) {
    types[kind] = installed(kind);
    for (const Type& type : types[kind]) pair.scene.add(type.id, "of_" + std::string(type.id).replace(type.id.find('.'), 1, "_"));
  }
  const auto use = [&](Kind kind, std::size_t index) {
    const Type& type = types[kind][index % types[kind].size()];
    pair.use(kind, "of_" + std::string(type.id).replace(type.id.find('.'), 1, "_"));
    return type.id;
  };
  for (std::size_t i = 0; i < types[first].size(); ++i)
    for (std::size_t j = 0; j < types[second].size(); ++j) {
      std::string names;
      for (const Kind kind : kinds) names += " " + use(kind, kind == first ? i : kind == second ? j : i + j);
      SCOPED_TRACE(names);
      pair.draw();
    }
}

TEST(AllTerms, DiffuseWithSpecular) { expect_sound(Kind::diffuse, Kind::specular); }
TEST(AllTerms, DiffuseWithOpacity) { expect_sound(Kind::diffuse, Kind::opacity); }
TEST(AllTerms, DiffuseWithAmbient) { expect_sound(Kind::diffuse, Kind::ambient); }
TEST(AllTerms, SpecularWithOpacity) { expect_sound(Kind::specular, Kind::opacity); }
TEST(AllTerms, SpecularWithAmbient) { expect_sound(Kind::specular, Kind::ambient); }
TEST(AllTerms, AmbientWithOpacity) { expect_sound(Kind::ambient, Kind::opacity); }

/// Values that differ from the default, within the range.
std::vector<Value> others(const PropertySpec& spec) {
  const PropertyOptions& options = spec.options;
  const auto held = [&](double x) { return float(std::clamp(x, options.min, options.max)); };
  const auto spread = [&](double x) { return std::vector<float>{held(x * 0.5), held(x * 1.6 + 0.15), held(x - 0.3), held(options.min), held(options.max)}; };
  std::vector<Value> values;
  const auto add = [&](Value value) {
    if (value != spec.default_value) values.push_back(std::move(value));
  };
  const auto add_vectors = [&](auto start) {
    for (const float factor : {0.5f, 1.3f}) {
      auto value = start;
      for (int c = 0; c < value.length(); ++c) value[c] = held(factor * (value[c] + 0.02f * float(c)));
      add(value);
    }
  };
  switch (spec.type) {
    case ValueType::boolean: add(!std::get<bool>(spec.default_value)); break;
    case ValueType::integer:
      for (const float x : spread(std::get<int>(spec.default_value))) add(int(std::round(x)));
      break;
    case ValueType::real:
      for (const float x : spread(std::get<float>(spec.default_value))) add(x);
      break;
    case ValueType::vec2: add_vectors(std::get<glm::vec2>(spec.default_value)); break;
    case ValueType::vec3: add_vectors(std::get<glm::vec3>(spec.default_value)); break;
    case ValueType::vec4: add_vectors(std::get<glm::vec4>(spec.default_value)); break;
    case ValueType::color: add(Color(0.15f, 0.55f, 0.35f)); break;
    case ValueType::rotation: add(glm::angleAxis(1.0f, slanted)); break;
    case ValueType::choice:
      for (const std::string& name : options.choices) add(Choice{name});
      break;
    case ValueType::transfer_function:
      add(TransferFunction{{-1, 1}, {{-1, {0.2f, 0.1f, 0.6f, 1}}, {1, {1, 0.7f, 0.1f, 1}}}});
      break;
    default: break;  // a shader does not see it
  }
  return values;
}

/// Makes the property's condition hold: "mode", "mode = sorted" or "mode != none".
void fulfil(Scene& scene, const std::string& term, const Type& type, const std::string& condition) {
  if (condition.empty()) return;
  const std::string property = condition.substr(0, condition.find_first_of(" !="));
  const auto watched = std::find_if(type.properties.begin(), type.properties.end(), [&](const PropertySpec& spec) { return spec.id == property; });
  ASSERT_NE(watched, type.properties.end()) << condition;
  const auto equals = condition.find("= ");
  if (equals == std::string::npos) {
    if (watched->type == ValueType::boolean) scene.set(term + "." + property, "true");
    return;
  }
  const std::string wanted = condition.substr(equals + 2);
  if (condition.find("!=") == std::string::npos) {
    scene.set(term + "." + property, wanted);
    return;
  }
  for (const std::string& choice : watched->options.choices)
    if (choice != wanted) scene.set(term + "." + property, choice);
}

/// Each property of each term of a kind, alone on its surface, shows in the picture.
void expect_properties_show(Kind kind) {
  Pair pair(dented_ball());
  pair.scene.give("picture", colors());
  int number = 0;
  for (const Type& type : installed(kind)) {
    for (const PropertySpec& spec : type.properties) {
      const std::vector<Value> values = others(spec);
      if (values.empty()) continue;
      SCOPED_TRACE(type.id + "." + spec.id);
      const std::string term = "term" + std::to_string(number++);
      pair.scene.add(type.id, term);
      for (const PropertySpec& input : type.properties)
        if (input.type == ValueType::data && input.data_kind == DataKind::image) pair.scene.set(term + "." + input.id, R"({"link": "picture.image"})");
      fulfil(pair.scene, term, type, spec.options.when);
      pair.use(kind, term);
      const Pixels before = pair.draw();
      float change = 0;
      for (const Value& value : values) {
        pair.scene.set_value(term + "." + spec.id, value);
        change = std::max(change, largest_difference(before, pair.draw()));
      }
      EXPECT_GT(change, 1e-4f) << "no value that was tried changes the picture";
    }
  }
}

TEST(AllTerms, PropertiesOfAmbientTermsShow) { expect_properties_show(Kind::ambient); }
TEST(AllTerms, PropertiesOfDiffuseTermsShow) { expect_properties_show(Kind::diffuse); }
TEST(AllTerms, PropertiesOfSpecularTermsShow) { expect_properties_show(Kind::specular); }
TEST(AllTerms, PropertiesOfOpacitiesShow) { expect_properties_show(Kind::opacity); }

}  // namespace
}  // namespace lumen::testing
