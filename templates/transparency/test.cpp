TEST(@test@, IsExactForOneLayer) {
  lumen::testing::Scene scene({64, 64});
  scene.add("transparency.@name@", "transparency");
  scene.add("diffuse.lambert", "lambert");
  scene.add("opacity.constant", "half", R"({"alpha": 0.5})");
  scene.surface("plate", lumen::testing::rectangle(), R"({"diffuse": "lambert", "opacity": "half", "ambient_color": [0, 0, 0], "diffuse_color": [1, 0, 0]})");
  const auto transparent = scene.layer("transparent");
  EXPECT_NEAR(transparent.at(32, 32, 0), 0.5f, 2e-3f);
  EXPECT_NEAR(transparent.at(32, 32, 3), 0.5f, 2e-3f);
}
